#!/bin/sh
# Builds and runs the benchmarks whose name contains the argument (all without one); prints each
# beside its alternative from the same run, and writes build/release/benchmarks.json.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh
exec build/release/bin/PalpateBenchmarks --filter "${1:-}" --json build/release/benchmarks.json
