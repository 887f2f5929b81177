# Load that inverts an element of the soft layer in free sinkage, against its modulus. Strings: style, output, data.
load style
set rmargin 4
set logscale xy
set xrange [8:300]
set xtics (12.5, 25, 50, 100, 200)
set ytics (20, 50, 100, 200, 500, 1000, 2000)
set yrange [20:4000]
set xlabel "Young's modulus of the intermediate layer [kPa]"
set ylabel "load [N]"
set label 1 "stiffness × thickness of the layer" at 14,420 left rotate by 27 textcolor rgb muted
set label 2 "● first load that inverts, ○ last that does not" at 10,30 left textcolor rgb mars_colour font ",12"
set label 3 "text: B3, 170 N" at 50,170 left offset 1,-0.5 textcolor rgb text_colour
plot data using 1:2 skip 1 with lines dashtype 2 linewidth 1.4 linecolor rgb muted, \
     data using 1:($4 > 0 ? $4 : NaN) skip 1 with linespoints pointtype 7 pointsize 0.8 linewidth 1.4 linecolor rgb mars_colour, \
     data using 1:($3 > 0 ? $3 : NaN) skip 1 with points pointtype 6 pointsize 0.9 linewidth 1.4 linecolor rgb mars_colour, \
     "<echo 50,170" using 1:2 with points pointtype 12 pointsize 1.4 linewidth 1.6 linecolor rgb text_colour
