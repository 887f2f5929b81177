# Relative place of the greatest normal stress. Strings from the report: style, output, data, ylabel.
load style
set xrange [0:0.6]
set xlabel "slip i [-]"
set ylabel ylabel
set key bottom right samplen 1.8 spacing 1.15 textcolor rgb ink
driven(x) = x >= 0.0749 ? x : NaN
stats data using (driven($1)):2 every ::1 nooutput name "S"
f(x) = S_intercept + S_slope * x
mx = S_mean_x
my = S_mean_y
plot f(x) with lines linewidth 1.6 linecolor rgb earth_colour title sprintf("ours: gradient %.3f", S_slope), \
     my + 0.519 * (x - mx) with lines linewidth 1.3 dashtype 2 linecolor rgb text_colour title "the text's FE–DEM: 0.519", \
     my + 0.311 * (x - mx) with lines linewidth 1.3 dashtype 4 linecolor rgb muted title "the text's experiment: 0.311", \
     data using (driven($1)):2:3:4 with yerrorbars pointtype 7 pointsize 0.7 linewidth 1.3 linecolor rgb earth_colour notitle
