# Restitution and duration of a collision against the damping ratio. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
pick(kind, end, c) = strcol(1) eq kind && strcol(2) eq end ? column(c) : NaN
set xlabel "damping ratio ζ"
set xrange [0:0.75]
set ylabel "restitution e"
set yrange [0:1]
set label 1 "no attraction" at 0.36,0.5 left textcolor rgb earth_colour
set label 2 "attraction" at 0.27,0.2 right textcolor rgb mars_colour
plot data using (pick("closed","force",3)):4 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using (pick("closed","overlap",3)):4 with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using (pick("measured","force",3)):4 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour, \
     data using (pick("measured","overlap",3)):4 with points pointtype 4 linewidth 1.4 linecolor rgb text_colour
set ylabel "duration t ω_0"
set yrange [2:4.5]
set label 1 "no attraction" at 0.4,2.75 left
set label 2 "attraction" at 0.38,3.7 right
plot data using (pick("closed","force",3)):5 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using (pick("closed","overlap",3)):5 with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using (pick("measured","force",3)):5 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour, \
     data using (pick("measured","overlap",3)):5 with points pointtype 4 linewidth 1.4 linecolor rgb text_colour
unset multiplot
