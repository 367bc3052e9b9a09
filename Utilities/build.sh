#!/bin/sh
# Configures the release preset and builds it into build/release, incrementally: everything, or the
# targets that are named.
set -eu
cd "$(dirname "$0")/.."

echo "== Build: preset release into build/release (programs in build/release/bin)"
cmake --preset release --log-level=NOTICE
[ $# -eq 0 ] || set -- --target "$@"
cmake --build --preset release --parallel "$(nproc)" "$@"
