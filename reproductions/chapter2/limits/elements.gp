# Largest step of the wheel alone: element bound (dashed), whole mesh (line), measured (points). Strings: style, output, data.
plot_size = "960,400"
load style
set multiplot layout 1,3 margins 0.09,0.975,0.16,0.89 spacing 0.055
set logscale y
set yrange [2e-6:4e-4]
set format y "10^{%T}"
set ylabel "time step [s]"
set label 1 "default" at graph 0.03, first 4e-5 left offset 0,0.5 textcolor rgb muted font ",12"
set label 2 "text" at graph 0.97, first 1e-5 right offset 0,0.5 textcolor rgb muted font ",12"
part(i) = sprintf("index %d", i)
set title "rings of the layers × n" textcolor rgb ink
set xrange [0.7:3.3]
set xtics 1
set xlabel "n"
plot 4e-5 with lines dashtype 2 linecolor rgb muted, 1e-5 with lines dashtype 3 linecolor rgb muted, \
  data using (strcol(1) eq "layers" ? $2 : NaN):3 with lines dashtype 2 linewidth 1.4 linecolor rgb earth_colour, \
  data using (strcol(1) eq "layers" ? $2 : NaN):4 with lines linewidth 1.6 linecolor rgb earth_colour, \
  data using (strcol(1) eq "layers" ? $2 : NaN):5 with points pointtype 7 pointsize 0.7 linecolor rgb earth_colour
set ylabel ""
set title "rings of an elastic rim" textcolor rgb ink
set xrange [0.7:6.3]
set xlabel "rings"
plot 4e-5 with lines dashtype 2 linecolor rgb muted, 1e-5 with lines dashtype 3 linecolor rgb muted, \
  data using (strcol(1) eq "rim" ? $2 : NaN):3 with lines dashtype 2 linewidth 1.4 linecolor rgb mars_colour, \
  data using (strcol(1) eq "rim" ? $2 : NaN):4 with lines linewidth 1.6 linecolor rgb mars_colour, \
  data using (strcol(1) eq "rim" ? $2 : NaN):5 with points pointtype 7 pointsize 0.7 linecolor rgb mars_colour
set title "ν of the surface layer" textcolor rgb ink
set logscale x
set xrange [0.3:0.7e-4]
set xtics ("0.4" 0.1, "0.49" 0.01, "0.499" 0.001, "0.4999" 1e-4)
set xlabel "Poisson's ratio"
set label 3 "plane stress" at 2e-3,2.1e-4 textcolor rgb earth_colour font ",12"
set label 4 "plane strain" at 1.5e-2,7e-6 textcolor rgb other_colour font ",12"
plot 4e-5 with lines dashtype 2 linecolor rgb muted, 1e-5 with lines dashtype 3 linecolor rgb muted, \
  for [g in "strain stress"] data using (strcol(1) eq g ? $2 : NaN):3 with lines dashtype 2 linewidth 1.4 linecolor rgb (g eq "strain" ? other_colour : earth_colour), \
  for [g in "strain stress"] data using (strcol(1) eq g ? $2 : NaN):4 with lines linewidth 1.6 linecolor rgb (g eq "strain" ? other_colour : earth_colour), \
  for [g in "strain stress"] data using (strcol(1) eq g ? $2 : NaN):5 with points pointtype 7 pointsize 0.7 linecolor rgb (g eq "strain" ? other_colour : earth_colour)
unset multiplot
