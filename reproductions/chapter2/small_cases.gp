# Small exact cases of one to ten discs: closed forms as lines, computed as points. Strings: style, output, data.
plot_size = "900,560"
load style
set multiplot layout 2,3
pick(kind, c) = strcol(1) eq kind ? column(c) : NaN
points = "with points pointtype 6 pointsize 0.8 linewidth 1.3 linecolor rgb text_colour"
squares = "with points pointtype 4 pointsize 0.8 linewidth 1.3 linecolor rgb text_colour"
set macros
set samples 300
g = 9.81
set title "launched sliding" textcolor rgb ink offset 0,-0.6
set xlabel "time [s]"
set ylabel "speed [m/s]"
set xrange [0:0.06]
set xtics 0.02
set yrange [0:0.32]
end = 0.3/(3*0.3*g)
v(x) = x < end ? 0.3 - 0.3*g*x : 0.2
w(x) = x < end ? 2*0.3*g*x : 0.2
set label 1 "v" at 0.012,0.285 left textcolor rgb earth_colour
set label 2 "ω r" at 0.012,0.05 left textcolor rgb mars_colour
plot v(x) with lines linewidth 1.6 linecolor rgb earth_colour, w(x) with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using (pick("launch",2)):3 @points, data using (pick("launch",2)):4 @squares
unset label
set title "sliding block"
set ylabel "way [mm]"
set xrange [0:0.1]
set xtics 0.05
set yrange [0:12.5]
stop = 0.3/(0.4*g)
s(x) = 1e3*(x < stop ? 0.3*x - 0.2*g*x*x : 0.3*stop/2)
plot s(x) with lines linewidth 1.6 linecolor rgb earth_colour, data using (pick("block",2)):3 @points
set title "column of ten discs"
set xlabel "contact, from the floor"
set ylabel "overlap [m g/K_n]"
set xrange [0:11]
set xtics 2
set yrange [0:11]
plot [1:10] 11 - x with lines linewidth 1.6 linecolor rgb earth_colour, data using (pick("column",2)):3 @points
set title 'Chung \& Ooi, case 3'
set xlabel "restitution wanted"
set ylabel "rebound / impact"
set xrange [0.2:1.05]
set xtics 0.2
set yrange [0.2:1.05]
plot x with lines linewidth 1.6 linecolor rgb earth_colour, data using (pick("case3",2)):3 @points, data using (pick("case3",2)):4 @squares
set title 'Chung \& Ooi, case 7'
set logscale x
set xlabel "spin before [rad/s]"
set ylabel "spin after / before"
set xrange [15:3000]
set xtics (20,100,500,2000)
set yrange [-0.1:1.1]
plot 0 with lines linecolor rgb muted, data using (pick("case7",2)):($3/$2) @points, data using (pick("case7",2)):($4/$2) with points pointtype 2 pointsize 0.6 linecolor rgb mars_colour
unset logscale x
set title "step limit of a pair"
set logscale y
set xlabel "Δt / (2/√(2K_n/m))"
set ylabel "growth in 100 steps"
set format y "10^{%T}"
set xrange [0.983:1.005]
set xtics 0.01
set yrange [1:1e9]
set ytics 1e3
plot data using (pick("growth",2)):3 with lines linewidth 1.6 linecolor rgb earth_colour, data using (pick("growth",2)):4 @points
unset multiplot
