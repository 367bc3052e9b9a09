#!/bin/sh
# Configures a preset, release unless another one is named, and builds it incrementally: everything, or the
# targets that are named.
#   Utilities/build.sh [--preset PRESET] [TARGET…]
set -eu
cd "$(dirname "$0")/.."

preset=release
if [ "${1-}" = --preset ]; then
  preset=${2:?--preset needs a name}
  shift 2
fi
echo "== Build: preset $preset (programs in build/release/bin)"
cmake --preset "$preset" --log-level=NOTICE
[ $# -eq 0 ] || set -- --target "$@"
cmake --build --preset "$preset" --parallel "$(nproc)" "$@"
