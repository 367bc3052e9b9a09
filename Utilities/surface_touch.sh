#!/bin/sh
# Prints how true touch of surface models is, next to searches of the whole surface, and how long its
# ticks take: of phantoms, or of the models (JSON) that are named. Takes half an hour.
#   Utilities/surface_touch.sh [MODEL.json ...]
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh --preset benchmarks
exec build/release/bin/PalpateSurfaceTouch 6667 1000000 30000 "$@"
