#!/bin/sh
# measure.sh IFEDEM OUT RUN...: what the claims of chapter 5 compare, from finished runs named REGION-sSLIP-rREALISATION (-WHAT: a variant).
# Writes OUT/runs.csv (means of each run over its last 0.3 m, section 5.2.1), OUT/curves.csv (means over realisations),
# OUT/epochs.csv (what a conversion does to the tyre), OUT/surface-RUN.csv, OUT/measurements.csv and the report's pictures.
set -eu
ifedem=$1 out=$2
shift 2
mkdir -p "$out"
here=$(dirname "$0")

echo "run,kind,quantity,conversions,step,standard_error" > "$out/epochs.csv"
echo "run,ahead_kPa,behind_kPa,positive_kPa" > "$out/shear.csv"
echo "run,region,slip_percent,realisation,gross_N,net_N,resistance_N,sinkage_cm,vertical_N,slip,cpu_s,conversions,refused,upheaval_cm,rut_cm,discs,state_hash,results_version" > "$out/runs.csv"
for run in "$@"; do
    name=$(basename "$run")
    case $name in *-s40-r1 | *-s70-r1) cp "$run/snapshot_bed.png" "$out/${name%-r1}.png" ;; esac
    # Fig 5-A.1: the travel as a strip of pictures and as an animation.
    [ "$name" != large-s40-r1 ] || "$ifedem" picture "$run" -o "$out" --sheet --animation --pressure
    step_s=$(sed -n 's/^time_step_s = \([^ ]*\).*/\1/p' "$run/case.toml")
    [ ! -f "$run/conversions.csv" ] || awk -v step_s="$step_s" -v half=0.25 -v name="$name" -f "$here/epoch.awk" \
        "$run/conversions.csv" "$run/soil.csv" "$run/series.csv" >> "$out/epochs.csv"
    # Shear stress of the discs in the row under the tyre: the mean over a block ahead of the axle and over one behind the
    # tyre, and the largest mean of a cell of 5 cm.
    [ ! -f "$run/stress.csv" ] || awk -F, -v name="$name" '
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
        }' "$run/series.csv" "$run/stress.csv" >> "$out/shear.csv"
    # Fig 5-16: mean shear stress (Eq 5.10) over squares of 2.5 cm of discs, and that of each soil element.
    case $name in small-s40-r1 | discs-s40-r1) awk -F, -v edge=0.025 '
        FILENAME ~ /series.csv$/ { if (FNR == 1) for (k = 1; k <= NF; ++k) at[$k] = k; else hub_x = $at["wheel_x_m"]; next }
        $1 == "element" { print "element," $2 "," $3 ",0.075,0.1," $7 / 1000 }
        $1 == "disc" { sum[int($2 / edge) "," int($3 / edge)] += 3.14159265 * $4 * $4 * $7 / (edge * edge) / 1000 }
        END {
            for (cell in sum) { split(cell, place, ","); printf "disc,%g,%g,%g,%g,%.4g\n", edge * (place[1] + 0.5), edge * (place[2] + 0.5), edge / 2, edge / 2, sum[cell] }
            printf "axle,%.4f,,,,\n", hub_x
        }' "$run/series.csv" "$run/stress.csv" | sort > "$out/shear-${name%-r1}.csv" ;; esac
    "$ifedem" surface "$run" -o "$out/surface-$name.csv"
    awk -F, -v name="$name" -v last=0.3 '
        FILENAME ~ /run.csv$/ { if ($1 == "cpu_s") cpu = $2; if ($1 == "particles") discs = $2
                if ($1 == "state_hash") hash = $2; if ($1 == "results_version") version = $2; next }
        FILENAME ~ /conversions.csv$/ { if (FNR > 1) { if ($4 == 0) ++made; else ++refused }; next }
        FILENAME ~ /series.csv$/ {
            if (FNR == 1) { for (k = 1; k <= NF; ++k) at[$k] = k; next }
            ++rows; x[rows] = $at["wheel_x_m"]; line[rows] = $0; next }
        FILENAME ~ /surface-/ { if (FNR > 1) { ++tops; sx[tops] = $1; sy[tops] = $2 } }
        END {
            for (n = 1; n <= rows; ++n) {
                if (x[n] < x[rows] - last) continue
                split(line[n], c, ","); ++count
                t += c[at["torque_Nm"]]; r += c[at["effective_radius_m"]]; net += c[at["net_traction_N"]]
                z += c[at["sinkage_m"]]; fy += c[at["vertical_force_N"]]; v += c[at["hub_speed_m_s"]]; w += c[at["omega_rad_s"]]
            }
            h = (t / count) / (r / count); net /= count
            # Upheaval: the highest mean over 6 cm (a top alone is roughness) from the front edge − 0.1 m to 0.14 m ahead of it,
            # over the level from 0.15 to 0.35 m ahead. Rut: the mean top over the block behind the rear edge, the tyre
            # being 0.2675 m in radius, under that level.
            front = x[rows] + 0.2675; rear = x[rows] - 0.2675
            for (n = 1; n <= tops; ++n) {
                if (sx[n] > front - 0.1 && sx[n] < front + 0.14) { b = int((sx[n] - front + 0.1) / 0.06); top[b] += sy[n]; ++in_bin[b] }
                if (sx[n] > front + 0.15 && sx[n] < front + 0.35) { level += sy[n]; ++ahead }
                if (sx[n] > rear - 0.15 && sx[n] < rear) { bottom += sy[n]; ++behind }
            }
            for (b in top) if (top[b] / in_bin[b] > high) high = top[b] / in_bin[b]
            level = ahead ? level / ahead : 0
            parts = split(name, p, "-")
            slip = parts == 3 && p[2] ~ /^s[0-9]+$/ ? substr(p[2], 2) : ""
            printf "%s,%s,%s,%s,%.5g,%.5g,%.5g,%.5g,%.5g,%.4g,%s,%d,%d,%.3g,%.3g,%d,%s,%s\n", name, p[1], slip, substr(p[3], 2), \
                h, net, net - h, 100 * z / count, fy / count, 1 - (v / count) / (r / count * (w / count)), cpu, made, refused, \
                100 * (high - level), behind ? 100 * (bottom / behind - level) : 0, discs, hash, version
        }' "$run/run.csv" $([ -f "$run/conversions.csv" ] && echo "$run/conversions.csv") "$run/series.csv" "$out/surface-$name.csv" >> "$out/runs.csv"
