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
    def fitted(self, kind, degree):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder) / "egg.nrrd"
            write_nrrd(image, egg())
            options = ["--label", "1", "--model", kind, "--degree", str(degree), "--output", f"{folder}/out"]
            subprocess.run([PROGRAM, "fit", image, *options], check=True, capture_output=True)
            return palpate.read_model(next((pathlib.Path(folder) / "out").glob("*model*.json")))

    def test_models_are_the_same_to_the_last_bit(self):
        for kind in ("surface", "radial"):
            for degree in (4, 10):
                with self.subTest(kind, degree=degree):
                    wanted = self.fitted(kind, degree)
                    found = palpate.fit_mask(egg(), degree, kind, **PLACE)
                    self.assertEqual([*map(float.hex, found.center)], [*map(float.hex, wanted.center)])
                    numpy.testing.assert_array_equal(found.coefficients, wanted.coefficients)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
