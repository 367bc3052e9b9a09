"""Checks, registration, motion, calibre, mixed models and asymmetry over arrays: results, shapes, errors."""

import unittest

import numpy
import palpate

UNIT = numpy.sqrt(4 * numpy.pi)


def ball(center, radius, size=(60, 32, 32)):
    i, j, k = numpy.indices(size)
    return (i - center[0]) ** 2 + (j - center[1]) ** 2 + (k - center[2]) ** 2 <= radius**2


def two_balls(radius=11):
    return ball((15, 16, 16), radius) + 2 * ball((45, 16, 16), 11).astype(int)


class Checks(unittest.TestCase):
    def test_labels_and_masks_are_the_same_case(self):
        labels = two_balls()
        labels[ball((45, 16, 16), 4)] = 0
        of_labels = palpate.check(labels, names={1: "a", 2: "b"}, affine=numpy.eye(4))
        masks = {"a": labels == 1, "b": labels == 2}
        for given, names in (masks, None), ([*masks.values()], ["a", "b"]), (numpy.stack([*masks.values()]), "ab"):
            of_masks = palpate.check(given, names=names, affine=numpy.eye(4))
            for one, other in zip(of_labels, of_masks):
                self.assertEqual(one[:4], other[:4])
        self.assertEqual([one.verdict for one in of_labels], ["plausible", "implausible"])
        self.assertEqual(of_labels[1].rule, "hole")
        numpy.testing.assert_allclose(of_labels[1].place, [45, 16, 16], atol=1.0)  # of voxels
        self.assertEqual(of_labels[0].volume, (labels == 1).sum())

    def test_any_memory_order_and_type_gives_the_same(self):
        labels = two_balls(9)
        wanted = palpate.check(labels, spacing=(1, 1, 2))
        for other in numpy.asfortranarray(labels), labels.astype(numpy.uint8), labels[::-1][::-1]:
            found = palpate.check(other, spacing=(1, 1, 2))
            self.assertEqual([str(one) for one in found], [str(one) for one in wanted])

    def test_groups_need_twenty_clean_cases(self):
        random = numpy.random.default_rng(2)
        cases = [palpate.MaskCase(two_balls(random.uniform(9, 11))) for _ in range(21)]
        with self.assertRaisesRegex(palpate.Error, "20 clean cases"):
            palpate.CheckGroup(cases[:19])
        group = palpate.CheckGroup(cases)
        self.assertEqual(group.least_false_alarms, 1 / 22)
        self.assertTrue(all(0 <= place < 21 and "odd shape" in why for place, why in group.dropped))
        verdicts = palpate.MaskCase(two_balls(4)).check(group=group, false_alarms=0.1)
        self.assertNotEqual(verdicts[0].verdict, "plausible")
        self.assertLess(verdicts[0].p, 0.1)
        sizes = [rule.p for one in verdicts for rule in one.rules if rule.rule == "size"]
        self.assertLess(sizes[0], sizes[1])
        with self.assertRaisesRegex(palpate.Error, "too few cases"):
            palpate.check(two_balls(), group=group, false_alarms=0.01)

    def test_refuses_in_a_sentence(self):
        labels = two_balls()
        for rate in (0, 1, float("nan")):
            with self.assertRaisesRegex(ValueError, "between 0 and 1"):
                palpate.check(labels, false_alarms=rate)
        with self.assertRaisesRegex(TypeError, "integers"):
            palpate.check(labels.astype(float))
        with self.assertRaisesRegex(ValueError, "mapping from labels"):
            palpate.check(labels, names=["a", "b"])
        with self.assertRaisesRegex(ValueError, "there are 1 for 2 masks"):
            palpate.check([labels == 1, labels == 2], names=["a"])
        with self.assertRaisesRegex(ValueError, "shapes differ"):
            palpate.check([labels == 1, labels[1:] == 2])
        with self.assertRaisesRegex(ValueError, "have names already"):
            palpate.check({"a": labels == 1}, names=["b"])
        with self.assertRaisesRegex(ValueError, "too large"):
            palpate.check(labels.astype(numpy.int64) << 40)
        with self.assertRaisesRegex(palpate.Error, "one structure at least"):
            palpate.check(0 * labels)
        with self.assertRaisesRegex(palpate.Error, "label 2 has no voxels"):
            palpate.check([labels == 1, labels == 3])
        with self.assertRaisesRegex(ValueError, "shape has to be"):
            palpate.check(labels[0])


