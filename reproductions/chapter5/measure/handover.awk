# handover.awk RUNS.csv EPOCHS.csv: conversions with the stress handed over beside those without, and what it changes in the
# means of a travel. Conversions of all slips together, each weighted alike; `more` is a mean over pairs of travels.
function pool(k, side) { return made[k, side] ? sprintf("%d,%.4g,%.2g", made[k, side], sum[k, side] / made[k, side], sqrt(var[k, side]) / made[k, side]) : "0,," }
BEGIN { FS = ","; quantities = split("gross_N net_N resistance_N sinkage_cm", quantity, " ") }
FNR == 1 { delete at; for (k = 1; k <= NF; ++k) at[$k] = k; next }
{ parts = split($1, name, "-"); side = parts == 4 && name[4] == "handover" }
FILENAME ~ /runs.csv$/ { for (q = 1; q <= quantities; ++q) value[name[2], q, side] = $at[quantity[q]]; slips[name[2]] = 1; next }
{
    key = $2 "," $3
    if (!(key in seen)) { seen[key] = 1; keys[++count] = key }
    made[key, side] += $4; sum[key, side] += $4 * $5; var[key, side] += ($4 * $6) ^ 2
}
END {
    print "kind,quantity,without_n,without,without_standard_error,with_n,with,with_standard_error"
    for (k = 1; k <= count; ++k) print keys[k] "," pool(keys[k], 0) "," pool(keys[k], 1)
    for (q = 1; q <= quantities; ++q) {
        pairs = first = second = total = squares = 0
        for (s in slips) if (((s, q, 0) in value) && ((s, q, 1) in value)) {
            more = value[s, q, 1] - value[s, q, 0]
            ++pairs; first += value[s, q, 0]; second += value[s, q, 1]; total += more; squares += more * more
        }
        if (pairs > 1) printf "travel,%s,%d,%.4g,,%d,%.4g,%.2g\n", quantity[q], pairs, first / pairs, pairs, second / pairs, sqrt((squares - total ^ 2 / pairs) / (pairs - 1) / pairs)
    }
}
