# adaptive.awk RUNS.csv: what regions give beyond discs only, packing by packing, as means with their standard errors; and their share
# of its discs (mean over the travel) and CPU time. Of regions at a slip those realisations that discs only have too.
function name_of(parts) { return parts[4] == "adaptive" ? "adaptive" : parts[1] }
BEGIN {
    FS = ","; split("gross_N net_N resistance_N sinkage_cm", quantity, " "); split("large small adaptive", region, " ")
    printf "slip_percent,region,n,discs_share,cpu_share"
    for (q = 1; q <= 4; ++q) printf ",%s,%s_standard_error", quantity[q], quantity[q]
    print ""
}
FNR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
{
    delete parts; split($1, parts, "-"); name = name_of(parts); slip = substr(parts[2], 2); r = $at["realisation"]
    if (!(slip in seen)) { seen[slip] = 1; slips[++count] = slip }
    has[name, slip, r] = 1; discs[name, slip, r] = $at["discs"]; cpu[name, slip, r] = $at["cpu_s"]
    for (q = 1; q <= 4; ++q) value[name, slip, r, q] = $at[quantity[q]]
}
END {
    for (k = 1; k <= count; ++k) for (g = 1; g <= 3; ++g) {
        s = slips[k]; n = all_discs = own_discs = all_cpu = own_cpu = 0; split("", total); split("", squares)
        for (r = 1; r <= 8; ++r) if (((region[g], s, r) in has) && (("discs", s, r) in has)) {
            ++n; own_discs += discs[region[g], s, r]; all_discs += discs["discs", s, r]
            own_cpu += cpu[region[g], s, r]; all_cpu += cpu["discs", s, r]
            for (q = 1; q <= 4; ++q) { more = value[region[g], s, r, q] - value["discs", s, r, q]; total[q] += more; squares[q] += more * more }
        }
        if (n < 2) continue
        printf "%s,%s,%d,%.3f,%.3f", s, region[g], n, own_discs / all_discs, own_cpu / all_cpu
        for (q = 1; q <= 4; ++q) printf ",%.4g,%.2g", total[q] / n, sqrt((squares[q] - total[q] ^ 2 / n) / (n - 1) / n)
        print ""
    }
}
