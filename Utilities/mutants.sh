#!/bin/sh
# Breaks the safety chain, the servo and the loops below them line by line
# (Testing/Mutants/mutants.toml, half an hour), and writes the test that failed to
# Documentation/Mutants.md. Fails if a mutant survives. The working tree is only read. An argument
# restricts the run to files whose path contains it, and writes nothing.
set -eu
exec /usr/bin/python3 "$(dirname "$0")/mutants.py" "$@"
