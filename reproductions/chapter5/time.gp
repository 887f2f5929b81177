# Time of a travel against its number of discs, both over discs only. Strings from the report: style, output, data, ylabel.
plot_size = "640,560"
load style
set xrange [0:0.6]
set yrange [0:0.6]
set xlabel "discs over those of discs only [-]"
set ylabel ylabel
set key outside bottom center horizontal Left reverse samplen 1.8 spacing 1.1 textcolor rgb ink
of(region) = strcol(1) eq region ? $4 : NaN
hue(n) = n == 1 ? "#d55e00" : n == 2 ? "#e69f00" : n == 3 ? "#009e73" : "#cc79a7"
names = "small middle large row"
plot 0.105 + 0.797 * x with lines linewidth 1.3 dashtype 2 linecolor rgb text_colour title "line through the text's three ratios", \
     "-" using 1:2 with points pointtype 12 pointsize 1.2 linewidth 1.2 linecolor rgb text_colour title "the text: 5, 7, 9 blocks of discs", \
     x with lines linewidth 1.0 dashtype 3 linecolor rgb muted title "time as discs", \
     for [n=1:4] data using 3:(of(word(names, n))) with points pointtype 7 pointsize 0.7 linecolor rgb hue(n) title word(names, n)
0.15676,0.23
0.21947,0.28
0.28217,0.33
e
