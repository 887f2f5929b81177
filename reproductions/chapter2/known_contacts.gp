# Left: horizontal force of contacts that are known; right: shares of a contact's force on its segment's two nodes.
# Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
pick(kind, c) = strcol(1) eq kind ? column(c) : NaN
mu = 0.4
f(x) = mu*cos(x*pi/180) - sin(x*pi/180)
set xlabel "β, ahead of bottom dead centre [°]"
set ylabel "f_x / N"
set xrange [-65:85]
set xtics 30
set yrange [-1.1:1.2]
set samples 300
set style fill solid 0.25 noborder
set label 1 "H = Σf_x^+" at -55,0.3 left front textcolor rgb earth_colour
set label 2 "R = Σf_x^−" at 80,-0.12 right front textcolor rgb mars_colour
set label 3 "tan β = µ" at 21.8,0.08 left offset 0.5,0 textcolor rgb muted
plot f(x) > 0 ? f(x) : NaN with filledcurves y1=0 linecolor rgb earth_colour, \
     f(x) < 0 ? f(x) : NaN with filledcurves y1=0 linecolor rgb mars_colour, \
     0 with lines linecolor rgb muted, f(x) with lines linewidth 1.6 linecolor rgb ink, \
     data using (pick("contact",2)):3 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour
unset label 3
set xlabel "place of the contact on its segment"
set ylabel "share of R_3"
set xrange [0:1]
set xtics 0.2
set yrange [0:1]
set label 1 "F_1 = (1 − s) R_3" at 0.25,0.86 left
set label 2 "F_2 = s R_3" at 0.3,0.2 left
plot 1 - x with lines linewidth 1.6 linecolor rgb earth_colour, x with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using (pick("share",2)):3 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour, \
     data using (pick("share",2)):4 with points pointtype 4 linewidth 1.4 linecolor rgb text_colour
unset multiplot
