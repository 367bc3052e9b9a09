#!/bin/sh
# Runs in full the slow proofs, of which ctest runs a part: many more random scenes, masks and minutes. Ten minutes on
# two cores; the last run is in Documentation/Evidence/Proofs.md.
#   Utilities/prove.sh [OPTION OF CTEST…]
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh
export PALPATE_PROVE=1
proofs='WholeGland|EveryOtherMask|SameModel\.|SameScene\.|ForMinutes|MinutesOfStrokes|Structure\.Configurations|MixedModel(TypeOne|AgainstR)|SideAsymmetryTypeOne\.'
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" ctest --preset release -R "$proofs" --timeout 900 "$@"
exec build/release/bin/PalpateFuzz --inputs 500 --output build/release/fuzz-failures
