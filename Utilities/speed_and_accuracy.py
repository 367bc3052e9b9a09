#!/usr/bin/python3
"""Writes Documentation/Evidence/SpeedAndAccuracy.md and its figure from the benchmarks.

    Utilities/speed_and_accuracy.py BENCHMARKS PAGE_DATA TRADE [--page FILE] [--pictures FOLDER]

BENCHMARKS is build/release/benchmarks.json, PAGE_DATA build/release/page.json; both are written by
PalpateBenchmarks. TRADE is build/release/trade, written by Utilities/trade.sh. Utilities/bench.sh
calls all of them.
"""
import argparse
import json
import os
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import trade_page  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENTATION = ROOT / "Documentation"

INTRODUCTION = """# Speed and accuracy

Written by `Utilities/bench.sh` on {machine}, with {compiler}. Times are the shortest of many
repetitions on one core of that shared machine: read the ratios, and the instruction counts, which do not change from
run to run. Every benchmark compares the results of both sides before it times them.
"""

PEERS = """Eigen's and ITK's templates are compiled with the same compiler for AVX2 and FMA, as the kernels are (`/sse2`: for any
x86-64); VTK, GSL and libsharp are Debian's builds, for any x86-64. Eigen's fits are given the matrix of the harmonics,
which Palpate has to compute. *chained*: the direction of each call depends on the result of the previous one.

sphericart 2.0.3 (clang 14 with `-march=native`, AMD EPYC Zen 4, degree 12, double, one direction a call), which the
scripts do not install, took 331 ns independent and 337 ns chained; on the same machine GSL took 489 ns for the value
alone.
"""

AIMS_TEXT = """## Aims

For one core with AVX2, in double precision; frames (`render/`) on two cores. The aims of surface models (`surface/`,
`touch/surface/`) are for a machine on which GSL's gradient of degree 12 takes 541 ns; scale them by it.
"""

# Nanoseconds.
AIMS = {
    "sh/gradient/degree12/chained": 40,
    "sh/gradient/degree12/independent": 30,
    "sh/gradient/degree12/batch": 20,
    "sh/gradient/degree12/portable": 80,
    "sh/nearest/degree12/warm": 150,
    "sh/fit/4002x169": 600e3,
    "field/inside": 50,
    "field/firsthit": 500,
    "field/firsthit/tool": 500,
    "render/subvoxel/512": 1e9 / 30,
    "surface/second/degree12/independent": 120,
    "surface/second/degree20/independent": 300,
    "touch/sh/degree12": 250,
    "touch/surface/degree16": 600,
    "touch/subvoxel/26": 4e3,
    "drill/tick/3mm": 50e3,
    "elastic/tick/degree20": 3e3,
}
TRADE = """## Time of an evaluation against its accuracy

![Time for a radius and its gradient against the error]({picture})

Radius and gradient along one direction, of an organ-like body of 25 mm (coefficients of degree l fall as (l + 1)^-2.5,
up to degree 96). *Shape lost* is the part of the body that a model of that degree leaves out; *rounding* is the largest
error of the computed radius against sums in extended precision.
"""

CAPS = """## Missing directions

A cap around one axis is left out of 4,002 directions; the others sample organ-like bodies with 0.3 mm noise, fitted at
degree 12. *Noise gain* is the amplification of noise of the radii in the model, over the whole sphere.
"""


FOOTPRINTS = """## Memory of a field

The bone of a head phantom (16-bit samples, `Testing/Benchmarks/SkullPhantom`) as a field, compared with the whole
volume as dense floats: `vtkImageCast` for trilinear interpolation, `vtkImageBSplineCoefficients` for cubic. One thread
builds the field; VTK uses all.
"""

TOUCH = """## A minute of touch

A tool slides for 60 s at 1 kHz over a body of 25 mm (1 + 0.15 bumps of degrees 3 and 4), at 20 to 100 mm/s, 0.5 to 3 mm
deep. A tick's time is the shortest of five runs of the same path on one core, which excludes other programs. The ideal
force points to the nearest point of the exact body, found by the certified search. *Force jump* is the change of the
force from one tick to the next, relative to the larger of both (the ideal's is that of spherical harmonics); a
*seizure* is a proxy more than 2 mm from the true one. The published law is made for tools that are pressed in by less
than their radius; here the sphere is up to 3 mm deep.
"""

