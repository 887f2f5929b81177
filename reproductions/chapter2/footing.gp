# Sinkage of a rigid cylinder on discs all the way down and on discs over elements. Strings: style, output, data.
load style
set xlabel "time since touch [s]"
set ylabel "sinkage [mm]"
set yrange [0:*]
set label 1 "discs" at graph 0.75,graph 0.2 left textcolor rgb earth_colour
set label 2 "discs over elements" at graph 0.5,graph 0.1 left textcolor rgb mars_colour
stats data using 1 skip 1 nooutput
seeds = STATS_max < 5 ? int(STATS_max) : 5  # more hide each other
plot for [s=1:seeds] data using (column(1) == s ? $2 : NaN):3 skip 1 with lines linecolor rgb earth_colour, \
     for [s=1:seeds] data using (column(1) == s ? $2 : NaN):4 skip 1 with lines linecolor rgb mars_colour
