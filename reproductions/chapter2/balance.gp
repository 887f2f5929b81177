# Horizontal balance and slip of a wheel in a prescribed motion. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
set xlabel "time [s]"
set xrange [0:0.16]
set xtics 0.04
set ylabel "force [N]"
set yrange [-80:200]
set label 1 "H" at graph 0.03,0.95 left textcolor rgb earth_colour
set label 2 "|R|" at graph 0.13,0.95 left textcolor rgb mars_colour
set label 3 "P_d = −P" at graph 0.27,0.95 left textcolor rgb other_colour
set label 4 "○ H − |R| − dp/dt" at graph 0.03,0.86 left textcolor rgb ink
plot 0 with lines linecolor rgb muted, \
     data using 1:2 skip 1 with lines linewidth 1.4 linecolor rgb earth_colour, \
     data using 1:3 skip 1 with lines linewidth 1.4 linecolor rgb mars_colour, \
     data using 1:4 skip 1 with lines linewidth 1.4 linecolor rgb other_colour, \
     data using 1:5 skip 1 with points pointtype 6 pointsize 0.6 linewidth 1.2 linecolor rgb text_colour
unset label
set ylabel "slip 1 − V/(rω) [%]"
set yrange [0:100]
plot 60 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:6 skip 1 with points pointtype 6 pointsize 0.6 linewidth 1.2 linecolor rgb text_colour
unset multiplot
