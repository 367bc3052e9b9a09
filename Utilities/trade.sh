#!/bin/sh
# Measures the cost in accuracy of speed on four sample scenes (some minutes): a prostate-like phantom
# with thick slices, one that yields and has a nodule, a thalamus of Debian's brain atlas, bone in
# Debian's CT of a head. Pages and numbers are written to build/release/trade; Utilities/bench.sh copies them to
# Documentation/Evidence/SpeedAndAccuracy.md.
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
echo "== Trade: a gland that yields, with a nodule of 8 mm"
"$palpate" phantom --output "$output/nodule" --nodule 8,3
cat > "$output/nodule/gland.scene.json" << 'EOF'
{"format": "palpate-scene", "structures": [
  {"file": "mask.nii.gz", "name": "gland", "representation": "elastic", "modulus_kpa": 20, "free_side": "posterior"},
  {"file": "nodule.nii.gz", "touched": false, "inclusion_kpa": 60}],
 "tool": {"shape": "sphere", "radius_mm": 4}}
EOF
"$palpate" tradeoff "$output/nodule/gland.scene.json" --output "$output/yielding" "$@"
echo "== Trade: a thalamus, 1 mm"
"$palpate" tradeoff "$atlas" --label Thalamus_L --output "$output/thalamus" "$@"
echo "== Trade: bone in a CT, 0.96 x 0.96 x 1.5 mm"
/usr/bin/python3 Data/convert_invesalius.py "$head" "$output/head.nrrd"
"$palpate" tradeoff "$output/head.nrrd" --iso 300 --tool-radius 1.5 --output "$output/bone" "$@"
