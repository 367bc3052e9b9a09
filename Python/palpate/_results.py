"""What queries return."""

from typing import NamedTuple

from numpy import float64, int32
from numpy.typing import NDArray


class Curvature(NamedTuple):
    """Curvature at n directions, positive where the surface is convex."""

    mean: NDArray[float64]
    """(n,), 1/mm: half the sum of the principal curvatures."""
    gaussian: NDArray[float64]
    """(n,), 1/mm^2: their product."""
    principal: NDArray[float64]
    """(n, 2), 1/mm: the larger first."""
    directions: NDArray[float64]
    """(n, 2, 3): unit tangents, in the same order."""


class Nearest(NamedTuple):
    """The surface's points nearest to n points."""

    points: NDArray[float64]
    """(n, 3), mm."""
    normals: NDArray[float64]
    """(n, 3): unit normals there, outwards."""
    distances: NDArray[float64]
    """(n,), mm: negative inside."""


class Mesh(NamedTuple):
    """A closed mesh."""

    points: NDArray[float64]
    """(n, 3), mm."""
    normals: NDArray[float64]
    """(n, 3): unit normals of the surface, outwards."""
    triangles: NDArray[int32]
    """(m, 3): indices of points, counter-clockwise from outside."""


class Measures(NamedTuple):
    """Measures of the body that a model encloses."""

    volume: float
    """mm^3."""
    area: float
    """mm^2."""
    centroid: NDArray[float64]
    """(3,), mm."""
    semi_axes: NDArray[float64]
    """(3,), mm, the longest first: of the ellipsoid with the same volume and, up to a factor, second moments."""
    axes: NDArray[float64]
    """(3, 3): row i is the unit vector of semi-axis i."""


class State(NamedTuple):
    """One tick of a session."""

    time: float
    """s, of the machine's steady clock."""
    tick: int
    probe: NDArray[float64]
    """(3,), mm: the hand."""
    proxy: NDArray[float64]
    """(3,), mm: where the tool is shown."""
    force: NDArray[float64]
    """(3,), N: as sent, in the scene's axes."""
    buttons: int
    """One bit each."""
    has_sample: bool
    """Whether the device has told its position."""
    id: int
    """Of the structure touched most deeply; 0 for none."""
    depth: float
    """mm."""
    patch: float
    """mm: radius of the contact with a structure that yields; else 0."""
    is_estimate: bool
    """Linear elasticity does not hold there."""
    is_armed: bool
    """Whether forces are on; they are off after a fault."""
    is_ramping: bool
    """Whether they are still fading in."""
