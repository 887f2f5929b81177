# Fig 5-8: stress against strain in confined compression. Strings: style, output, data.
load style
set xlabel "strain [%]"
set ylabel "vertical stress [kPa]"
set key left top reverse Left samplen 1.5 textcolor rgb ink
of(preparation, c) = strcol(1) eq preparation ? -1e-3*column(c) : NaN
plot data using (-100*column(2)):(of("text", 5)) with lines linewidth 1.6 linecolor rgb text_colour title "element, E = 1.7 MPa", \
     data using (-100*column(2)):(of("text", 3)) with linespoints pointtype 7 pointsize 0.4 linecolor rgb earth_colour title "discs, prepared with 1/100 of their mass", \
     data using (-100*column(2)):(of("full", 3)) with linespoints pointtype 7 pointsize 0.4 linecolor rgb mars_colour title "discs, prepared with full mass"
