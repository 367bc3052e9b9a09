#!/bin/sh
# Breaks the safety chain, the servo and the loops below them line by line (Testing/Mutants/mutants.toml,
# half an hour), and writes Documentation/Mutants.md: which test noticed. Fails where a mutant survives.
# The working tree is only read. One argument tries the files alone whose path holds it, and writes nothing.
set -eu
exec /usr/bin/python3 "$(dirname "$0")/mutants.py" "$@"
