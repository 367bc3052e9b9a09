"""A model fitted from an array is the one that `palpate fit` writes.

  test_command_line.py PROGRAM
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
import palpate

SPACING = numpy.array([0.8, 1.0, 2.5])  # mm
ORIGIN = numpy.array([30.0, -12.0, 5.0])
# Columns are the axes.
DIRECTION = numpy.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
PLACE = {"spacing": SPACING, "origin": ORIGIN, "direction": DIRECTION}


def egg():
    """A mask, with a smaller part that is left out."""
    x, y, z = (numpy.indices((50, 45, 18)).T * SPACING).T
    mask = ((x - 19) / 15) ** 2 + ((y - 22) / (13 + 0.2 * (x - 19))) ** 2 + ((z - 22) / 16) ** 2 <= 1
    mask[0:2, 0:2, 0] = True
    return mask.astype(numpy.uint8)


def write_nrrd(path, mask):
    vectors = " ".join("({},{},{})".format(*axis) for axis in (DIRECTION * SPACING).T)
    header = (
        f"NRRD0005\ntype: uint8\ndimension: 3\nsizes: {' '.join(map(str, mask.shape))}\n"
        "space: left-posterior-superior\nencoding: raw\n"
        f"space directions: {vectors}\nspace origin: ({','.join(map(str, ORIGIN))})\n\n"
    )
    path.write_bytes(header.encode() + mask.tobytes(order="F"))


class CommandLine(unittest.TestCase):
    def fitted(self, model, degree):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder) / "egg.nrrd"
            write_nrrd(image, egg())
            options = ["--label", "1", "--model", model, "--degree", str(degree), "--output", f"{folder}/out"]
            subprocess.run([PROGRAM, "fit", image, *options], check=True, capture_output=True)
            return palpate.read_model(next((pathlib.Path(folder) / "out").glob("*model*.json")))

    def test_parametric_models_are_the_same(self):
        wanted = self.fitted("surface", 10)
        model = palpate.fit_mask(egg(), 10, **PLACE)
        # The places of the file are rounded otherwise.
        numpy.testing.assert_allclose(model.coefficients, wanted.coefficients, atol=1e-9)

    def test_star_shaped_models_are_close(self):
        wanted = self.fitted("radial", 10)
        model = palpate.fit_mask(egg(), 10, "star-shaped", **PLACE)
        distances = numpy.abs(model.nearest(wanted.mesh(20).points).distances)
        # Their surfaces are marched otherwise, over a grid of the pixels' spacing.
        self.assertLess(distances.mean(), 0.05)
        self.assertLess(distances.max(), 0.5)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
