"""Whether the command line and Python make the same model of each structure of real masks, to the last bit.

  Utilities/same_model.py FOLDER_OR_MASK…

Python's module has to be on PYTHONPATH; runs build/release/bin/palpate with every structure, both kinds of model and
two degrees. Prints structures that differ, and a line with the counts; exits with 1 if one differs. Where one of the
two refuses, the other has to refuse, too.
"""

import concurrent.futures
import gzip
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
    run = subprocess.run([PROGRAM, "info", image, "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout.splitlines()[0])


def read_nrrd(path):
    """Voxels (i, j, k) of what `palpate convert` writes, and the place that the command line reads."""
    header, _, data = path.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    sizes = [int(n) for n in fields["sizes"].split()]
    voxels = numpy.frombuffer(gzip.decompress(data), "<" + TYPES[fields["type"]]).reshape(sizes, order="F")
    grid = info_of(path)["geometry"]
    return voxels, {"spacing": grid["spacing_mm"], "origin": grid["origin_mm"], "direction": numpy.array(grid["axes"]).T}


def by_command_line(image, label, model, degree, folder):
    command = [PROGRAM, "fit", image, "--label", str(label), "--model", model, "--degree", str(degree)]
    run = subprocess.run([*command, "--output", folder, "--json"], capture_output=True, text=True)
    result = json.loads(run.stdout.splitlines()[0])
    if result["status"] != "fitted":
        return None, result["message"]
    return palpate.read_model(next(pathlib.Path(folder).glob("*model*.json"))), ""


def by_python(voxels, label, model, degree, place):
    try:
        return palpate.fit_mask(voxels == label, degree, model, **place), ""
    except palpate.Error as error:
        return None, str(error)


def compare(image, label, model, degree):
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "mask.nrrd"
        subprocess.run([PROGRAM, "convert", image, copy], check=True, capture_output=True)
        voxels, place = read_nrrd(copy)
        one, why = by_command_line(copy, label, model, degree, f"{folder}/out")
        other, reason = by_python(voxels, label, model, degree, place)
    if one is None or other is None:
        return "refused" if one is other else f"refused by one alone: {why or reason}"
    same = numpy.array_equal(one.coefficients, other.coefficients) and numpy.array_equal(one.center, other.center)
    return "same" if same else f"differ by {numpy.abs(one.coefficients - other.coefficients).max():.2g} mm"


def labels_of(image):
    return [structure["label"] for structure in info_of(image)["labels"]]


def main():
    images = []
    for given in map(pathlib.Path, sys.argv[1:]):
        images += sorted(given.rglob("*.nii.gz")) if given.is_dir() else [given]
    jobs = [(i, label, model, degree) for i in images for label in labels_of(i) for model in KINDS for degree in DEGREES]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda job: compare(*job), jobs))
    differing = 0
    for job, result in zip(jobs, found):
        if result not in ("same", "refused"):
            differing += 1
            print(*job, result)
    print(f"{len(jobs)} models: {found.count('same')} the same, {found.count('refused')} refused by both, {differing} others")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
