#!/bin/sh
# gains.sh OUT DEFAULT RUN...: how well the controllers follow their targets with gains × 0.1 and × 10; the default is named text-…, the runs
# LOOPTERMxFACTOR-… (drawbarP0.1-tyre-s22-r1), each in the case's averaging window. Writes OUT/gains.csv (rms error of hub speed and of
# angular velocity over the target, in percent) and OUT/measurements.csv: for each loop the greatest change by its I or D gains over the
# greatest by its P gains, as |ln(error / default's error)| of its own quantity. Its uncertainty is what the other loop's gains do to that
# quantity, which they have nothing to do with. Without the default or a pair of each there is nothing to compare.
set -eu
out=$1
shift
mkdir -p "$out"
for run in "$@"; do
    name=$(basename "$run")
    value() { sed -n "s/^$1 = \([^ ]*\).*/\1/p" "$run/case.toml"; }
    awk -F, -v name="${name%%-*}" -v target="$(value speed_m_s)" -v slip="$(value slip_percent)" \
        -v from="$(value stress_from_x_m)" -v to="$(value stress_to_x_m)" '
        FNR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
        $at["wheel_x_m"] >= from && $at["wheel_x_m"] <= to {
            v = $at["hub_speed_m_s"] / (target * (1 - slip / 100)) - 1; w = $at["omega_rad_s"] / $at["commanded_omega_rad_s"] - 1
            speed += v * v; turning += w * w; ++n }
        END { if (n) printf "%s,%.4g,%.4g\n", name, 100 * sqrt(speed / n), 100 * sqrt(turning / n) }' "$run/series.csv"
done > "$out/rows"
{ echo "gain,speed_error_percent,turning_error_percent"; cat "$out/rows"; } > "$out/gains.csv"
rm "$out/rows"
awk -F, '
    function size(a) { return a < 0 ? -a : a }
    BEGIN { print "name,value,units,scatter,n,note,uncertainty" }
    $1 == "text" { speed = $2; turning = $3; next }
    speed && match($1, /^(drawbar|torque)[PID]/) {
        loop = $1 ~ /^drawbar/ ? "drawbar" : "torque"; other = loop == "drawbar" ? "torque" : "drawbar"
        own = size(log(loop == "drawbar" ? $2 / speed : $3 / turning)); by_chance = size(log(loop == "drawbar" ? $3 / turning : $2 / speed))
        term = substr($1, RLENGTH, 1) == "P" ? "P" : "ID"; ++seen[loop, term]
        if (own > most[loop, term]) most[loop, term] = own
        if (by_chance > chance[other]) chance[other] = by_chance }
    END {
        for (k = 1; k <= 2; ++k) {
            loop = k == 1 ? "drawbar" : "torque"; id = most[loop, "ID"]; p = most[loop, "P"]; c = chance[loop]
            if (seen[loop, "P"] && seen[loop, "ID"]) printf "gain_sensitivity_%s,%.4g,-,0,1,greatest |ln(error / default)| by I and D gains over that by P gains: %.3g over %.3g; the other loop changes it by up to %.2g,%.4g\n",
                loop, id / p, id, p, c, id / p * sqrt((c / id) ^ 2 + (c / p) ^ 2) } }' "$out/gains.csv" > "$out/measurements.csv"
