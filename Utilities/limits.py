#!/usr/bin/python3
"""Writes the table measured by PalpateLimits into Documentation/Evidence/Limits.md.

    Utilities/limits.py [TABLE] [--page FILE]

TABLE is build/release/fit-precision.md (see Utilities/limits.sh, which calls this). Only the part
of the page between the two comments is replaced. Every test named on the page must exist in
Testing/Extremes or in a module, otherwise nothing is written; without TABLE only this is checked.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN = "<!-- Utilities/limits.py writes from here -->\n"
END = "<!-- to here -->\n"
TEST = re.compile(r"\bTEST(?:_P|_F)?\(\s*(\w+),\s*(\w+)\s*\)|\bTYPED_TEST\(\s*(\w+),\s*(\w+)\s*\)")
SKIPPED = tuple(f"| all but a cap of {degrees}° |" for degrees in (10, 30, 50))  # others show the course
NAMED = re.compile(r"`([A-Z]\w+\.[A-Z]\w+)`")


def known_tests():
    tests = set()
    for folder in ("Testing", "Modules"):
        for path in (ROOT / folder).rglob("Test*.cxx"):
            for first, second, typed, name in TEST.findall(path.read_text()):
                tests.add(f"{first or typed}.{second or name}")
    return tests


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table", type=pathlib.Path, nargs="?")
    parser.add_argument("--page", type=pathlib.Path, default=ROOT / "Documentation" / "Evidence" / "Limits.md")
    arguments = parser.parse_args()
    page = arguments.page.read_text()
    unknown = sorted(set(NAMED.findall(page)) - known_tests())
    if unknown:
        sys.exit(f"{arguments.page} names tests that do not exist: {', '.join(unknown)}")
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    if arguments.table is not None:
        rows = [line for line in arguments.table.read_text().splitlines() if not line.startswith(SKIPPED)]
        arguments.page.write_text(before + BEGIN + "\n".join(rows) + "\n" + END + after)


if __name__ == "__main__":
    main()
