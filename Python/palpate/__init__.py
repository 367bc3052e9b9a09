"""Palpate: organs as spherical harmonics, to fit, evaluate and touch, over NumPy arrays.

Lengths are mm, forces N, in the patient's frame (LPS). Arrays of points are (n, 3) and of any real type; one point
(3,) gives results without the leading dimension. What Palpate refuses raises Error, with one sentence; wrong shapes
and types raise ValueError and TypeError.

    import palpate
    model = palpate.fit_mask(mask, degree=20, spacing=(0.5, 0.5, 3.0))
    model.nearest(points).distances

The VTK filters (names that begin with vtk) are loaded when one is first asked for; nothing else needs VTK. So is
to_pyvista, which needs PyVista (palpate.pyvista).
"""

import importlib
import pkgutil
from typing import Any

from ._correct import correct as correct
from ._inputs import Mask as Mask
from ._kernels import CheckGroup as CheckGroup
from ._kernels import Correction as Correction
from ._kernels import Error as Error
from ._kernels import Field as Field
from ._kernels import Geodesics as Geodesics
from ._kernels import LinearModel as LinearModel
from ._kernels import MaskCase as MaskCase
from ._kernels import Model as Model
from ._kernels import Scene as Scene
from ._kernels import Session as Session
from ._kernels import Tracker as Tracker
from ._kernels import __version__ as __version__
from ._kernels import asymmetry as asymmetry
from ._kernels import calibre as calibre
from ._kernels import check as check
from ._kernels import compare as compare
from ._kernels import complete as complete
from ._kernels import contact_dtype as contact_dtype
from ._kernels import displacement as displacement
from ._kernels import fit_mask as fit_mask
from ._kernels import fit_points as fit_points
from ._kernels import motion as motion
from ._kernels import read_check_group as read_check_group
from ._kernels import read_model as read_model
from ._kernels import register_bodies as register_bodies
from ._kernels import register_landmarks as register_landmarks
from ._kernels import register_points as register_points
from ._kernels import relate as relate
from ._kernels import shape as shape
from ._results import Asymmetry as Asymmetry
from ._results import Calibre as Calibre
from ._results import CheckedRule as CheckedRule
from ._results import Coefficients as Coefficients
from ._results import ComparedSurface as ComparedSurface
from ._results import Comparison as Comparison
from ._results import Completion as Completion
from ._results import Curvature as Curvature
from ._results import Displacement as Displacement
from ._results import Distances as Distances
from ._results import Geodesic as Geodesic
from ._results import LandmarkRegistration as LandmarkRegistration
from ._results import Measures as Measures
from ._results import Mesh as Mesh
from ._results import Mirror as Mirror
from ._results import MixedFit as MixedFit
from ._results import Motion as Motion
from ._results import MultivariateTest as MultivariateTest
from ._results import Nearest as Nearest
from ._results import PermutationTest as PermutationTest
from ._results import PointRegistration as PointRegistration
from ._results import Relation as Relation
from ._results import Shape as Shape
from ._results import State as State
from ._results import Statistic as Statistic
from ._results import TermTest as TermTest
from ._results import Verdict as Verdict

_OTHERS = ("importlib", "pkgutil", "Any")
_CORE = [name for name in globals() if not name.startswith("_") and name not in _OTHERS]


def _load_filters() -> list[str]:
    """Loads what VTK wraps into this module, and returns its names."""
    modules = sorted(module.name for module in pkgutil.iter_modules(__path__) if module.name.startswith("Palpate"))
    if not modules:
        raise ImportError("palpate's VTK filters are not installed (Debian: python3-palpate-vtk)")
    loaded: dict[str, Any] = {}
    try:
        for name in modules:
            loaded[name] = importlib.import_module(f"{__name__}.{name}")
            loaded.update((n, value) for n, value in vars(loaded[name]).items() if not n.startswith("_"))
    except ImportError as error:
        raise ImportError("palpate's VTK filters need VTK for this Python (Debian: python3-vtk9)") from error
    globals().update(loaded)
    return sorted(loaded)


def __getattr__(name: str) -> Any:
    if name == "__all__":  # of a star import
        try:
            return _CORE + _load_filters()
        except ImportError:
            return _CORE
    if name == "to_pyvista":
        return importlib.import_module(f"{__name__}.pyvista").to_pyvista
    if name.startswith(("vtk", "Palpate")) and name in _load_filters():
        return globals()[name]
    raise AttributeError(f"module 'palpate' has no attribute '{name}'")
