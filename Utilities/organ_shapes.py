"""Bodies like organs, as masks of voxels: inside(x, y, z) in mm, on a grid with thick slices."""
import pathlib

import numpy as np


def ball(x, y, z, center, radii):
    a, b, c = center
    p, q, r = radii
    return ((x - a) / p) ** 2 + ((y - b) / q) ** 2 + ((z - c) / r) ** 2 <= 1


def tube(x, y, z, points, radius):
    """Around a line through points."""
    inside = np.zeros(x.shape, bool)
    place = np.stack([x, y, z], -1)
    for start, end in zip(points, points[1:]):
        start, end = np.array(start, float), np.array(end, float)
        way = end - start
        along = np.clip((place - start) @ way / (way @ way), 0, 1)
        inside |= np.linalg.norm(place - start - along[..., None] * way, axis=-1) <= radius
    return inside


def kidney(x, y, z):
    return ball(x, y, z, (0, 0, 0), (28, 20, 52)) & ~ball(x, y, z, (-30, 0, 0), (20, 12, 22))


def vertebra(x, y, z):
    arch = ((x / 16) ** 2 + ((y - 24) / 16) ** 2 <= 1) & ((x / 10) ** 2 + ((y - 24) / 10) ** 2 >= 1)
    return (((x / 24) ** 2 + (y / 18) ** 2 <= 1) & (abs(z) <= 14)) | (arch & (abs(z) <= 9)) | \
        tube(x, y, z, [(0, 38, 0), (0, 62, -10)], 5) | \
        tube(x, y, z, [(-40, 28, 0), (40, 28, 0)], 5) & ~((x / 10) ** 2 + ((y - 24) / 10) ** 2 < 1)


def aorta(x, y, z):
    return tube(x, y, z, [(0, 0, 70), (0, 0, 0)], 10) | \
        tube(x, y, z, [(0, 0, 0), (25, 0, -50)], 6.5) | tube(x, y, z, [(0, 0, 0), (-25, 0, -50)], 6.5)


def liver(x, y, z):
    return ball(x, y, z, (0, 0, 0), (95, 60, 70)) & (z + 0.45 * x > -32) & \
        ~ball(x, y, z, (20, -20, -60), (60, 50, 45))


def cochlea(x, y, z):
    turns = np.linspace(0, 2.5 * 2 * np.pi, 80)
    radius = 5.0 * np.exp(-0.12 * turns)
    return tube(x, y, z, list(zip(radius * np.cos(turns), radius * np.sin(turns), 0.32 * turns)), 0.75)


def femur(x, y, z):
    return tube(x, y, z, [(0, 0, -70), (0, 0, 40)], 13) | ball(x, y, z, (42, 0, 72), (23, 23, 23)) | \
        tube(x, y, z, [(0, 0, 40), (42, 0, 72)], 14)


def tooth(x, y, z):
    return (ball(x, y, z, (0, 0, 4), (5.2, 5.5, 4.5)) |
            tube(x, y, z, [(2.4, 0, 2), (3.2, 0, -11)], 1.9) |
            tube(x, y, z, [(-2.4, 0, 2), (-3.2, 0, -11)], 1.9))


def ventricle(x, y, z):
    """A wall of 10 mm, open at its base."""
    return ball(x, y, z, (0, 0, 0), (38, 38, 58)) & ~ball(x, y, z, (0, 0, 0), (28, 28, 48)) & (z < 26)


def lung(x, y, z):
    return ball(x, y, z, (0, 0, 0), (55, 75, 120)) & ~ball(x, y, z, (0, 0, -125), (75, 80, 70)) & \
        ~ball(x, y, z, (-55, 10, -10), (38, 38, 50))


SMALL = 0.5  # mm
# mm: size of a voxel in the slice, and half the extents of the grid.
ORGANS = {"kidney": (kidney, 1.0, (32, 24, 56)), "vertebra": (vertebra, 0.8, (48, 66, 18)),
          "aorta with fork": (aorta, 1.0, (36, 14, 84)), "liver": (liver, 1.5, (98, 64, 74)),
          "cochlea": (cochlea, 0.2, (7, 7, 7)), "femur": (femur, 1.0, (68, 26, 98)),
          "tooth": (tooth, 0.25, (7, 7, 15)), "ventricle's wall": (ventricle, 1.2, (42, 42, 64)),
          "lung": (lung, 1.5, (60, 80, 124))}


def write_mask(path, name, slice_mm):
    """Writes a mask (.mha); a voxel that is half inside is inside. Of small organs the slices are as
    many times thicker than a voxel is wide."""
    inside, pixel, half = ORGANS[name]
    spacing = (pixel, pixel, slice_mm * pixel if pixel < SMALL else slice_mm)
    size = [int(np.ceil(2 * h / s)) + 2 for h, s in zip(half, spacing)]
    axes = [(np.arange(n) - (n - 1) / 2) * s for n, s in zip(size, spacing)]
    share = np.zeros(size[::-1])
    for part in (-0.375, -0.125, 0.125, 0.375):
        z, y, x = np.meshgrid(axes[2] + part * spacing[2], axes[1], axes[0], indexing="ij")
        share += inside(x, y, z)
    origin = " ".join(repr(float(axis[0])) for axis in axes)
    header = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
              f"Offset = {origin}\nElementSpacing = {' '.join(map(repr, map(float, spacing)))}\n"
              f"DimSize = {' '.join(map(str, size))}\nElementType = MET_UCHAR\n"
              "ElementDataFile = LOCAL\n")
    pathlib.Path(path).write_bytes(header.encode() + (share >= 2).astype(np.uint8).tobytes())
