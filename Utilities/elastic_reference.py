#!/usr/bin/python3
"""Contact forces on organs that yield, by another program than Palpate: references for its tests.

    Utilities/elastic_reference.py sphere --output sphere.json
    Utilities/elastic_reference.py notch --fine 0.5 --output notch.json
    Utilities/elastic_reference.py gland MODEL LESION --case NUMBER --output gland.json

The elements and their assembly are CalculiX's (ccx, Debian's calculix-ccx): linear elasticity with
springs as the bed. This script makes the mesh, condenses the matrix to the nodes under the ball and
solves the frictionless unilateral contact of a rigid ball: forces along one normal, none negative,
and no node in the ball. It needs numpy, scipy and CHOLMOD (libcholmod3), and is run to make
Testing/References/elastic again; tests only read what it wrote. A place takes a minute or two of
processor time and 4 GB. MODEL is the radial model of `palpate fit MASK --model radial --degree
12`, LESION a NIfTI mask. Lengths in mm, forces in N, moduli in N/mm^2, directions in patient LPS
from the model's centre.
"""
import argparse
import ctypes
import gzip
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")  # before numpy reads them
import numpy as np
import scipy.ndimage
import scipy.sparse

from elastic_mesh import Organ, Shape, unit

TISSUE, LESION, POISSON = 0.02, 0.06, 0.49
BED = 1e-3  # N/mm^3
BALL = 8.0
DEPTHS = (2.0, 3.0, 4.0)
ELEMENT = "C3D8I"  # with incompatible modes
FORWARD, PERMUTE = 4, 7  # systems of CHOLMOD's solve
REAL, LONG = 1, 2  # its kinds of numbers and indices


# CalculiX ----------------------------------------------------------------------------------------

def rounded(values, step):
    """Numbers of bins of equal ratios, and the mean of each bin."""
    bins = np.unique(np.round(np.log(values) / step), return_inverse=True)[1]
    return bins, np.bincount(bins, values) / np.bincount(bins)


def write_deck(path, organ, moduli, bed):
    """Elements of which the modulus is not 0, and springs; the step only stores the matrix."""
    lines = ["*NODE,NSET=ALL"]
    lines += [f"{i + 1},{x:.9e},{y:.9e},{z:.9e}" for i, (x, y, z) in enumerate(organ.points)]
    elements = np.flatnonzero(moduli > 0.0)
    bins, means = rounded(moduli[elements], 0.01)
    for k, modulus in enumerate(means):
        lines.append(f"*ELEMENT,TYPE={ELEMENT},ELSET=E{k}")
        lines += [f"{e + 1}," + ",".join(map(str, organ.elements[e] + 1))
                  for e in elements[bins == k]]
        lines += [f"*MATERIAL,NAME=M{k}", "*ELASTIC", f"{modulus:.9e},{POISSON}",
                  "*DENSITY", "1e-9", f"*SOLID SECTION,ELSET=E{k},MATERIAL=M{k}"]
    nodes = np.flatnonzero(bed > 1e-9 * BED)
    bins, means = rounded(bed[nodes], 0.02)
    number = len(organ.elements)
    for k, stiffness in enumerate(means):
        for axis in (1, 2, 3):
            lines.append(f"*ELEMENT,TYPE=SPRING1,ELSET=S{k}X{axis}")
            for node in nodes[bins == k]:
                number += 1
                lines.append(f"{number},{node + 1}")
            lines += [f"*SPRING,ELSET=S{k}X{axis}", str(axis), f"{stiffness:.9e}"]
    lines += ["*STEP", "*FREQUENCY,SOLVER=MATRIXSTORAGE", "1", "*END STEP", ""]
    pathlib.Path(path).write_text("\n".join(lines))


def run_calculix(folder):
    done = subprocess.run(["nice", "-n", "19", "ccx", "organ"], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if not (folder / "organ.sti").exists():
        sys.exit(done.stdout[-2000:])


def read_stiffness(folder):
    """The matrix that CalculiX assembled, and the place of node and axis (from 0) of each row."""
    entries = np.fromfile(folder / "organ.sti", sep=" ").reshape(-1, 3)
    row, column = entries[:, 0].astype(int) - 1, entries[:, 1].astype(int) - 1
    size = row.max() + 1
    half = scipy.sparse.coo_matrix((entries[:, 2], (row, column)), (size, size)).tocsr()
    words = (folder / "organ.dof").read_text().split()
    nodes, axes = np.array([word.split(".") for word in words], int).T - 1
    return half + scipy.sparse.triu(half, 1).T, nodes, axes


def without_modes(stiffness, nodes, real):
    """Eliminates the incompatible modes, which CalculiX numbers as three nodes an element."""
    inner, kept = np.flatnonzero(nodes >= real), np.flatnonzero(nodes < real)
    if not len(inner):
        return stiffness, kept
    inner = inner[np.argsort(nodes[inner], kind="stable")]
    rows = stiffness[inner]
    own = rows[:, inner].tobsr((9, 9)).data
    across = rows[:, kept].tocoo()
    element, mode = across.row.astype(int) // 9, across.row % 9
    pairs, place = np.unique(element * len(kept) + across.col, return_inverse=True)
    owner = pairs // len(kept)
    place -= np.searchsorted(owner, np.arange(len(own)))[element]
    columns = np.zeros((len(own), 24), int)
    columns[owner, np.arange(len(pairs)) - np.searchsorted(owner, owner)] = pairs % len(kept)
    coupling = np.zeros((len(own), 9, 24))
    coupling[element, mode, place] = across.data
    softer = coupling.transpose(0, 2, 1) @ np.linalg.solve(own, coupling)
    row, column = np.repeat(columns, 24, axis=1).ravel(), np.tile(columns, 24).ravel()
    size = (len(kept), len(kept))
    less = scipy.sparse.coo_matrix((softer.ravel(), (row, column)), size).tocsc()
    return stiffness[kept][:, kept] - less, kept


class SparseMatrix(ctypes.Structure):
    """cholmod_sparse."""
    _fields_ = [("sizes", ctypes.c_size_t * 3), ("pointers", ctypes.c_void_p * 5),
                ("kinds", ctypes.c_int * 6)]


class DenseMatrix(ctypes.Structure):
    """cholmod_dense."""
    _fields_ = [("rows", ctypes.c_size_t), ("columns", ctypes.c_size_t), ("size", ctypes.c_size_t),
                ("leading", ctypes.c_size_t), ("x", ctypes.POINTER(ctypes.c_double)),
                ("z", ctypes.c_void_p), ("kinds", ctypes.c_int * 2)]


def compliance(stiffness, forces, together=64):
    """F' K^-1 F for columns F of forces, by CHOLMOD: with P K P' = L L', the square of L^-1 P F."""
    library = ctypes.CDLL("libcholmod.so.3")
    for name in ("analyze", "factorize", "solve"):
        getattr(library, "cholmod_l_" + name).restype = ctypes.c_void_p
    library.cholmod_l_solve.restype = ctypes.POINTER(DenseMatrix)
    half = scipy.sparse.tril(stiffness, format="csc")
    half.sum_duplicates()
    parts = [half.indptr.astype(np.int64), half.indices.astype(np.int64), half.data]
    where = [part.ctypes.data for part in parts]
    matrix = SparseMatrix((*half.shape, half.nnz), (where[0], where[1], None, where[2], None),
                          (-1, LONG, REAL, 0, 1, 1))
    common = ctypes.create_string_buffer(1 << 16)
    library.cholmod_l_start(common)
    factor = ctypes.c_void_p(library.cholmod_l_analyze(ctypes.byref(matrix), common))
    if not library.cholmod_l_factorize(ctypes.byref(matrix), factor, common):
        sys.exit("The stiffness could not be factorised.")

    def solve(system, values):
        side = DenseMatrix(*values.shape, values.size, len(values), ctypes.cast(
            values.ctypes.data, ctypes.POINTER(ctypes.c_double)), None, (REAL, 0))
        found = library.cholmod_l_solve(system, factor, ctypes.byref(side), common)
        shape = values.shape[::-1]
        result = np.ctypeslib.as_array(found.contents.x, shape).copy().T
        library.cholmod_l_free_dense(ctypes.byref(found), common)
        return result

    columns = [solve(FORWARD, solve(PERMUTE, np.asfortranarray(
        forces[:, start:start + together].toarray())))
               for start in range(0, forces.shape[1], together)]
    library.cholmod_l_free_factor(ctypes.byref(factor), common)
    library.cholmod_l_finish(common)
    half = np.hstack(columns)
    return half.T @ half


def assembled(organ, moduli, bed):
    """Row 3 n + k is node n's along axis k."""
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        write_deck(work / "organ.inp", organ, moduli, bed)
        run_calculix(work)
        stiffness, nodes, axes = read_stiffness(work)
    stiffness, kept = without_modes(stiffness, nodes, len(organ.points))
    stiffness, rows = stiffness.tocoo(), 3 * nodes[kept] + axes[kept]
    size = (organ.points.size, organ.points.size)
    return scipy.sparse.csc_matrix((stiffness.data, (rows[stiffness.row], rows[stiffness.col])),
                                   size)


def forces_on(organ, nodes, normals):
    """A column for each node: a unit force along its normal."""
    rows = 3 * np.repeat(nodes, 3) + np.tile([0, 1, 2], len(nodes))
    columns = np.repeat(np.arange(len(nodes)), 3)
    return scipy.sparse.csc_matrix((normals.ravel(), (rows, columns)),
                                   (organ.points.size, len(nodes)))


# Contact ------------------------------------------------------------------------------------------

def push(softness, overlap):
    """Forces that push, at nodes that would otherwise enter the ball: an active set."""
    active = overlap > 0.0
    for _ in range(200):
        force = np.zeros(len(overlap))
        force[active] = np.linalg.solve(softness[np.ix_(active, active)], overlap[active])
        entered = ~active & (softness @ force < overlap - 1e-9)
        pulled = active & (force < 0.0)
        if not entered.any() and not pulled.any():
            return force
        active = (active & ~pulled) | entered
    sys.exit("The contact did not settle.")


def overlaps(points, normals, center, ball):
    """How far nodes have to yield against their normals to leave a ball."""
    away = points - center
    along = np.einsum("nc,nc->n", away, normals)
    beside = ball ** 2 - np.einsum("nc,nc->n", away, away) + along ** 2
    return np.where(beside > 0.0, along + np.sqrt(np.maximum(beside, 0.0)), -ball)


class Place:
    """A place in which a ball is pressed along the normal, on a mesh that is fine there."""

    def __init__(self, shape, direction, bed, fine, reach=6.5):
        self.organ = Organ(shape, direction, fine, reach)
        self.bed = bed(self.organ.directions) * self.organ.areas()
        self.reach = 1.15 * reach
        surface = np.unique(self.organ.faces)
        self.kept = surface[np.linalg.norm(self.organ.points[surface], axis=1) < self.reach]
        self.normals = np.tile([0.0, 0.0, 1.0], (len(self.kept), 1))
        self.plain = assembled(self.organ, np.full(len(self.organ.elements), TISSUE), self.bed)

    def forces(self, modulus=None):
        """N, at DEPTHS. `modulus`, at least TISSUE, is a function of points about the centre (LPS):
        what it adds is assembled alone."""
        stiffness = self.plain
        if modulus is not None:
            more = self.organ.moduli(modulus) - TISSUE
            more[more < 1e-4 * TISSUE] = 0.0
            stiffness = stiffness + assembled(self.organ, more, np.zeros_like(self.bed))
        softness = compliance(stiffness, forces_on(self.organ, self.kept, self.normals))
        points, result = self.organ.points[self.kept], []
        for depth in DEPTHS:
            center = np.array([0.0, 0.0, BALL - depth])
            force = push(softness, overlaps(points, self.normals, center, BALL))
            if np.linalg.norm(points[force > 0.0], axis=1).max() > 0.9 * self.reach:
                sys.exit("The patch is larger than the part that is retained.")
            result.append(float(force.sum()))
        return result

    def settings(self):
        return {"nodes": len(self.organ.points), "elements": len(self.organ.elements),
                "retained": len(self.kept)}


# Bodies -------------------------------------------------------------------------------------------

def bed_with_free_cone(axis, half_angle=math.radians(60.0), rim=1.0 / 6.0):
    """As Palpate's ElasticBed."""
    def stiffness(directions):
        angle = np.arccos(np.clip(directions @ axis, -1.0, 1.0))
        t = np.clip((angle - half_angle) / rim, 0.0, 1.0)
        return BED * t * t * (3.0 - 2.0 * t)
    return stiffness


class Mask:
    """A binary NIfTI image, as a trilinear partial volume of points about a centre."""

    def __init__(self, path, center):
        data = gzip.open(path).read()
        size = np.frombuffer(data, "<i2", 8, 40)[1:4]
        kind = {2: "u1", 4: "<i2", 8: "<i4", 16: "<f4", 64: "<f8", 256: "i1", 512: "<u2"}[
            int(np.frombuffer(data, "<i2", 1, 70)[0])]
        start = int(np.frombuffer(data, "<f4", 1, 108)[0])
        values = np.frombuffer(data, kind, int(size.prod()), start)
        self.inside = (values.reshape(size, order="F") > 0).astype(float)
        to_ras = np.frombuffer(data, "<f4", 12, 280).reshape(3, 4).astype(float)
        lps = to_ras * np.array([[-1.0], [-1.0], [1.0]])
        self.axes, self.origin = lps[:, :3], lps[:, 3] - center

    def at(self, points):
        index = np.linalg.solve(self.axes, (points - self.origin).T)
        return scipy.ndimage.map_coordinates(self.inside, index, order=1, mode="constant")

    def middle(self):
        return self.axes @ np.argwhere(self.inside > 0).mean(axis=0) + self.origin


def free_side(direction):
    """The patient's axis closest to a direction."""
    axis = np.zeros(3)
    largest = np.argmax(np.abs(direction))
    axis[largest] = np.sign(direction[largest])
    return axis


def places_of(shape, lesion, side):
    """Over the lesion, at its rim and well away: along the great circle towards the free side."""
    over = unit(lesion.middle())
    along = unit(side - (side @ over) * over)
    turned = lambda degrees: (math.cos(math.radians(degrees)) * over +
                              math.sin(math.radians(degrees)) * along)

    def share(direction):  # of lesion in the outer 10 mm
        depth = np.linspace(0.0, 10.0, 101)
        return lesion.at((shape.radius(direction[None])[0] - depth)[:, None] * direction).mean()

    least = 0.5 * share(over)
    rim = next(angle for angle in range(1, 130) if share(turned(angle)) < least)
    return {"over the lesion": over, "at its rim": turned(rim), "away": turned(rim + 45)}


# A sphere with a cleft whose walls enclose a right angle, along y and open to +z.
NOTCH = {"radius_mm": 25.0, "edge_mm": 13.0, "fillet_mm": 2.0, "blend_mm": 1.0, "degree": 40,
         "smoothing": 0.0012}


def notch_radius(directions):
    """The nearer of the sphere and of the cleft (two planes that meet `edge` above the centre, with
    a fillet), blended; see notch_shape."""
    edge, fillet, blend = NOTCH["edge_mm"], NOTCH["fillet_mm"], NOTCH["blend_mm"]
    x, z = np.abs(directions[:, 0]), directions[:, 2]
    wall = np.where(z > x, edge / np.maximum(z - x, 1e-9), np.inf)
    middle = edge + math.sqrt(2.0) * fillet
    square = x * x + z * z
    root = (middle * z) ** 2 - square * (middle ** 2 - fillet ** 2)
    hollow = (middle * z - np.sqrt(np.maximum(root, 0.0))) / np.maximum(square, 1e-9)
    in_hollow = (z > x) & (root > 0.0) & (hollow * x < fillet / math.sqrt(2.0))
    cleft = np.minimum(np.where(in_hollow, hollow, wall), 1e3)
    sphere = NOTCH["radius_mm"]
    return -blend * np.logaddexp(-sphere / blend, -cleft / blend)


def notch_shape():
    """The function on harmonics up to the degree, each times exp(-smoothing l(l+1))."""
    shape = Shape.project(NOTCH["degree"], notch_radius)
    degrees = np.floor(np.sqrt(np.arange(len(shape.coefficients)) + 0.5))
    shape.coefficients *= np.exp(-NOTCH["smoothing"] * degrees * (degrees + 1.0))
    return shape


def touching_height(shape, ball, aside):
    """Of the centre (aside, 0, height) of a ball that touches the cleft from above."""
    x, y = np.meshgrid(np.linspace(-12.0, 12.0, 481), np.linspace(-4.0, 4.0, 81))
    directions = np.stack([x.ravel(), y.ravel(), np.full(x.size, 20.0)], -1)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    points = shape.radius(directions)[:, None] * directions
    beside = np.hypot(points[:, 0] - aside, points[:, 1])
    over = points[:, 2] + np.sqrt(np.maximum(ball ** 2 - beside ** 2, 0.0))
    return over[beside < ball].max()


REACH = np.array([11.0, 6.0])  # mm, across and along the cleft, where nodes may touch the ball


class Cleft:
    """A ball that touches both walls: each node yields along the surface's normal there. From
    elements of 0.7 to 0.5 mm forces change by up to 1.2 %, and by 3 % for the larger ball at the
    smallest depth, where its patch is a few elements wide."""

    def __init__(self, shape, fine):
        self.shape, up = shape, np.array([0.0, 0.0, 1.0])
        self.organ = Organ(shape, up, fine, 9.5, 20.0)
        surface = np.unique(self.organ.faces)
        points = self.organ.world[surface]
        near = np.all(np.abs(points[:, :2]) < REACH, axis=1) & (points[:, 2] > 0.0)
        self.kept, self.points = surface[near], points[near]
        self.normals = np.array([shape.normal(unit(point)) for point in self.points])
        moduli = np.full(len(self.organ.elements), TISSUE)
        stiffness = assembled(self.organ, moduli, BED * self.organ.areas())
        self.softness = compliance(stiffness, forces_on(self.organ, self.kept,
                                                        self.normals @ self.organ.axes.T))

    def press(self, ball, depth, aside):
        """`depth` is below the place where the ball touches, `aside` across the cleft."""
        height = touching_height(self.shape, ball, aside) - depth
        center = np.array([aside, 0.0, height])
        force = push(self.softness, overlaps(self.points, self.normals, center, ball))
        if np.any(np.abs(self.points[force > 0.0, :2]) > 0.9 * REACH):
            sys.exit("The patch is larger than the part that is retained.")
        sides = [self.points[:, 0] < -1e-6, self.points[:, 0] > 1e-6]
        return {"ball_radius_mm": ball, "depth_mm": depth, "center_mm": center.tolist(),
                "force_n": (force @ self.normals).tolist(),
                "wall_force_n": [float(force[side].sum()) for side in sides]}


# Commands -----------------------------------------------------------------------------------------

def write(path, result):
    """Numbers with six digits, which is more than they are worth."""
    def short(value):
        if isinstance(value, float):
            return float(f"{value:.6g}")
        if isinstance(value, dict):
            return {key: short(entry) for key, entry in value.items()}
        return [short(entry) for entry in value] if isinstance(value, (list, tuple)) else value
    text = json.dumps(short(result), indent=2)
    pathlib.Path(path).write_text(text + "\n")


def common(arguments):
    version = subprocess.run(["ccx", "-v"], stdout=subprocess.PIPE, text=True).stdout.split()[-1]
    return {"program": f"CalculiX {version}", "element": ELEMENT, "element_mm": arguments.fine,
            "tissue_kpa": 1e3 * TISSUE, "poisson_ratio": POISSON, "bed_kpa_per_mm": 1e3 * BED,
            "ball_radius_mm": BALL, "depths_mm": DEPTHS}


def sphere(arguments):
    """A sphere of 25 mm on a bed all round, without a core and with one that begins 5 mm down."""
    radius, core, stiff = 25.0, 20.0, 0.08
    shape = Shape(0, [radius * math.sqrt(4.0 * math.pi)])
    place = Place(shape, unit(np.array([0.3, 0.5, -0.8])), lambda d: np.full(len(d), BED),
                  arguments.fine)

    def cored(points):
        return np.where(np.linalg.norm(points, axis=1) < core, stiff, TISSUE)

    result = {"case": "sphere", **common(arguments), "radius_mm": radius, "core_radius_mm": core,
              "core_kpa": 1e3 * stiff, "mesh": place.settings()}
    result["force_n"] = {
        "homogeneous": place.forces(),
        "with_core": place.forces(cored)}
    write(arguments.output, result)


def gland(arguments):
    shape = Shape.read(arguments.model)
    lesion = Mask(arguments.lesion, shape.center)
    side = free_side(unit(lesion.middle()))
    result = {"case": arguments.case, **common(arguments), "lesion_kpa": 1e3 * LESION,
              "fit_degree": shape.degree, "free_direction": side.tolist(), "free_degrees": 60.0,
              "places": []}
    stiffer = lambda p: TISSUE + (LESION - TISSUE) * lesion.at(p)
    for name, direction in places_of(shape, lesion, side).items():
        place = Place(shape, direction, bed_with_free_cone(side), arguments.fine)
        result["places"].append({
            "name": name, "direction": direction.tolist(), "mesh": place.settings(),
            "force_n": {"without_lesion": place.forces(),
                        "with_lesion": place.forces(stiffer)}})
        print(json.dumps(result["places"][-1]), flush=True)
        write(arguments.output, result)


def notch(arguments):
    place = Cleft(notch_shape(), arguments.fine)
    shared = common(arguments)
    del shared["ball_radius_mm"], shared["depths_mm"]
    presses = [(ball, depth, 0.0) for ball in (4.0, 8.0) for depth in (1.0, 2.0, 3.0)]
    presses += [(ball, 2.0, aside) for ball in (4.0, 8.0) for aside in (0.5, 1.0, 2.0)]
    write(arguments.output, {
        "case": "notch", **shared, "shape": NOTCH, "nodes": len(place.organ.points),
        "elements": len(place.organ.elements), "retained": len(place.kept),
        "presses": [place.press(*press) for press in presses]})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(required=True)
    for run in (sphere, gland, notch):
        command = commands.add_parser(run.__name__)
        command.set_defaults(run=run)
        command.add_argument("--output", required=True)
        command.add_argument("--fine", type=float, default=0.6, help="elements at the contact, mm")
        if run is gland:
            command.add_argument("model")
            command.add_argument("lesion")
            command.add_argument("--case", type=int, required=True, help="public case number")
    arguments = parser.parse_args()
    arguments.run(arguments)


if __name__ == "__main__":
    main()
