"""A volume's values as a surface that can be touched: a tube, with friction."""

import numpy
import palpate

# A tube along z of 8 mm in radius, in voxels of 0.5 x 0.5 x 1 mm; bone has 700 or more.
spacing, origin = (0.5, 0.5, 1.0), (-15.0, -15.0, -10.0)
x, y, z = (o + s * n for o, s, n in zip(origin, spacing, numpy.indices((61, 61, 21))))
values = 1000.0 - 300.0 * numpy.abs(numpy.hypot(x, y) - 8.0) / 2.0
tube = palpate.Field(values.astype(numpy.float32), iso=700.0, spacing=spacing, origin=origin)
print("in the wall, in the tube, outside:", tube.contains([[8, 0, 0], [0, 0, 0], [0, 12, 0]]))

scene = palpate.Scene(tool_radius=1.0)
scene.add(tube, stiffness=0.5, static_friction=0.3, dynamic_friction=0.2)
tracker = palpate.Tracker(scene)

# Inside the tube: 1 mm into the wall at 6 mm, which a tool of 1 mm touches at 5 mm; then around.
angle = numpy.concatenate([numpy.zeros(50), numpy.linspace(0.0, numpy.pi / 2, 200)])
radius = numpy.concatenate([numpy.linspace(0.0, 6.0, 50), numpy.full(200, 6.0)])
contacts = tracker.follow(numpy.stack([radius * numpy.cos(angle), radius * numpy.sin(angle), 0 * angle], axis=1))
outward = numpy.stack([numpy.cos(angle), numpy.sin(angle), 0 * angle], axis=1)
push = (contacts["force"] * outward).sum(axis=1)
drag = numpy.linalg.norm(contacts["force"] - push[:, None] * outward, axis=1)
print(f"pushed back by {-push[49]:.2f} N; friction while sliding {drag[-1]:.2f} N")

assert abs(-push[49] - 0.5) < 0.05
assert 0.05 < drag[-1] < 0.16
