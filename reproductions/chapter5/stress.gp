# Fig 5-9: vertical stress of every disc of one block at 3 % of compression, prepared as the text says. Strings: style, output, data.
plot_size = "460,460"
load style
unset grid
set size ratio -1
set xrange [0:0.15]
set yrange [0:0.2]
set xtics 0.05
set ytics 0.05
set xlabel "x [m]"
set ylabel "y [m]"
set style fill solid noborder
set cbrange [-150:0]
set cbtics 50 textcolor rgb ink
set cblabel "vertical stress [kPa]" offset 1 textcolor rgb ink
set palette defined (0 "#fde725", 0.25 "#5ec962", 0.5 "#21918c", 0.75 "#3b528b", 1 "#440154") negative
plot data using (strcol(1) eq "text" ? $2 : NaN):3:4:($5 / 1000) with circles linecolor palette
