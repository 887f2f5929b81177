# upheaval.awk surface-RUN.csv...: how far the surface rose in each travel, "run,x_m,rise_mm", from the axle on.
BEGIN { FS = ","; print "run,x_m,rise_mm" }
FNR == 1 { name = FILENAME; sub(/.*surface-/, "", name); sub(/\.csv$/, "", name); next }
$1 > 1.4 && $1 < 2.1 { printf "%s,%s,%.3f\n", name, $1, 1000 * ($2 - $3) }
