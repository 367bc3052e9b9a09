#!/bin/sh
# Breaks the safety chain, the servo, the loops below them, effects, guides, organs that yield, the
# network, statistics and comparison line by line (Testing/Mutants/mutants.toml, about two hours),
# and writes the test that failed to Testing/Mutants/mutants.csv. Fails if a mutant survives. The
# sources are only read. Arguments restrict the run to files whose path contains one of them, --new
# to mutants that are not known to be killed; the other rows stay.
set -eu
# Some tests draw, on a separate X server.
exec xvfb-run -a /usr/bin/python3 "$(dirname "$0")/mutants.py" "$@"
