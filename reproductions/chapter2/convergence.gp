# Error of four problems of bending and stress against the number of bilinear quads. Strings: style, output, data.
load style
set logscale xy
set xrange [0.8:900]
set yrange [3e-4:1]
set format y "10^{%T}"
set xlabel "quads (rows, arc, radius, side)"
set ylabel "relative error"
names = "cantilever ring ellipse trapezium"
hues = earth_colour." ".mars_colour." ".other_colour." ".muted
array what[4] = ["cantilever", "ring", "NAFEMS LE1", "Cook"]
pick(k, c) = strcol(1) eq word(names,k) ? column(c) : NaN
set label 1 what[1] at 1.2,0.45 left textcolor rgb word(hues,1)
set label 2 what[2] at 150,0.1 left textcolor rgb word(hues,2)
set label 3 what[3] at 70,1.1e-3 left textcolor rgb word(hues,3)
set label 4 what[4] at 40,8e-3 left textcolor rgb word(hues,4)
set label 5 "dotted: slope −2" at 1.1,4e-3 left textcolor rgb muted
plot x < 24 ? 0.2/x**2 : NaN with lines dashtype 3 linecolor rgb muted, \
     for [k=1:4] data using 2:(pick(k,3)) skip 1 with linespoints pointtype 7 pointsize 0.7 linewidth 1.4 linecolor rgb word(hues,k)
