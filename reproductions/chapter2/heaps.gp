# Heaps at rest, discs at true size. Strings: style, output, data.
plot_size = "900,420"
load style
unset border
unset tics
unset grid
set style fill solid 0.85 noborder
set multiplot layout 2,2 margins 0.02,0.98,0.02,0.92 spacing 0.04,0.12
set xrange [-0.01:0.52]
set yrange [-0.005:0.135]
set size ratio -1
names = "sliding-low sliding-high rolling-low rolling-high"
array what[4] = ["µ lowest, α = 1", "µ highest, α = 1", "α = 0, µ = 0.6", "α highest, µ = 0.6"]
do for [k=1:4] {
    set title what[k] textcolor rgb ink offset 0,-0.6
    plot data using (strcol(1) eq word(names,k) ? $2 : NaN):3:4 with circles linecolor rgb earth_pale, \
         0 with lines linecolor rgb muted
}
unset multiplot
