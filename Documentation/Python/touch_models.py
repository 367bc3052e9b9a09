"""What a tool feels on its way through two organs, without a device."""

import numpy
import palpate

gland = palpate.Model([20.0 * numpy.sqrt(4 * numpy.pi)])
bone = palpate.Model([10.0 * numpy.sqrt(4 * numpy.pi)], center=(0.0, 30.0, 0.0)).mesh(frequency=20)

scene = palpate.Scene(tool_radius=2.0)
soft = scene.add(gland, stiffness=0.2)
hard = scene.add_mesh(bone.points, bone.triangles, stiffness=1.0)

# From outside to 3 mm below the gland's surface, across its edge, and against the bone.
corners = numpy.array([[0.0, -30.0, 0.0], [0.0, -19.0, 0.0], [-19.0, 0.0, 0.0], [-19.0, 30.0, 0.0], [-9.0, 30.0, 0.0]])
probes = numpy.concatenate([numpy.linspace(a, b, 100) for a, b in zip(corners, corners[1:])])
contacts = palpate.Tracker(scene).follow(probes)

for name, structure in (("gland", soft), ("bone", hard)):
    touched = contacts[contacts["id"] == structure]
    force = numpy.linalg.norm(touched["force"], axis=1)
    print(f"{name}: {len(touched)} of {len(probes)} places, up to {touched['depth'].max():.2f} mm and {force.max():.2f} N")

assert abs(contacts["depth"][99] - 3.0) < 1e-6  # 22 mm - 19 mm
assert contacts["id"][-1] == hard
