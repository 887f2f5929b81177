# differences.awk -v varied="WHAT:key=value ..." RUNS.csv: each variant beside the default, which is the first line.
BEGIN {
    count = split(varied, v, " ")
    for (k = 1; k <= count; ++k) { split(v[k], part, ":"); change[part[1]] = part[2] }
    split("gross_N net_N resistance_N sinkage_cm cpu_s conversions refused upheaval_cm rut_cm", column, " ")
    printf "what,change"
    for (k = 1; k <= 9; ++k) printf ",%s", column[k]
    for (k = 1; k <= 4; ++k) printf ",more_%s", column[k]
    print ""
}
FNR == 1 { for (k = 1; k <= NF; ++k) at[$k] = k; next }
{
    parts = split($1, name, "-")
    printf "%s,%s", parts == 4 ? name[4] : "default", parts == 4 ? change[name[4]] : ""
    for (k = 1; k <= 9; ++k) printf ",%s", $at[column[k]]
    for (k = 1; k <= 4; ++k) { if (FNR == 2) base[k] = $at[column[k]]; printf ",%.4g", $at[column[k]] - base[k] }
    print ""
}
