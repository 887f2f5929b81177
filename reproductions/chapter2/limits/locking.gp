# Radial stiffness of B3 as ν of surface and lugs nears 0.5. Strings: style, output, data.
load style
set rmargin 4
set logscale x
set xrange [0.3:0.7e-4]
set yrange [0:45]
set xtics ("0.3" 0.2, "0.4" 0.1, "0.49" 0.01, "0.499" 0.001, "0.4999" 1e-4)
set xlabel "Poisson's ratio of surface layer and lugs"
set ylabel "radial stiffness [N/mm]"
set label 1 "plane strain: locks" at 3e-3,34 right textcolor rgb other_colour
set label 2 "plane stress (text and default, ν = 0.49)" at 0.2,11 left textcolor rgb earth_colour
plot data using 1:2 skip 1 with linespoints pointtype 7 pointsize 0.7 linewidth 1.6 linecolor rgb other_colour, \
     data using 1:3 skip 1 with linespoints pointtype 7 pointsize 0.7 linewidth 1.6 linecolor rgb earth_colour
