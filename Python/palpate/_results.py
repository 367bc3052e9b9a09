"""What queries return."""

from typing import TYPE_CHECKING, List, NamedTuple, Optional

from numpy import bool_, float64, int32
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._kernels import Model


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


class Mirror(NamedTuple):
    """How a mirror image at the sagittal plane was brought onto another body."""

    turn: float
    """rad."""
    shift: NDArray[float64]
    """(3,), mm, of its centroid."""


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
    """With `mirror`, of the mirror image; volumes and areas stay those of the body that was given."""
    mirror: Optional[Mirror] = None


class Motion(NamedTuple):
    """How a body moved as a whole, and what that leaves."""

    turn: float
    """rad."""
    shift: NDArray[float64]
    """(3,), mm, of the centroid."""
    rest: float
    """mm: RMS distance of the surfaces after turn and shift."""
    landmarks: NDArray[float64]
    """(n, 3), mm: where they are after it."""


class LandmarkRegistration(NamedTuple):
    """Landmarks brought to their partners."""

    map: NDArray[float64]
    """(4, 4): of the moving landmarks, mm."""
    rms: float
    """mm, weighted, of what remains."""
    turn_error: float
    """Predicted standard deviations, rad and mm; NaN of an affine map."""
    shift_error: float
    residuals: NDArray[float64]
    """(n,), mm: of each pair."""
    weights: NDArray[float64]
    """(n,), 0 to 1: near 0 for a wrong pair."""


class PointRegistration(NamedTuple):
    """Points brought onto a surface."""

    map: NDArray[float64]
    """(4, 4): of the points, mm."""
    rms: float
    """mm, of the distances that remain."""
    median: float
    turn_error: float
    """Predicted standard deviations, rad and mm; NaN of an affine map."""
    shift_error: float
    has_converged: bool
    """If not, start it closer."""


class CheckedRule(NamedTuple):
    """A statistic of a mask, the larger the more suspicious."""

    rule: str
    value: float
    place: NDArray[float64]
    """(3,), mm: where it comes from."""
    p: float
    """Of a clean structure of the group to have as large a value; NaN without one."""
    is_alarm: bool
    """Whether it alone gives a verdict."""


class Verdict(NamedTuple):
    """How believable a structure's mask is."""

    name: str
    verdict: str
    """One of "plausible", "look here" and "implausible"."""
    sentence: str
    """What is suspicious, without the name."""
    rule: str
    """That gave the verdict; empty of a plausible structure."""
    place: NDArray[float64]
    """(3,), mm; NaN of a plausible structure."""
    p: float
    """Of a clean case to look as bad; NaN without a group."""
    volume: float
    """mm^3."""
    rules: List[CheckedRule]
    """All that was measured."""


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
    """The surface; its `distances` are the diameters of the largest balls that touch it from inside, or the lengths of
    its inward normals."""


class Calibre(NamedTuple):
    """The axis of a tube, and its n sections."""

    length: float
    """mm of the axis, from one end of the body to the other."""
    along: NDArray[float64]
    """(n,), mm of the axis, from its first end."""
    centers: NDArray[float64]
    """(n, 3), mm: here the axis is."""
    axes: NDArray[float64]
    """(n, 3): unit vectors along it."""
    areas: NDArray[float64]
    """(n,), mm^2."""
    least: NDArray[float64]
    """(n,), mm: the least width of each section."""
    largest: NDArray[float64]
    """(n,), mm: the largest."""


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


class Completion(NamedTuple):
    """A surface completed from touched points."""

    model: "Model"
    """A radial model, or a surface model if the prior is of those."""
    deviations: NDArray[float64]
    """(642,), mm: standard deviations along the normals at the points of model.mesh(8)."""
    next: NDArray[float64]
    """(6, 3), mm: where to touch next, the best place first."""


class Geodesic(NamedTuple):
    """The shortest path along a surface between two of its points."""

    along: float
    """mm."""
    straight: float
    """mm, through space."""
    uncertainty: float
    """mm, of `along`; NaN of triangles."""
    points: NDArray[float64]
    """(n, 3), mm, from end to end."""


class Coefficients(NamedTuple):
    """A linear model's coefficients: k of the design, for m outcomes."""

    values: NDArray[float64]
    """(k, m)."""
    errors: NDArray[float64]
    """(k, m): standard errors."""
    half_widths: NDArray[float64]
    """(k, m): of the confidence intervals."""


class MixedFit(NamedTuple):
    """A linear mixed model: k coefficients and t testable terms of a design, for m outcomes; NaN where one does not
    vary."""

    values: NDArray[float64]
    """(k, m): coefficients."""
    errors: NDArray[float64]
    """(k, m): standard errors, with Kenward and Roger's correction."""
    half_widths: NDArray[float64]
    """(k, m): of the confidence intervals."""
    f: NDArray[float64]
    """(t, m): Kenward and Roger's tests of the terms, in the order of LinearModel.terms."""
    numerator_degrees: NDArray[float64]
    denominator_degrees: NDArray[float64]
    p: NDArray[float64]
    criterion: NDArray[float64]
    """(m,): -2 log restricted likelihood."""
    residual_variance: NDArray[float64]
    """(m,)."""
    subject_covariance: NDArray[float64]
    """(3, m): variance of intercepts (at time 0), covariance with slopes, variance of slopes."""
    is_singular: NDArray[bool_]
    """(m,): no variance of subjects, or slopes that follow from intercepts."""


class Asymmetry(NamedTuple):
    """Left against right of n individuals, and at p points of the mean."""

    squares: NDArray[float64]
    """(3,), mm^2: of individuals, sides (directional) and their interaction (fluctuating)."""
    degrees: NDArray[float64]
    """(3,): of freedom."""
    f: float
    """Of the sides."""
    p: float
    individuals: NDArray[float64]
    """(n,), mm: left minus right along the mean's normals, root mean square."""
    points: NDArray[float64]
    """(p, 3), mm."""
    mean: NDArray[float64]
    """(p,), mm: left minus right along the normals."""
    deviations: NDArray[float64]
    """(p,), mm."""
    statistic: NDArray[float64]
    """(p,): paired t."""
    point_p: NDArray[float64]
    """(p,)."""
    family_p: NDArray[float64]
    """(p,): corrected for all points, by the largest t."""


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
