#!/bin/bash
# check_paraview.sh BUILD: a small run's discs.xdmf and wheel.xdmf, opened by ParaView as they are, without a screen. ParaView
# must find the frames, points, cells and values that h5py finds in results.h5.
set -eu
here=$(dirname "$0") scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1/ifedem" run "$here/../reliability/tiny.toml" -o "$scratch/a run" --stages "$scratch/stages" --quiet > /dev/null
/usr/bin/python3 "$here/expect.py" "$scratch/a run/results.h5" "$scratch/expected.npz"
pvbatch "$here/compare.py" "$scratch/a run" "$scratch/expected.npz"
