#!/bin/bash
# run_fuzzers.sh SECONDS: each fuzzer for that long, from the corpus that earlier runs left, or from the seeds.
# Lines go to build/fuzz.csv: fuzzer,executions,crashes. Ends with 1 if there was a crash, a hang or a leak.
set -eu
seconds=$1 build=build-fuzz failed=0
corpus=$build/corpus
mkdir -p $corpus/case $corpus/mesh $corpus/checkpoint
cp -n reproductions/*/cases/*.toml tests/reliability/tiny.toml $corpus/case/
cp -n tests/support/gmsh/*.msh $corpus/mesh/
if [ ! -f $corpus/checkpoint/seed ]; then
    build/ifedem run tests/reliability/tiny.toml -o $build/seed --stages $build/stages --stop-at-step 5500 --quiet --force > /dev/null
    cp $build/seed/checkpoint.h5 $corpus/checkpoint/seed
fi
build/ifedem describe | awk '/^\[/ { table = substr($1, 2, length($1) - 2) "." } /^  [a-z]/ { print "\"" table $1 "\"" }' > $build/case.dict
printf '"%s"\n' '$MeshFormat' '$EndMeshFormat' '$PhysicalNames' '$Entities' '$Nodes' '$EndNodes' '$Elements' '2.2 0 8' '4.1 0 8' rim surface lug > $build/mesh.dict
echo "fuzzer,executions,crashes" > build/fuzz.csv
for name in case mesh checkpoint; do
    dictionary=()
    [ ! -f $build/$name.dict ] || dictionary=(-dict=$build/$name.dict)
    status=0
    $build/tests/fuzz/${name}_fuzzer -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=100000 -print_final_stats=1 \
        -artifact_prefix=$build/$name- "${dictionary[@]}" $corpus/$name > $build/$name.log 2>&1 || status=$?
    executions=$(awk '/stat::number_of_executed_units/ { print $2 }' $build/$name.log)
    echo "$name,${executions:-0},$([ $status = 0 ] && echo 0 || echo 1)" >> build/fuzz.csv
    [ $status = 0 ] || { failed=1; tail -40 $build/$name.log; }
done
cat build/fuzz.csv
exit $failed
