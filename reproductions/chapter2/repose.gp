# Angle of repose against friction, rolling coefficient, density, stiffness, size and damping. Strings: style, output, data.
plot_size = "900,560"
load style
set multiplot layout 2,3
pick(sweep, c) = strcol(1) eq sweep ? column(c) : NaN
set ylabel "angle of repose [°]"
set yrange [0:50]
set xlabel "friction µ (full chord, α = 1)"
set xrange [0:0.9]
set xtics 0.2
one(sweep, hue) = sprintf("data using (pick('%s',2)):3 with points pointtype 6 pointsize 0.7 linecolor rgb '%s', data using (pick('%s',2)):3 smooth unique with lines linewidth 1.4 linecolor rgb '%s'", sweep, hue, sweep, hue)
eval "plot ".one("sliding", earth_colour)
set xlabel "α (full chord), µ = 0.6"
set xrange [-0.1:2.1]
set xtics 0.5
eval "plot ".one("rolling", earth_colour)
set xlabel "damping ratio ζ (α = 0)"
set xrange [0:0.8]
set xtics 0.2
eval "plot ".one("damping", earth_colour)
set logscale x
set xrange [0.25:4]
set xtics (0.3,0.5,1,2,3)
set label 1 "α = 1 (Eq 2.18)" at 0.3,45 left textcolor rgb mars_colour
set label 2 "no rolling resistance" at 0.3,5 left textcolor rgb earth_colour
set xlabel "density / chapter 3’s, µ = 0.6"
eval "plot ".one("density", earth_colour).", ".one("density_chord", mars_colour)
set xlabel "stiffness / chapter 3’s, µ = 0.6"
eval "plot ".one("stiffness", earth_colour).", ".one("stiffness_chord", mars_colour)
set xlabel "size / chapter 3’s, µ = 0.6"
set xrange [0.6:1.6]
set xtics (0.7,1,1.4)
set label 1 at 0.65,45
set label 2 at 0.65,5
set label 3 "α ∝ 1/r: constant arm" at 0.65,40 left textcolor rgb other_colour
eval "plot ".one("size", earth_colour).", ".one("size_chord", mars_colour).", ".one("size_arm", other_colour)
unset multiplot
