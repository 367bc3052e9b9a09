#!/bin/sh
# Two processor minutes of fuzzing under the sanitizers with fixed seeds, by two processes side by side; needs
# the build of Utilities/sanitize.sh. Inputs that fail are left in build/asan-ubsan/fuzz-failures.
set -eu
cd "$(dirname "$0")/.."

failures=$PWD/build/asan-ubsan/fuzz-failures
mkdir -p "$failures"
echo "== Fuzzing: seeds 1 and 2, a minute each; inputs that fail are left in $failures"
for seed in 1 2; do
  echo $seed
done | ASAN_OPTIONS=detect_leaks=0:log_path="$failures/report" \
  UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1:log_path="$failures/report" \
  xargs -P 2 -I '{}' build/asan-ubsan/bin/PalpateFuzz --seconds 60 --seed '{}' --output "$failures"
