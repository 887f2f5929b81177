# Contact stress against angle, a line a slip. Strings from the report: style, output, data, ylabel (which names the stress).
plot_size = "720,440"
load style
c = strstrt(ylabel, "tangential") > 0 ? 4 : 3
array hues[6] = ["#56b4e9", "#0072b2", "#009e73", "#e69f00", "#d55e00", "#882255"]
hue(k) = hues[(k % 6) + 1]
stats data using 2 every ::1 nooutput
blocks = STATS_blocks
slip(k) = system(sprintf("awk -F, -v k=%d '$1+0==$1 && $1!=last {last=$1; if (n++==k) print $1}' '%s'", k, data))
set xrange [40:130]
set xtics 10
set xlabel "rotation angle θ [deg], bottom dead centre at 90"
set ylabel ylabel
set key top right samplen 1.6 spacing 1.1 title "slip" textcolor rgb ink
set arrow 1 from 90, graph 0 to 90, graph 1 nohead linewidth 0.8 dashtype 2 linecolor rgb muted
set xzeroaxis linecolor rgb muted linewidth 0.8
plot for [k=0:blocks-1] data index k using 2:c with lines linewidth 1.5 linecolor rgb hue(k) title slip(k)." %"
