# epochs.awk epochs.csv shear.csv: more lines of measurements.csv: steps at a conversion over all runs, each run weighted alike, and
# the shear stress of the small region against discs only.
BEGIN { FS = "," }
FILENAME ~ /epochs.csv$/ {
    if ($2 == "all") { ++n[$3]; sum[$3] += $5; var[$3] += $6 * $6; made[$3] += $4 }
    next }
FNR > 1 { ahead[$1] = $2; behind[$1] = $3; most[$1] = $4 }
END {
    split("net_traction_N vertical_force_N sinkage_mm", q, " "); unit[1] = unit[2] = "N"; unit[3] = "mm"
    for (k = 1; k <= 3; ++k) if (n[q[k]])
        printf "epoch_%s,%.4g,%s,%.4g,%d,step at a conversion: mean over 0.25 s after less before; scatter is the standard error,\n", \
            q[k], sum[q[k]] / n[q[k]], unit[k], sqrt(var[q[k]]) / n[q[k]], made[q[k]]
    s = "small-s40-r1"; d = "discs-s40-r1"
    if (s in behind) printf "shear_behind_small,%.4g,-,0,1,mean shear stress over a block behind the tyre over that ahead of the axle at 40 %%,\n", behind[s] / ahead[s]
    if ((s in ahead) && (d in ahead)) {
        printf "shear_ahead_ratio,%.4g,-,0,1,mean shear stress over a block ahead of the axle: small region over discs only at 40 %%,\n", ahead[s] / ahead[d]
        printf "shear_positive_excess,%.4g,-,0,1,largest positive shear stress of a cell of 5 cm: small region less discs only over that ahead of the axle,\n", (most[s] - most[d]) / -ahead[d]
    }
}
