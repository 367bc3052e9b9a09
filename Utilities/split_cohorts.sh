#!/bin/sh
# Prints how often the tests of covariates reject a true null hypothesis and find known bumps, in studies
# drawn from the masks of a folder. Takes some twenty minutes.
#   Utilities/split_cohorts.sh MASKS [COHORTS [PERMUTATIONS]]
set -eu
cd "$(dirname "$0")/.."
masks=${1:?the folder of masks}

Utilities/build.sh palpate PalpateSplitCohorts
build/release/bin/palpate fit "$masks" --output build/split-cohorts >/dev/null || true
exec build/release/bin/PalpateSplitCohorts build/split-cohorts "${2:-2000}" "${3:-499}"
