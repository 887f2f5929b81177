# Node force of a square that only turns: the code's element and Eq 2.4 to the letter. Strings: style, output, data.
load style
set lmargin 11
set logscale y
set format y "10^{%T}"
set xrange [0:180]
set xtics 30
set yrange [1e-18:10]
set xlabel "rotation [°]"
set ylabel "largest node force / (E t h)"
set label 1 "f = K u, to the letter" at 60,0.03 left textcolor rgb mars_colour
set label 2 "line: (1 − cos θ)/(2(1 − ν))" at 60,2e-3 left textcolor rgb muted
set label 3 "turned frames (here)" at 60,1e-14 left textcolor rgb earth_colour
plot data using 1:4 skip 1 with lines linewidth 1.2 linecolor rgb muted, \
     data using 1:3 skip 1 with points pointtype 6 linewidth 1.2 linecolor rgb mars_colour, \
     data using 1:2 skip 1 with points pointtype 7 pointsize 0.5 linecolor rgb earth_colour
