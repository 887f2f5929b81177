# Curves of soil tests. Strings from the program: style, output, data, xlabel, ylabel, curves (names in column 1).
load style
set xrange [0:*]
set xlabel xlabel
set ylabel ylabel
hue(name) = name eq "low" ? other_colour : name eq "high" ? mars_colour : name eq "fit" ? "#d5dade" : earth_colour
pick(name) = strcol(1) eq name ? column(2) : NaN
if (curves eq "centres") {
    set size ratio -1
    plot data skip 1 using (pick("centres")):3 with points pointtype 7 pointsize 0.25 linecolor rgb earth_colour
} else {
    plot for [name in curves] data skip 1 using (pick(name)):3 with lines linewidth (name eq "fit" ? 3 : 1.2) linecolor rgb hue(name)
}
