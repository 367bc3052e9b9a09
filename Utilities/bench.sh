#!/bin/sh
# Builds and runs the benchmarks whose name contains the argument (all without one); prints each
# next to its alternative from the same run, and writes build/release/benchmarks.json. Without an
# argument it also measures the sample scenes (Utilities/trade.sh) and writes
# Documentation/Evidence/SpeedAndAccuracy.md and its pictures from this run.
set -eu
cd "$(dirname "$0")/.."
# Frames are drawn with OpenGL, on a separate X server.
benchmarks="xvfb-run -a build/release/bin/PalpateBenchmarks"
counts=build/release/instructions

Utilities/build.sh --preset benchmarks
rm -rf "$counts"
mkdir -p "$counts"
echo "Counting instructions (some minutes without a filter) ..." >&2
valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file="$counts/count" --quiet \
  build/release/bin/PalpateBenchmarks --count-only --filter "${1:-}" >"$counts/log" 2>&1 ||
  echo "They could not be counted; see $counts/log." >&2
if [ $# -gt 0 ]; then
  exec $benchmarks --filter "$1" --instructions "$counts" --json build/release/benchmarks.json
fi
$benchmarks --instructions "$counts" --json build/release/benchmarks.json \
  --page-json build/release/page.json
rm -rf build/release/trade
Utilities/trade.sh
exec /usr/bin/python3 Utilities/speed_and_accuracy.py build/release/benchmarks.json \
  build/release/page.json build/release/trade
