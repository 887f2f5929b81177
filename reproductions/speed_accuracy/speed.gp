# Cost against error of variants, both logarithmic. Strings from the program: style, output, data, front, ylabel, xlow, xhigh,
# ylow, yhigh, floor_y ("" if scatter is not known), kinds (of marks that
# there are). The area of the axes is fixed: the program places the labels in it.
plot_size = "960,560"
load style
set lmargin at screen 77.0/960
set rmargin at screen 936.0/960
set bmargin at screen 62.0/560
set tmargin at screen 538.0/560
set logscale xy
set xrange [xlow+0:xhigh+0]
set yrange [ylow+0:yhigh+0]
set xtics ()
set ytics ()
set for [e=-6:3] for [m in "1 2 5"] xtics add (sprintf("%g", m*10**e) m*10**e)
set for [e=-6:3] for [m in "1 2 5"] ytics add (sprintf("%g", m*10**e) m*10**e)
set xlabel "cost, relative to the text's scene"
set ylabel ylabel
if (strlen(floor_y)) {
    set object 1 rectangle from graph 0, graph 0 to graph 1, first floor_y+0 behind fillcolor rgb "#eef1f3" fillstyle solid noborder
    set label 1 "scatter rules" at graph 0.995, first floor_y+0 right offset 0,-0.7 textcolor rgb muted font ",12"
}
is(kind, c) = strcol(6) eq kind ? column(c) : NaN
# gnuplot warns of a plot without points, so kinds that are not there are left out of the command.
has(kind) = strstrt(kinds, kind) > 0
bars = has("bar") ? "data using 2:3:4:5 with yerrorbars pointtype 0 linewidth 0.8 linecolor rgb earth_pale, " : ""
seen = has("seen") ? "data using (is('seen', 2)):3 with points pointtype 7 pointsize 0.65 linecolor rgb earth_colour, " : ""
hidden = has("hidden") ? "data using (is('hidden', 2)):3 with points pointtype 6 pointsize 0.65 linewidth 1.3 linecolor rgb earth_colour, " : ""
stopped = has("stopped") ? "data using (is('stopped', 2)):3 with points pointtype 2 pointsize 0.7 linewidth 1.5 linecolor rgb bad_colour, " : ""
plot front using 1:2 with lines linewidth 2.2 linecolor rgb mars_pale, \
     data using 2:3:($9-$2):($10-$3) with vectors nohead linewidth 0.6 linecolor rgb muted, \
     @bars @seen @hidden @stopped \
     data using 7:8:1 with labels left noenhanced textcolor rgb ink font ",11"
