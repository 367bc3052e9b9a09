from os import PathLike
from typing import Any, Iterable, List, Literal, Mapping, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from ._inputs import Mask
from ._results import (
    Asymmetry,
    Calibre,
    Coefficients,
    ComparedSurface,
    Comparison,
    Completion,
    Curvature,
    Displacement,
    Geodesic,
    LandmarkRegistration,
    Measures,
    Mesh,
    MixedFit,
    Motion,
    MultivariateTest,
    Nearest,
    PermutationTest,
    PointRegistration,
    Relation,
    Shape,
    State,
    TermTest,
    Verdict,
)

__version__: str
contact_dtype: numpy.dtype[numpy.void]

Floats = NDArray[numpy.float64]

class Error(RuntimeError): ...

class Model:
    def __init__(self, coefficients: ArrayLike, center: Optional[ArrayLike] = None) -> None: ...
    @property
    def degree(self) -> int: ...
    @property
    def is_radial(self) -> bool: ...
    @property
    def is_star_shaped(self) -> bool: ...
    @property
    def yields(self) -> bool: ...
    @property
    def coefficients(self) -> Floats: ...
    @property
    def center(self) -> Floats: ...
    def points(self, directions: ArrayLike) -> Floats: ...
    def normals(self, directions: ArrayLike) -> Floats: ...
    def radii(self, directions: ArrayLike) -> Floats: ...
    def gradients(self, directions: ArrayLike) -> Floats: ...
    def curvature(self, directions: ArrayLike) -> Curvature: ...
    def nearest(self, points: ArrayLike) -> Nearest: ...
    def mesh(self, frequency: int = 20) -> Mesh: ...
    def measures(self) -> Measures: ...
    def spectrum(self) -> Floats: ...
    def write(self, path: Union[str, PathLike[str]]) -> None: ...

class Correction:
    def __init__(
        self,
        start: Union[Model, ArrayLike],
        *,
        barrier: Optional[ArrayLike] = None,
        spacing: Optional[ArrayLike] = None,
        origin: Optional[ArrayLike] = None,
        direction: Optional[ArrayLike] = None,
        affine: Optional[ArrayLike] = None,
    ) -> None: ...
    @property
    def surface(self) -> Mesh: ...
    @property
    def displacements(self) -> Floats: ...
    @property
    def mask(self) -> NDArray[numpy.bool_]: ...
    @property
    def model(self) -> Model: ...
    def pull(
        self,
        place: ArrayLike,
        by: Optional[float] = None,
        *,
        to: Optional[ArrayLike] = None,
        width: ArrayLike = 8.0,
    ) -> None: ...
    def preview(
        self,
        place: ArrayLike,
        by: Optional[float] = None,
        *,
        to: Optional[ArrayLike] = None,
        width: ArrayLike = 8.0,
    ) -> Floats: ...
    def undo(self) -> bool: ...
    def remove_islands(self) -> None: ...
    def fill(self) -> None: ...
    def smooth(self, deviation: float) -> None: ...
    def cut(self, point: ArrayLike, normal: ArrayLike) -> None: ...

class Geodesics:
    def __init__(
        self,
        body: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
        *,
        spacing: Optional[ArrayLike] = None,
        origin: Optional[ArrayLike] = None,
        direction: Optional[ArrayLike] = None,
        affine: Optional[ArrayLike] = None,
    ) -> None: ...
    def path(self, start: ArrayLike, end: ArrayLike) -> Geodesic: ...
    def map(self, start: ArrayLike) -> ComparedSurface: ...

