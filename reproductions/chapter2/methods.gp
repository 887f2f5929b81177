# Motion resistance against slip by two methods of driving and two definitions. Strings: style, output, data.
plot_size = "760,400"
load style
set multiplot layout 1,2
pick(method, quantity, c) = strcol(1) eq method && strcol(2) eq quantity ? column(c) : NaN
methods = "pid prescribed"
hues = earth_colour." ".mars_colour
set xlabel "slip [%]"
set xrange [-5:65]
set xtics 20
set ylabel "motion resistance R [N]"
set yrange [*:0]
set title "R = Σf_x^- (Eq 2.14)" textcolor rgb ink
set label 1 "PID" at graph 0.45,graph 0.12 left textcolor rgb earth_colour
set label 2 "V and ω prescribed" at graph 0.45,graph 0.05 left textcolor rgb mars_colour
plot for [k=1:2] data using (pick(word(methods,k),"resistance",3)+(k*2-3)*0.7):4:5 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb word(hues,k), \
     for [k=1:2] data using (pick(word(methods,k),"resistance",3)):4 with lines linecolor rgb word(hues,k)
unset label
set title "R = P_d − T/r_e (Eqs 3.5–3.7)" textcolor rgb ink
plot for [k=1:2] data using (pick(word(methods,k),"motion_resistance",3)+(k*2-3)*0.7):4:5 with yerrorbars pointtype 7 pointsize 0.6 linecolor rgb word(hues,k), \
     for [k=1:2] data using (pick(word(methods,k),"motion_resistance",3)):4 with lines linecolor rgb word(hues,k)
unset multiplot
