# Error over tolerance of every number, coloured by verdict. Strings: style, output, data, verdicts (those that occur).
plot_size = "960,430"
load style
stats data using 1 nooutput
rows = STATS_max + 1
set lmargin at screen 0.40
set rmargin at screen 0.97
set xrange [-3.2:3.2]
set yrange [rows - 0.4:-1.3]
set xtics ("≤ −3" -3, "−2" -2, "−1" -1, "0" 0, "1" 1, "2" 2, "≥ 3" 3)
set xlabel "(computed − text) / tolerance"
set grid x noy
set border 1
unset ylabel
set object 1 rectangle from -1,rows-0.4 to 1,-1.3 behind fillcolor rgb "#e6f3ee" fillstyle solid noborder
set arrow 1 from 0,-0.5 to 0,rows-0.4 nohead back linewidth 1.2 linecolor rgb muted
is(verdict) = strcol(4) eq verdict ? column(3) : NaN
set label 2 "within tolerance" at 0,-0.9 center textcolor rgb muted font ",12"
hue(v) = v eq "match" ? good_colour : v eq "unresolved" ? unsure_colour : v eq "differs-explained" ? known_colour : bad_colour
plot for [v in verdicts] data using (0):(is(v) == is(v) ? $1 : NaN):(is(v)):(0) \
         with vectors nohead linewidth 2 linecolor rgb hue(v), \
     for [v in verdicts] data using (is(v)):1 with points pointtype 7 pointsize 0.9 linecolor rgb hue(v), \
     data using (-3.2):1:ytic(2) with dots linecolor rgb "white"