class Bodies(unittest.TestCase):
    def egg(self):
        coefficients = numpy.zeros(16)
        coefficients[[0, 3, 5, 6, 12]] = [20 * UNIT, 5, 3, 6, 4]
        return palpate.Model(coefficients, center=[30, 4, 5])

    def test_motion_is_that_of_the_points(self):
        mesh = self.egg().mesh(16)
        c, s = numpy.cos(0.2), numpy.sin(0.2)
        turn = numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        moved = mesh.points @ turn.T + [1, 2, 3]
        found = palpate.motion(mesh, (moved, mesh.triangles), landmarks=mesh.points[:3])
        self.assertAlmostEqual(found.turn, 0.2, places=4)
        self.assertLess(found.rest, 1e-3)
        numpy.testing.assert_allclose(found.landmarks, moved[:3], atol=1e-2)
        self.assertEqual(palpate.motion(mesh, mesh).landmarks.shape, (0, 3))

    def test_mirror_images_come_back(self):
        mesh = self.egg().mesh(16)
        other = palpate.Mesh(mesh.points * [-1, 1, 1] + [7, 8, 9], mesh.normals, mesh.triangles[:, ::-1].copy())
        found = palpate.compare(mesh, other, mirror=True)
        self.assertLess(found.both.maximum, 0.02)
        self.assertAlmostEqual(found.mirror.turn, 0.0, places=3)
        self.assertIsNone(palpate.compare(mesh, other).mirror)

    def test_calibre_of_a_tube(self):
        i, j, _ = numpy.indices((20, 20, 80))
        tube = (i - 9.5) ** 2 + (j - 9.5) ** 2 <= 25
        tube[:, :, :5] = tube[:, :, 75:] = False
        found = palpate.calibre(tube)
        self.assertAlmostEqual(found.length, 70, delta=1)
        numpy.testing.assert_allclose(found.areas, 25 * numpy.pi, rtol=0.05)
        self.assertEqual(found.centers.shape, (len(found.along), 3))
        with self.assertRaisesRegex(palpate.Error, "the body is not long"):
            palpate.calibre(self.egg())
        with self.assertRaisesRegex(ValueError, "spheres"):
            palpate.shape(tube, thickness="ray")

    def test_rays_are_at_least_spheres(self):
        egg = self.egg()
        spheres = palpate.shape(egg).thickness.distances
        rays = palpate.shape(egg, thickness="rays").thickness.distances
        known = numpy.isfinite(rays)
        self.assertTrue((rays[known] > spheres[known] - 0.1).all())  # of triangles
        self.assertGreater(rays[known].max(), spheres.max() + 1)

    def test_registrations_find_the_map(self):
        mesh = self.egg().mesh(8)
        start = numpy.eye(4)
        start[:3, 3] = [1, -1, 0.5]
        found = palpate.register_points(mesh.points - [1, -1, 0.5], mesh, start=start)
        self.assertTrue(found.has_converged)
        numpy.testing.assert_allclose(found.map, start, atol=1e-6)
        exact = palpate.register_landmarks(mesh.points[:9], 2 * mesh.points[:9] + 3, kind="similarity")
        numpy.testing.assert_allclose(exact.map[:3], [[2, 0, 0, 3], [0, 2, 0, 3], [0, 0, 2, 3]], atol=1e-9)
        self.assertEqual(exact.weights.shape, (9,))

    def test_registrations_refuse_in_a_sentence(self):
        mesh = self.egg().mesh(4)
        with self.assertRaisesRegex(ValueError, "2 landmarks for 3"):
            palpate.register_landmarks(mesh.points[:2], mesh.points[:3])
        with self.assertRaisesRegex(ValueError, "kind is"):
            palpate.register_landmarks(mesh.points, mesh.points, kind="elastic")
        with self.assertRaisesRegex(palpate.Error, "at least three"):
            palpate.register_landmarks(mesh.points[:2], mesh.points[:2])
        with self.assertRaisesRegex(ValueError, "start: the shape"):
            palpate.register_points(mesh.points, mesh, start=numpy.eye(3))
        with self.assertRaisesRegex(palpate.Error, "no matrix of a map"):
            palpate.register_points(mesh.points, mesh, start=numpy.ones((4, 4)))


