# Error of restitution against the step for three integrators. Strings: style, output, data.
load style
set lmargin 11
set logscale xy
set xrange [4e-4:0.03]
set yrange [1e-8:1]
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "time step / duration of the contact"
set ylabel "relative error of e"
pick(name, c) = strcol(1) eq name ? column(c) : NaN
names = "symplectic modified-1 modified-2"
colours = "#0072b2 #d55e00 #009e73"
set label 1 "symplectic Euler" at 4.2e-3,1e-3 left textcolor rgb word(colours,1)
set label 2 "modified, 1 evaluation" at 4.6e-4,3e-5 left textcolor rgb word(colours,2)
set label 3 "2 evaluations" at 3.5e-3,5e-7 left textcolor rgb word(colours,3)
set label 4 "dotted: slopes 1 and 2" at 4.6e-4,0.06 left textcolor rgb muted
set label 5 "open: contact begins between two steps" at 4.6e-4,0.3 left textcolor rgb muted
plot [4e-4:0.03] 0.7*x with lines dashtype 3 linecolor rgb muted, 3*x**2 with lines dashtype 3 linecolor rgb muted, \
     for [k=1:3] data using 2:(pick(word(names,k),3)) skip 1 with linespoints pointtype 7 pointsize 0.7 linewidth 1.4 linecolor rgb word(colours,k), \
     for [k=1:3] data using 2:(pick(word(names,k),4)) skip 1 with points pointtype 6 pointsize 0.9 linecolor rgb word(colours,k)
