# Error of a cantilever's tip deflection against the rows of quads. Strings: style, output, data.
load style
set logscale xy
set xrange [0.8:20]
set yrange [1e-3:1]
set xtics (1,2,4,8,16)
set format y "10^{%T}"
set xlabel "rows of square quads over the height"
set ylabel "1 − tip deflection / Timoshenko"
set label 1 "slope −2" at 9,0.012 left textcolor rgb muted
plot 0.66/x**2 with lines dashtype 3 linecolor rgb muted, \
     data using 1:2 skip 1 with linespoints pointtype 7 pointsize 0.8 linewidth 1.4 linecolor rgb earth_colour
