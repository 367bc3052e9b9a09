#!/bin/sh
# Configures and builds the release preset into build/release, incrementally.
set -eu
cd "$(dirname "$0")/.."

echo "== Build: preset release into build/release (programs in build/release/bin)"
cmake --preset release --log-level=NOTICE
cmake --build --preset release --parallel "$(nproc)"