PUBLISHED = """## Compared with the two published systems

The comparisons of both systems, repeated: an organ of degree 12 against the 8,000 facets that are drawn of it, touched
by a point 1.5 mm deep, and a sphere in voxels of 0.5 mm touched by a sphere of 26 points, half a voxel deep. A tick is
everything from the device's sample to its force, running freely on one core. The published rates are from machines of
their time, while drawing: compare the methods with each other.
"""

ELASTIC_BUILDS = """## Elastic organs: elements and harmonics

Cost and accuracy of `palpate soften --elements --degree` with two threads: a sphere of 25 mm, 20 kPa, supported by 1
kPa/mm. Compliance is that to Hertz bumps of 0.5 to 8 mm, against the closed form; force is that of a spherical tool of
8 mm, 0.5 to 4 mm deep, against exact unilateral contact. Each is the largest error of five directions.
"""

ELASTIC_MAPS = """## Elastic organs: degree of the maps

Cost and accuracy of `palpate soften --map-degree`: a bumpy organ of 20 mm with a lesion of three times the modulus, 2
mm below its surface. The part left out is that of the compliance to a bump of 3 mm, between the positions of the fit. A
tick is `ElasticForce::Of` at a wandering position.
"""

# Entered by hand; see its text.
CHAI3D = """CHAI3D 3.3 (release build; a driver that is not part of this project; same description of body, path and depths; sphere
of 1 mm; one core of an AMD EPYC Zen 4 virtual machine), not run by `Utilities/bench.sh`. Compare orders of magnitude:

| touched | tick: median, µs | 99.9 % | place to surface: mean, mm | most | force angle error: mean | 99 % | most | force jump a tick: mean | most | seizures |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
| mesh of 8,000, static | 4.6 | 11 | 0.014 | 0.038 | 2.5° | 12° | 59° | 5.2 % | 86 % | 0 |
| mesh of 128,000, static | 24 | 79 | 0.0009 | 0.010 | 2.6° | 23° | 75° | 5.2 % | 84 % | 11 |
| mesh of 128,000, dynamic | 62 | 149 | 0.0011 | 0.009 | 0.7° | 12° | 74° | 0.7 % | 73 % | 10 |
| 128³ voxels, static | 2.4 | 4.5 | 0.13 | 0.48 | 19° | 38° | 55° | 6.1 % | 63 % | 216 |
| 256³ voxels, dynamic |  |  | 0.086 | 0.35 | 11° | 25° | 38° | 4.9 % | 44 % | 3 |
"""

SHOWN_ONCE = ("sh/value/", "sh/hessian/", "surface/point/", "surface/first/", "field/firsthit/tricubic",
              "render/subvoxel/1024")
VARIANTS = ("/portable", "/sse2", "/recurrence", "/chained", "/fixedpoint", "/itk")
REPEATED = ["spherical harmonics, sphere of 1 mm", "32,000 facets, sphere of 1 mm",
            "128³ voxels, the published law, 26 points on 1 mm"]  # as the rows next to them
IDEAL = ["ideal's: mean"]  # and "most": the same in every row of a minute of touch


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def table(head, rows):
    return "\n".join([row(*head), row(*["---"] * len(head)), *rows]) + "\n"


def time_text(nanoseconds):
    for limit, unit, scale in ((1e3, "ns", 1), (1e6, "µs", 1e3), (1e9, "ms", 1e6)):
        if nanoseconds < limit:
            return f"{nanoseconds / scale:.3g} {unit}"
    return f"{nanoseconds / 1e9:.3g} s"


def comparisons(entries):
    """Against other programs; what is compared with ours is among the aims, or in a table of its own."""
    rows = []
    for entry in entries:
        if "(ours)" in entry["against"] or entry["name"].startswith(("elastic/", *SHOWN_ONCE)) \
                or entry["name"].endswith(VARIANTS):
            continue
        count = f"{entry['instructions']:,.0f}" if "instructions" in entry else ""
        rows.append(row(f"`{entry['name']}`", time_text(entry["ns"]), count, entry["against"],
                        f"{entry['ratio']:.3g}"))
    return table(["benchmark", "time", "instructions", "against", "times faster"], rows)


