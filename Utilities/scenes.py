#!/usr/bin/python3
"""Writes Documentation/Scenes.md from what PalpateScenes measured.

    Utilities/scenes.py MEASURED [--page FILE]

MEASURED is build/release/scenes.json (see Utilities/scenes.sh, which calls this).
"""
import argparse
import json
import pathlib

DOCUMENTATION = pathlib.Path(__file__).resolve().parent.parent / "Documentation"

INTRODUCTION = """# Scenes of many structures

Made by `Utilities/scenes.sh`, on {machine}, with {compiler}. Nothing is built, allocated or evaluated for what a scene
does not require; this page says so in numbers. `palpate scene explain` says it of any scene.

## A tick does not grow with the scene

All structures can be touched, and one is: an organ of degree 12, stroked 1.5 mm deep at 50 mm/s and 1 kHz. The others are
balls of 20 facets on a lattice of 60 mm round it. A tick is all that a servo does, from the device's sample to its force; its time
is the shortest of {strokes} strokes, so that other programs do not count. *Made in* is what publishing the scene takes, off the servo
thread; *bytes* are a follower's, its tracker's and the index's, without the models. From 1 to 10,000 structures the median
grows by {growth:.1f} %, on a clock that tells 10 ns (`touch/structures/10000` of `Utilities/bench.sh` times whole strokes). Forces have the bits of asking every structure in every tick (`TestServoScene`).
"""

SCENES = """## Memory follows what is touched

A scene file with an entry for every structure of one segmentation, of which the first ones are `touched` and the others
are neither seen nor touched. *Made* is what `palpate scene explain` counts; *servo* are
trackers and index; *process* is by how much it grew while the scene was made. The tick is the
median over two seconds of touch. Cubes are made of 6³ voxels, sub-voxel; AAL is mricron's atlas.
"""

ON_DEMAND = """## Bricks where the tool goes

The bone of a CT of 512³ voxels of 0.8 mm, touched and not seen, stroked by a ball of 2 mm at 90 mm/s for 5 s. With `"memory_mb"` only
the bricks round the tool are in memory, their records in a file without a name, and a coarse field beneath. *Felt by* is what
`palpate scene explain` counts; *process* is by how much it grew while the scene was made, which
itself takes the whole field for a moment. *Different* are ticks that differ in any bit from those of the whole field on the
same path, and by how much; *coarse* are ticks in which the tool was faster than its bricks; *versions* and *bricks read*
are what the stroke took.
"""

DEGREES = """## Degrees where the tool goes

Those of AAL's 116 structures that can be felt by harmonics of degree 12 ({structures}, fitted without a limit of what is hidden), all touched, stroked by a
ball of 2 mm at 90 mm/s for 20 s. With `"memory_mb"` each keeps its coefficients and a coarse body of degree 4; the model, its
stand-ins and their trackers are made when the tool comes near. *Kept* is what is there all the time, trackers included, *most at hand* what was there beside
it at most at once; *process* is by how much it grew for scene and stroke together. *Different* are ticks that differ in any bit from those of all in memory on
the same path; *coarse* are ticks that touched a coarse body; *brought* are structures that were made in that stroke. The budget counts
without the servo's followers and its index.
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
    return table(["structures", "tick, median", "beside one", "99.9 %", "longest", "made in",
                  "bytes a structure"], rows)


def scenes(entries):
    rows = [row(e["scene"], f"{e['structures']:,}", e["touched"], e["files_read"],
                f"{1e3 * e['read_s']:.0f} ms", f"{1e3 * e['make_s']:.0f} ms",
                f"{e['bytes'] / 1e3:,.1f} kB", f"{e['servo_bytes'] / 1e3:,.1f} kB",
                f"{e['resident_mib']:.1f} MiB", f"{e['tick_us']:.2f} µs") for e in entries]
    return table(["scene", "structures", "touched", "files read", "read in", "made in", "made",
                  "servo", "process", "tick, median"], rows)


def on_demand(entries):
    rows = [row(e["interpolation"],
                "all" if e["budget_mb"] is None else f"{e['budget_mb']:.1f} MB",
                f"{e['bytes'] / 1e6:.1f} MB", f"{e['resident_mib']:.0f} MiB",
                f"{e['make_s']:.1f} s", f"{e['tick_us']:.2f} µs",
                f"{e['different']:,} of {e['ticks']:,}, {e['largest_n']:.3g} N", f"{e['coarse']:,}",
                f"{e['versions']:,}" if e["versions"] else "–",
                f"{e['reads']:,}" if e["versions"] else "–") for e in entries]
    return table(["interpolation", "budget", "felt by", "process", "made in", "tick, median",
                  "different", "coarse", "versions", "bricks read"], rows)


def degrees(entries):
    rows = [row("all" if e["budget_mb"] is None else f"{e['budget_mb']:.0f} MB",
                f"{e['kept'] / 1e6:.1f} MB",
                "–" if e["budget_mb"] is None else f"{e['most'] / 1e6:.1f} MB",
                f"{e['resident_mib']:.0f} MiB",
                f"{e['different']:,} of {e['ticks']:,}", f"{e['coarse']:,}",
                "–" if e["budget_mb"] is None else f"{e['brought']:,}") for e in entries]
    return table(["budget", "kept", "most at hand", "process", "different", "coarse", "brought"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("measured", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=DOCUMENTATION / "Scenes.md")
    arguments = parser.parse_args()
    measured = json.loads(arguments.measured.read_text())
    medians = {e["structures"]: e["median_ns"] for e in measured["ticks"]}
    growth = 100 * (medians[10000] / medians[1] - 1)
    parts = [INTRODUCTION.format(machine=measured["machine"], compiler=measured["compiler"],
                                 strokes=20, growth=growth),
             ticks(measured["ticks"]), SCENES, scenes(measured["scenes"]),
             ON_DEMAND, on_demand(measured["on_demand"])]
    if measured["degrees"]:
        parts += [DEGREES.format(structures=measured["degrees"][0]["structures"]),
                  degrees(measured["degrees"])]
    arguments.page.write_text("\n".join(parts))


if __name__ == "__main__":
    main()
