# epochs.awk epochs.csv shear.csv: more lines of measurements.csv: steps at a conversion over all runs, each run weighted alike, and
# the shear stress of the small region against discs only at 40 %, packing by packing.
BEGIN { FS = "," }
# A ratio of two columns of the small region.
function ratio_row(name, above, below, note,    r, x, n, total, squares) {
    for (r = 1; r <= 12; ++r) if ((("small", r) in run) && of["small", r, below]) {
        x = of["small", r, above] / of["small", r, below]; ++n; total += x; squares += x * x
    }
    if (n) printf "%s,%.4g,-,%.4g,%d,%s,\n", name, total / n, sd(total, squares, n), n, note
}
# Mean difference of a column, small region less discs only, over the mean of another with discs only, plus `offset`; 95 % interval of
# the mean over packings.
function difference_row(name, column, over, sign, offset, note,    r, d, n, total, squares, scale) {
    for (r = 1; r <= 12; ++r) if ((("small", r) in run) && (("discs", r) in run)) {
        d = of["small", r, column] - of["discs", r, column]; ++n; total += d; squares += d * d; scale += of["discs", r, over]
    }
    if (!n || !scale) return
    scale *= sign / n
    printf "%s,%.4g,-,%.4g,%d,%s,%s\n", name, offset + total / n / scale, sd(total, squares, n) / (scale < 0 ? -scale : scale), n, note, \
        (n > 1 ? sprintf("%.4g", t975[n - 1] * sd(total, squares, n) / sqrt(n) / (scale < 0 ? -scale : scale)) : "")
}
FILENAME ~ /epochs.csv$/ {
    if ($2 == "all") { ++n[$3]; sum[$3] += $5; var[$3] += $6 * $6; made[$3] += $4 }
    next }
FNR == 1 { for (k = 2; k <= NF; ++k) title[k] = $k; next }
split($1, part, "-") == 3 && part[2] == "s40" {
    r = substr(part[3], 2); run[part[1], r]
    for (k = 2; k <= NF; ++k) of[part[1], r, title[k]] = $k
}
END {
    split("net_traction_N vertical_force_N sinkage_mm", q, " "); unit[1] = unit[2] = "N"; unit[3] = "mm"
    for (k = 1; k <= 3; ++k) if (n[q[k]])
        printf "epoch_%s,%.4g,%s,%.4g,%d,step at a conversion: mean over 0.25 s after less before; scatter is the standard error,\n", \
            q[k], sum[q[k]] / n[q[k]], unit[k], sqrt(var[q[k]]) / n[q[k]], made[q[k]]
    difference_row("shear_band_ratio", "band_kPa", "band_kPa", 1, 1, "negative shear stress within 15 cm of the axle at 40 %: small region over discs only")
    difference_row("shear_lowest_ratio", "lowest_kPa", "lowest_kPa", 1, 1, "lowest cell of 5 cm at 40 %: small region over discs only")
    ratio_row("shear_behind_small", "behind_kPa", "band_kPa", "negative shear stress 15 to 45 cm behind the axle over that within 15 cm of it at 40 %")
    ratio_row("shear_past_axle_small", "rear_kPa", "front_kPa", "negative shear stress up to 15 cm behind the axle over that up to 15 cm ahead of it at 40 %")
    difference_row("shear_positive_excess", "highest_kPa", "lowest_kPa", -1, 0, "highest cell of 5 cm at 40 %: small region less discs only over the depth of the lowest with discs only")
}
