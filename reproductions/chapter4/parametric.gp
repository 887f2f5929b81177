# The semi-empirical wheel against slip. Strings from the report: style, output, data, ylabel.
load style
set xlabel "slip [%]"
set ylabel ylabel
set key top left samplen 1.8 spacing 1.1 textcolor rgb ink
set xzeroaxis linecolor rgb muted linewidth 0.8
set xrange [-8:58]
plot data using 1:2 with lines linewidth 1.6 linecolor rgb "#0072b2" title "H", \
     data using 1:3 with lines linewidth 1.6 linecolor rgb "#d55e00" title "P_d", \
     data using 1:4 with lines linewidth 1.6 linecolor rgb "#009e73" title "R"
