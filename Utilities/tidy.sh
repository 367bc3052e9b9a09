#!/bin/sh
# Runs clang-tidy over our own sources, in parallel on all cores. Arguments select sources by a part
# of their path:
#   Utilities/tidy.sh Modules/Numerics
# BUILD names a build tree other than build/release.
set -eu
cd "$(dirname "$0")/.."
build=${BUILD:-build/release}

if [ ! -f "$build/compile_commands.json" ]; then
  echo "$build/compile_commands.json is missing: run Utilities/build.sh first." >&2
  exit 1
fi
[ $# -gt 0 ] || set -- Modules/ Applications/ Testing/
for part in "$@"; do
  sed -n "s|^ *\"file\": \"$PWD/\(.*$part.*\.cxx\)\".*|\1|p" "$build/compile_commands.json"
done | grep -v '^build/' | sort -u |
  xargs --no-run-if-empty -P "$(nproc)" -n 1 clang-tidy -p "$build" --quiet
