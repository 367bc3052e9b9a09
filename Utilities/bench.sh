#!/bin/sh
# Builds and runs the benchmarks whose name contains the argument (all without one); prints each
# beside its alternative from the same run, and writes build/release/benchmarks.json. Without an
# argument it also writes Documentation/SpeedAndAccuracy.md and its picture from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh
if [ $# -gt 0 ]; then
  exec build/release/bin/PalpateBenchmarks --filter "$1" --json build/release/benchmarks.json
fi
build/release/bin/PalpateBenchmarks --json build/release/benchmarks.json \
  --page-json build/release/page.json
exec /usr/bin/python3 Utilities/speed_and_accuracy.py build/release/benchmarks.json \
  build/release/page.json
