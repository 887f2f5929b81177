# A mean against slip for each region, from measured/curves.csv. Strings from the report: style, output, data, ylabel; the first
# word of ylabel chooses the column; bars where there are several realisations.
load style
set rmargin 16
set xrange [-2:72]
set xtics 0,10,70
set offsets graph 0, graph 0, graph 0.08, graph 0.06
set xlabel "slip [%]"
set ylabel ylabel
set key outside right center samplen 1.5 textcolor rgb ink
first = word(ylabel, 1)
col = first eq "gross" ? 4 : first eq "net" ? 5 : first eq "motion" ? 6 : first eq "sinkage" ? 7 : 8
of(region) = strcol(1) eq region ? column(col) : NaN
hue(n) = n == 1 ? "#d55e00" : n == 2 ? "#e69f00" : n == 3 ? "#009e73" : n == 4 ? "#cc79a7" : "#111111"
regions = "small middle large row discs"
half(n) = col < 8 && n > 1 ? column(col + 7) : 0
plot for [n=1:5] data using 2:(of(word(regions, n))) with linespoints pointtype 7 pointsize 0.5 linewidth 1.3 linecolor rgb hue(n) \
     title word(regions, n), \
     for [n=1:5] data using ($2 + 0.3 * (n - 3)):(of(word(regions, n)) - half($3)):(0):(2 * half($3)) with vectors nohead linewidth 1 linecolor rgb hue(n) notitle
