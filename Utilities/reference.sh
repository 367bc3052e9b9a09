#!/bin/sh
# Makes the reference of all headers, build/reference/html/index.html; fails on every warning of
# Doxygen.
set -eu
cd "$(dirname "$0")/.."

mkdir -p build
doxygen Documentation/Doxyfile
echo "build/reference/html/index.html"
