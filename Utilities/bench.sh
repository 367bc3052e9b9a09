#!/bin/sh
# Builds and runs the benchmarks whose name contains the argument (all without one); prints each
# beside its alternative from the same run, and writes build/release/benchmarks.json. Where valgrind
# is installed, instructions are counted too, which do not depend on what else the machine does.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh
counts=$(mktemp -d)
trap 'rm -rf "$counts"' EXIT
if command -v valgrind >/dev/null; then
  valgrind --quiet --tool=callgrind --instr-atstart=no --callgrind-out-file="$counts/count" \
    build/release/bin/PalpateBenchmarks --filter "${1:-}" --count-only 2>"$counts/log" ||
    echo "Instructions could not be counted; times follow without them."
fi
build/release/bin/PalpateBenchmarks --filter "${1:-}" --instructions "$counts" \
  --json build/release/benchmarks.json
