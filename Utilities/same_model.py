"""Whether the command line and Python make the same model of each structure of real masks, to the last bit.

  Utilities/same_model.py FOLDER_OR_MASK…

Python's module has to be on PYTHONPATH; runs build/release/bin/palpate with every structure, both kinds of model and
two degrees. Prints structures that differ, and a line with the counts; exits with 1 if one differs. Where one of the
two refuses, the other has to refuse, too. Files of folders that are no masks are left out.
"""

import concurrent.futures
import gzip
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import palpate

PROGRAM = pathlib.Path(__file__).resolve().parents[1] / "build/release/bin/palpate"
KINDS = ("radial", "surface")
DEGREES = (8, 12)
TYPES = {"short": "i2", "unsigned short": "u2", "unsigned char": "u1", "int": "i4", "float": "f4", "double": "f8"}


def info_of(image):
    """What `palpate info` says; none of a file that it refuses."""
    run = subprocess.run([PROGRAM, "info", image, "--json"], capture_output=True, text=True)
    return json.loads(run.stdout.splitlines()[0]) if run.returncode == 0 else {}


def read_nrrd(path):
    """Voxels (i, j, k) of what `palpate convert` writes, and the place that the command line reads."""
    header, _, data = path.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    sizes = [int(n) for n in fields["sizes"].split()]
    voxels = numpy.frombuffer(gzip.decompress(data), "<" + TYPES[fields["type"]]).reshape(sizes, order="F")
    grid = info_of(path)["geometry"]
    return voxels, {"spacing": grid["spacing_mm"], "origin": grid["origin_mm"], "direction": numpy.array(grid["axes"]).T}


def by_command_line(image, model, degree, folder):
    """Each label's model, or why there is none."""
    command = [PROGRAM, "fit", image, "--model", model, "--degree", str(degree), "--min-dice", "0"]
    run = subprocess.run([*command, "--output", folder, "--json"], capture_output=True, text=True)
    made = {}
    for result in map(json.loads, run.stdout.splitlines()):
        if result["status"] == "fitted":
            made[result["label"]] = palpate.read_model(pathlib.Path(result["folder"]) / "model.json"), ""
        else:
            made[result["label"]] = None, result["message"]
    return made


def by_python(voxels, label, model, degree, place):
    try:
        return palpate.fit_mask(voxels == label, degree, model, **place), ""
    except palpate.Error as error:
        return None, str(error)


def judgement(one, why, other, reason):
    if one is None or other is None:
        return "refused" if one is other else f"refused by one alone: {why or reason}"
    same = numpy.array_equal(one.coefficients, other.coefficients) and numpy.array_equal(one.center, other.center)
    return "same" if same else f"differ by {numpy.abs(one.coefficients - other.coefficients).max():.2g} mm"


def compare(image):
    """A line and a judgement of every structure, kind of model and degree."""
    if not info_of(image).get("labels"):
        return []
    found = []
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "mask.nrrd"
        subprocess.run([PROGRAM, "convert", image, copy], check=True, capture_output=True)
        voxels, place = read_nrrd(copy)
        for model, degree in itertools.product(KINDS, DEGREES):
            for label, (one, why) in by_command_line(copy, model, degree, f"{folder}/{model}{degree}").items():
                other, reason = by_python(voxels, label, model, degree, place)
                found.append((f"{image} {label} {model} {degree}", judgement(one, why, other, reason)))
    return found


def main():
    images = []
    for given in map(pathlib.Path, sys.argv[1:]):
        images += sorted(given.rglob("*.nii.gz")) if given.is_dir() else [given]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = [each for image in pool.map(compare, images) for each in image]
    judged = [result for _, result in found]
    for job, result in found:
        if result not in ("same", "refused"):
            print(job, result)
    differing = len(found) - judged.count("same") - judged.count("refused")
    print(f"{len(found)} models: {judged.count('same')} the same, {judged.count('refused')} refused by both, {differing} others")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