def aims(entries):
    measured = {entry["name"]: entry["ns"] for entry in entries}
    rows = [row(f"`{name}`", time_text(aim), time_text(measured[name]),
                "yes" if measured[name] <= aim else f"{100 * (measured[name] / aim - 1):.0f} % above")
            for name, aim in AIMS.items()]
    return AIMS_TEXT + "\n" + table(["benchmark", "aim", "this run", "within"], rows)


def name_of(entry):
    return f"{entry['formulation']}, {entry['calls']}"


def with_short_lines(text):
    return "\n".join(line if line.startswith("|") else trade_page.wrapped(line) for line in text.split("\n"))


def without(text, columns=(), rows=()):
    """A table without some columns, and without the rows that have one of these cells."""
    lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.strip().splitlines()]
    kept = [i for i, name in enumerate(lines[0])
            if name not in columns and not (i and name == "most" and lines[0][i - 1] in columns)]
    return "\n".join(row(*[cells[i] for i in kept]) for cells in lines if not set(rows) & set(cells)) + "\n"


def draw(entries, file):
    figure, (shape, rounding) = pyplot.subplots(1, 2, figsize=(11, 4.8), constrained_layout=True)
    for name in dict.fromkeys(map(name_of, entries)):
        series = [e for e in entries if name_of(e) == name]
        times = [e["ns"] for e in series]
        marker = "s" if "batch" in name else "o"
        shape.loglog(times, [e["lost_rms_mm"] for e in series], "-", marker=marker, label=name)
        rounding.loglog(times, [e["rounding_mm"] for e in series], "-", marker=marker, label=name)
        for e in series if name.endswith(", one") else []:
            shape.annotate(e["degree"], (e["ns"], e["lost_rms_mm"]), textcoords="offset points",
                           xytext=(6, 3), fontsize=8)
    shape.set_title("what a degree costs and brings (numbers: the degree)", fontsize=9)
    rounding.set_title("what the arithmetic adds", fontsize=9)
    shape.set_ylabel("shape that the degree leaves out, RMS, mm")
    rounding.set_ylabel("largest rounding error, mm")
    for axes in (shape, rounding):
        axes.set_xlabel("time for one radius and gradient, ns")
        axes.grid(True, which="both", alpha=0.25)
    rounding.legend(fontsize=7, loc="center right")
    figure.savefig(file, dpi=110, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("benchmarks", type=pathlib.Path)
    parser.add_argument("page_data", type=pathlib.Path)
    parser.add_argument("trade", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, default=DOCUMENTATION / "Evidence" / "SpeedAndAccuracy.md")
    parser.add_argument("--pictures", type=pathlib.Path, default=DOCUMENTATION / "Images")
    arguments = parser.parse_args()
    measured = json.loads(arguments.page_data.read_text())
    scenes = trade_page.read(arguments.trade)
    if not scenes:
        parser.error(f"{arguments.trade} holds no scene; run Utilities/trade.sh")
    draw(measured["tradeoff"], arguments.pictures / "speed-accuracy.png")
    trade_page.draw(scenes, arguments.pictures / "trade.png")

    def link(name):
        return os.path.relpath(arguments.pictures / name, arguments.page.parent)

    pairs = [pair for pair in json.loads(arguments.benchmarks.read_text())
             if not pair["name"].startswith("sh/tradeoff/")]
    parts = [INTRODUCTION.format(machine=measured["machine"], compiler=measured["compiler"]),
             aims(pairs), "## Against others\n", PEERS, comparisons(pairs),
             trade_page.section(scenes, link("trade.png")),
             TRADE.format(picture=link("speed-accuracy.png")),
             PUBLISHED, with_short_lines(measured["published"]), TOUCH, without(measured["touch"], IDEAL, REPEATED), CHAI3D, ELASTIC_BUILDS,
             without(measured["elastic_builds"], rows=["8"]), ELASTIC_MAPS, measured["elastic_maps"], FOOTPRINTS,
             without(measured["footprints"], rows=["192³", "256³", "384³"]), CAPS,
             without(measured["caps"], rows=["10°", "30°", "50°", "1e-3"])]
    arguments.page.write_text("\n".join(parts))


if __name__ == "__main__":
    main()
