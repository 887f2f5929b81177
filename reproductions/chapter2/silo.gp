# What reaches the floor of a silo with rough walls against its height. Strings: style, output, data.
load style
pick(kind, c) = strcol(1) eq kind ? column(c) : NaN
stats data using (pick("k",2)) skip 1 nooutput
k = STATS_mean
stats data using (pick("k",3)) skip 1 nooutput
rate = 2*STATS_mean*k
set xlabel "height / width"
set ylabel "load on the floor / (ρ g L² t)"
set xrange [0:4.6]
set yrange [0:3]
set label 1 "weight" at 2.5,2.75 right textcolor rgb muted
set label 2 sprintf("Janssen, k = %.2f", k) at 4.5,1.35 right textcolor rgb earth_colour
plot x with lines dashtype 2 linecolor rgb muted, (1 - exp(-rate*x))/rate with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using (pick("floor",2)):3 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour
