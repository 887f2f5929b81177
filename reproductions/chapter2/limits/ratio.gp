# Limits of a sunk wheel against the contacts' stiffness. Strings: style, output, data.
load style
set rmargin 4
set logscale xy
set xrange [2e3:1.6e6]
set yrange [2e-5:2e-3]
set format xy "10^{%T}"
set xlabel "K_n [N/m]"
set ylabel "time step [s]"
set label 1 "wheel's elements" at 2.2e3,1.8e-4 left textcolor rgb mars_colour
set label 2 "bed alone" at 6e3,7e-4 left textcolor rgb earth_colour
set label 3 "line: bed and wheel together, as they stand" at 1.4e6,1.4e-3 right textcolor rgb ink
set label 4 "●: first failure, ○: last survival" at 1.4e6,1.0e-3 right textcolor rgb text_colour
set label 5 "default" at 1e5,4e-5 left offset 1,-0.6 textcolor rgb muted
plot data using 1:4 skip 1 with lines dashtype 2 linewidth 1.4 linecolor rgb mars_colour, \
     data using 1:3 skip 1 with lines dashtype 2 linewidth 1.4 linecolor rgb earth_colour, \
     data using 1:6 skip 1 with lines linewidth 1.8 linecolor rgb ink, \
     data using 1:($8 > 0 ? $8 : NaN) skip 1 with points pointtype 7 pointsize 0.8 linecolor rgb text_colour, \
     data using 1:($7 > 0 ? $7 : NaN) skip 1 with points pointtype 6 pointsize 0.9 linecolor rgb text_colour, \
     "<echo 1e5,4e-5" using 1:2 with points pointtype 4 pointsize 1.4 linewidth 1.6 linecolor rgb muted
