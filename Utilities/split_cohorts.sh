#!/bin/sh
# Prints how often the tests of covariates reject a true null hypothesis and find known bumps of
# masks, in studies drawn from the masks of a folder, by models of degree 20. Takes about an hour of a
# processor.
#   Utilities/split_cohorts.sh MASKS [COHORTS [PERMUTATIONS [DEGREE]]]
set -eu
cd "$(dirname "$0")/.."
masks=${1:?the folder of masks}
degree=${4:-20}
out=build/split-cohorts/$degree

Utilities/build.sh palpate PalpateFitBumps PalpateSplitCohorts
build/release/bin/palpate fit "$masks" --model radial --degree "$degree" --output "$out/fit" >/dev/null || true
printf '%s\n' flat posterior left anterior superior |
  xargs -P "$(nproc)" -I '{}' build/release/bin/PalpateFitBumps "$out/fit" "$out" '{}'
exec build/release/bin/PalpateSplitCohorts "$out/fit" "$out" "${2:-2000}" "${3:-499}"
