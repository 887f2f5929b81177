# A window mean against slip. Strings from the report: style, output, data, ylabel, and for each kind of line (fit, run,
# mean, text, above, below, label) the names of the curves that have it.
load style
set rmargin 13
if (!exists("slip_label")) slip_label = "slip, set by the unloaded radius [%]"
if (!exists("least_slip")) least_slip = -2
set xrange [least_slip:72]
set xtics 0,10,70
set offsets graph 0, graph 0, graph 0.12, graph 0.06
set xlabel slip_label
set ylabel ylabel
set style textbox opaque noborder fillcolor rgb "white" margins 0.6,0.4

# Two curves: the colours of the planets, or of two wheels. More: light to dark, by load.
pick(curve, kind, c) = (strcol(1) eq curve && strcol(2) eq kind) ? column(c) : NaN
place(curve) = sum [k = 1:words(mean)] (word(mean, k) eq curve ? k : 0)
hue(curve) = words(mean) > 2 ? word(ramp_colours, place(curve)) : place(curve) == 1 ? earth_colour : mars_colour
pale(curve) = "#90".hue(curve)[2:7]
marker(curve) = words(mean) > 2 ? word("5 9 7 11 13", place(curve)) + 0 : 7

# gnuplot warns of a loop over no names, so parts that are not there are left out of the command. Error bars stand where
# there are several realisations.
fits = fit eq "" ? "" : "for [c in fit] data using (pick(c, 'fit', 3)):4 with lines linewidth 1.6 linecolor rgb hue(c), "
runs = run eq "" ? "" : "for [c in run] data using (pick(c, 'run', 3)):4 with points pointtype 7 pointsize 0.3 linecolor rgb pale(c), "
bars = run eq "" ? "" : "for [c in run] data using (column(6) > 1 ? pick(c, 'mean', 3) : NaN):4:5 with yerrorbars pointtype 0 linewidth 1.3 linecolor rgb hue(c), "
texts = text eq "" ? "" : "for [c in text] data using (pick(c, 'text', 3)):4 with points pointtype 12 pointsize 1.25 linewidth 1.6 linecolor rgb text_colour, "
mark_words(names, kind, up) = names eq "" ? "" : sprintf("for [c in '%s'] data using (pick(c, '%s', 3)):4:7 with labels right boxed offset -1.3, %.1f textcolor rgb text_colour font ',12', ", names, kind, up)
uppers = mark_words(above, "above", 1.0)
lowers = mark_words(below, "below", -1.0)
plot @fits @runs @bars \
     for [c in mean] data using (pick(c, "mean", 3)):4 with points pointtype marker(c) pointsize 0.62 linecolor rgb hue(c), \
     @texts @uppers @lowers \
     for [c in label] data using (pick(c, "label", 3)):4:7 with labels left offset 1.6, 0 textcolor rgb hue(c)
