# One, two and five squeezed discs: predicted (lines) and measured (points) largest step against ζ. Strings: style, output, data.
load style
set rmargin 3
set logscale y
set yrange [0.05:0.9]
set xrange [0:1.05]
set ytics (0.05, 0.1, 0.2, 0.5)
set xlabel "damping ratio ζ"
set ylabel "step / 2 √(m/K)"
names = "symplectic modified-1 modified-2"
colours = "#0072b2 #d55e00 #009e73"
pick(k, n, c) = (strcol(1) eq word(names, k) && column(3) == n) ? column(c) : NaN
set label 1 "symplectic Euler, and modified with 2 evaluations (open)" at 1.03,0.75 right textcolor rgb word(colours,3) font ",11"
set label 2 "modified, 1 evaluation" at 0.08,0.13 left textcolor rgb word(colours,2) font ",12"
set label 3 "from above: 1, 2, 5 discs" at 1.03,0.60 right textcolor rgb muted font ",12"
plot for [k=1:3] for [n in "1 2 5"] data using 2:(pick(k,n+0,4)) skip 1 with lines linewidth 1.3 linecolor rgb word(colours,k), \
     for [k=1:3] for [n in "1 2 5"] data using 2:(pick(k,n+0,5)) skip 1 with points pointtype (k==3?6:7) pointsize (k==3?1.0:0.5) linecolor rgb word(colours,k)
