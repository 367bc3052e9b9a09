"""Star-shaped bodies and hexahedra that fill them, for elastic_reference.py.

Lengths in mm, directions in patient LPS from the model's centre.
"""
import json
import math
import pathlib
import sys

import numpy as np

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                    [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
GAUSS = 1.0 / math.sqrt(3.0)


# Shapes -------------------------------------------------------------------------------------------

def harmonics(degree, directions):
    """Real, orthonormal, without Condon-Shortley phase; entry l(l+1)+m. One row a direction."""
    x, y, z = directions.T
    phi, sine = np.arctan2(y, x), np.hypot(x, y)
    values = np.empty((len(z), (degree + 1) ** 2))
    diagonal = np.full(len(z), math.sqrt(0.25 / math.pi))
    for m in range(degree + 1):
        before, now = np.zeros_like(z), diagonal
        for l in range(m, degree + 1):
            if m == 0:
                values[:, l * (l + 1)] = now
            else:
                values[:, l * (l + 1) + m] = math.sqrt(2.0) * now * np.cos(m * phi)
                values[:, l * (l + 1) - m] = math.sqrt(2.0) * now * np.sin(m * phi)
            up = math.sqrt(((l + 1) ** 2 - m * m) / (4.0 * (l + 1) ** 2 - 1.0))
            down = math.sqrt((l * l - m * m) / (4.0 * l * l - 1.0)) if l > m else 0.0
            before, now = now, (z * now - down * before) / up
        diagonal = diagonal * sine * math.sqrt((2 * m + 3.0) / (2 * m + 2.0))
    return values


class Shape:
    """A radial model R(d) about a centre."""

    def __init__(self, degree, coefficients, center=(0.0, 0.0, 0.0)):
        self.degree, self.coefficients = degree, np.array(coefficients)
        self.center = np.array(center)

    @classmethod
    def read(cls, path):
        file = json.loads(pathlib.Path(path).read_text())
        return cls(file["degree"], file["coefficients_mm"], file["center_mm"])

    @classmethod
    def project(cls, degree, radius):
        """Of a function of directions, by quadrature that resolves four times the degree."""
        count = 4 * degree
        heights, weights = np.polynomial.legendre.leggauss(count)
        turns = 2.0 * math.pi * np.arange(2 * count) / (2 * count)
        z, phi = [grid.ravel() for grid in np.meshgrid(heights, turns, indexing="ij")]
        side = np.sqrt(1.0 - z * z)
        directions = np.stack([side * np.cos(phi), side * np.sin(phi), z], -1)
        weighted = np.repeat(weights, 2 * count) * math.pi / count * radius(directions)
        parts = [harmonics(degree, d).T @ w for d, w in
                 zip(np.array_split(directions, 50), np.array_split(weighted, 50))]
        return cls(degree, sum(parts))

    def radius(self, directions):
        return harmonics(self.degree, directions) @ self.coefficients

    def point(self, direction):
        return self.radius(direction[None])[0] * direction

    def normal(self, direction, step=1e-5):
        """From differences along two tangents."""
        sides = frame(direction)[:2]
        along = [self.point(unit(direction + step * s)) - self.point(unit(direction - step * s))
                 for s in sides]
        return unit(np.cross(*along))


def unit(vector):
    return vector / np.linalg.norm(vector)


def frame(axis):
    """Rows: two tangents and the axis, right-handed."""
    first = unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    return np.array([first, np.cross(axis, first), axis])


# Mesh ---------------------------------------------------------------------------------------------

def graded(half, fine, reach, growth):
    """Nodes from 0 to `half` in steps of `fine` as far as `reach`, growing from there."""
    count = math.ceil(reach / fine)
    steps = [reach / count] * count
    left, tail = half - reach, []
    while sum(tail) + 0.5 * (tail or steps)[-1] * growth < left:
        tail.append((tail or steps)[-1] * growth)
    tail = [t * left / sum(tail) for t in tail]
    return np.concatenate([[0.0], np.cumsum(steps + tail)])


def on_sphere(cube):
    """Equal angles along the great circles through the middles of the cube's faces."""
    points = np.tan(0.25 * math.pi * cube)
    return points / np.maximum(np.linalg.norm(points, axis=1, keepdims=True), 1e-12)


def in_middle(cube):
    """A rounded cube of about half the ball's size."""
    largest = np.abs(cube).max(axis=1, keepdims=True)
    return 0.25 * (cube + 1.2 * largest * on_sphere(cube / np.maximum(largest, 1e-12)))


class BallMesh:
    """Hexahedra of the unit ball, fine around +z: a rounded cube and layers on its six sides."""

    def __init__(self, radius, fine, reach, growth=1.6, down=6):
        side = graded(0.25 * math.pi * radius, fine, reach, growth)
        side = np.concatenate([-side[:0:-1], side]) / side[-1]
        outer = [side, side, np.linspace(-1.0, 1.0, down + 1)]
        even = np.linspace(-1.0, 1.0, len(side))
        inner = [0.5 * (side + even)] * 2 + [outer[2]]
        self.size = np.array([len(a) for a in outer])
        index = np.stack(np.meshgrid(*[np.arange(n) for n in self.size], indexing="ij"), -1)
        index = index.reshape(-1, 3)
        at = lambda axes, k: np.stack([axes[c][k[:, c]] for c in range(3)], -1)
        skin = np.any((index == 0) | (index == self.size - 1), axis=1)
        middle, top = in_middle(at(inner, index)), on_sphere(at(outer, index[skin]))
        depths = graded(0.45 * radius, fine, min(0.85 * reach, 0.25 * radius), growth)
        parts = 1.0 - depths[::-1] / depths[-1]
        points = [middle] + [(1.0 - p) * middle[skin] + p * top for p in parts[1:]]
        self.points = np.concatenate(points)
        self.skin = np.cumsum(skin) - 1  # of a lattice node on the cube
        self._connect(len(middle), len(top), len(parts) - 1)

    def _lattice(self, k):
        return (k[..., 0] * self.size[1] + k[..., 1]) * self.size[2] + k[..., 2]

    def _connect(self, inside, shell, layers):
        cells = np.stack(np.meshgrid(*[np.arange(n - 1) for n in self.size], indexing="ij"), -1)
        elements = [self._lattice(cells.reshape(-1, 1, 3) + CORNERS)]
        squares = np.concatenate([self._side(axis, end) for axis in range(3) for end in (0, 1)])
        on = lambda layer: (squares if layer == 0 else
                            inside + (layer - 1) * shell + self.skin[squares])
        elements += [np.hstack([on(k), on(k + 1)]) for k in range(layers)]
        self.elements, self.faces = np.concatenate(elements), on(layers)

    def _side(self, axis, end):
        """Squares of a side of the cube, counterclockwise from outside."""
        u, v = (axis + 1) % 3, (axis + 2) % 3
        i, j = np.meshgrid(np.arange(self.size[u] - 1), np.arange(self.size[v] - 1), indexing="ij")
        corners = np.zeros((i.size, 4, 3), int)
        corners[..., axis] = end * (self.size[axis] - 1)
        corners[..., u] = i.reshape(-1, 1) + np.array([0, 1, 1, 0])
        corners[..., v] = j.reshape(-1, 1) + np.array([0, 0, 1, 1])
        return self._lattice(corners)[:, ::1 if end else -1]


def shape_functions(s):
    """Of the eight nodes at points of [-1, 1]^3, and their slopes."""
    signs = 2.0 * CORNERS - 1.0
    terms = 1.0 + s[:, None, :] * signs
    values = terms.prod(axis=2) / 8.0
    slopes = np.stack([signs[:, a] * np.delete(terms, a, 2).prod(axis=2) for a in range(3)], -1)
    return values, slopes / 8.0


class Organ:
    """A mesh of a shape, fine around a direction, in axes whose z is the normal there."""

    def __init__(self, shape, direction, fine, reach, radius=None):
        place = shape.point(direction)
        self.axes = frame(shape.normal(direction))
        ball = BallMesh(radius or np.linalg.norm(place), fine, reach)
        points = ball.points @ frame(direction)
        length = np.linalg.norm(points, axis=1, keepdims=True)
        self.directions = np.where(length > 0.0, points / np.maximum(length, 1e-12), direction)
        radii = shape.radius(self.directions)[:, None]
        middle = min(radii.mean(), 1.8 * radii.min())
        self.world = points * (middle + (radii - middle) * length)  # about the centre, LPS
        self.elements, self.faces = ball.elements, ball.faces
        self.points = (self.world - place) @ self.axes.T
        _, slopes = shape_functions(GAUSS * (2.0 * CORNERS - 1.0))
        jacobians = np.einsum("enc,pna->epca", self.points[self.elements], slopes)
        if not np.linalg.det(jacobians).min() > 0.0:
            sys.exit("Elements of the mesh overlap.")

    def areas(self):
        """Of the surface, shared between its nodes."""
        share = np.zeros(len(self.points))
        corner = self.points[self.faces]
        for s, t in ((s, t) for s in (-GAUSS, GAUSS) for t in (-GAUSS, GAUSS)):
            a, b = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
            along = [np.einsum("n,fnc->fc", k, corner)
                     for k in (0.25 * a * (1 + t * b), 0.25 * b * (1 + s * a))]
            area = np.linalg.norm(np.cross(*along), axis=1)
            value = 0.25 * (1 + s * a) * (1 + t * b)
            np.add.at(share, self.faces, area[:, None] * value)
        return share

    def moduli(self, modulus, across=4):
        """Geometric means over points in each element: an element that a boundary crosses would be
        too stiff with the arithmetic mean, too soft with the harmonic one."""
        inside = (2.0 * np.arange(across) + 1.0) / across - 1.0
        points = np.stack(np.meshgrid(inside, inside, inside), -1).reshape(-1, 3)
        values, _ = shape_functions(points)
        sums = [np.log(modulus(np.einsum("n,enc->ec", v, self.world[self.elements])))
                for v in values]
        return np.exp(np.mean(sums, axis=0))
