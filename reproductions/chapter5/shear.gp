# Mean shear stress of discs and soil elements as tiles. Strings from the report: style, output, data.
plot_size = "900,330"
load style
# Before the ranges are set: stats minds them.
stats data using (strcol(1) eq "element") name "ELEMENT" nooutput
unset grid
set xrange [0:2.4]
set yrange [0:0.45]
set xtics 0.4
set ytics 0.1
set xlabel "x [m]"
set ylabel "y [m]"
set cblabel "shear stress [kPa]" offset 1.5 textcolor rgb ink
set cbrange [-12:12]
set cbtics 6 textcolor rgb ink
set palette defined (-1 "#08306b", -0.5 "#4a98c9", 0 "#f7f7f7", 0.5 "#f08a3c", 1 "#7f2704")
set style fill solid noborder
is(what) = strcol(1) eq what ? $2 : NaN
axle = "data using (is('axle')):(0):(0):(0.45) with vectors nohead dashtype 2 linewidth 1.2 linecolor rgb text_colour"
tiles = "data using (strcol(1) eq 'axle' ? NaN : $2):3:4:5:6 with boxxyerror linecolor palette"
outlines = "data using (is('element')):3:4:5 with boxxyerror fillstyle empty border linewidth 0.6 linecolor rgb '#8a7f66'"
if (ELEMENT_max > 0) { plot @tiles, @outlines, @axle } else { plot @tiles, @axle }
