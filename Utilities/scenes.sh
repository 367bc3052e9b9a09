#!/bin/sh
# Measures the cost of scenes of 1 to 100,000 structures when one is touched (under a minute), and
# writes Documentation/Evidence/Scenes.md from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh --preset benchmarks
build/release/bin/PalpateScenes build/release/scenes.json
exec /usr/bin/python3 Utilities/scenes.py build/release/scenes.json
