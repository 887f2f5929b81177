# shear_means.awk -v name=RUN series.csv stress.csv: shear stress of the discs in the row under the tyre, kPa, by cells of 5 cm around the
# axle. Means of what is negative (the band that the text sees) over 15 cm either side of the axle, 15 to 45 cm behind it, 15 cm ahead
# and 15 cm behind; the lowest and the highest cell within 60 cm.
BEGIN { FS = ","; edge = 0.05 }
function floor(x) { return x < int(x) ? int(x) - 1 : int(x) }
function mean_negative(from, to,    c, place, total, all) {
    for (c in sum) { split(c, place, SUBSEP); if (place[1] >= from && place[1] < to) { all += area[c]; if (sum[c] < 0) total += sum[c] } }
    return all ? total / all / 1000 : 0
}
FILENAME ~ /series.csv$/ { if (FNR == 1) for (k = 1; k <= NF; ++k) at[$k] = k; else hub = $at["wheel_x_m"]; next }
$1 == "disc" && $3 > 0.2 && $2 - hub > -0.6 && $2 - hub < 0.6 {
    c = floor(($2 - hub) / edge) SUBSEP floor(($3 - 0.2) / edge)
    sum[c] += $4 * $4 * $7; area[c] += $4 * $4
}
END {
    for (c in sum) if (area[c] < 2.5e-4) { delete sum[c]; delete area[c] }  # under a third of a cell
    for (c in sum) { s = sum[c] / area[c] / 1000; if (s < lowest) lowest = s; if (s > highest) highest = s }
    printf "%s,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", name, mean_negative(-3, 3), mean_negative(-9, -3), mean_negative(0, 3), mean_negative(-3, 0), lowest, highest
}
