# One look for all plots. A script sets `plot_size` ("560,400") before it loads this file, and `output`.
# SVG for lines, PNG for pictures of discs; both have the same bytes on every run.
if (!exists("plot_size")) plot_size = "560,400"
if (output[strlen(output)-2:] eq "png") {
    eval "set terminal pngcairo size ".plot_size." font 'DejaVu Sans,13' enhanced"
} else {
    eval "set terminal svg size ".plot_size." dynamic font 'sans-serif,14' enhanced linewidth 1 background rgb 'white'"
}
set output output
set encoding utf8
set datafile separator ","
set datafile missing NaN
set minussign

# Colours that stay apart for colour-blind readers and in grey print (Okabe & Ito 2008).
ink = "#222b33"
muted = "#66717c"
grid = "#e3e7ea"
earth_colour = "#0072b2"
mars_colour = "#d55e00"
earth_pale = "#8cc3e6"
mars_pale = "#f0b48a"
ramp_colours = "#e8952e #dc5a6a #b12a90 #6a00a8 #0d0887"
other_colour = "#009e73"
text_colour = "#111111"
good_colour = "#009e73"
unsure_colour = "#e69f00"
known_colour = "#0072b2"
bad_colour = "#d55e00"

set border 3 linecolor rgb muted linewidth 1
set tics nomirror scale 0.5 textcolor rgb ink
set grid linetype 1 linewidth 0.8 linecolor rgb grid
unset key
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
