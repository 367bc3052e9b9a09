"""Shapes by touch, over NumPy arrays: completed from points, corrected by pulls, measured along the surface."""

import unittest

import numpy
import palpate

UNIT = numpy.sqrt(4 * numpy.pi)
CENTER = numpy.array([3.0, -2.0, 7.0])


def ball(radius=20.0, center=(0.0, 0.0, 0.0)):
    return palpate.Model([radius * UNIT], center=center)


def directions(count=500):
    vectors = numpy.random.default_rng(5).normal(size=(count, 3))
    return vectors / numpy.linalg.norm(vectors, axis=1, keepdims=True)


class Completion(unittest.TestCase):
    def test_touches_and_normals_of_a_ball_give_the_ball(self):
        along = palpate.Model([UNIT]).mesh(1).points
        made = palpate.complete(CENTER + 22 * along, normals=along, sigma=0.5, strokes=numpy.arange(12))
        numpy.testing.assert_allclose(made.model.radii(directions()), 22.0, atol=0.05)
        self.assertEqual((made.deviations.shape, made.next.shape), ((642,), (6, 3)))

    def test_points_outside_hold_the_surface_back(self):
        along = palpate.Model([UNIT]).mesh(1).points
        points = numpy.vstack([20 * along[1:], 23 * along[:1]])
        free = palpate.complete(points[:-1], center=(0, 0, 0), sigma=3.0).model.radii(along[:1])
        touched = palpate.complete(points, center=(0, 0, 0), sigma=3.0).model.radii(along[:1])
        outside = numpy.arange(12) == 11
        held = palpate.complete(points, center=(0, 0, 0), sigma=3.0, outside=outside).model.radii(along[:1])
        self.assertGreater(touched[0], free[0] + 0.5)
        self.assertAlmostEqual(held[0], free[0], 1)

    def test_takes_the_known_organ_as_a_model(self):
        with self.assertRaisesRegex(palpate.Error, "no other organ"):
            palpate.complete(20 * directions(12), known=ball(25))
        with self.assertRaises(TypeError):
            palpate.complete(20 * directions(12), known="gland.json")

    def test_refuses_other_counts_and_what_is_not_star_shaped(self):
        points = 20 * directions(30)
        with self.assertRaisesRegex(ValueError, "one for each point"):
            palpate.complete(points, normals=points[:3])
        points[::2] *= 0.5
        with self.assertRaisesRegex(palpate.Error, "not star-shaped"):
            palpate.complete(points, center=(0, 0, 0), sigma=0.3)


class Geodesics(unittest.TestCase):
    def test_of_a_ball_are_great_circles(self):
        surface = palpate.Geodesics(ball(center=CENTER))
        found = surface.path(CENTER + [30, 0, 0], CENTER + [0, 30, 0])
        self.assertAlmostEqual(found.along, 10 * numpy.pi, 4)
        self.assertAlmostEqual(found.straight, 20 * numpy.sqrt(2), 9)
        numpy.testing.assert_allclose(numpy.linalg.norm(found.points - CENTER, axis=1), 20.0, atol=1e-9)
        distances = surface.map(CENTER + [30, 0, 0])
        self.assertAlmostEqual(distances.distances.max(), 20 * numpy.pi, 1)
        self.assertEqual(len(distances.points), len(distances.distances))

    def test_of_a_mesh_run_along_its_triangles(self):
        square = palpate.Geodesics(([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]], [[0, 1, 2], [0, 2, 3]]))
        found = square.path([1, 1, 5], [9, 7, -5])
        self.assertAlmostEqual(found.along, 10.0, 12)
        self.assertTrue(numpy.isnan(found.uncertainty))
        with self.assertRaisesRegex(palpate.Error, "not finite"):
            square.path([1, numpy.inf, 0], [9, 7, 0])


