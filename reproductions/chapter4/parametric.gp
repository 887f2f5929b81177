# The semi-empirical wheel, and the travels beside it. Strings from the report: style, output, data, ylabel.
plot_size = "640,480"
load style
set xrange [-8:58]
set xlabel "slip [%]"
set ylabel ylabel
set key outside bottom center horizontal Left reverse samplen 1.8 spacing 1.1 textcolor rgb ink
set xzeroaxis linecolor rgb muted linewidth 0.8
h = "#0072b2"; p = "#d55e00"; r = "#009e73"
plot data index 0 using 1:2 with lines linewidth 1.6 linecolor rgb h title "H, semi-empirical", \
     data index 1 using 1:2 with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb h title "H, controllers", \
     data index 1 using 1:5 with points pointtype 7 pointsize 0.7 linecolor rgb h title "H, integral", \
     data index 0 using 1:3 with lines linewidth 1.6 linecolor rgb p title "P_d, semi-empirical", \
     data index 1 using 1:3 with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb p title "P_d, controllers", \
     data index 1 using 1:6 with points pointtype 7 pointsize 0.7 linecolor rgb p title "P_d, integral", \
     data index 0 using 1:4 with lines linewidth 1.6 linecolor rgb r title "R, semi-empirical", \
     data index 1 using 1:4 with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb r title "R, controllers", \
     data index 1 using 1:7 with points pointtype 7 pointsize 0.7 linecolor rgb r title "R, integral"
