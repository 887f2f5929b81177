# Friction angles, dilatancy and modulus of the sand against the rolling coefficient. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
set xlabel "α (full chord)"
set xrange [-0.1:2.1]
set ylabel "angle [°]"
set yrange [0:55]
set label 1 "φ, peak" at 1.5,graph 0.83 left textcolor rgb earth_colour
set label 2 "φ, end" at 0.35,graph 0.62 left textcolor rgb other_colour
set label 3 "ψ, dilatancy" at 1.2,graph 0.27 left textcolor rgb mars_colour
plot data using 1:2:3 skip 1 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb earth_colour, data using 1:2 skip 1 with lines linecolor rgb earth_colour, \
     data using 1:4:5 skip 1 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb other_colour, data using 1:4 skip 1 with lines linecolor rgb other_colour, \
     data using 1:6:7 skip 1 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb mars_colour, data using 1:6 skip 1 with lines linecolor rgb mars_colour
unset label
set ylabel "secant modulus E_{50} [MPa]"
set yrange [0:*]
plot data using 1:8:9 skip 1 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb earth_colour, data using 1:8 skip 1 with lines linecolor rgb earth_colour
unset multiplot
