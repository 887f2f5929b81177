# time.awk runs.csv: number of discs at the end and CPU time, both over discs only at the same slip; an index a region.
BEGIN { FS = "," }
FNR == 1 { next }
{ key = $2 SUBSEP $3; ++n[key]; cpu[key] += $11; discs[key] += $16 }
END {
    print "region,slip_percent,disc_share,time_share"
    count = split("small middle large row", all, " ")
    for (q = 1; q <= count; ++q) {
        if (q > 1) print "\n"
        for (s = 0; s <= 70; s += 10) {
            a = all[q] SUBSEP s; b = "discs" SUBSEP s
            if ((a in n) && (b in n)) printf "%s,%d,%.5g,%.5g\n", all[q], s, discs[a] / n[a] / (discs[b] / n[b]), cpu[a] / n[a] / (cpu[b] / n[b])
        }
    }
}
