#!/usr/bin/python3
"""Measures lengths along the surfaces of patients' models, forwards, backwards and by maps.

    Utilities/geodesics.py build/release/bin/palpate DATA --page Documentation/Evidence/Geodesics.md

DATA has the folders whole_gland and zones (label 1: peripheral zone). Seeds are fixed.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile
import textwrap

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

TARGETS = 6
LONGER = 0.005  # of the length: another route
PAGE = """
# Geodesics: lengths along a surface

Written by `Utilities/geodesics.py`: models of {cases} patients' whole glands (radial, degree 12) and peripheral zones
(surface, degree 20), from a random point of each to {targets} others. *Number*: `palpate measure --to`, on the model. *Not the
shortest*: more than 0.5 % longer than the number measured backwards or the map's length. *Change*: at the last refinement.
*Map*: `--map`, exact for triangles with points on the model, against the shortest of both numbers.

| organ | pairs | not the shortest | change, largest | map's error, mean | map's error, largest |
| --- | --- | --- | --- | --- | --- |
{rows}

On spheres and on arcs over the flat face of an ellipsoid with semi-axes of 40, 20 and 10 mm, lengths are those of great
circles and elliptic integrals to 1e-6 (test `ModelPaths`). The heat method was not used: on zones its error is 5 % or more.
"""


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def text_of(point):
    return ",".join(f"{x:.6f}" for x in point)


class Organ:
    def __init__(self, palpate, model):
        self.palpate, self.model = palpate, model

    def measure(self, start, ends):
        targets = [word for end in ends for word in ("--to", text_of(end))]
        found = json.loads(run(self.palpate, "measure", self.model, "--from", text_of(start), *targets, "--json"))
        return found["distances"]

    def map(self, start):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "map.vtp"
            run(self.palpate, "measure", self.model, "--from", text_of(start), "--map", path)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(path))
            reader.Update()
            surface = reader.GetOutput()
            lengths = surface.GetPointData().GetArray("DistanceAlongSurface")
            return vtk_to_numpy(surface.GetPoints().GetData()).copy(), vtk_to_numpy(lengths).copy()


def row_of(name, organs, random):
    longer, changes, errors = 0, [], []
    for organ in organs:
        shape = json.loads(run(organ.palpate, "evaluate", organ.model, "--frequency", 6, "--json"))
        samples = [sample["point_mm"] for sample in shape["directions"]]
        start = samples[random.integers(len(samples))]
        points, lengths = organ.map(start)
        far = numpy.flatnonzero(lengths > 5.0)
        for target in random.choice(far, TARGETS, replace=False):
            there = organ.measure(start, [points[target]])[0]
            back = organ.measure(points[target], [start])[0]
            shortest = min(there["along_mm"], back["along_mm"])
            longer += there["along_mm"] > (1.0 + LONGER) * min(shortest, lengths[target])
            changes.append(there["uncertainty_mm"] / there["along_mm"])
            errors.append(abs(lengths[target] / shortest - 1.0))
    return (f"| {name} | {len(errors)} | {longer} | {max(changes):.0e} | {100 * numpy.mean(errors):.2f} % "
            f"| {100 * max(errors):.2f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("palpate", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=8)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    given = parser.parse_args()
    random = numpy.random.default_rng(64)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, source, options in (
            ("whole glands", "whole_gland", ["--model", "radial", "--degree", "12"]),
            ("peripheral zones", "zones", ["--model", "surface", "--degree", "20"]),
        ):
            masks = sorted((given.data / source).glob("*.nii.gz"))
            organs = []
            for mask in masks[:: len(masks) // given.cases][: given.cases]:
                output = pathlib.Path(folder) / source / mask.name.split(".")[0]
                run(given.palpate, "fit", mask, "--label", "1", *options, "--output", output)
                organs.append(Organ(given.palpate, output / "model.json"))
            rows.append(row_of(name, organs, random))
            print(rows[-1], flush=True)
    text = PAGE.format(cases=given.cases, targets=TARGETS, rows="\n".join(rows)).strip()
    blocks = [b if b.startswith(("|", "#")) else textwrap.fill(b, 120) for b in text.split("\n\n")]
    given.page.write_text("\n\n".join(blocks) + "\n")


if __name__ == "__main__":
    main()
