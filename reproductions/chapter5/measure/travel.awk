# travel.awk -v name=RUN run.csv [conversions.csv] series.csv surface-RUN.csv: a travel as one line: means over its last 0.3 m
# (section 5.2.1), conversions, upheaval and rut at the end.
BEGIN { FS = ","; last = 0.3 }
FILENAME ~ /run.csv$/ { of[$1] = $2; next }
FILENAME ~ /conversions.csv$/ { if (FNR > 1) { if ($4 == 0) ++made; else ++refused }; next }
FILENAME ~ /series.csv$/ {
    if (FNR == 1) { for (k = 1; k <= NF; ++k) at[$k] = k; next }
    ++rows; x[rows] = $at["wheel_x_m"]; line[rows] = $0
    next
}
FILENAME ~ /surface-/ { if (FNR > 1) { ++tops; sx[tops] = $1; rise[tops] = $2 - $3 } }
END {
    for (n = 1; n <= rows; ++n) {
        if (x[n] < x[rows] - last) continue
        split(line[n], c, ","); ++count
        t += c[at["torque_Nm"]]; r += c[at["effective_radius_m"]]; net += c[at["net_traction_N"]]
        z += c[at["sinkage_m"]]; fy += c[at["vertical_force_N"]]; v += c[at["hub_speed_m_s"]]; w += c[at["omega_rad_s"]]
    }
    h = (t / count) / (r / count); net /= count
    # How far the surface rose over where it was when the travel began: a packing's own unevenness is as large as what is
    # looked for. Upheaval: the greatest mean over 6 cm (a top alone is roughness) from the front edge - 0.1 m to 0.14 m
    # ahead of it, the tyre being 0.2675 m in radius. Rut: the mean over the block behind the rear edge.
    front = x[rows] + 0.2675; rear = x[rows] - 0.2675; high = -1
    for (n = 1; n <= tops; ++n) {
        if (sx[n] > front - 0.1 && sx[n] < front + 0.14) { b = int((sx[n] - front + 0.1) / 0.06); top[b] += rise[n]; ++in_bin[b] }
        if (sx[n] > rear - 0.15 && sx[n] < rear) { bottom += rise[n]; ++behind }
    }
    for (b in top) if (top[b] / in_bin[b] > high) high = top[b] / in_bin[b]
    parts = split(name, p, "-")
    slip = parts == 3 && p[2] ~ /^s[0-9]+$/ ? substr(p[2], 2) : ""
    printf "%s,%s,%s,%s,%.5g,%.5g,%.5g,%.5g,%.5g,%.4g,%s,%d,%d,%.3g,%.3g,%d,%s,%s\n", name, p[1], slip, substr(p[3], 2), \
        h, net, net - h, 100 * z / count, fy / count, 1 - (v / count) / (r / count * (w / count)), of["cpu_s"], made, refused, \
        100 * high, behind ? 100 * bottom / behind : 0, of["particles"], of["state_hash"], of["results_version"]
}
