# The patch of distorted quads at rest and strained, and confined compression of soil elements. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
pick(kind, c) = strcol(1) eq kind ? column(c) : NaN
set size ratio -1
set xrange [-0.02:0.46]
set yrange [-0.02:0.34]
set xtics 0.1
set ytics 0.1
set xlabel "x [m]"
set ylabel "y [m]"
plot data using (pick("patch",2)):3 skip 1 with lines linecolor rgb muted, \
     data using (pick("patch",4)):5 skip 1 with lines linewidth 1.6 linecolor rgb earth_colour
set size noratio
set xlabel "strain [%]"
set ylabel "stress [kPa]"
set xrange [0:3.2]
set yrange [0:75]
set xtics 1
set ytics 20
modulus = 1.7e3*0.7/(1.3*0.4)
plot modulus*x/100 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using (pick("confined",2)):3 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour
unset multiplot
