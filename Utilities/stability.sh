#!/bin/sh
# Measures the largest stable stiffness of structures on the simulated device (some minutes), and
# writes Documentation/Evidence/Stability.md and its figure from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh --preset benchmarks
build/release/bin/PalpateStability build/release/stability.json
exec /usr/bin/python3 Utilities/stability.py build/release/stability.json
