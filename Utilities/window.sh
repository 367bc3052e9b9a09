#!/bin/sh
# Measures the servo next to a window that draws, is resized, loads and refits, the time to start
# and to close the window, and what volumes and structures cost (three minutes), and writes Documentation/Evidence/Window.md from this run.
set -eu
cd "$(dirname "$0")/.."

Utilities/build.sh --preset benchmarks
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" build/release/bin/PalpateWindow build/release/window.json
rm -f build/release/tasks.md
PALPATE_TASKS=$PWD/build/release/tasks.md xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  build/release/bin/WidgetsTrialTests --gtest_filter='TasksTest.*'
exec /usr/bin/python3 Utilities/window.py build/release/window.json build/release/tasks.md
