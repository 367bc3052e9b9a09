#!/bin/sh
# Breaks the safety chain, the servo, the loops below them and organs that yield line by line
# (Testing/Mutants/mutants.toml, about an hour), and writes the test that failed to
# Documentation/Mutants.md. Fails if a mutant survives. The working tree is only read. An argument
# restricts the run to files whose path contains it, and writes nothing.
set -eu
exec /usr/bin/python3 "$(dirname "$0")/mutants.py" "$@"
