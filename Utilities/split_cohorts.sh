#!/bin/sh
# Prints how often the tests of covariates reject a true null hypothesis and find known bumps of
# masks, in studies drawn from the masks of a folder. Takes about an hour of a processor.
#   Utilities/split_cohorts.sh MASKS [COHORTS [PERMUTATIONS]]
set -eu
cd "$(dirname "$0")/.."
masks=${1:?the folder of masks}
out=build/split-cohorts

Utilities/build.sh palpate PalpateFitBumps PalpateSplitCohorts
build/release/bin/palpate fit "$masks" --output "$out/fit" >/dev/null || true
printf '%s\n' posterior left anterior superior |
  xargs -P "$(nproc)" -I '{}' build/release/bin/PalpateFitBumps "$out/fit" "$out" '{}'
exec build/release/bin/PalpateSplitCohorts "$out/fit" "$out" "${2:-2000}" "${3:-499}"
