# H, P_d and R by both ways. Strings from the report: style, output, data, ylabel.
plot_size = "640,460"
load style
set xrange [-8:58]
set xlabel "slip [%]"
set ylabel ylabel
set key outside bottom center horizontal Left reverse samplen 1.8 spacing 1.1 textcolor rgb ink
set xzeroaxis linecolor rgb muted linewidth 0.8
h = "#0072b2"; p = "#d55e00"; r = "#009e73"
plot data using 1:2 with lines linewidth 1.6 linecolor rgb h title "H, controllers", \
     data using 1:5 with points pointtype 7 pointsize 0.75 linecolor rgb h title "H, integral", \
     data using 1:8 with points pointtype 6 pointsize 0.75 linewidth 1.2 linecolor rgb h title "H, Eq 4.4 as printed", \
     data using 1:3 with lines linewidth 1.6 linecolor rgb p title "P_d, controllers", \
     data using 1:6 with points pointtype 7 pointsize 0.75 linecolor rgb p title "P_d, integral", \
     data using 1:4 with lines linewidth 1.6 linecolor rgb r title "R, controllers", \
     data using 1:7 with points pointtype 7 pointsize 0.75 linecolor rgb r title "R, integral", \
     data using 1:9 with points pointtype 6 pointsize 0.75 linewidth 1.2 linecolor rgb r title "R, Eq 4.5 as printed"