class Repeated(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(6)
        self.subjects = numpy.repeat([*"abcdefghij"], 4)
        self.times = numpy.tile([0.0, 1.0, 2.0, 3.0], 10)
        own = numpy.repeat(random.normal(0, 2, (10, 1)), 4, axis=0)
        self.outcomes = 3 + 0.5 * self.times[:, None] + own + random.normal(0, 0.1, (40, 3))
        self.model = palpate.LinearModel("~ time", {"time": self.times})

    def test_mixed_models_of_balanced_cases_have_the_slopes_of_least_squares(self):
        found = self.model.fit_mixed(self.outcomes, self.subjects)
        numpy.testing.assert_allclose(found.values, self.model.fit(self.outcomes).values, atol=1e-9)
        self.assertEqual(found.f.shape, (1, 3))
        numpy.testing.assert_allclose(found.denominator_degrees, 29, atol=1e-3)  # 40 - 10 - 1
        self.assertTrue((found.p < 1e-9).all())
        self.assertFalse(found.is_singular.any())
        centred = self.outcomes.reshape(10, 4, 3) - self.outcomes.reshape(10, 4, 3).mean(axis=1, keepdims=True)
        slope = found.values[1]
        rest = centred - (numpy.arange(4) - 1.5)[None, :, None] * slope
        numpy.testing.assert_allclose(found.residual_variance, (rest**2).sum(axis=(0, 1)) / 29, rtol=1e-5)

    def test_slopes_are_random_with_times(self):
        slopes = numpy.repeat(numpy.linspace(-1, 1, 10), 4) * self.times
        found = self.model.fit_mixed(self.outcomes + slopes[:, None], self.subjects, times=self.times)
        numpy.testing.assert_allclose(found.subject_covariance[2], numpy.linspace(-1, 1, 10).var(ddof=1), rtol=0.2)

    def test_what_does_not_vary_is_nan(self):
        found = self.model.fit_mixed(numpy.ones(40), self.subjects)
        self.assertTrue(numpy.isnan(found.values).all() and numpy.isnan(found.p).all())

    def test_refuses_in_a_sentence(self):
        with self.assertRaisesRegex(ValueError, "subjects: the shape"):
            self.model.fit_mixed(self.outcomes, self.subjects[:5])
        with self.assertRaisesRegex(ValueError, "times: the shape"):
            self.model.fit_mixed(self.outcomes, self.subjects, times=[1.0])
        with self.assertRaisesRegex(palpate.Error, "not finite"):
            self.model.fit_mixed(self.outcomes, self.subjects, times=numpy.nan * self.times)
        with self.assertRaisesRegex(palpate.Error, "confidence"):
            self.model.fit_mixed(self.outcomes, self.subjects, confidence=1.0)
        with self.assertRaises(palpate.Error):
            self.model.fit_mixed(self.outcomes, numpy.arange(40))


class Asymmetry(unittest.TestCase):
    def models(self, seed, offset, side):
        random = numpy.random.default_rng(seed)
        rows = random.normal(0, 0.1, (8, 9))
        rows[:, 0] += 20 * UNIT
        rows[:, 6] += 12 + offset
        rows[:, 8] += 8
        return [palpate.Model(row, center=[30 * side, 0, 0]) for row in rows]

    def test_left_sides_stand_out(self):
        left, right = self.models(1, 1.5, 1), self.models(2, 0.0, -1)
        for align in ("patient", "procrustes"):
            found = palpate.asymmetry(left, right, align=align, frequency=4, flips=99)
            self.assertLess(found.p, 0.05)
            self.assertAlmostEqual(found.squares[1], 0.5 * 8 * 1.5**2, delta=1.5)
            top = found.mean[found.points[:, 2].argmax()]
            self.assertAlmostEqual(top, 1.5 * numpy.sqrt(5 / (4 * numpy.pi)), delta=0.2)
        triangles = palpate.displacement(left[0], frequency=4).triangles
        self.assertEqual(triangles.max() + 1, len(found.points))

    def test_turned_cases_are_turned_back(self):
        left, right = self.models(1, 0.0, 1), self.models(2, 0.0, -1)
        turned = left[3].coefficients.copy()
        c, s = numpy.cos(0.6), numpy.sin(0.6)  # twice 0.3 rad about z, of order 2
        turned[[4, 8]] = [c * turned[4] + s * turned[8], c * turned[8] - s * turned[4]]
        left[3] = palpate.Model(turned)
        patient, procrustes = (
            palpate.asymmetry(left, right, align=align, frequency=4, flips=9) for align in ("patient", "procrustes")
        )
        self.assertGreater(patient.individuals[3], 0.8)
        self.assertLess(procrustes.individuals.max(), 0.2)

    def test_the_midline_is_compared_with_its_mirror_image(self):
        found = palpate.asymmetry(self.models(3, 0.0, 0), frequency=4, flips=99)
        self.assertEqual(len(found.individuals), 8)
        self.assertLess(found.degrees[1], 9)

    def test_refuses_in_a_sentence(self):
        models = self.models(1, 0.0, 1)
        with self.assertRaisesRegex(ValueError, "7 models for 8"):
            palpate.asymmetry(models, models[1:])
        with self.assertRaisesRegex(ValueError, "align is"):
            palpate.asymmetry(models, align="ellipsoid")
        with self.assertRaisesRegex(palpate.Error, "at least 3"):
            palpate.asymmetry(models[:2])
        with self.assertRaisesRegex(palpate.Error, "the frequency"):
            palpate.asymmetry(models, frequency=0)


if __name__ == "__main__":
    unittest.main()
