# shear_tiles.awk series.csv stress.csv: Fig 5-16: mean shear stress (Eq 5.10) over squares of 2.5 cm of discs, and that of each soil
# element: what, centre, half sides [m], kPa; and where the axle is.
BEGIN { FS = ","; edge = 0.025 }
FILENAME ~ /series.csv$/ { if (FNR == 1) for (k = 1; k <= NF; ++k) at[$k] = k; else hub_x = $at["wheel_x_m"]; next }
$1 == "element" { print "element," $2 "," $3 ",0.075,0.1," $7 / 1000 }
$1 == "disc" { sum[int($2 / edge) "," int($3 / edge)] += 3.14159265 * $4 * $4 * $7 / (edge * edge) / 1000 }
END {
    for (cell in sum) { split(cell, place, ","); printf "disc,%g,%g,%g,%g,%.4g\n", edge * (place[1] + 0.5), edge * (place[2] + 0.5), edge / 2, edge / 2, sum[cell] }
    printf "axle,%.4f,,,,\n", hub_x
}
