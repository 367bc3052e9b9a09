#!/bin/sh
# Builds and runs a part of the tests under the sanitizers, each preset in its own build tree:
# kernels, readers and servo under AddressSanitizer and UndefinedBehaviorSanitizer, what is exchanged
# between threads under ThreadSanitizer. The whole of it, for a slow evening:
#   cmake --preset asan-ubsan && cmake --build --preset asan-ubsan && ctest --preset asan-ubsan
set -eu
cd "$(dirname "$0")/.."

# under PRESET PROGRAM[:TESTS]…: TESTS is a regular expression after the program's name.
under() {
  preset=$1
  shift
  echo "== $preset: build"
  cmake --preset "$preset" --log-level=NOTICE
  # shellcheck disable=SC2046 # a list of targets
  cmake --build --preset "$preset" --parallel "$(nproc)" --target $(printf '%s\n' "$@" | sed 's/:.*//')
  for part in "$@"; do
    echo "== $preset: $part"
    # A program that matches no test fails here, rather than all of them together.
    ctest --preset "$preset" --output-on-failure --progress --no-tests=error \
      -R "^${part%%:*}\\.$(printf '%s' "$part" | sed -n 's/^[^:]*://p')"
  done
}

under asan-ubsan NumericsTests FieldTests HapticsTests ServoTests IOTests FuzzTests
cmake --build --preset asan-ubsan --parallel "$(nproc)" --target PalpateFuzz
under tsan RealtimeTests ServoTests \
  'FieldTests:(FieldThreads|EditedField|FieldVersions)' \
  'HapticsTests:(OnDemand|DrillEditor|DrillFeed|TrackerSlot)'
