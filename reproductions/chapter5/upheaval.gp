# Rise of the surface at the end of travel, 70 %, with both counts of discs in a block. Strings from the report: style, output, data, ylabel.
load style
set xrange [1.45:2.05]
set yrange [-12:10]
set xlabel "x [m]"
set ylabel ylabel
set key outside bottom center horizontal Left reverse samplen 1.8 spacing 1.1 maxcols 3 textcolor rgb ink
set arrow 1 from 1.7675, graph 0 to 1.7675, graph 1 nohead dashtype 2 linewidth 1 linecolor rgb muted
set label 1 "front edge of the tyre" at 1.775, graph 0.06 textcolor rgb muted
rise(run) = strcol(1) eq run ? $3 : NaN
line(n) = word("small-s70-r1-discs1451 middle-s70-r1-discs1451 large-s70-r1-discs1451 small-s70-r1 large-s70-r1 discs-s70-r1", n)
name(n) = n == 1 ? "small, 1451 discs" : n == 2 ? "middle, 1451" : n == 3 ? "large, 1451" : n == 4 ? "small, 1431" : n == 5 ? "large, 1431" : "discs only"
hue(n) = n == 1 || n == 4 ? "#d55e00" : n == 2 ? "#e69f00" : n == 3 || n == 5 ? "#009e73" : "#111111"
plot for [n=1:3] data using 2:(rise(line(n))) with lines linewidth 1.8 linecolor rgb hue(n) title name(n), \
     for [n=4:5] data using 2:(rise(line(n))) with lines linewidth 1.2 dashtype 2 linecolor rgb hue(n) title name(n), \
     data using 2:(rise(line(6))) with lines linewidth 1.2 linecolor rgb hue(6) title name(6)
