# A disc on a slope of 30°: acceleration and spin against friction. Strings: style, output, data.
load style
set xlabel "µ / (tan θ/3)"
set ylabel "acceleration [m/s²]"
set xrange [0:2.1]
set yrange [0:5.2]
theta = pi/6; g = 9.81
along(s) = s < 1 ? g*(sin(theta) - s*tan(theta)/3*cos(theta)) : 2./3*g*sin(theta)
spin(s) = s < 1 ? 2*s*tan(theta)/3*g*cos(theta) : 2./3*g*sin(theta)
set arrow 1 from 1,0 to 1,5.2 nohead dashtype 2 linecolor rgb muted
set label 1 "slides" at 0.97,0.25 right textcolor rgb muted
set label 2 "rolls" at 1.03,0.25 left textcolor rgb muted
set label 3 "a, down the slope" at 0.3,4.9 left textcolor rgb earth_colour
set label 4 "r dω/dt" at 0.55,1.5 left textcolor rgb mars_colour
plot along(x) with lines linewidth 1.6 linecolor rgb earth_colour, spin(x) with lines linewidth 1.6 linecolor rgb mars_colour, \
     data using 1:2 skip 1 with points pointtype 6 linewidth 1.2 linecolor rgb text_colour, \
     data using 1:3 skip 1 with points pointtype 4 linewidth 1.2 linecolor rgb text_colour
