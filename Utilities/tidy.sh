#!/bin/sh
# Runs clang-tidy over our own sources, in parallel on all cores. Arguments select sources by a part
# of their path:
#   Utilities/tidy.sh Modules/Harmonics
# The preset dev is configured for it, which compiles each source on its own; it need not be built.
set -eu
cd "$(dirname "$0")/.."

cmake --preset dev --log-level=NOTICE
[ $# -gt 0 ] || set -- Modules/ Applications/ Testing/
for part in "$@"; do
  sed -n "s|^ *\"file\": \"$PWD/\(.*$part.*\.cxx\)\".*|\1|p" build/dev/compile_commands.json
done | grep -v '^build/' | sort -u |
  xargs --no-run-if-empty -P "$(nproc)" -n 1 clang-tidy -p build/dev --quiet --extra-arg=-Wno-unused-command-line-argument
