# Torque, net traction and sinkage against travel. Strings from the report: style, output, data, run, window_from,
# window_to, torque, pull, sinkage.
plot_size = "960,620"
load style
set multiplot layout 3,1 margins 0.085,0.90,0.12,0.985 spacing 0.035
set xrange [0:*]
set autoscale xfixmax
set format x ""
a = window_from + 0
b = window_to + 0
set object 1 rectangle from first a, graph 0 to first b, graph 1 behind fillcolor rgb "#eef3f6" fillstyle solid noborder

set ylabel "torque [N m]" offset 0.5
set arrow 1 from a,torque+0 to b,torque+0 nohead front linewidth 1.4 dashtype 2 linecolor rgb ink
set label 1 gprintf("mean %.2f", torque+0) at graph 1, first torque+0 left offset 0.8,0 textcolor rgb ink font ",12"
plot data using 1:3:4 with filledcurves fillcolor rgb "#b9d7e8" fillstyle solid noborder, \
     data using 1:2 with lines linewidth 1.2 linecolor rgb earth_colour

set ylabel "net traction [N]"
set arrow 1 from a,pull+0 to b,pull+0 nohead front linewidth 1.4 dashtype 2 linecolor rgb ink
set label 1 gprintf("mean %.1f", pull+0) at graph 1, first pull+0 left offset 0.8,0 textcolor rgb ink font ",12"
plot data using 1:6:7 with filledcurves fillcolor rgb "#f3cdb2" fillstyle solid noborder, \
     data using 1:5 with lines linewidth 1.2 linecolor rgb mars_colour

set ylabel "sinkage [cm]"
set label 2 "averaging window" at first (a+b)/2, graph 0.86 center textcolor rgb muted font ",12"
set format x "%g"
set xlabel "travel [cm]"
set arrow 1 from a,sinkage+0 to b,sinkage+0 nohead front linewidth 1.4 dashtype 2 linecolor rgb ink
set label 1 gprintf("mean %.2f", sinkage+0) at graph 1, first sinkage+0 left offset 0.8,0 textcolor rgb ink font ",12"
plot data using 1:9:10 with filledcurves fillcolor rgb "#b4e0d1" fillstyle solid noborder, \
     data using 1:8 with lines linewidth 1.2 linecolor rgb other_colour
unset multiplot
