# Error of a fall and of a turn under a constant load against the step. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
set logscale xy
set format y "10^{%T}"
set xrange [10:130]
set xtics (12.5,25,50,100)
set yrange [1e-16:1]
set xlabel "step [µs]"
set label 1 "symplectic Euler, slope 1" at 11,6e-3 left textcolor rgb earth_colour
set label 2 "modified Euler: round-off" at 11,3e-11 left textcolor rgb mars_colour
pick(name, c) = strcol(1) eq name ? column(c) : NaN
names = "symplectic modified-1 modified-2"
hues = earth_colour." ".mars_colour." ".mars_colour
do for [c=3:4] {
    set ylabel (c == 3 ? "error of a fall of 0.1 s" : "error of a turn in 0.2 s")
    plot for [k=1:3] data using 2:(pick(word(names,k),c)) with linespoints pointtype (k == 3 ? 4 : 6) pointsize (k == 3 ? 1.4 : 0.8) linewidth 1.4 linecolor rgb word(hues,k)
}
unset multiplot
