# Gross tractive effort and sinkage of a short travel against the step. Strings: style, output, data.
plot_size = "960,380"
load style
set multiplot layout 1,2 margins 0.09,0.985,0.16,0.95 spacing 0.10
set logscale x
set xrange [1.2e-5:1e-4]
set xtics ("1.5·10^{−5}" 1.5e-5, "3·10^{−5}" 3e-5, "5·10^{−5}" 5e-5, "8·10^{−5}" 8e-5)
set xlabel "time step [s]"
set ylabel "gross tractive effort [N]"
set yrange [0:*]
is(s, c) = strcol(2) eq s ? column(c) : NaN
set label 1 "limit" at graph 0.55,0.40 left textcolor rgb earth_colour
set label 2 "raw sign" at graph 0.55,0.30 left textcolor rgb mars_colour
plot for [s in "limit sign"] data using 1:(is(s,4)) with points pointtype 7 pointsize 0.9 linecolor rgb (s eq "limit" ? earth_colour : mars_colour)
unset label
set ylabel "sinkage [mm]"
set yrange [*:0]
plot for [s in "limit sign"] data using 1:(is(s,5)) with points pointtype 7 pointsize 0.9 linecolor rgb (s eq "limit" ? earth_colour : mars_colour)
unset multiplot
