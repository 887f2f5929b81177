# A window mean against slip, a line for each load. Strings from the program: style, output, data, ylabel, loads.
load style
set xlabel "slip [%]"
set ylabel ylabel
set key outside right top title "load [N]" textcolor rgb ink
set offsets graph 0.03, graph 0.03, graph 0.08, graph 0.05
array hue[6] = [earth_colour, mars_colour, other_colour, unsure_colour, ink, earth_pale]
plot for [k=1:words(loads)] data skip 1 using (strcol(1) eq word(loads, k) ? column(2) : NaN):3 with linespoints \
    pointtype 7 pointsize 0.6 linewidth 1.5 linecolor rgb hue[(k - 1) % 6 + 1] title word(loads, k)
