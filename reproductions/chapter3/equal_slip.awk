# equal_slip.awk runs.csv: B3 less B6 at equal slip by Eq 3.8 (with the effective radius). The runs have equal set slips (unloaded radius), at
# which the softer wheel slips less: means over realisations are interpolated between their measured slips, where both wheels have them.
BEGIN { FS = "," }
FNR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
{
    key = $at["gravity"] "," $at["load_N"]; keys[key]; c = key SUBSEP $at["wheel"] SUBSEP $at["slip_percent"]
    ++n[c]; own[c] += $at["measured_slip_percent"]; h[c] += $at["gross_tractive_effort_N"]; p[c] += $at["net_traction_N"]
}
# Value of a wheel at a measured slip; "" outside of its range.
function value(key, wheel, slip, sum,    s, a, b, x, y) {
    for (s = 0; s < 70; s += 10) {
        a = key SUBSEP wheel SUBSEP s; b = key SUBSEP wheel SUBSEP s + 10
        if (!(a in n) || !(b in n)) continue
        x = own[a] / n[a]; y = own[b] / n[b]
        if (slip >= x && slip <= y) return sum[a] / n[a] + (slip - x) / (y - x) * (sum[b] / n[b] - sum[a] / n[a])
    }
    return ""
}
END {
    print "gravity,load_N,slip_percent,B3_gross_N,B6_gross_N,gross_difference_N,B3_net_N,B6_net_N,net_difference_N"
    for (key in keys) for (slip = 0; slip <= 60; slip += 10) {
        a = value(key, "B3", slip, h); b = value(key, "B6", slip, h); c = value(key, "B3", slip, p); d = value(key, "B6", slip, p)
        if (a == "" || b == "") continue
        printf "%s,%d,%.1f,%.1f,%+.1f,%.1f,%.1f,%+.1f\n", key, slip, a, b, a - b, c, d, c - d | "sort -t, -k1,1 -k2,2n -k3,3n"
    }
}
