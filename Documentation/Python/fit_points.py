"""A model of points that were measured on a surface."""

import numpy
import palpate

# An ellipsoid of 20, 15 and 12 mm, measured at 2,000 places with an error of 0.2 mm.
random = numpy.random.default_rng(1)
directions = random.normal(size=(2000, 3))
directions /= numpy.linalg.norm(directions, axis=1, keepdims=True)
points = directions * [20.0, 15.0, 12.0] + [5.0, -30.0, 100.0]
points += random.normal(scale=0.2, size=points.shape)

model = palpate.fit_points(points, degree=8)
measures = model.measures()
print(model)
print(f"{measures.volume / 1000:.2f} ml, semi-axes {measures.semi_axes.round(2)} mm")

residuals = model.nearest(points).distances
print(f"rms distance of the points {residuals.std():.2f} mm")

assert abs(measures.volume / (4 / 3 * numpy.pi * 20 * 15 * 12) - 1) < 0.01
assert residuals.std() < 0.22
