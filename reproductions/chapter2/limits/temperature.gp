# Temperature of a bed at rest against ζ and step; line: the step that its frozen network bears. Strings: style, output, data.
load style
set lmargin 11
set rmargin 12
set logscale y
set xrange [0:1.05]
set yrange [1.9e-5:2.4e-4]
set ytics ("2·10^{−5}" 2e-5, "4·10^{−5}" 4e-5, "10^{−4}" 1e-4, "2·10^{−4}" 2e-4)
set xlabel "damping ratio ζ"
set ylabel "time step [s]"
set palette defined (0 "#dbe9f1", 0.35 "#8cc3e6", 0.5 "#e69f00", 0.8 "#d55e00", 1 "#5a1a00")
set cbrange [-7:1]
set cblabel "log_{10} of the temperature" textcolor rgb ink
set label 1 "default" at 0.2,4e-5 left offset 1.2,-0.9 textcolor rgb ink font ",12"
set label 2 "frozen network" at 1.0,6.4e-5 right textcolor rgb ink font ",12"
plot data using 1:2:(log10($3)) skip 1 with points pointtype 5 pointsize 1.5 linecolor palette, \
     data using 1:4 skip 1 with lines linewidth 2 linecolor rgb ink, \
     "<echo 0.2,4e-5" using 1:2 with points pointtype 4 pointsize 2 linewidth 1.6 linecolor rgb ink
