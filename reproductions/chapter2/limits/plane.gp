# The explicit PID's plane: stable below the line; ours is semi-implicit and has no boundary. Strings: style, output, data.
load style
set rmargin 4
set logscale y
set xrange [0:4.6]
set yrange [5e-7:20]
set format y "10^{%T}"
set xlabel "K_d Δt / m"
set ylabel "K_p Δt² / m"
set label 1 "K_p Δt² + 2 K_d Δt = 4 m" at 1.5,7 left textcolor rgb earth_colour
set label 2 "stable" at 0.9,1e-2 center textcolor rgb good_colour
set label 3 "runs away" at 2.7,1e-2 center textcolor rgb bad_colour
set arrow 1 from 2,5e-7 to 2,1e-1 nohead dashtype 2 linecolor rgb earth_colour
boundary(x) = x < 2 ? 4 - 2*x : NaN
set samples 800
mark(s) = strcol(4) eq s ? column(3) : NaN
plot boundary(x) with lines linewidth 1.8 linecolor rgb earth_colour, \
     data index 0 using 1:3 skip 1 with points pointtype 7 pointsize 0.6 linecolor rgb earth_colour, \
     data index 1 using 2:(mark("explicit")) with points pointtype 12 pointsize 1.2 linewidth 1.6 linecolor rgb text_colour, \
     data index 1 using 2:(mark("semi-implicit")) with points pointtype 4 pointsize 1.1 linewidth 1.6 linecolor rgb other_colour, \
     data index 1 every 2::0 using 2:3:1 with labels left offset 0.3,0.7 textcolor rgb ink font ",11", \
     data index 1 every 2::1 using 2:3:1 with labels left offset 0.3,-0.7 textcolor rgb ink font ",11"
