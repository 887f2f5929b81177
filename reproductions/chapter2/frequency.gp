# Central difference against ω Δt: error of the frequency, and of the decay by damping. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
set logscale xy
set xrange [0.02:2.2]
set yrange [1e-5:1]
set format y "10^{%T}"
set xlabel "ω Δt"
set ylabel "ω_{num}/ω − 1"
set label 1 "limit 2" at 1.6,2e-5 right textcolor rgb muted
set arrow 1 from 2,1e-5 to 2,1 nohead dashtype 2 linecolor rgb muted
set label 2 "dotted: (ω Δt)²/24" at 0.08,6e-5 left textcolor rgb muted
closed(x) = 2/x*asin(x/2) - 1
set samples 400
plot [0.02:1.9999] x**2/24 with lines dashtype 3 linecolor rgb muted, closed(x) with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:3 skip 1 with points pointtype 6 pointsize 0.9 linewidth 1.6 linecolor rgb text_colour
set yrange [1e-6:1]
set ylabel "decay / (ζ ω Δt) − 1"
set label 1 "ζ = 0.2" at 1.6,2e-6 right
set label 2 "dotted: (ζ ω Δt)²/3" at 0.08,6e-6 left
z = 0.2
decay(x) = log((1 + z*x)/(1 - z*x))/(2*z*x) - 1
plot [0.02:1.9999] (z*x)**2/3 with lines dashtype 3 linecolor rgb muted, decay(x) with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:4 skip 1 with points pointtype 6 pointsize 0.9 linewidth 1.6 linecolor rgb text_colour
unset multiplot
