# Largest stable step of a bed of 300 discs against ζ, in units of 2√(m_min/K_n): frozen network (lines), first heating
# (filled), blow-up (open). Left: poured without friction, right: with µ = 0.6. Strings: style, output, data.
plot_size = "960,430"
load style
set multiplot layout 1,2 margins 0.085,0.985,0.15,0.90 spacing 0.06
set logscale y
set yrange [0.02:1.2]
set ytics (0.02, 0.05, 0.1, 0.2, 0.5, 1)
set xrange [0:1.05]
set xlabel "damping ratio ζ"
names = "symplectic modified-1 modified-2"
colours = "#0072b2 #d55e00 #009e73"
pick(k, mu, c) = (strcol(1) eq word(names, k) && column(3) == mu && column(c) > 0) ? column(c) : NaN
do for [p=1:2] {
  mu = p == 1 ? 0.0 : 0.6
  set ylabel (p == 1 ? "step / 2 √(m/K)" : "")
  set title (p == 1 ? "without friction" : "µ = 0.6") textcolor rgb ink
  set label 1 "default 4·10^{−5} s" at 1.04, 0.1106*1.13 right textcolor rgb muted font ",12"
  set label 2 "text 10^{−5} s" at 1.04, 0.02766*1.13 right textcolor rgb muted font ",12"
  if (p == 2) {
    set label 3 "symplectic Euler" at 0.42,0.62 left textcolor rgb word(colours,1) font ",12"
    set label 4 "modified, 1 evaluation" at 0.42,0.80 left textcolor rgb word(colours,2) font ",12"
    set label 5 "modified, 2 evaluations" at 0.42,1.0 left textcolor rgb word(colours,3) font ",12"
  } else {
    set label 6 "line: frozen network" at 0.40,1.0 left textcolor rgb muted font ",12"
    set label 7 "●: first heating, ○: blow-up" at 0.40,0.80 left textcolor rgb muted font ",12"
  }
  plot 0.1106 with lines dashtype 2 linecolor rgb muted, 0.02766 with lines dashtype 3 linecolor rgb muted, \
    for [k=1:3] data using 2:(pick(k,mu,5)) skip 1 with lines linewidth 1.6 linecolor rgb word(colours,k), \
    for [k=1:3] data using 2:(pick(k,mu,6)) skip 1 with points pointtype 7 pointsize 0.7 linecolor rgb word(colours,k), \
    for [k=1:3] data using 2:(pick(k,mu,7)) skip 1 with points pointtype 6 pointsize 0.9 linewidth 1.3 linecolor rgb word(colours,k)
  unset label
}
unset multiplot