done

awk -F, -v out="$out" '
    function sd(sum, sum2, n) { return n > 1 && sum2 > sum * sum / n ? sqrt((sum2 - sum * sum / n) / (n - 1)) : 0 }
    function row(name, value, units, scatter, n, note) {
        printf "%s,%.5g,%s,%.4g,%d,%s\n", name, value, units, scatter, n, note > (out "/measurements.csv") }
    function distance(a, b) { return a > b ? a - b : b - a }
    FNR == 1 || $3 == "" { next }
    {
        g = $2; s = $3; key = g SUBSEP s; ++n[key]
        for (k = 5; k <= 15; ++k) { sum[key, k] += $k; sum2[key, k] += $k * $k }
    }
    END {
        print "name,value,units,scatter,n,note" > (out "/measurements.csv")
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
        for (s = 0; s <= 10; s += 10) {
            a = "small" SUBSEP s; b = "large" SUBSEP s; c = "discs" SUBSEP s
            if ((a in n) && (b in n) && (c in n))
                row("approach_" s, (distance(mean[a, 6], mean[c, 6]) - distance(mean[b, 6], mean[c, 6])) / 980, "-", \
                    sqrt(dev[a, 6] ^ 2 + dev[b, 6] ^ 2) / 980, n[a], "how much nearer to discs only the large region is than the small one: net traction over W")
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
    }' "$out/runs.csv"

# Time and number of discs at the end, both over discs only at the same slip: an index a region.
awk -F, '
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
    }' "$out/runs.csv" > "$out/time.csv"

# Epochs over all runs with conversions, each run weighted alike; shear of the small region against discs only.
awk -F, '
    FILENAME ~ /epochs.csv$/ {
        if ($2 == "all") { ++n[$3]; sum[$3] += $5; var[$3] += $6 * $6; made[$3] += $4 }
        next }
    FNR > 1 { ahead[$1] = $2; behind[$1] = $3; most[$1] = $4 }
    END {
        split("net_traction_N vertical_force_N sinkage_mm", q, " "); unit[1] = unit[2] = "N"; unit[3] = "mm"
        for (k = 1; k <= 3; ++k) if (n[q[k]])
            printf "epoch_%s,%.4g,%s,%.4g,%d,step at a conversion: mean over 0.25 s after less before; scatter is the standard error\n", \
                q[k], sum[q[k]] / n[q[k]], unit[k], sqrt(var[q[k]]) / n[q[k]], made[q[k]]
        s = "small-s40-r1"; d = "discs-s40-r1"
        if (s in behind) printf "shear_behind_small,%.4g,-,0,1,mean shear stress over a block behind the tyre over that ahead of the axle at 40 %%\n", behind[s] / ahead[s]
        if ((s in ahead) && (d in ahead)) {
            printf "shear_ahead_ratio,%.4g,-,0,1,mean shear stress over a block ahead of the axle: small region over discs only at 40 %%\n", ahead[s] / ahead[d]
            printf "shear_positive_excess,%.4g,-,0,1,largest positive shear stress of a cell of 5 cm: small region less discs only over that ahead of the axle\n", (most[s] - most[d]) / -ahead[d]
        }
    }' "$out/epochs.csv" "$out/shear.csv" >> "$out/measurements.csv"
