# Slope on which a rolling disc keeps its speed, against the rolling coefficient. Strings: style, output, data.
load style
set xlabel "α (b: half chord)"
set ylabel "tan θ of the neutral slope"
set xrange [0:8.5]
set yrange [0:*]
set label 1 "Eq 2.18: α b/r" at graph 0.45,0.62 right textcolor rgb earth_colour
plot data using 1:2 skip 1 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:3 skip 1 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour
