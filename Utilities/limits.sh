#!/bin/sh
# Measures the effect of rounding on hard fits (seconds), and writes the table of Documentation/Evidence/Limits.md
# from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh PalpateLimits
build/release/bin/PalpateLimits build/release/fit-precision.md
exec /usr/bin/python3 Utilities/limits.py build/release/fit-precision.md
