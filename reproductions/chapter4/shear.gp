# Shear stress of dragged plates against displacement. Strings from the report: style, output, data, ylabel.
load style
set xrange [0:*]
set yrange [0:*]
set xlabel "displacement [mm]"
set ylabel ylabel
array hues[4] = ["#56b4e9", "#0072b2", "#e69f00", "#d55e00"]
hue(k) = hues[(k % 4) + 1]
stats data using 2 every ::1 nooutput
plot for [k=0:STATS_blocks-1] data index k using 2:3 with lines linewidth 0.8 linecolor rgb hue(k), \
     for [k=0:STATS_blocks-1] data index k using 2:4 with lines linewidth 1.8 linecolor rgb hue(k)
