# What each change of one input does to H, P_d, R and z, with the 95 % half-width of the difference; coloured where it is larger
# than that. Strings: style, output, data.
set datafile separator ","
stats data using 1 nooutput
rows = STATS_max + 1
stats data using (abs($3)+$4) name "q0" nooutput
stats data using (abs($5)+$6) name "q1" nooutput
stats data using (abs($7)+$8) name "q2" nooutput
stats data using (abs($9)+$10) name "q3" nooutput
plot_size = sprintf("960,%d", 130 + 24*rows)
load style
top = 1 - 34.0/(130 + 24*rows)
bottom = 50.0/(130 + 24*rows)
set multiplot
set yrange [rows - 0.4:-0.6]
set border 1
set grid x noy
set arrow 1 from first 0, graph 0 to first 0, graph 1 nohead back linewidth 1.2 linecolor rgb muted
# Three tics a panel, at a round number near the largest value.
array widest[4] = [q0_max, q1_max, q2_max, q3_max]
decade(x) = 10**floor(log10(x))
round_down(x) = x >= 5*decade(x) ? 5*decade(x) : x >= 2*decade(x) ? 2*decade(x) : decade(x)
set ytics scale 0 noenhanced font ",11"
loud(k) = abs(column(k)) > column(k+1) ? column(k) : NaN
calm(k) = abs(column(k)) > column(k+1) ? NaN : column(k)
titles = "H P_d R z"
units = "N N N cm"
do for [q = 0:3] {
    k = 3 + 2*q
    set lmargin at screen 0.4 + 0.15*q
    set rmargin at screen 0.4 + 0.15*q + 0.135
    set tmargin at screen top
    set bmargin at screen bottom
    m = widest[q+1]
    set xrange [-1.05*m:1.05*m]
    tic = round_down(m)
    set xtics -tic,tic,tic font ",11"
    set title "Δ".word(titles, q+1)." [".word(units, q+1)."]" offset 0,-0.6 textcolor rgb ink
    if (q == 0) {
        plot data using (0):1:ytic(2) with dots linecolor rgb "white", \
             data using (calm(k)):1:k+1 with xerrorbars pointtype 7 pointsize 0.6 linecolor rgb muted, \
             data using (loud(k)):1:k+1 with xerrorbars pointtype 7 pointsize 0.7 linecolor rgb mars_colour
        set format y ""
    } else {
        plot data using (calm(k)):1:k+1 with xerrorbars pointtype 7 pointsize 0.6 linecolor rgb muted, \
             data using (loud(k)):1:k+1 with xerrorbars pointtype 7 pointsize 0.7 linecolor rgb mars_colour
    }
}
unset multiplot
