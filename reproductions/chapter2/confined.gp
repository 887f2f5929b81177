# Confined compression of the sand, and the triangular lattice of the same springs. Strings: style, output, data.
load style
set xlabel "strain [%]"
set ylabel "stress [kPa]"
set xrange [0:3.1]
set yrange [0:45]
lattice = sqrt(3.)/4*(3*1e5 + 2.5e4)/0.1
set label 1 "triangular lattice" at 1.75,33 right textcolor rgb muted
set label 2 "samples of the sand" at 1.3,5 left textcolor rgb earth_colour
stats data using 1 skip 1 nooutput
seeds = int(STATS_max)
plot lattice*x*1e-5 with lines dashtype 2 linecolor rgb muted, \
     for [s=1:seeds] data using (column(1) == s ? $2 : NaN):3 skip 1 with lines linewidth 1.2 linecolor rgb earth_colour
