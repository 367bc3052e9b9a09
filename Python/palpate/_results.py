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


class Distances(NamedTuple):
    """Distances over a surface, mm, weighted by area."""

    mean: float
    rms: float
    percentile95: float
    maximum: float
    signed_mean: float
    """Negative inside the other body; NaN if that is open, and of both directions together."""


class ComparedSurface(NamedTuple):
    """A body's surface, at whose points distances were taken: it may have more than were given."""

    points: NDArray[float64]
    """(n, 3), mm."""
    triangles: NDArray[int32]
    """(m, 3): indices of points, counter-clockwise from outside."""
    distances: NDArray[float64]
    """(n,), mm, from the other body: negative inside, if that is closed."""


class Comparison(NamedTuple):
    """A body compared with a reference. NaN is what an open mesh has not."""

    dice: float
    jaccard: float
    volumes: NDArray[float64]
    """(2,), mm^3: of the first and the reference."""
    areas: NDArray[float64]
    """(2,), mm^2."""
    both: Distances
    """Each direction with half of the weight; the maximum is the Hausdorff distance."""
    to_reference: Distances
    """Of the first surface's points from the reference."""
    to_first: Distances
    hausdorff95: float
    """mm: the larger of the two directions' 95th percentiles."""
    surface_dice: NDArray[float64]
    """(n,): at each tolerance, the area of both surfaces within it of the other one, over the area of both."""
    side_bias: NDArray[float64]
    """(6,), mm: mean signed distance of the first surface on the left, right, posterior, anterior, superior and inferior
    side of the reference's centroid."""
    first: ComparedSurface
    reference: ComparedSurface


class Shape(NamedTuple):
    """A closed body's shape features, under their codes in the manual of the Image Biomarker Standardisation
    Initiative; mm, mm^2, mm^3."""

    volume: float
    """RNU0, of the surface."""
    area: float
    """C0JK."""
    surface_to_volume_ratio: float
    """2PR5."""
    compactness_1: float
    """SKGS."""
    compactness_2: float
    """BQWJ."""
    spherical_disproportion: float
    """KRCK."""
    sphericity: float
    """QCFX."""
    asphericity: float
    """25C7."""
    maximum_diameter: float
    """L0JK."""
    major_axis_length: float
    """TDIC: four standard deviations along the principal axis."""
    minor_axis_length: float
    """P9VJ."""
    least_axis_length: float
    """7J51."""
    elongation: float
    """Q3CK."""
    flatness: float
    """N17B."""
    volume_density_box: float
    """PBX1: over the box along the axes of the world."""
    area_density_box: float
    """R59B."""
    volume_density_ellipsoid: float
    """6BDE: over the approximate enclosing ellipsoid."""
    area_density_ellipsoid: float
    """RDD2."""
    volume_density_hull: float
    """R3ER: over the convex hull."""
    area_density_hull: float
    """7T7F."""
    centroid: NDArray[float64]
    """(3,), mm."""
    axes: NDArray[float64]
    """(3, 3): row i is a unit vector along a principal axis, the longest first."""
    thickness: ComparedSurface
    """The surface; its `distances` are the diameters of the largest balls that touch it from inside."""


class Relation(NamedTuple):
    """How two closed bodies lie to each other."""

    kind: str
    """The first is "apart" from the second, "overlapping" it, "inside" it or "around" it."""
    distance: float
    """mm; 0 unless they are apart."""
    wall: float
    """mm between the surfaces, also of bodies in each other."""
    first_point: NDArray[float64]
    """(3,), mm: where the surfaces are nearest."""
    second_point: NDArray[float64]
    shared_volume: float
    """mm^3."""
    contact_areas: NDArray[float64]
    """(2,), mm^2 of each surface within the contact distance of the other one."""
    near_areas: NDArray[float64]
    """(n, 2): at each margin, the share of the first body's surface that lies in the second or as near, and of the
    second's."""
    near_volumes: NDArray[float64]
    """(n, 2): the same of the volumes."""
    offset: NDArray[float64]
    """(3,), mm: from the first centroid to the second."""
    axes_angle: float
    """Degrees between the longest axes, 0 to 90."""


class Coefficients(NamedTuple):
    """A linear model's coefficients: k of the design, for m outcomes."""

    values: NDArray[float64]
    """(k, m)."""
    errors: NDArray[float64]
    """(k, m): standard errors."""
    half_widths: NDArray[float64]
    """(k, m): of the confidence intervals."""


class TermTest(NamedTuple):
    """Tests of a term given all others, one for each of m outcomes."""

    f: NDArray[float64]
    p: NDArray[float64]
    partial_r2: NDArray[float64]
    """(m,): the share of what the other terms leave that the term explains."""


class Statistic(NamedTuple):
    """A multivariate statistic and its approximation by Fisher's distribution."""

    value: float
    f: float
    numerator_degrees: float
    denominator_degrees: float
    p: float


class MultivariateTest(NamedTuple):
    """A term given all others, on all outcomes together."""

    pillai: Statistic
    wilks: Statistic
    hotelling_lawley: Statistic
    roy: Statistic
    """Its p is a lower bound."""


class PermutationTest(NamedTuple):
    """A term given all others, at m points of a surface."""

    statistic: NDArray[float64]
    """(m,): t of a term with one column, else the root of F."""
    p: NDArray[float64]
    """(m,): of each point by itself."""
    family_p: NDArray[float64]
    """(m,): corrected for all points, by the largest statistic."""
    enhanced_p: NDArray[float64]
    """(m,): corrected for all points, by threshold-free cluster enhancement."""
    whole_f: float
    """Explained by residual variance of the whole surface."""
    whole_p: float


class Displacement(NamedTuple):
    """A model at n points, and how coefficients move them."""

    points: NDArray[float64]
    """(n, 3), mm: of a radial model relative to its centre."""
    normals: NDArray[float64]
    """(n, 3), outwards."""
    areas: NDArray[float64]
    """(n,), mm^2."""
    triangles: NDArray[int32]
    """(t, 3), counter-clockwise from outside."""
    map: NDArray[float64]
    """(n, c), mm per mm: along the normals, of each coefficient; of three coordinates those of x, then y, then z."""


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
