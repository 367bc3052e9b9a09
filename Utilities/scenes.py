#!/usr/bin/python3
"""Writes Documentation/Evidence/Scenes.md from the measurements of PalpateScenes.

    Utilities/scenes.py MEASURED [--page FILE]

MEASURED is build/release/scenes.json (see Utilities/scenes.sh, which calls this).
"""
import argparse
import json
import pathlib

DOCUMENTATION = pathlib.Path(__file__).resolve().parent.parent / "Documentation"

INTRODUCTION = """# Scenes of many structures

Made by `Utilities/scenes.sh`, on {machine}, with {compiler}. `palpate scene explain` lists
what a scene requires.

## A tick does not grow with the scene

All structures can be touched, and one is: an organ of degree 12, stroked 1.5 mm deep at 50 mm/s and 1 kHz; the others
are spheres of 20 facets. A tick's time is the shortest of {strokes} strokes. *Made in* is the time to publish the scene, off
the servo thread; *bytes* counts followers, their trackers and the index. From 1 to 10,000 structures the median grows
by {growth:.1f} %, on a clock with a resolution of 10 ns. Forces equal, bit for bit, those of a servo that queries every
structure in every tick (`TestServoScene`).
"""

SCENES = """## Memory by touched structures

A scene file with an entry for every structure of one segmentation, of which the first ones are `touched`. *Made* is the
memory that `palpate scene explain` reports; *servo* is that of trackers and index; *process* is the growth of the
process. Cubes are made of 6³ voxels, sub-voxel; AAL is mricron's atlas.
"""

def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def table(head, rows):
    return "\n".join([row(*head), row(*["---"] * len(head)), *rows]) + "\n"


def ticks(entries):
    first = entries[0]["median_ns"]
    rows = [row(f"{e['structures']:,}", f"{e['median_ns']:.0f} ns",
                f"{100 * (e['median_ns'] / first - 1):+.1f} %", f"{e['p999_ns']:.0f} ns",
                f"{e['max_ns']:.0f} ns", f"{1e3 * e['publish_s']:.1f} ms",
                f"{e['bytes_each']:,.0f}") for e in entries]
    return table(["structures", "tick, median", "compared with one", "99.9 %", "longest", "made in",
                  "bytes a structure"], rows)


def scenes(entries):
    rows = [row(e["scene"], f"{e['structures']:,}", e["touched"], e["files_read"],
                f"{1e3 * e['read_s']:.0f} ms", f"{1e3 * e['make_s']:.0f} ms",
                f"{e['bytes'] / 1e3:,.1f} kB", f"{e['servo_bytes'] / 1e3:,.1f} kB",
                f"{e['resident_mib']:.1f} MiB", f"{e['tick_us']:.2f} µs") for e in entries]
    return table(["scene", "structures", "touched", "files read", "read in", "made in", "made",
                  "servo", "process", "tick, median"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("measured", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=DOCUMENTATION / "Evidence" / "Scenes.md")
    arguments = parser.parse_args()
    measured = json.loads(arguments.measured.read_text())
    medians = {e["structures"]: e["median_ns"] for e in measured["ticks"]}
    growth = 100 * (medians[10000] / medians[1] - 1)
    parts = [INTRODUCTION.format(machine=measured["machine"], compiler=measured["compiler"],
                                 strokes=20, growth=growth),
             ticks(measured["ticks"]), SCENES, scenes(measured["scenes"])]
    arguments.page.write_text("\n".join(parts))


if __name__ == "__main__":
    main()