def fit_points(points: ArrayLike, degree: int = 12, center: Optional[ArrayLike] = None) -> Model: ...
def complete(
    points: ArrayLike,
    normals: Optional[ArrayLike] = None,
    prior: Optional[Union[str, PathLike[str]]] = None,
    sigma: float = 1.0,
    center: Optional[ArrayLike] = None,
    *,
    strokes: Optional[ArrayLike] = None,
    outside: Optional[ArrayLike] = None,
    known: Optional[Model] = None,
) -> Completion: ...
def fit_mask(
    mask: ArrayLike,
    degree: int = 20,
    kind: Literal["surface", "radial"] = "surface",
    *,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Model: ...
def compare(
    first: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    reference: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    tolerances: Optional[ArrayLike] = None,
    mirror: bool = False,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Comparison: ...
def shape(
    body: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    definition: Literal["subvoxel", "ibsi"] = "subvoxel",
    thickness: Literal["spheres", "rays"] = "spheres",
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Shape: ...
def calibre(
    body: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    definition: Literal["subvoxel", "ibsi"] = "subvoxel",
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Calibre: ...
def motion(
    before: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    after: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    landmarks: Optional[ArrayLike] = None,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Motion: ...
def register_bodies(
    moving: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    fixed: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    kind: Literal["rigid", "similarity", "affine"] = "rigid",
    noise: float = 0.0,
    start: Optional[ArrayLike] = None,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> PointRegistration: ...
def register_landmarks(
    moving: ArrayLike,
    fixed: ArrayLike,
    *,
    kind: Literal["rigid", "similarity", "affine"] = "rigid",
    noise: float = 0.0,
) -> LandmarkRegistration: ...
def register_points(
    points: ArrayLike,
    surface: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    kind: Literal["rigid", "similarity", "affine"] = "rigid",
    noise: float = 0.0,
    start: Optional[ArrayLike] = None,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> PointRegistration: ...

Masks = Union[ArrayLike, Mapping[str, ArrayLike], Sequence[ArrayLike]]
Names = Union[Mapping[int, str], Sequence[str]]

class MaskCase:
    def __init__(
        self,
        masks: Masks,
        *,
        names: Optional[Names] = None,
        spacing: Optional[ArrayLike] = None,
        origin: Optional[ArrayLike] = None,
        direction: Optional[ArrayLike] = None,
        affine: Optional[ArrayLike] = None,
    ) -> None: ...
    def check(self, *, group: Optional[CheckGroup] = None, false_alarms: float = 0.05) -> List[Verdict]: ...

class CheckGroup:
    def __init__(self, cases: Sequence[MaskCase]) -> None: ...
    @property
    def least_false_alarms(self) -> float: ...
    @property
    def dropped(self) -> List[Tuple[int, str]]: ...
    def write(self, path: Union[str, PathLike[str]]) -> None: ...

def read_check_group(path: Union[str, PathLike[str]]) -> CheckGroup: ...
def check(
    masks: Masks,
    *,
    names: Optional[Names] = None,
    group: Optional[CheckGroup] = None,
    false_alarms: float = 0.05,
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> List[Verdict]: ...
def relate(
    first: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    second: Union[Model, Mask, Mesh, Tuple[ArrayLike, ArrayLike], ArrayLike],
    *,
    contact: float = 1.0,
    margins: Optional[ArrayLike] = None,
    definition: Literal["subvoxel", "ibsi"] = "subvoxel",
    spacing: Optional[ArrayLike] = None,
    origin: Optional[ArrayLike] = None,
    direction: Optional[ArrayLike] = None,
    affine: Optional[ArrayLike] = None,
) -> Relation: ...

class LinearModel:
    def __init__(
        self,
        formula: str,
        covariates: Mapping[str, Iterable[Any]],
        *,
        references: Optional[Iterable[Tuple[str, str]]] = None,
    ) -> None: ...
    @property
    def columns(self) -> List[str]: ...
    @property
    def terms(self) -> List[str]: ...
    @property
    def cases(self) -> NDArray[numpy.uint64]: ...
    @property
    def matrix(self) -> Floats: ...
    def fit(self, outcomes: ArrayLike, *, confidence: float = 0.95) -> Coefficients: ...
    def test(self, term: str, outcomes: ArrayLike) -> TermTest: ...
    def fit_mixed(
        self,
        outcomes: ArrayLike,
        subjects: Iterable[Any],
        *,
        times: Optional[ArrayLike] = None,
        confidence: float = 0.95,
    ) -> MixedFit: ...
    def test_together(self, term: str, outcomes: ArrayLike) -> MultivariateTest: ...
    def permute(
        self,
        term: str,
        outcomes: ArrayLike,
        areas: ArrayLike,
        triangles: ArrayLike,
        *,
        permutations: int = 10000,
        seed: int = 1,
    ) -> PermutationTest: ...

def asymmetry(
    left: Sequence[Model],
    right: Optional[Sequence[Model]] = None,
    *,
    align: Literal["patient", "procrustes"] = "patient",
    frequency: int = 16,
    flips: int = 10000,
    seed: int = 1,
) -> Asymmetry: ...
def displacement(model: Model, *, frequency: int = 16) -> Displacement: ...
def read_model(path: Union[str, PathLike[str]]) -> Model: ...

class Field:
    def __init__(
        self,
        values: ArrayLike,
        iso: float,
        *,
        spacing: Optional[ArrayLike] = None,
        origin: Optional[ArrayLike] = None,
        direction: Optional[ArrayLike] = None,
        affine: Optional[ArrayLike] = None,
    ) -> None: ...
    def contains(self, points: ArrayLike) -> NDArray[numpy.bool_]: ...

class Scene:
    def __init__(self, tool_radius: float = 1.0) -> None: ...
    def add(
        self,
        structure: Union[Model, Field],
        id: Optional[int] = None,
        *,
        stiffness: float = 0.5,
        damping: float = 0.0,
        static_friction: float = 0.0,
        dynamic_friction: float = 0.0,
    ) -> int: ...
    def add_mesh(
        self,
        points: ArrayLike,
        triangles: ArrayLike,
        id: Optional[int] = None,
        *,
        stiffness: float = 0.5,
        damping: float = 0.0,
        static_friction: float = 0.0,
        dynamic_friction: float = 0.0,
    ) -> int: ...
    def set_tool_radius(self, radius: float) -> None: ...
    def set_workspace(self, center: ArrayLike, scale: float = 1.0) -> None: ...

class Tracker:
    def __init__(self, scene: Scene) -> None: ...
    def follow(self, probes: ArrayLike) -> NDArray[numpy.void]: ...
    def release(self) -> None: ...

class Session:
    def __init__(self, device: str = "simulated") -> None: ...
    def __enter__(self) -> Session: ...
    def __exit__(self, *exception: object) -> None: ...
    def close(self) -> None: ...
    def show(self, scene: Scene, is_continuing: bool = False) -> None: ...
    def read(self) -> State: ...
    @property
    def problem(self) -> str: ...
    def stop_force(self) -> None: ...
    def allow_force(self) -> None: ...
    def lead_hand(self, place: ArrayLike) -> bool: ...
