#!/bin/sh
# Builds and runs a part of the tests under the sanitizers, each preset in its own build tree: programs that lead
# through all kernels (fields, contact, masks to models, servo) and readers under AddressSanitizer and
# UndefinedBehaviorSanitizer, exchange between threads under ThreadSanitizer.
#   Utilities/sanitize.sh [--all]    with --all also the other tests of kernels and readers, twice as long
# For all tests (slow):
#   cmake --preset asan-ubsan && cmake --build --preset asan-ubsan && ctest --preset asan-ubsan
set -eu
cd "$(dirname "$0")/.."
others=
[ "${1-}" != --all ] || others="HarmonicsTests MeshTests ContactTests HapticsTests ElasticityTests FuzzTests"

# under PRESET PROGRAM[:TESTS]…: TESTS is a prefix of test names. Each is run separately, so that a
# prefix that selects no test fails.
under() {
  preset=$1
  shift
  echo "== $preset: build into build/$preset"
  cmake --preset "$preset" --log-level=NOTICE
  # shellcheck disable=SC2046 # a list of targets
  cmake --build --preset "$preset" --parallel "$(nproc)" \
    --target $(printf '%s\n' "$@" | sed 's/:.*//' | sort -u)
  for part in "$@"; do
    echo "== $preset: $part"
    code=0
    ctest --preset "$preset" --no-tests=error \
      -R "^${part%%:*}\\.$(printf '%s' "$part" | sed -n 's/^[^:]*://p')" || code=$?
    [ "$code" -eq 0 ] || failed="$failed $preset:$part"
  done
}

failed=
# shellcheck disable=SC2086 # a list of programs
under asan-ubsan FieldTests ModelTests TouchTests ServoTests IOTests $others
cmake --build --preset asan-ubsan --parallel "$(nproc)" --target PalpateFuzz
under tsan ThreadTests
if [ -n "$failed" ]; then
  echo "Failed:$failed" >&2
  exit 1
fi
