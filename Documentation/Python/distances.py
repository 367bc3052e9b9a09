"""How far two surfaces are apart, and where."""

import numpy
import palpate

# The same organ twice; the second time it has grown by a bump of 2 mm around +y.
directions = palpate.Model([1.0]).mesh(frequency=12).normals
before = 20.0 + 2.0 * directions[:, 2] ** 2
growth = 2.0 * numpy.exp(8.0 * (directions[:, 1] - 1.0))
first = palpate.fit_points(directions * before[:, None], degree=10, center=(0, 0, 0))
second = palpate.fit_points(directions * (before + growth)[:, None], degree=10, center=(0, 0, 0))

found = first.nearest(second.mesh(frequency=20).points)
largest = found.distances.argmax()
print(f"mean distance {numpy.abs(found.distances).mean():.2f} mm")
print(f"largest {found.distances[largest]:.2f} mm, at {found.points[largest].round(1)} mm")
print(f"grown by {second.measures().volume - first.measures().volume:.0f} mm^3")

assert 1.8 < found.distances[largest] < 2.1
assert found.points[largest][1] > 19.0
