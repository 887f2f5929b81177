# Biaxial compression of the sand for several rolling coefficients. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
pick(alpha, c) = column(1) == alpha ? column(c) : NaN
stats data using 1 skip 1 nooutput
is_full = STATS_max > 1
levels = is_full ? "0 0.5 1 2" : "0 1"
hues = is_full ? "#66717c #009e73 #0072b2 #d55e00" : "#66717c #0072b2"
set xlabel "axial strain [%]"
set xrange [0:*]
set ylabel "σ_1/σ_3"
do for [k=1:words(levels)] { set label k sprintf("α = %s", word(levels,k)) at graph 0.7,graph (0.2+0.07*k) left textcolor rgb word(hues,k) }
plot for [k=1:words(levels)] data using (pick(word(levels,k)+0,2)):3 skip 1 with lines linewidth 1.5 linecolor rgb word(hues,k)
do for [k=1:words(levels)] { unset label k }
set ylabel "volumetric strain [%]"
plot for [k=1:words(levels)] data using (pick(word(levels,k)+0,2)):4 skip 1 with lines linewidth 1.5 linecolor rgb word(hues,k)
unset multiplot
