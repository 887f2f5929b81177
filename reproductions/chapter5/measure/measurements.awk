# measurements.awk -v out=DIR runs.csv: DIR/curves.csv, means over realisations for the figures, and DIR/measurements.csv, what the
# claims compare.
BEGIN { FS = "," }
function row(name, value, units, scatter, n, note, uncertainty) {
    printf "%s,%.5g,%s,%.4g,%d,%s,%s\n", name, value, units, scatter, n, note, uncertainty > (out "/measurements.csv") }
function distance(a, b) { return a > b ? a - b : b - a }
# 95 % half-width of one pair's difference between a region and discs only, from all pairs with the same packing; "" if there are none.
function pair_width(g, column,    s, r, d, pairs, total, squares, ss, freedom) {
    for (s = 0; s <= 70; s += 10) {
        pairs = total = squares = 0
        for (r = 1; r <= 12; ++r) if (((g, s, r, column) in of) && (("discs", s, r, column) in of)) {
            d = of[g, s, r, column] - of["discs", s, r, column]; ++pairs; total += d; squares += d * d
        }
        if (pairs > 1) { ss += squares - total * total / pairs; freedom += pairs - 1 }
    }
    return freedom ? t975[freedom < 20 ? freedom : 20] * sqrt(ss / freedom) : ""
}
# How much nearer to discs only (c) a larger region (b) is than a smaller one (a), realisation by realisation.
function approach(column, a, b, c,    off_a, off_b, r, nearer, pairs, total, squares, scatter) {
    off_a = mean[a, column] > mean[c, column] ? 1 : -1; off_b = mean[b, column] > mean[c, column] ? 1 : -1
    for (r = 1; r <= 12; ++r) if (((a, r, column) in of) && ((b, r, column) in of) && ((c, r, column) in of)) {
        nearer = (off_a * (of[a, r, column] - of[c, r, column]) - off_b * (of[b, r, column] - of[c, r, column])) / 980
        ++pairs; total += nearer; squares += nearer * nearer
    }
    scatter = sd(total, squares, pairs)
    row("approach_" (column == 5 ? "gross_" : column == 6 ? "" : "resistance_") s, total / pairs, "-", scatter, pairs, \
        "how much nearer to discs only the large region is than the small one: " (column == 5 ? "gross tractive effort" : column == 6 ? "net traction" : "motion resistance") " over W", \
        pairs > 1 ? sprintf("%.4g", t975[pairs - 1] * scatter / sqrt(pairs)) : "")
}
$1 ~ /-s70-r1-discs1451$/ { text_count[$2] = $14 }
FNR == 1 || $3 == "" { next }
{
    g = $2; s = $3; key = g SUBSEP s; ++n[key]
    for (k = 5; k <= 15; ++k) { of[g, s, $4, k] = $k; sum[key, k] += $k; sum2[key, k] += $k * $k }
}
END {
    print "name,value,units,scatter,n,note,uncertainty" > (out "/measurements.csv")
    print "region,slip_percent,n,gross_N,net_N,resistance_N,sinkage_cm,cpu_s,upheaval_cm,rut_cm,gross_half,net_half,resistance_half,sinkage_half" > (out "/curves.csv")
    split("small middle large row discs", all, " ")
    for (q = 1; q <= 5; ++q) for (s = 0; s <= 70; s += 10) if ((all[q], s) in n) {
        g = all[q]; key = g SUBSEP s
        for (k = 5; k <= 15; ++k) { mean[key, k] = sum[key, k] / n[key]; dev[key, k] = sd(sum[key, k], sum2[key, k], n[key]) }
        printf "%s,%d,%d,%.5g,%.5g,%.5g,%.5g,%.5g,%.4g,%.4g", g, s, n[key], mean[key, 5], mean[key, 6], mean[key, 7], \
            mean[key, 8], mean[key, 11], mean[key, 14], mean[key, 15] > (out "/curves.csv")
        for (k = 5; k <= 8; ++k) printf ",%s", (n[key] > 1 ? sprintf("%.4g", t975[n[key] - 1] * dev[key, k] / sqrt(n[key])) : "NaN") > (out "/curves.csv")
        print "" > (out "/curves.csv")
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
            fewer = n[a] < n[b] ? n[a] : n[b]
            if (distance(mean[a, 6], mean[b, 6]) > net) { net = distance(mean[a, 6], mean[b, 6]); net_root = sqrt(fewer) }
            share = distance(mean[a, 8], mean[b, 8]) / distance(mean[b, 8], 0)
            if (share > worst) { worst = share; worst_root = sqrt(fewer) * distance(mean[b, 8], 0) }
        }
        if (pairs >= 3) {
            row("time_ratio_spread_" g, (high - low) / (total / pairs), "-", 0, 1, pairs " slips: (largest - smallest) / mean of the ratios")
            width = pair_width(g, 6)
            row("net_difference_" g, net / 980, "-", 0, 1, pairs " slips: largest difference of net traction from discs only over W; U by pairs of packings", \
                width == "" ? "" : sprintf("%.4g", width / net_root / 980))
            width = pair_width(g, 8)
            row("sinkage_difference_" g, worst, "-", 0, 1, pairs " slips: largest difference of sinkage from discs only over it; U by pairs of packings", \
                width == "" ? "" : sprintf("%.4g", width / worst_root))
        }
        a = g SUBSEP 70; b = "discs" SUBSEP 70
        if ((a in n) && (b in n)) {
            row("upheaval_" g, (mean[a, 14] - mean[b, 14]) / 0.6, "-", dev[a, 14] / 0.6, n[a], "above that of discs only at 70 % in diameters of the largest disc")
            share = mean[a, 15] / mean[b, 15]
            if (g != "row" && (rut == "" || distance(share, 1) > distance(rut, 1))) { rut = share; rut_of = g; rut_root = sqrt(n[a] < n[b] ? n[a] : n[b]) * mean[b, 15] }
        }
    }
    for (g in text_count) if (("discs", 70) in n)
        row("upheaval1451_" g, (text_count[g] - mean["discs" SUBSEP 70, 14]) / 0.6, "-", 0, 1, "the same with the text's 1451 discs in a block")
    if (rut != "") {
        width = pair_width("small", 15)  # one region has pairs enough at any slip
        row("rut_difference", rut, "-", 0, 1, "height behind the tyre over that of discs only at 70 %: the farthest from 1 of the three regions: " rut_of "; U by pairs of packings of the small region", \
            width == "" ? "" : sprintf("%.4g", width / rut_root))
    }
    # Differences of our own variants, realisation by realisation, have the 95 % interval of their mean (contract).
    for (s = 0; s <= 10; s += 10) {
        a = "small" SUBSEP s; b = "large" SUBSEP s; c = "discs" SUBSEP s
        if (!((a in n) && (b in n) && (c in n))) continue
        for (column = 5; column <= 7; ++column) approach(column, a, b, c)
    }
    # Where net traction is zero: between two slips of one packing by a straight line.
    for (q = 1; q <= 5; ++q) {
        g = all[q]; zeros = total = squares = 0
        for (r = 1; r <= 12; ++r) for (s = 10; s <= 70; s += 10) {
            if (!((g, s - 10, r, 6) in of) || !((g, s, r, 6) in of)) continue
            low = of[g, s - 10, r, 6]; high = of[g, s, r, 6]
            if (low >= 0 || high < 0) continue
            zero = s - 10 + 10 * low / (low - high); ++zeros; total += zero; squares += zero * zero
            break
        }
        if (zeros) row("zero_net_slip_" g, total / zeros, "%", sd(total, squares, zeros), zeros, "net traction is zero: between two slips of one packing by a straight line; set slip")
    }
}
