"""A model of a mask, as nibabel or SimpleITK give it."""

import numpy
import palpate

# A kidney-like shape in voxels of 1 x 1 x 3 mm, indexed [i, j, k].
affine_ras = numpy.array([[-1.0, 0, 0, 40], [0, 1.0, 0, -50], [0, 0, 3.0, -30], [0, 0, 0, 1]])
x, y, z = (step * index for step, index in zip((1.0, 1.0, 3.0), numpy.indices((80, 100, 20))))
bend = x - 40 + 0.02 * (y - 50) ** 2
mask = (bend / 14) ** 2 + ((y - 50) / 32) ** 2 + ((z - 28) / 15) ** 2 <= 1

# nibabel's affine is in RAS, Palpate's in LPS: the signs of x and y change.
affine = numpy.diag([-1.0, -1.0, 1.0, 1.0]) @ affine_ras
model = palpate.fit_mask(mask, degree=12, affine=affine)

# SimpleITK has LPS and arrays [k, j, i]:
#   palpate.fit_mask(GetArrayViewFromImage(image).T, spacing=image.GetSpacing(), origin=image.GetOrigin(),
#                    direction=numpy.reshape(image.GetDirection(), (3, 3)))

measures = model.measures()
voxels = numpy.argwhere(mask)
centroid = (affine[:3, :3] @ voxels.mean(axis=0)) + affine[:3, 3]
print(f"{measures.volume / 1000:.2f} ml of {mask.sum() * 3.0 / 1000:.2f} ml; centroid {measures.centroid.round(1)} mm")

assert abs(measures.volume / (mask.sum() * 3.0) - 1) < 0.01
assert numpy.linalg.norm(measures.centroid - centroid) < 0.3
