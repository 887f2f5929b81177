# Superposed epochs: what a conversion does to net traction, vertical force and sinkage, as the mean over `half` seconds
# after it less the mean over as long before, over all conversions of a run: step and its standard error.
# awk -v step_s=4e-5 -v half=0.25 -v load=980 -v name=RUN -f epoch.awk conversions.csv series.csv
BEGIN { FS = "," }
FILENAME ~ /conversions.csv$/ { if (FNR > 1 && $4 == 0) { ++made; at[made] = $1 * step_s; kind[made] = $3 } next }
FNR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
{
    t = $column["time_s"]
    for (c = 1; c <= made; ++c) {
        d = t - at[c]
        if (d < -half || d >= half) continue
        side = d < 0 ? 0 : 1
        ++n[c, side]
        sum[c, side, 1] += $column["net_traction_N"]; sum[c, side, 2] += $column["vertical_force_N"]; sum[c, side, 3] += 1000 * $column["sinkage_m"]
    }
}
END {
    for (q = 1; q <= 3; ++q) {
        s = s2 = m = 0
        for (c = 1; c <= made; ++c) if (n[c, 0] && n[c, 1]) {
            d = sum[c, 1, q] / n[c, 1] - sum[c, 0, q] / n[c, 0]; s += d; s2 += d * d; ++m
        }
        if (m > 1) printf "%s,%s,%d,%.4g,%.4g\n", name, q == 1 ? "net_traction_N" : q == 2 ? "vertical_force_N" : "sinkage_mm", m, s / m, sqrt((s2 - s * s / m) / (m - 1) / m)
    }
}
