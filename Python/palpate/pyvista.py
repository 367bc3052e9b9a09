"""Palpate with PyVista: models as meshes, models of label maps, distances on meshes.

    import pyvista
    import palpate.pyvista
    model = palpate.pyvista.fit_image(pyvista.read("labels.nii.gz"), label=3)
    palpate.to_pyvista(model).plot()

From PyVista 0.48 on, importing this module gives datasets an accessor: `image.palpate.fit(label=3)`, `mesh.palpate.distances(model)`.
Lengths are mm in the frame of the data. `import palpate` alone loads neither PyVista nor VTK.
"""

from typing import Any, Literal, Union

import numpy
import pyvista

from ._kernels import Model, fit_mask
from ._results import Mesh

Kind = Literal["surface", "radial"]


def to_pyvista(surface: Union[Model, Mesh], frequency: int = 20) -> pyvista.PolyData:
    """A model or a mesh of one as triangles with the point array "Normals".

    `frequency` is that of Model.mesh, and counts for models.
    """
    mesh = surface.mesh(frequency) if isinstance(surface, Model) else surface
    corners = numpy.full((len(mesh.triangles), 1), 3)
    poly = pyvista.PolyData(mesh.points, numpy.hstack([corners, mesh.triangles]).ravel())
    poly.point_data["Normals"] = mesh.normals
    poly.point_data.active_normals_name = "Normals"
    return poly


def fit_image(image: Any, label: int = 1, degree: int = 20, kind: Kind = "surface", name: str = "") -> Model:
    """The model of the voxels of an image (pyvista.ImageData) that have a label, as fit_mask makes it.

    `name` is that of the array, else the active scalars count. Values of points are voxels around them, values of cells are voxels.
    """
    chosen = name or image.active_scalars_name
    if chosen is None:
        raise ValueError("image: it has no active scalars; give the name of an array")
    is_of_points = chosen in image.point_data
    values = image.point_data[chosen] if is_of_points else image.cell_data[chosen]
    size = numpy.array(image.dimensions) - (0 if is_of_points else 1)
    matrix = image.GetDirectionMatrix()
    direction = numpy.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])
    first = numpy.array(image.extent[::2]) + (0.0 if is_of_points else 0.5)  # index of the first voxel's centre
    spacing = numpy.array(image.spacing)
    mask = (numpy.asarray(values) == label).reshape(size, order="F")
    origin = image.origin + direction @ (spacing * first)
    return fit_mask(mask, degree, kind, spacing=spacing, origin=origin, direction=direction)


def distances(mesh: Any, model: Model, name: str = "DistanceToModel") -> Any:
    """A copy of a mesh with the distances (mm) of its points from a model as a point array; negative inside."""
    copy = mesh.copy(deep=False)
    copy.point_data[name] = model.nearest(numpy.asarray(mesh.points, dtype=float)).distances
    copy.set_active_scalars(name)
    return copy


class Accessor:
    """`dataset.palpate` of PyVista's datasets."""

    def __init__(self, dataset: Any) -> None:
        self._dataset = dataset

    def fit(self, label: int = 1, degree: int = 20, kind: Kind = "surface", name: str = "") -> Model:
        """fit_image of this image."""
        return fit_image(self._dataset, label, degree, kind, name)

    def distances(self, model: Model, name: str = "DistanceToModel") -> Any:
        """distances of this mesh from a model."""
        return distances(self._dataset, model, name)


if hasattr(pyvista, "register_dataset_accessor"):  # from 0.48
    pyvista.register_dataset_accessor("palpate", pyvista.DataSet)(Accessor)
