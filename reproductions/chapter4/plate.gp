# Sinkage of plates against pressure. Strings from the report: style, output, data, ylabel.
load style
set xrange [0:*]
set yrange [0:*] reverse
set xlabel "pressure [kPa]"
set ylabel ylabel
plot data using 1:3 with lines linewidth 1.6 linecolor rgb muted, \
     data using 1:2 with points pointtype 7 pointsize 0.9 linecolor rgb earth_colour
