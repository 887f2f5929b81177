# shear_means.awk -v name=RUN series.csv stress.csv: shear stress of the discs in the row under the tyre, kPa: RUN, the mean over a
# block ahead of the axle, over one behind the tyre, and the largest mean of a cell of 5 cm.
BEGIN { FS = "," }
FILENAME ~ /series.csv$/ { if (FNR == 1) for (k = 1; k <= NF; ++k) at[$k] = k; else hub = $at["wheel_x_m"]; next }
$1 == "disc" && $3 > 0.2 {
    a = $4 * $4; d = $2 - hub
    if (d > 0 && d < 0.15) { ahead += a * $7; ahead_area += a }
    if (d < -0.15 && d > -0.3) { behind += a * $7; behind_area += a }
    if (d > -0.6 && d < 0.6) { cell = int($2 / 0.05) SUBSEP int($3 / 0.05); sum[cell] += a * $7; area[cell] += a }
}
END {
    for (c in sum) if (area[c] > 2.5e-4 && sum[c] / area[c] > most) most = sum[c] / area[c]
    printf "%s,%.4g,%.4g,%.4g\n", name, ahead_area ? ahead / ahead_area / 1000 : 0, behind_area ? behind / behind_area / 1000 : 0, most / 1000
}
