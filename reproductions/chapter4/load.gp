# W by the integral of stress. Strings from the report: style, output, data, ylabel.
plot_size = "640,460"
load style
set xrange [-8:58]
set xlabel "slip [%]"
set ylabel ylabel
set offsets 0, 0, graph 0.35, graph 0.08
set key outside bottom center horizontal Left reverse samplen 1.8 spacing 1.1 textcolor rgb ink
plot data using 1:6 with lines linewidth 1.2 linecolor rgb muted title "load, 980 N", \
     data using 1:2 with linespoints pointtype 7 pointsize 0.75 linewidth 1.2 linecolor rgb "#0072b2" title "radial parts", \
     data using 1:3 with linespoints pointtype 5 pointsize 0.7 linewidth 1.2 linecolor rgb "#009e73" title "surface normals", \
     data using 1:4 with linespoints pointtype 6 pointsize 0.8 linewidth 1.2 dashtype 2 linecolor rgb "#0072b2" title "radial parts, Eq 4.3 as printed", \
     data using 1:5 with linespoints pointtype 4 pointsize 0.8 linewidth 1.2 dashtype 2 linecolor rgb "#009e73" title "surface normals, Eq 4.3 as printed"
