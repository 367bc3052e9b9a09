#!/bin/sh
# Measures the cost in accuracy of speed on three sample scenes (some minutes): a prostate-like phantom
# with thick slices, a thalamus of Debian's brain atlas, bone in Debian's CT of a head. Pages and
# numbers are written to build/release/trade; Utilities/bench.sh copies them to
# Documentation/SpeedAndAccuracy.md.
set -eu
cd "$(dirname "$0")/.."
palpate=build/release/bin/palpate
output=build/release/trade
atlas=/usr/share/mricron/templates/aal.nii.gz
head=/usr/share/doc/invesalius-examples/examples/Cranium.inv3

[ -x "$palpate" ] || Utilities/build.sh
mkdir -p "$output"

echo "== Trade: a gland, as MR shows it: 0.5 x 0.5 x 3 mm"
"$palpate" phantom --output "$output/phantom" --spacing 0.5,0.5,3
"$palpate" tradeoff "$output/phantom/mask.nii.gz" --output "$output/gland" "$@"
echo "== Trade: a thalamus, 1 mm"
"$palpate" tradeoff "$atlas" --label Thalamus_L --output "$output/thalamus" "$@"
echo "== Trade: bone in a CT, 0.96 x 0.96 x 1.5 mm"
/usr/bin/python3 Data/convert_invesalius.py "$head" "$output/head.nrrd"
"$palpate" tradeoff "$output/head.nrrd" --iso 300 --tool-radius 1.5 --output "$output/bone" "$@"
