# Chung & Ooi, case 4: tangential restitution and spin against the angle from the normal; the published points are those
# of reference_data/external.csv. Strings: style, output, data.
plot_size = "760,380"
load style
set multiplot layout 1,2
set xlabel "angle from the normal [°]"
set xrange [25:90]
set ylabel "tangential rebound / impact"
set yrange [0.6:1]
set samples 300
mu = 0.092; e = 0.98; v = 3.9; r = 0.0025
plot [28.66:90] 1 - mu*(1+e)/tan(x*pi/180) with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:2 skip 1 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour, \
     "-" using 1:2 with points pointtype 2 linewidth 1.2 linecolor rgb mars_colour
40,0.781
50,0.845
60,0.893
70,0.932
80,0.966
85,0.983
e
set ylabel "spin after impact [rad/s]"
set yrange [0:560]
plot [28.66:90] 2*mu*(1+e)*v*cos(x*pi/180)/r with lines linewidth 1.6 linecolor rgb earth_colour, \
     data using 1:4 skip 1 with points pointtype 6 linewidth 1.4 linecolor rgb text_colour
unset multiplot
