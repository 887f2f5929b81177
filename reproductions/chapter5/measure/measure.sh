#!/bin/sh
# measure.sh IFEDEM OUT RUN...: what the claims of chapter 5 compare, from finished runs named REGION-sSLIP-rREALISATION (-WHAT: a variant).
# Writes OUT/runs.csv (means of each run), OUT/curves.csv (means over realisations), OUT/epochs.csv (what a conversion does to
# the tyre), OUT/surface-RUN.csv, OUT/upheaval.csv, OUT/measurements.csv and the report's pictures.
set -eu
ifedem=$1 out=$2
shift 2
mkdir -p "$out"
here=$(dirname "$0")

echo "run,kind,quantity,conversions,step,standard_error" > "$out/epochs.csv"
echo "run,band_kPa,behind_kPa,front_kPa,rear_kPa,lowest_kPa,highest_kPa" > "$out/shear.csv"
echo "run,region,slip_percent,realisation,gross_N,net_N,resistance_N,sinkage_cm,vertical_N,slip,cpu_s,conversions,refused,upheaval_cm,rut_cm,discs,state_hash,results_version" > "$out/runs.csv"
for run in "$@"; do
    name=$(basename "$run")
    "$ifedem" surface "$run" -o "$out/surface-$name.csv"
    conversions=
    if [ -f "$run/conversions.csv" ]; then
        conversions=$run/conversions.csv
        step_s=$(sed -n 's/^time_step_s = \([^ ]*\).*/\1/p' "$run/case.toml")
        awk -v step_s="$step_s" -v half=0.25 -v name="$name" -f "$here/epoch.awk" "$conversions" "$run/soil.csv" "$run/series.csv" >> "$out/epochs.csv"
    fi
    awk -v name="$name" -f "$here/travel.awk" "$run/run.csv" ${conversions:+"$conversions"} "$run/series.csv" "$out/surface-$name.csv" >> "$out/runs.csv"
    [ ! -f "$run/stress.csv" ] || awk -v name="$name" -f "$here/shear_means.awk" "$run/series.csv" "$run/stress.csv" >> "$out/shear.csv"

    # Pictures
    case $name in *-s40-r1 | *-s70-r1) cp "$run/snapshot_bed.png" "$out/${name%-r1}.png" ;; esac
    case $name in small-s40-r1 | discs-s40-r1)
        awk -f "$here/shear_tiles.awk" "$run/series.csv" "$run/stress.csv" | sort > "$out/shear-${name%-r1}.csv" ;;
    esac
    [ "$name" != large-s40-r1 ] || "$ifedem" picture "$run" -o "$out" --sheet --animation --pressure
done

awk -v out="$out" -f "$here/statistics.awk" -f "$here/measurements.awk" "$out/runs.csv"
set -- "$out"/surface-*-s70-r1*.csv
[ ! -f "$1" ] || awk -f "$here/upheaval.awk" "$@" > "$out/upheaval.csv"
awk -f "$here/statistics.awk" -f "$here/epochs.awk" "$out/epochs.csv" "$out/shear.csv" >> "$out/measurements.csv"
awk -f "$here/time.awk" "$out/runs.csv" > "$out/time.csv"
