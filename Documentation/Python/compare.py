"""Two segmentations of one organ, and a model, compared."""

import numpy
import palpate

# A reader's mask of 1 x 1 x 3 mm, and another one's, who drew the front 3 mm farther out.
x, y, z = (step * index for step, index in zip((1.0, 1.0, 3.0), numpy.indices((80, 90, 24))))
reference = ((x - 40) / 26) ** 2 + ((y - 45) / 20) ** 2 + ((z - 36) / 24) ** 2 <= 1
front = numpy.where(y < 45, 23, 20)  # y runs to the patient's back
first = ((x - 40) / 26) ** 2 + ((y - 45) / front) ** 2 + ((z - 36) / 24) ** 2 <= 1

found = palpate.compare(first, reference, tolerances=(1, 2, 3), spacing=(1, 1, 3))
print(f"Dice {found.dice:.3f}, 95 % Hausdorff distance {found.hausdorff95:.2f} mm")
for tolerance, value in zip((1, 2, 3), found.surface_dice):
    print(f"surface Dice at {tolerance} mm: {value:.3f}")
sides = dict(zip(("left", "right", "posterior", "anterior", "superior", "inferior"), found.side_bias))
print("bias by side, mm:", {side: round(float(bias), 2) for side, bias in sides.items()})

# The same numbers, from the voxels.
assert abs(found.dice - 2 * (first & reference).sum() / (first.sum() + reference.sum())) < 1e-12
assert sides["anterior"] > 1.5 > sides["superior"] > sides["posterior"] - 0.01
worst = found.first.points[found.first.distances.argmax()]
assert worst[1] < 25

# A model of a mask, with the mask on another grid: distances are from the model itself.
model = palpate.fit_mask(reference, degree=8, spacing=(1, 1, 3))
coarse = palpate.Mask(reference[::2, ::2], spacing=(2, 2, 3))
print(f"model and coarse mask: mean distance {palpate.compare(coarse, model).both.mean:.2f} mm")
