"""A label map of PyVista as a model, and how far the model is from the voxels' surface."""

import sys

import numpy

try:
    import pyvista
except ImportError:
    print("PyVista is not installed (Debian 13: python3-pyvista): this example is skipped.")
    sys.exit(77)
import palpate.pyvista

# An ellipsoid of label 3 in a rotated image with slices of 2 mm.
image = pyvista.ImageData(dimensions=(60, 50, 30), spacing=(1.0, 1.0, 2.0), origin=(-20.0, 5.0, 40.0))
image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
i, j, k = numpy.meshgrid(*[numpy.arange(n) for n in image.dimensions], indexing="ij")
inside = ((i - 30) / 20) ** 2 + ((j - 25) / 15) ** 2 + ((k - 15) / 10) ** 2 <= 1
image.point_data["labels"] = 3 * inside.ravel(order="F").astype(numpy.uint8)

model = palpate.pyvista.fit_image(image, label=3, degree=8)
surface = palpate.to_pyvista(model)
print(f"{surface.n_cells} triangles, {surface.volume / 1000:.2f} ml")

# A surface through the centres of the outermost voxels.
voxels = image.threshold((2.5, 3.5), scalars="labels", all_scalars=True).extract_surface()
deep = palpate.pyvista.distances(voxels, model)["DistanceToModel"]
print(f"the outermost voxels' centres lie {-deep.mean():.2f} mm deep in the mean, from {-deep.max():.2f} to {-deep.min():.2f}")

if hasattr(pyvista, "register_dataset_accessor"):
    assert numpy.array_equal(image.palpate.fit(label=3, degree=8).coefficients, model.coefficients)
    print("the accessor gives the same: image.palpate.fit(label=3)")
assert abs(surface.volume / (4 / 3 * numpy.pi * 20 * 15 * 20) - 1) < 0.02
assert -1.5 < deep.mean() < 0.0
assert numpy.linalg.norm(model.measures().centroid - (-45.0, 35.0, 70.0)) < 0.1
