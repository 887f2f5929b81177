# Superposed epochs: what a conversion does to the tyre, as the mean over `half` seconds after it less the mean over as long
# before; what it does to the soil's elastic and kinetic energy at once; and how far a new element's surface has moved when
# `half` seconds have gone by. Mean over all conversions of a run, and over those to elements and to discs: step, standard error.
# awk -v step_s=4e-5 -v half=0.25 -v name=RUN -f epoch.awk conversions.csv soil.csv series.csv
BEGIN {
    FS = ","
    split("net_traction_N vertical_force_N sinkage_mm elastic_J kinetic_J surface_mm", quantity, " ")
    split("all to-element to-discs", kinds, " ")
}
function note(c, q, step,    k) {
    for (k = 1; k <= 3; ++k) if (k == 1 || kinds[k] == kind[c]) { ++n[k, q]; sum[k, q] += step; sum2[k, q] += step * step }
}
FNR == 1 { delete column; for (k = 1; k <= NF; ++k) column[$k] = k; next }
FILENAME ~ /conversions.csv$/ {
    if ($column["refused"] != 0) next
    ++made; at[made] = $column["step"] * step_s; kind[made] = $column["kind"]; block[made] = $column["block"]
    surface[made] = $column["surface_after_m"]
    note(made, 4, $column["elastic_after_J"] - $column["elastic_before_J"])
    note(made, 5, $column["kinetic_after_J"] - $column["kinetic_before_J"])
    next
}
FILENAME ~ /soil.csv$/ {
    for (c = 1; c <= made; ++c)
        if ($2 == "element" && kind[c] == "to-element" && $3 == block[c] && !(c in settled) && $1 >= at[c] + half) {
            settled[c] = 1
            note(c, 6, 1000 * ((($column["y2_m"]) + $column["y3_m"]) / 2 - surface[c]))
        }
    next
}
{
    t = $column["time_s"]
    for (c = 1; c <= made; ++c) {
        d = t - at[c]
        if (d < -half || d >= half) continue
        side = d < 0 ? 0 : 1
        ++samples[c, side]
        for (q = 1; q <= 3; ++q) mean[c, side, q] += q == 1 ? $column["net_traction_N"] : q == 2 ? $column["vertical_force_N"] : 1000 * $column["sinkage_m"]
    }
}
END {
    for (c = 1; c <= made; ++c) if (samples[c, 0] && samples[c, 1])
        for (q = 1; q <= 3; ++q) note(c, q, mean[c, 1, q] / samples[c, 1] - mean[c, 0, q] / samples[c, 0])
    for (k = 1; k <= 3; ++k) for (q = 1; q <= 6; ++q) if (n[k, q] > 1)
        printf "%s,%s,%s,%d,%.4g,%.4g\n", name, kinds[k], quantity[q], n[k, q], sum[k, q] / n[k, q], sqrt((sum2[k, q] - sum[k, q] ^ 2 / n[k, q]) / (n[k, q] - 1) / n[k, q])
}
