# Porosity of ten beds, the text's value and random close packing. Strings: style, output, data.
load style
set xlabel "packing seed"
set ylabel "porosity"
set xrange [0.5:10.5]
set xtics 1
set yrange [0.14:0.17]
set label 1 "text: 0.1557 (section 4.2.4)" at 0.7,0.1567 left textcolor rgb text_colour
set label 2 "random close packing at low skewness: 0.160" at 0.7,0.161 left textcolor rgb muted
plot 0.1557 with lines linewidth 1.2 linecolor rgb text_colour, 0.160 with lines dashtype 2 linecolor rgb muted, \
     data using 1:2 skip 1 with points pointtype 7 pointsize 0.9 linecolor rgb earth_colour
