# beside_whole.awk WHOLE.csv FITTED.csv: what the chapter's scene gives beyond the whole one, travel by travel (equal seed and lug phase,
# hence only alike packings), as the mean over a group's travels with its 95 % half-width: H, P_d and R as shares of the load in per cent,
# z in cm; and its share of the CPU time. Quantiles of Student's t are rounded up.
function t95(f) { return f > 100 ? 1.98 : f > 60 ? 2.00 : f > 30 ? 2.04 : f > 20 ? 2.09 : f > 14 ? 2.14 : f > 10 ? 2.23 : f > 6 ? 2.45 : f > 4 ? 2.78 : f > 2 ? 4.30 : 12.7 }
function add(group,    q) {
    if (!(group in n)) order[++groups] = group
    ++n[group]; cpu[group] += $at["cpu_s"]; cpu_whole[group] += whole[$1, "cpu_s"]
    for (q = 1; q <= 4; ++q) {
        more = ($at[quantity[q]] - whole[$1, quantity[q]]) * (q < 4 ? 100 / $at["load_N"] : 1)
        total[group, q] += more; squares[group, q] += more * more
    }
}
BEGIN {
    FS = ","
    split("gross_tractive_effort_N net_traction_N motion_resistance_N sinkage_cm", quantity, " ")
    print "travels,n,cpu_share,H_percent_of_load,half_width,Pd_percent_of_load,half_width,R_percent_of_load,half_width,z_cm,half_width"
}
FNR == 1 { ++file; for (k = 1; k <= NF; ++k) at[$k] = k; next }
file == 1 { there[$1]; whole[$1, "cpu_s"] = $at["cpu_s"]; for (q = 1; q <= 4; ++q) whole[$1, quantity[q]] = $at[quantity[q]]; next }
$1 in there {
    add("all"); add($at["wheel"]); add($at["gravity"]); add($at["load_N"] " N"); add("slip " $at["slip_percent"] " %")
}
END {
    for (g = 1; g <= groups; ++g) {
        group = order[g]
        if (n[group] < 2) continue
        printf "%s,%d,%.2f", group, n[group], cpu[group] / cpu_whole[group]
        for (q = 1; q <= 4; ++q) {
            mean = total[group, q] / n[group]
            printf ",%.2f,%.2f", mean, t95(n[group] - 1) * sqrt((squares[group, q] / n[group] - mean * mean) / (n[group] - 1))
        }
        print ""
    }
}
