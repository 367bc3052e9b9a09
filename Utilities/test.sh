#!/bin/sh
# Installs what is missing, builds, and runs every test. Arguments go to ctest, for example
#   Utilities/test.sh -R Harmonics
# The exit code is that of ctest.
set -eu
cd "$(dirname "$0")/.."

Utilities/install-dependencies.sh
Utilities/build.sh

echo "== Tests: all of build/release; again without building: xvfb-run -a ctest --preset release -R NAME"
# One X server for all, since rendering needs one; it must not reset when a client leaves.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" ctest --preset release "$@"
