# Tractive effort against the bounce of the wheel for three variants. Strings: style, output, data.
plot_size = "760,400"
load style
variants = "pid walls light"
hues = earth_colour." ".mars_colour." ".other_colour
name(k) = k == 1 ? "default" : k == 2 ? "walls of discs" : "light rim and lugs"
pick(k, c) = strcol(1) eq word(variants, k) ? column(c) : NaN
set multiplot layout 1,2
unset key
set xlabel "bounce: amplitude of ΣF_y [N]"
set ylabel "gross tractive effort H [N]"
set xrange [0:*]
set yrange [60:150]
plot for [k=1:3] data using (pick(k,7)):3 with points pointtype 7 pointsize 0.7 linecolor rgb word(hues,k) notitle
set xlabel "frequency of the bounce [Hz]"
set xrange [4:12]
set key bottom right
plot for [k=1:3] data using (pick(k,8)):3 with points pointtype 7 pointsize 0.7 linecolor rgb word(hues,k) title name(k)
unset multiplot
