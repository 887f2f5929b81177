# measurements.awk -v out=DIR runs.csv: DIR/curves.csv, means over realisations for the figures, and DIR/measurements.csv, what the
# claims compare.
BEGIN { FS = ","; split("12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262 2.228 2.201", t975, " ") }  # t(0.975) of 1 to 11 degrees of freedom
function sd(sum, sum2, n) { return n > 1 && sum2 > sum * sum / n ? sqrt((sum2 - sum * sum / n) / (n - 1)) : 0 }
function row(name, value, units, scatter, n, note, uncertainty) {
    printf "%s,%.5g,%s,%.4g,%d,%s,%s\n", name, value, units, scatter, n, note, uncertainty > (out "/measurements.csv") }
function distance(a, b) { return a > b ? a - b : b - a }
FNR == 1 || $3 == "" { next }
{
    g = $2; s = $3; key = g SUBSEP s; ++n[key]; net_N[g, s, $4] = $6
    for (k = 5; k <= 15; ++k) { sum[key, k] += $k; sum2[key, k] += $k * $k }
}
END {
    print "name,value,units,scatter,n,note,uncertainty" > (out "/measurements.csv")
    print "region,slip_percent,n,gross_N,net_N,resistance_N,sinkage_cm,cpu_s,upheaval_cm,rut_cm" > (out "/curves.csv")
    split("small middle large row discs", all, " ")
    for (q = 1; q <= 5; ++q) for (s = 0; s <= 70; s += 10) if ((all[q], s) in n) {
        g = all[q]; key = g SUBSEP s
        for (k = 5; k <= 15; ++k) { mean[key, k] = sum[key, k] / n[key]; dev[key, k] = sd(sum[key, k], sum2[key, k], n[key]) }
        printf "%s,%d,%d,%.5g,%.5g,%.5g,%.5g,%.5g,%.4g,%.4g\n", g, s, n[key], mean[key, 5], mean[key, 6], mean[key, 7], \
            mean[key, 8], mean[key, 11], mean[key, 14], mean[key, 15] > (out "/curves.csv")
    }
    split("small middle large row", wanted, " ")
    for (q = 1; q <= 4; ++q) {
        g = wanted[q]; a = g SUBSEP 40; b = "discs" SUBSEP 40
        if ((a in n) && (b in n)) {
            ratio = mean[a, 11] / mean[b, 11]
            rel = sqrt((dev[a, 11] / mean[a, 11]) ^ 2 + (dev[b, 11] / mean[b, 11]) ^ 2)
            row("time_ratio_" g, ratio, "-", ratio * rel, n[a] < n[b] ? n[a] : n[b], "CPU time of the travel at 40 % against discs only")
            if (g == "small") {
                row("time_percent_small", 100 * ratio, "%", 100 * ratio * rel, n[a], "the same in percent")
                row("time_saved_small", 100 * (1 - ratio), "%", 100 * ratio * rel, n[a], "what is left of it")
            }
        }
        low = 1e300; high = total = pairs = net = worst = 0
        for (s = 0; s <= 70; s += 10) {
            a = g SUBSEP s; b = "discs" SUBSEP s
            if (!((a in n) && (b in n))) continue
            ratio = mean[a, 11] / mean[b, 11]; total += ratio; ++pairs
            if (ratio < low) low = ratio
            if (ratio > high) high = ratio
            if (distance(mean[a, 6], mean[b, 6]) > net) net = distance(mean[a, 6], mean[b, 6])
            share = distance(mean[a, 8], mean[b, 8]) / distance(mean[b, 8], 0)
            if (share > worst) worst = share
        }
        if (pairs >= 3) {
            row("time_ratio_spread_" g, (high - low) / (total / pairs), "-", 0, 1, pairs " slips: (largest - smallest) / mean of the ratios")
            row("net_difference_" g, net / 980, "-", 0, 1, pairs " slips: largest difference of net traction from discs only over W")
            row("sinkage_difference_" g, worst, "-", 0, 1, pairs " slips: largest difference of sinkage from discs only over it")
        }
        a = g SUBSEP 70; b = "discs" SUBSEP 70
        if ((a in n) && (b in n)) {
            row("upheaval_" g, (mean[a, 14] - mean[b, 14]) / 0.6, "-", dev[a, 14] / 0.6, n[a], "above that of discs only at 70 % in diameters of the largest disc")
            row("rut_difference_" g, mean[a, 15] / mean[b, 15], "-", 0, 1, "depth of the rut over that of discs only at 70 %")
        }
    }
    # Differences of our own variants, realisation by realisation, have the 95 % interval of their mean (contract).
    for (s = 0; s <= 10; s += 10) {
        a = "small" SUBSEP s; b = "large" SUBSEP s; c = "discs" SUBSEP s
        if (!((a in n) && (b in n) && (c in n))) continue
        off_a = mean[a, 6] > mean[c, 6] ? 1 : -1; off_b = mean[b, 6] > mean[c, 6] ? 1 : -1
        pairs = total = squares = 0
        for (r = 1; r <= 12; ++r) if (((a, r) in net_N) && ((b, r) in net_N) && ((c, r) in net_N)) {
            nearer = (off_a * (net_N[a, r] - net_N[c, r]) - off_b * (net_N[b, r] - net_N[c, r])) / 980
            ++pairs; total += nearer; squares += nearer * nearer
        }
        scatter = sd(total, squares, pairs)
        row("approach_" s, total / pairs, "-", scatter, pairs, "how much nearer to discs only the large region is than the small one: net traction over W", \
            pairs > 1 ? sprintf("%.4g", t975[pairs - 1] * scatter / sqrt(pairs)) : "")
    }
    for (q = 1; q <= 5; ++q) {
        g = all[q]
        for (s = 10; s <= 70; s += 10) {
            a = g SUBSEP (s - 10); b = g SUBSEP s
            if ((a in n) && (b in n) && mean[a, 6] < 0 && mean[b, 6] >= 0) {
                row("zero_net_slip_" g, s - 10 + 10 * mean[a, 6] / (mean[a, 6] - mean[b, 6]), "%", 0, 1, "net traction is zero: between two slips by a straight line")
                break
            }
        }
    }
}
