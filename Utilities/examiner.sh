#!/bin/sh
# Lets the virtual examiner search elastic phantoms for nodules (some minutes on one core), and writes
# Documentation/Evidence/VirtualExaminer.md from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh PalpateExaminer
build/release/bin/PalpateExaminer build/release/examiner.json
exec /usr/bin/python3 Utilities/examiner.py build/release/examiner.json
