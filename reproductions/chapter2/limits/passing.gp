# Discs shot at the tread: share of eight that pass (filled by share) or sink beyond the overlap limit (open). Strings:
# style, output, data.
load style
set rmargin 11
set logscale xy
set xrange [0.04:7]
set yrange [0.025:4]
set xlabel "speed × step / radius"
set ylabel "speed × √(m/K) / radius"
set palette defined (0 "#e3e7ea", 0.01 "#f0b48a", 1 "#d55e00")
set cbrange [0:1]
set cblabel "share that passes" textcolor rgb ink
set arrow 1 from 2,0.025 to 2,4 nohead dashtype 2 linewidth 1.4 linecolor rgb ink
set arrow 2 from 0.04,2 to 7,2 nohead dashtype 2 linewidth 1.4 linecolor rgb ink
set arrow 4 from 0.06,0.03 to 7,3.5 nohead linewidth 1.4 linecolor rgb earth_colour
set arrow 3 from 0.04,0.8 to 7,0.8 nohead dashtype 3 linewidth 1.4 linecolor rgb muted
plot data using 1:2:3 skip 1 with points pointtype 5 pointsize 1.4 linecolor palette, \
     data using 1:($4 > 0.5 ? $2 : NaN) skip 1 with points pointtype 4 pointsize 1.4 linecolor rgb unsure_colour
