# Angle of repose against sliding friction, rolling coefficient, density and stiffness. Strings: style, output, data.
plot_size = "900,640"
load style
set multiplot layout 2,2
pick(sweep, c) = strcol(1) eq sweep ? column(c) : NaN
set ylabel "angle of repose [°]"
set yrange [0:50]
set xlabel "friction µ (full chord, α = 1)"
set xrange [0:0.9]
set xtics 0.2
plot data using (pick("sliding",2)):3 with points pointtype 6 pointsize 0.7 linecolor rgb earth_colour, \
     data using (pick("sliding",2)):3 smooth unique with lines linewidth 1.4 linecolor rgb earth_colour
set xlabel "α (full chord), µ = 0.6"
set xrange [-0.1:2.1]
set xtics 0.5
plot data using (pick("rolling",2)):3 with points pointtype 6 pointsize 0.7 linecolor rgb earth_colour, \
     data using (pick("rolling",2)):3 smooth unique with lines linewidth 1.4 linecolor rgb earth_colour
set logscale x
set xrange [0.25:4]
set xtics (0.3,0.5,1,2,3)
set xlabel "density / chapter 3’s, µ = 0.6"
set label 1 "α = 1 (Eq 2.18)" at 0.3,45 left textcolor rgb mars_colour
set label 2 "no rolling resistance" at 0.3,5 left textcolor rgb earth_colour
plot for [k=1:2] data using (pick(word("density density_chord",k),2)):3 with points pointtype 6 pointsize 0.7 linecolor rgb word(earth_colour." ".mars_colour,k), \
     for [k=1:2] data using (pick(word("density density_chord",k),2)):3 smooth unique with lines linewidth 1.4 linecolor rgb word(earth_colour." ".mars_colour,k)
set xlabel "stiffness / chapter 3’s, µ = 0.6"
plot for [k=1:2] data using (pick(word("stiffness stiffness_chord",k),2)):3 with points pointtype 6 pointsize 0.7 linecolor rgb word(earth_colour." ".mars_colour,k), \
     for [k=1:2] data using (pick(word("stiffness stiffness_chord",k),2)):3 smooth unique with lines linewidth 1.4 linecolor rgb word(earth_colour." ".mars_colour,k)
unset multiplot
