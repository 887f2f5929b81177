# Angles of contact against slip. Strings from the report: style, output, data, ylabel.
plot_size = "640,460"
load style
set xrange [-8:58]
set yrange [50:125]
set xlabel "slip [%]"
set ylabel ylabel
set key outside bottom center horizontal Left reverse samplen 1.4 spacing 1.15 textcolor rgb ink
set arrow 1 from -8,90 to 58,90 nohead linewidth 0.8 dashtype 2 linecolor rgb muted
$text << EOD
22,65
22,105
EOD
plot data using 1:3:2:4 with yerrorbars pointtype 7 pointsize 0.7 linewidth 1.3 linecolor rgb "#d55e00" title "entry", \
     data using 1:6:5:7 with yerrorbars pointtype 5 pointsize 0.7 linewidth 1.3 linecolor rgb "#0072b2" title "exit", \
     data using ($1-0.4):8:9:10 with yerrorbars pointtype 13 pointsize 0.9 linewidth 1.3 linecolor rgb "#009e73" title "greatest normal stress", \
     data using ($1+0.4):11:12:13 with yerrorbars pointtype 2 pointsize 0.8 linewidth 1.3 linecolor rgb "#882255" title "greatest tangential stress", \
     $text using 1:2 with points pointtype 12 pointsize 1.4 linewidth 1.6 linecolor rgb text_colour title "the text"
