# Radial stiffness of two wheels here and by CalculiX on the same mesh. Strings: style, output, data.
load style
set logscale xy
set xlabel "CalculiX [N/mm]"
set ylabel "here [N/mm]"
set xrange [4:100]
set yrange [10:100]
set xtics (5,10,20,50,100)
set ytics (10,20,50,100)
plot x with lines linecolor rgb muted, data using 4:3 skip 1 with points pointtype 6 linewidth 1.4 linecolor rgb earth_colour, \
     data using 4:3:(sprintf("%s, plane %s", strcol(1), strcol(2))) skip 1 with labels right offset -1,0.4 textcolor rgb ink
