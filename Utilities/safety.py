#!/usr/bin/python3
"""Writes the table of times from a fault to 0 N into Documentation/Safety.md.

    Utilities/safety.py RESULTS...

RESULTS are GoogleTest's JSON (see Utilities/safety.sh, which calls this) of tests that recorded the
properties `front`, `fault` and ticks or milliseconds. Only the part of the page between the two
comments is replaced. A failed test is an error, and nothing is written.
"""
import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "Documentation" / "Safety.md"
BEGIN = "<!-- Utilities/safety.py writes from here -->\n"
END = "<!-- to here -->\n"
FRONTS = ("virtual time", "libusb", "virtual bus", "Inverse3", "library")


def tests_of(path):
    for suite in json.loads(pathlib.Path(path).read_text())["testsuites"]:
        yield from suite["testsuite"]


def words(name):
    """'SwitchedOffWhileOwed' -> 'switched off while owed'; acronyms and sentences are unchanged."""
    if " " in name and not name.startswith("SIG"):
        return name[0].lower() + name[1:]
    parts = re.findall(r"SIG[A-Z]+|NaN|[A-Z][a-z]*|[a-z]+|\d+", name)
    return " ".join(p if p.isupper() and len(p) > 1 or p == "NaN" else p.lower() for p in parts)


def cell(test):
    if "ticks_from_fault" in test:
        return f'{test["ticks_from_fault"]} ({test["ticks_from_cause"]})'
    if "ticks" in test:
        return str(test["ticks"])
    text = f'{float(test["milliseconds"]):.1f}'
    if "milliseconds_from_fault" in test:
        text = f'{float(test["milliseconds_from_fault"]):.1f} ({text})'
    return text


def main():
    rows = {}
    for path in sys.argv[1:]:
        for test in tests_of(path):
            if "failures" in test:
                sys.exit(f'{test["classname"]}.{test["name"]} failed: no table')
            if "front" in test:
                rows.setdefault(test["fault"], {})[test["front"]] = cell(test)
    if not rows:
        sys.exit("no test recorded a fault")
    lines = ["| fault | virtual time: ticks from the fault (from its cause) | libusb: ms, likewise "
             "| virtual bus: ms | Inverse3: ticks from the cause, most of 50 | makers' libraries, force and torque: "
             "likewise |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [f"| {words(fault)} | " + " | ".join(row.get(front, "–") for front in FRONTS) + " |"
              for fault, row in sorted(rows.items(), key=lambda item: words(item[0]))]
    before, rest = PAGE.read_text().split(BEGIN)
    PAGE.write_text(before + BEGIN + "\n".join(lines) + "\n" + END + rest.split(END)[1])


if __name__ == "__main__":
    main()
