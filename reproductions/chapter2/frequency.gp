# Error of the central difference's frequency against ω Δt: closed form and measured. Strings: style, output, data.
load style
set logscale xy
set xrange [0.02:2.2]
set yrange [1e-5:1]
set format y "10^{%T}"
set xlabel "ω Δt"
set ylabel "ω_{num}/ω − 1"
set label 1 "limit ω Δt = 2" at 1.9,2e-5 right textcolor rgb muted
set arrow 1 from 2,1e-5 to 2,1 nohead dashtype 2 linecolor rgb muted
set label 2 "dotted: (ω Δt)²/24" at 0.1,8e-5 left textcolor rgb muted
set label 3 "closed form" at 0.55,2.6e-2 right textcolor rgb earth_colour
closed(x) = 2/x*asin(x/2) - 1
set samples 400
plot [0.02:1.9999] x**2/24 with lines dashtype 3 linecolor rgb muted, closed(x) with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:3 skip 1 with points pointtype 6 pointsize 0.9 linewidth 1.6 linecolor rgb text_colour
