#!/bin/sh
# Fails if clang-format would change a source; skipped (77) if it is not installed.
set -eu
cd "$(dirname "$0")/../.."

if ! command -v clang-format >/dev/null; then
  echo "clang-format is not installed: the format is not checked."
  exit 77
fi
find Modules Applications Testing \( -name '*.h' -o -name '*.cxx' \) -print0 |
  xargs -0 clang-format --dry-run -Werror
