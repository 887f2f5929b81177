# Limits of the explicit loops on whole wheels: 2m/K_d (dashed), frozen wheel with loop (line), measured (points).
# Strings: style, output, data.
load style
set rmargin 4
set logscale y
set xrange [0.6:8.4]
set yrange [1e-6:1e-4]
set format y "10^{%T}"
set xlabel "rings of the rim"
set ylabel "time step [s]"
set label 1 "torque on the rim" at 4.2,3.2e-5 left textcolor rgb mars_colour
set label 2 "drawbar on the hub node" at 4.2,1.5e-6 left textcolor rgb earth_colour
set label 3 "text, Earth" at 8.3,1.15e-5 right textcolor rgb muted font ",12"
set label 4 "text, Mars" at 8.3,5.7e-6 right textcolor rgb muted font ",12"
is(loop, c) = (strcol(2) eq loop && column(1) > 0) ? column(c) : NaN
plot 1e-5 with lines dashtype 3 linecolor rgb muted, 5e-6 with lines dashtype 3 linecolor rgb muted, \
     for [l in "drawbar torque"] data using 1:(is(l,3)) with lines dashtype 2 linewidth 1.4 linecolor rgb (l eq "drawbar" ? earth_colour : mars_colour), \
     for [l in "drawbar torque"] data using 1:(is(l,4)) with lines linewidth 1.6 linecolor rgb (l eq "drawbar" ? earth_colour : mars_colour), \
     for [l in "drawbar torque"] data using 1:(is(l,5)) with points pointtype 7 pointsize 0.7 linecolor rgb (l eq "drawbar" ? earth_colour : mars_colour)
