#!/bin/sh
# Fuzzes readers for a long time with Clang's libFuzzer, which keeps the inputs that reach new code:
#   Utilities/fuzz.sh                      every reader, ten minutes each
#   Utilities/fuzz.sh --seconds 3600 vtp   one reader, for an hour
# Inputs that reach new code stay in build/fuzz/corpus/READER for the next run; inputs that fail are
# stored in build/fuzz/failures, and the exit code is 1. PalpateFuzz --list names the readers; it also
# fuzzes without Clang (Testing/Fuzz/README.md).
set -eu
cd "$(dirname "$0")/.."

seconds=600
if [ "${1-}" = --seconds ]; then
  seconds=${2:?--seconds needs a number}
  shift 2
fi

probe='extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'
if ! echo "$probe" | clang++ -fsanitize=fuzzer -x c++ - -o /dev/null 2>/dev/null; then
  echo "Clang with libFuzzer is missing: install the packages clang and libclang-rt-14-dev." >&2
  exit 1
fi
echo "== Build: preset fuzz into build/fuzz"
cmake --preset fuzz --log-level=NOTICE
cmake --build --preset fuzz --parallel "$(nproc)" --target PalpateLibFuzzer

fuzzer=$PWD/build/fuzz/bin/PalpateLibFuzzer
failures=$PWD/build/fuzz/failures
mkdir -p "$failures"
# shellcheck disable=SC2046 # a list of names
[ $# -gt 0 ] || set -- $(PALPATE_FUZZ_TARGET= "$fuzzer" 2>&1 | sed -n 's/.*name one of//p')
[ $# -gt 0 ] || { echo "No reader was specified, and the fuzzer lists none." >&2; exit 1; }
failed=
total=0
for reader in "$@"; do
  corpus=$PWD/build/fuzz/corpus/$reader
  mkdir -p "$corpus"
  log=$PWD/build/fuzz/$reader.log
  # Limits as in Testing/Fuzz/InputLimits.h, plus the overhead of the sanitizers.
  code=0
  PALPATE_FUZZ_TARGET=$reader ASAN_OPTIONS=detect_leaks=0:log_path=$failures/$reader-report \
    UBSAN_OPTIONS=print_stacktrace=1:log_path=$failures/$reader-report \
    "$fuzzer" -max_total_time="$seconds" -max_len=262144 -timeout=60 -rss_limit_mb=2048 \
    -malloc_limit_mb=1024 -print_final_stats=1 -artifact_prefix="$failures/$reader-" \
    "$corpus" >"$log" 2>&1 || code=$?
  inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  total=$((total + ${inputs:-0}))
  echo "$reader: ${inputs:-no} inputs, $(ls "$corpus" | wc -l) kept, exit code $code ($log)"
  [ "$code" -eq 0 ] || failed="$failed $reader"
done
echo "$total inputs."
if [ -n "$failed" ]; then
  echo "Failed:$failed; the inputs are in $failures." >&2
  exit 1
fi
