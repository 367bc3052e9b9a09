"""`import palpate` needs no VTK and loads none; filters say what they need."""

import subprocess
import sys
import unittest

# As on a machine without VTK.
BLOCK = """
import sys

class WithoutVtk:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("vtk", "vtkmodules"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, WithoutVtk())
"""


def run(script):
    done = subprocess.run([sys.executable, "-B", "-c", script], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stderr)
    return done.stdout


class WithoutVtk(unittest.TestCase):
    def test_import_loads_no_vtk(self):
        maps = run("import palpate\nprint(open('/proc/self/maps').read(), [*__import__('sys').modules])")
        self.assertIn("_kernels", maps)
        self.assertNotIn("vtk", maps.lower())
        self.assertNotIn("pyvista", maps)

    def test_arrays_work(self):
        run(
            BLOCK
            + """
import numpy
from palpate import *
model = fit_mask(numpy.ones((8, 8, 8)), degree=4)
assert model.radii is not None and "Model" in dir(__import__("palpate"))
contacts = Tracker(Scene()).follow(model.points(numpy.eye(3)))
assert (contacts["id"] == 0).all()
"""
        )

    def test_filters_say_what_they_need(self):
        said = run(
            BLOCK
            + """
import palpate
for name in ("vtkSegmentationSurface", "PalpateFilters"):
    try:
        getattr(palpate, name)
    except ImportError as error:
        print(error)
try:
    from palpate import vtkSegmentationSurface
except ImportError as error:
    print(error)
assert not hasattr(palpate, "segmentation_surface")
"""
        )
        lines = said.splitlines()
        self.assertEqual(len(lines), 3)
        for line in lines:
            self.assertRegex(line, "^palpate's VTK filters .*python3-")


if __name__ == "__main__":
    unittest.main()