class Correction(unittest.TestCase):
    def sphere(self):
        index = numpy.stack(numpy.meshgrid(*[numpy.arange(40.0)] * 3, indexing="ij"), axis=-1)
        return numpy.linalg.norm(index - 20.0, axis=-1) < 12.0

    def test_a_pulled_mask_grows_there_and_is_undone(self):
        start = self.sphere()
        correction = palpate.Correction(start, origin=CENTER)
        before = correction.mask
        numpy.testing.assert_array_equal(before, start)
        shown = correction.preview(CENTER + [32.0, 20.0, 20.0], 4.0, width=5.0)
        correction.pull(CENTER + [32.0, 20.0, 20.0], 4.0, width=5.0)
        numpy.testing.assert_array_equal(correction.displacements, shown)
        self.assertAlmostEqual(numpy.linalg.norm(shown, axis=1).max(), 4.0, 3)
        grown = correction.mask
        self.assertTrue(grown[35, 20, 20] and not grown[37, 20, 20])
        self.assertTrue((grown >= start).all())
        numpy.testing.assert_array_equal(grown[:20], start[:20])
        self.assertEqual(len(correction.surface.points), len(shown))
        self.assertTrue(correction.undo())
        numpy.testing.assert_array_equal(correction.mask, start)
        self.assertFalse(correction.undo())

    def test_pulls_stop_at_a_barrier(self):
        wall = numpy.zeros((40, 40, 40), bool)
        wall[34] = True
        correction = palpate.Correction(self.sphere(), barrier=wall)
        correction.pull((32, 20, 20), 6.0, width=5.0)
        grown = correction.mask
        self.assertTrue(grown[33, 20, 20] and not grown[34:].any())

    def test_steps_are_those_of_the_file(self):
        start = self.sphere()
        start[2, 2, 2] = True
        start[20, 20, 20] = False
        steps = [
            {"do": "islands"},
            {"do": "fill"},
            {"do": "pull", "place_mm": (32, 20, 20), "displacement_mm": 3, "width_mm": 4, "second_width_mm": 9},
            {"do": "smooth", "deviation_mm": 1.0},
            {"do": "cut", "point_mm": (10, 20, 20), "normal": (-1, 0, 0)},
        ]
        made = palpate.correct(start, steps).mask
        self.assertFalse(made[2, 2, 2] or made[:10].any())
        self.assertTrue(made[20, 20, 20] and made[34, 20, 20])
        with self.assertRaisesRegex(ValueError, "'do' has to be"):
            palpate.correct(start, [{"do": "paint"}])

    def test_a_pulled_model_passes_through_its_target(self):
        for start in (ball(), palpate.fit_points(20 * directions(2000), degree=4)):
            model = palpate.correct(start, [{"do": "pull", "place_mm": (20, 0, 0), "target_mm": (23, 0, 0)}]).model
            self.assertAlmostEqual(model.nearest([23.0, 0, 0]).distances, 0.0, 1)
            self.assertAlmostEqual(model.nearest([-20.0, 0, 0]).distances, 0.0, 2)

    def test_refuses_in_words(self):
        with self.assertRaisesRegex(palpate.Error, "no voxels to edit"):
            palpate.Correction(ball()).fill()
        with self.assertRaisesRegex(palpate.Error, "no mask"):
            palpate.Correction(ball()).mask
        with self.assertRaisesRegex(palpate.Error, "width"):
            palpate.Correction(ball()).pull((20, 0, 0), 1.0, width=0.1)
        with self.assertRaisesRegex(ValueError, "by, or a target"):
            palpate.Correction(ball()).pull((20, 0, 0))
        with self.assertRaisesRegex(palpate.Error, "no voxels"):
            palpate.Correction(numpy.zeros((4, 4, 4)))
        with self.assertRaisesRegex(ValueError, "that of the mask"):
            palpate.Correction(self.sphere(), barrier=numpy.zeros((3, 3, 3)))


if __name__ == "__main__":
    unittest.main()
