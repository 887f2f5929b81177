# A bed that settles: rms speed against time, as it is and with time and speed over √(g/9.81). Strings: style, output, data.
plot_size = "960,380"
load style
set multiplot layout 1,2 margins 0.085,0.985,0.16,0.95 spacing 0.09
set logscale y
set yrange [1e-4:1]
set format y "10^{%T}"
set xlabel "time [s]"
set ylabel "rms speed [m/s]"
set xrange [0:2]
colours = "#0072b2 #d55e00 #66717c"
names = "Earth Mars Moon"
g(k) = k == 1 ? 9.81 : k == 2 ? 3.71 : 1.62
set for [k=1:3] label k word(names,k) at graph 0.95, 1 - 0.07*k right textcolor rgb word(colours,k)
plot for [k=1:3] data using 1:(column(1+k)) skip 1 with lines linewidth 1.5 linecolor rgb word(colours,k)
unset label
set xlabel "time × √(g/9.81) [s]"
set ylabel "rms speed × √(9.81/g) [m/s]"
set xrange [0:1.2]
plot for [k=1:3] data using ($1*sqrt(g(k)/9.81)):(column(1+k)*sqrt(9.81/g(k))) skip 1 with lines linewidth 1.5 linecolor rgb word(colours,k)
unset multiplot
