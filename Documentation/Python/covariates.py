"""What a covariate does to a shape: effects in mm, where, and p-values."""

import numpy
import palpate

# Forty spheres of 20 mm with noise of 0.1 mm in every coefficient; one harmonic grows with age, 0.05 mm a year.
random = numpy.random.default_rng(1)
age = random.normal(60, 8, 40)
center = random.choice(["east", "west"], 40)
coefficients = random.normal(0, 0.1, (40, 25))
coefficients[:, 0] += 20 * numpy.sqrt(4 * numpy.pi)
coefficients[:, 6] += 0.05 * (age - 60)

# The outcomes: how far each point of the mean is moved along its normal, mm.
mean = palpate.Model(coefficients.mean(axis=0))
surface = palpate.displacement(mean, frequency=8)
outcomes = (coefficients - mean.coefficients) @ surface.map.T

model = palpate.LinearModel("~ age + center", {"age": age, "center": center})
print("coefficients:", model.columns)
effect = model.fit(outcomes)
farthest = abs(effect.values[1]).argmax()
print(f"a year moves the surface by up to {effect.values[1, farthest]:.3f} +- {effect.half_widths[1, farthest]:.3f} mm")

for term in model.terms:
    test = model.permute(term, outcomes, surface.areas, surface.triangles, permutations=999)
    share = surface.areas[test.enhanced_p < 0.05].sum() / surface.areas.sum()
    print(f"{term}: p of the whole surface {test.whole_p:.3f}; {100 * share:.0f} % of it is significant")
    assert (test.whole_p < 0.01) == (term == "age")

# All at once, without permutations: the first five scores of the shapes.
scores = numpy.linalg.svd(coefficients - coefficients.mean(axis=0))[0][:, :5]
print(f"Hotelling's test of age: p = {model.test_together('age', scores).pillai.p:.2g}")
