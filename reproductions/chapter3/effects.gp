# What each change of one input does to H, P_d, R and z, with the 95 % half-width of the difference. Strings: style, output, data.
# Grey: within the half-width.
stats data using 1 nooutput
rows = STATS_max + 1
plot_size = sprintf("960,%d", 120 + 22*rows)
load style
set multiplot layout 1,4 margins 0.36,0.985,0.12,0.90 spacing 0.012
set yrange [rows - 0.4:-0.6]
set border 1
set grid x noy
set arrow 1 from first 0, graph 0 to first 0, graph 1 nohead back linewidth 1.2 linecolor rgb muted
set xtics rotate by -45 left font ",11"
set bars 0
loud(k) = abs(column(k)) > column(k+1) ? column(k) : NaN
calm(k) = abs(column(k)) > column(k+1) ? NaN : column(k)
titles = "'ΔH [N]' 'ΔP_d [N]' 'ΔR [N]' 'Δz [cm]'"
do for [q = 0:3] {
    set title word(titles, q+1) noenhanced textcolor rgb ink
    k = 3 + 2*q
    if (q == 0) { set ytics scale 0 } else { set format y ""; set ytics scale 0 }
    plot data using (calm(k)):1:k+1:ytic(2) with xerrorbars pointtype 7 pointsize 0.6 linecolor rgb muted, \
         data using (loud(k)):1:k+1 with xerrorbars pointtype 7 pointsize 0.7 linecolor rgb mars_colour
}
unset multiplot
