# statistics.awk: what the measurements share; before another file: awk -f statistics.awk -f FILE.
BEGIN {  # t(0.975) of 1 to 20 degrees of freedom
    split("12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262 2.228 2.201 2.179 2.160 2.145 2.131 2.120 2.110 2.101 2.093 2.086", t975, " ")
}
function sd(sum, squares, n) { return n > 1 && squares > sum * sum / n ? sqrt((squares - sum * sum / n) / (n - 1)) : 0 }
