# Front of a wave in a bar of forty quads at the largest step and at half of it. Strings: style, output, data.
load style
set xlabel "x [m]"
set ylabel "v / v_0"
set xrange [0:1]
set yrange [-0.2:1.4]
set label 1 "Δt = l/c: exact at the nodes" at 0.03,1.3 left textcolor rgb earth_colour
set label 2 "Δt = l/2c" at 0.03,0.8 left textcolor rgb mars_colour
pick(n, c) = column(1) == n ? column(c) : NaN
set samples 1000
plot x < 0.5875 ? 1 : 0 with lines linewidth 1.2 linecolor rgb muted, \
     data using (pick(2,2)):3 skip 1 with linespoints pointtype 7 pointsize 0.4 linewidth 1 linecolor rgb mars_colour, \
     data using (pick(1,2)):3 skip 1 with points pointtype 6 pointsize 0.8 linewidth 1.6 linecolor rgb earth_colour
