# Largest stable step of a disc between two faces against their opening angle. Strings: style, output, data.
load style
set rmargin 10
set xlabel "opening angle of the faces [°]"
set ylabel "time step [2√(m/K)]"
set xrange [0:180]
set xtics 30
set yrange [0:*]
zetas = "0.05 0.2 0.7"
hues = earth_colour." ".mars_colour." ".other_colour
pick(k, c) = abs(column(2) - real(word(zetas, k))) < 1e-6 ? column(c) : NaN
set label 1 "ζ = 0.05" at 171,0.72 left textcolor rgb earth_colour
set label 2 "0.2" at 171,0.58 left textcolor rgb mars_colour
set label 3 "0.7" at 171,0.33 left textcolor rgb other_colour
plot for [k=1:3] data using 1:(pick(k,3)) with lines linewidth 1.6 linecolor rgb word(hues,k), \
     for [k=1:3] data using 1:(pick(k,4)) with points pointtype 7 pointsize 0.6 linecolor rgb word(hues,k)
