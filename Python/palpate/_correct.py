"""Lists of corrections."""

import json
import os
from typing import Any, Iterable, Mapping, Union

from numpy.typing import ArrayLike

from ._kernels import Correction, Model


def _apply(correction: Correction, step: Mapping[str, Any]) -> None:
    kind = step["do"]
    if kind == "pull":
        width = step.get("width_mm", 8.0)
        if step.get("second_width_mm"):
            width = (width, step["second_width_mm"])
        correction.pull(step["place_mm"], step.get("displacement_mm"), to=step.get("target_mm"), width=width)
    elif kind == "islands":
        correction.remove_islands()
    elif kind == "fill":
        correction.fill()
    elif kind == "smooth":
        correction.smooth(step["deviation_mm"])
    elif kind == "cut":
        correction.cut(step["point_mm"], step["normal"])
    else:
        raise ValueError(f"steps: 'do' has to be pull, islands, fill, smooth or cut, and is '{kind}'")


def correct(
    start: Union[Model, ArrayLike],
    steps: Union[str, "os.PathLike[str]", Iterable[Mapping[str, Any]]],
    **grid: Any,
) -> Correction:
    """Corrects a mask or a model by steps, in their order; the result's mask or model is the corrected one.

    steps: a corrections.json of palpate correct, or its list: {"do": "pull", "place_mm": (x, y, z),
    "displacement_mm": 4, "width_mm": 8}, {"do": "islands"}, "fill", "smooth" with "deviation_mm", "cut" with
    "point_mm" and "normal". grid: barrier, spacing, origin, direction and affine of Correction.
    """
    correction = Correction(start, **grid)
    if isinstance(steps, (str, os.PathLike)):
        with open(steps, encoding="utf-8") as file:
            steps = json.load(file)["steps"]
    for step in steps:
        _apply(correction, step)
    return correction
