# Tip of a slender cantilever under a large end load. Strings: style, output, data.
load style
pick(kind, c) = strcol(1) eq kind ? column(c) : NaN
set xlabel "P L²/(E I)"
set ylabel "tip displacement / L"
set xrange [0:10.5]
set yrange [0:0.9]
set label 1 "rise" at 5.5,0.76 left textcolor rgb earth_colour
set label 2 "shortening" at 5.5,0.35 left textcolor rgb mars_colour
plot data using (pick("closed",2)):3 with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using (pick("closed",2)):4 with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using (pick("quads",2)):3 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour, \
     data using (pick("quads",2)):4 with points pointtype 4 linewidth 1.4 linecolor rgb text_colour
