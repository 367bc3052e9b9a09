"""Where a surface is flat, convex or hollow."""

import numpy
import palpate

# A radius with a bump and a hollow: degree 3, mm.
coefficients = numpy.zeros(16)
coefficients[0] = 25.0 * numpy.sqrt(4 * numpy.pi)
coefficients[12] = 9.0  # l = 3, m = 0
model = palpate.Model(coefficients, center=(0.0, 0.0, 50.0))

mesh = model.mesh(frequency=40)
directions = mesh.points - model.center  # of any length
curvature = model.curvature(directions)
most, least = curvature.mean.argmax(), curvature.mean.argmin()
print(f"mean curvature {curvature.mean[least]:.3f} to {curvature.mean[most]:.3f} per mm")
print(f"most convex at {mesh.points[most].round(1)} mm, least at {mesh.points[least].round(1)} mm")

# Gauss and Bonnet: the Gaussian curvature of any such surface integrates to 4 pi.
corners = mesh.points[mesh.triangles]
areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
total = (curvature.gaussian[mesh.triangles].mean(axis=1) * areas).sum()
print(f"integral of the Gaussian curvature {total / numpy.pi:.3f} pi")

assert abs(total / (4 * numpy.pi) - 1) < 0.01
