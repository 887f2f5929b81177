# Soil and wheel at the end of a run, discs coloured by speed. Strings: style, output, data (discs), wheel.
plot_size = "1500,620"
load style
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set size ratio -1
set lmargin at screen 0.005
set rmargin at screen 0.995
set tmargin at screen 0.995
set bmargin at screen 0.10
stats data using 1 nooutput name "X"
stats data using 2 nooutput name "Y"
stats wheel using 3 nooutput name "W"
set xrange [X_min - 0.003:X_max + 0.003]
set yrange [Y_min - 0.003:W_max + 0.01]
# Pale soil at rest, darker where it moves: readable without colour.
set palette defined (0 "#efe3c8", 0.25 "#e3b96b", 0.6 "#c0602a", 1 "#5b1f3a")
set cbrange [0:0.25]
set colorbox horizontal user origin 0.40, 0.045 size 0.30, 0.022
set cbtics 0.05 scale 0 offset 0, 0.5
set label 1 "speed of the soil [m/s]" at screen 0.39, 0.057 right textcolor rgb ink
plot data using 1:2:3:4 with circles fillstyle solid 1 noborder linecolor palette, \
     wheel using 2:3:1 with polygons fillstyle solid 1 border linecolor rgb "#54626e" fillcolor rgb "#c9d3da"
