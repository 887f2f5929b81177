# Spin that Eq 2.18 leaves of a braked disc: as a sign and as a limit. Strings: style, output, data.
load style
set rmargin 4
set logscale xy
set xrange [8e-7:3e-4]
set yrange [1e-5:1]
set format xy "10^{%T}"
set xlabel "time step [s]"
set ylabel "spin left / spin before"
set label 1 "raw sign of ω" at 4e-6,6e-3 right textcolor rgb mars_colour
set label 2 "line: half of M Δt / (I ω_0)" at 2e-5,1.2e-3 left textcolor rgb muted
set label 3 "as a limit: nothing is left at any step" at 1e-6,2e-5 left textcolor rgb earth_colour
plot data using 1:4 skip 1 with lines linewidth 1.4 linecolor rgb muted, \
     data using 1:2 skip 1 with points pointtype 7 pointsize 0.8 linecolor rgb mars_colour
