# Load against deflection of each wheel on a rigid flat, a line a lug phase. Strings: style, output, data.
# The dashed lines are the radial stiffnesses that the text found: 15.9 and 53.2 N/mm (section 3.2.2).
load style
set rmargin 4
set xrange [0:*]
set yrange [0:190]
set xlabel "deflection [mm]"
set ylabel "load [N]"
of(wheel, c) = strcol(1) eq wheel ? column(c) : NaN
set label "B3 (dashed: text, 15.9 N/mm)" at 6.9, 92 left textcolor rgb earth_colour font ",12"
set label "B6 (dashed: text, 53.2 N/mm)" at 3.4, 150 left textcolor rgb mars_colour font ",12"
plot [0:12] 15.9*x with lines dashtype 2 linewidth 1.2 linecolor rgb muted, \
     (x < 3.4 ? 53.2*x : NaN) with lines dashtype 2 linewidth 1.2 linecolor rgb muted, \
     data using (of("B3", 3)):4 with points pointtype 7 pointsize 0.4 linecolor rgb earth_colour, \
     data using (of("B6", 3)):4 with points pointtype 7 pointsize 0.4 linecolor rgb mars_colour
