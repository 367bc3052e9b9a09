"""The package over NumPy arrays: results, shapes and types of arguments, errors, threads."""

import pathlib
import sys
import tempfile
import threading
import time
import unittest

import numpy
import palpate

UNIT = numpy.sqrt(4 * numpy.pi)
CENTER = numpy.array([3.0, -2.0, 7.0])


def ball(radius=20.0, center=(0.0, 0.0, 0.0)):
    return palpate.Model([radius * UNIT], center=center)


def bumpy(degree=6):
    random = numpy.random.default_rng(4)
    return palpate.Model([20.0 * UNIT, *random.normal(scale=0.5, size=(degree + 1) ** 2 - 1)], center=CENTER)


def directions(count=500):
    vectors = numpy.random.default_rng(5).normal(size=(count, 3))
    return vectors / numpy.linalg.norm(vectors, axis=1, keepdims=True)


class Models(unittest.TestCase):
    def test_points_are_centre_and_radius(self):
        model, along = bumpy(), directions()
        points = model.points(along)
        numpy.testing.assert_allclose(points, CENTER + model.radii(along)[:, None] * along, atol=1e-12)
        self.assertEqual(points.shape, (500, 3))

    def test_gradients_are_those_of_differences(self):
        model, along = bumpy(), directions()
        tangent = numpy.cross(along, [0.3, 0.5, -0.8])
        step = 1e-5
        slope = (model.radii(along + step * tangent) - model.radii(along - step * tangent)) / (2 * step)
        # The error of central differences: step^2 times the third derivative, and rounding / step.
        numpy.testing.assert_allclose((model.gradients(along) * tangent).sum(axis=1), slope, atol=1e-6)

    def test_normals_are_across_the_surface(self):
        model, along = bumpy(), directions()
        tangent = numpy.cross(along, [0.3, 0.5, -0.8])
        difference = model.points(along + 1e-6 * tangent) - model.points(along - 1e-6 * tangent)
        self.assertLess(numpy.abs((model.normals(along) * difference).sum(axis=1)).max(), 1e-9)

    def test_curvature_of_a_sphere(self):
        curvature = ball(20.0).curvature(directions())
        numpy.testing.assert_allclose(curvature.mean, 1 / 20.0, rtol=1e-12)
        numpy.testing.assert_allclose(curvature.gaussian, 1 / 400.0, rtol=1e-12)
        self.assertEqual(curvature.principal.shape, (500, 2))
        self.assertEqual(curvature.directions.shape, (500, 2, 3))

    def test_nearest_points_of_a_sphere(self):
        along = directions()
        found = ball(20.0, CENTER).nearest(CENTER + 23.0 * along)
        numpy.testing.assert_allclose(found.distances, 3.0, atol=1e-9)
        numpy.testing.assert_allclose(found.points, CENTER + 20.0 * along, atol=1e-6)
        numpy.testing.assert_allclose(found.normals, along, atol=1e-6)

    def test_mesh_encloses_the_volume(self):
        model = bumpy()
        mesh = model.mesh(frequency=30)
        corners = mesh.points[mesh.triangles]
        volume = (corners[:, 0] * numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6
        self.assertAlmostEqual(volume / model.measures().volume, 1.0, delta=0.003)
        self.assertEqual(mesh.triangles.dtype, numpy.int32)
        numpy.testing.assert_allclose(model.normals(mesh.points - CENTER), mesh.normals, atol=1e-9)

    def test_fit_restores_the_coefficients(self):
        model = bumpy()
        fitted = palpate.fit_points(model.points(directions()), degree=6, center=model.center)
        numpy.testing.assert_allclose(fitted.coefficients, model.coefficients, atol=1e-9)

    def test_parametric_models_have_three_coordinates(self):
        coefficients = numpy.zeros((3, 4))
        coefficients[:, 0] = CENTER * UNIT
        for coordinate, (index, semi_axis) in enumerate(((3, 15.0), (1, 9.0), (2, 6.0))):
            coefficients[coordinate, index] = semi_axis * UNIT / numpy.sqrt(3)
        model = palpate.Model(coefficients)
        self.assertFalse(model.is_radial)
        numpy.testing.assert_array_equal(model.coefficients, coefficients)
        numpy.testing.assert_allclose(model.points(numpy.eye(3)), CENTER + numpy.diag([15.0, 9.0, 6.0]), atol=1e-12)
        measures = model.measures()
        numpy.testing.assert_allclose(measures.semi_axes, [15.0, 9.0, 6.0], atol=1e-9)
        numpy.testing.assert_allclose(measures.centroid, CENTER, atol=1e-9)
        self.assertEqual(len(model.spectrum()), 2)

    def test_files_bring_models_back(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "model.json"
            bumpy().write(path)
            numpy.testing.assert_array_equal(palpate.read_model(str(path)).coefficients, bumpy().coefficients)


class Masks(unittest.TestCase):
    def setUp(self):
        self.spacing = numpy.array([1.0, 1.5, 2.0])
        grid = numpy.indices((40, 30, 24))
        offset = (grid.T * self.spacing - [20.0, 22.0, 23.0]) / [15.0, 12.0, 14.0]
        self.mask = ((offset**2).sum(axis=-1) <= 1.0).T
        self.direction = numpy.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
        self.origin = numpy.array([5.0, 6.0, 7.0])
        self.center = self.origin + self.direction @ [20.0, 22.0, 23.0]

    def fitted(self, **place):
        return palpate.fit_mask(self.mask, 8, **place)

    def check(self, model):
        measures = model.measures()
        self.assertAlmostEqual(measures.volume / (self.mask.sum() * self.spacing.prod()), 1.0, delta=0.01)
        # A twentieth of a voxel.
        numpy.testing.assert_allclose(measures.centroid, self.center, atol=0.08)

    def test_models_are_placed_by_direction(self):
        for kind in ("surface", "radial"):
            model = self.fitted(kind=kind, spacing=self.spacing, origin=self.origin, direction=self.direction)
            self.assertEqual(model.is_radial, kind == "radial")
            self.check(model)

    def test_affine_is_the_same_place(self):
        affine = numpy.eye(4)
        affine[:3, :3] = self.direction * self.spacing
        affine[:3, 3] = self.origin
        model = self.fitted(affine=affine)
        self.check(model)
        other = self.fitted(spacing=self.spacing, origin=self.origin, direction=self.direction)
        numpy.testing.assert_allclose(model.coefficients, other.coefficients, atol=1e-9)

    def test_axes_may_be_left_handed(self):
        self.direction = numpy.diag([-1.0, 1.0, 1.0])
        self.center = self.origin + self.direction @ [20.0, 22.0, 23.0]
        place = {"spacing": self.spacing, "origin": self.origin, "direction": self.direction}
        self.check(self.fitted(**place))
        field = palpate.Field(self.mask, 0.5, **place)
        inside = field.contains(self.center + numpy.array([[0, 0, 0], [14, 0, 0], [16, 0, 0], [0, 0, 13]]))
        self.assertEqual(inside.tolist(), [True, True, False, True])

    def test_memory_order_and_type_do_not_matter(self):
        wanted = self.fitted(spacing=self.spacing).coefficients
        padded = numpy.zeros((80, 30, 24), dtype=numpy.int16)
        padded[::2] = self.mask
        for mask in (numpy.asfortranarray(self.mask), padded[::2], self.mask.astype(numpy.float32)):
            self.mask = mask
            numpy.testing.assert_array_equal(self.fitted(spacing=self.spacing).coefficients, wanted)


def brute_force_distances(points, mesh):
    """Distances of points from a mesh: by the projections on planes, edges and corners of all triangles."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    found = numpy.linalg.norm(points[:, None] - mesh.points[None], axis=2).min(axis=1)
    for start, end in ((a, b), (b, c), (c, a)):
        along = end - start
        part = numpy.einsum("pti,ti->pt", points[:, None] - start, along) / (along**2).sum(axis=1)
        foot = start + numpy.clip(part, 0, 1)[..., None] * along
        found = numpy.minimum(found, numpy.linalg.norm(points[:, None] - foot, axis=2).min(axis=1))
    normal = numpy.cross(b - a, c - a)
    normal /= numpy.linalg.norm(normal, axis=1, keepdims=True)
    height = numpy.einsum("pti,ti->pt", points[:, None] - a, normal)
    foot = points[:, None] - height[..., None] * normal
    inside = numpy.ones(height.shape, dtype=bool)
    for start, end in ((a, b), (b, c), (c, a)):
        inside &= numpy.einsum("pti,ti->pt", numpy.cross(end - start, foot - start), normal) >= 0
    return numpy.minimum(found, numpy.where(inside, numpy.abs(height), numpy.inf).min(axis=1))


class Comparisons(unittest.TestCase):
    def masks(self):
        x, y, z = numpy.indices((30, 28, 12))
        first = ((x - 14) / 11) ** 2 + ((y - 13) / 9) ** 2 + ((z - 6) / 4.5) ** 2 < 1
        reference = ((x - 16) / 10) ** 2 + ((y - 13) / 10) ** 2 + ((z - 5) / 4.5) ** 2 < 1
        return first, reference

    def test_overlap_is_that_of_the_voxels(self):
        first, reference = self.masks()
        found = palpate.compare(first, reference, spacing=(1, 1, 2.5))
        both, either = (first & reference).sum(), (first | reference).sum()
        self.assertAlmostEqual(found.dice, 2 * both / (first.sum() + reference.sum()), 12)
        self.assertAlmostEqual(found.jaccard, both / either, 12)
        numpy.testing.assert_allclose(found.volumes, 2.5 * numpy.array([first.sum(), reference.sum()]))

    def test_distances_are_those_of_brute_force(self):
        first, reference = self.masks()
        found = palpate.compare(first, reference, spacing=(1, 1, 2.5))
        some = slice(0, None, 40)
        expected = brute_force_distances(found.first.points[some], found.reference)
        numpy.testing.assert_allclose(numpy.abs(found.first.distances[some]), expected, atol=1e-9)
        self.assertGreaterEqual(found.both.maximum, expected.max())

    def test_surface_of_a_mask_is_half_way_between_voxels(self):
        first, reference = self.masks()
        found = palpate.compare(first, reference)
        middles = set()
        for axis in range(3):
            change = numpy.argwhere(numpy.diff(first.astype(int), axis=axis))
            middles |= {tuple(p + 0.5 * numpy.eye(3)[axis]) for p in change}
        self.assertEqual({tuple(p) for p in found.first.points}, middles)

    def test_kinds_of_one_body_agree(self):
        model = palpate.Model([20 * numpy.sqrt(4 * numpy.pi)], center=(1, 2, 3))
        mesh = model.mesh(frequency=60)
        for other in (mesh, (mesh.points, mesh.triangles)):
            found = palpate.compare(model, other, tolerances=[0.1])
            self.assertLess(found.both.maximum, 0.005)
            self.assertGreater(found.dice, 0.9998)  # the mesh is inscribed
            self.assertEqual(found.surface_dice, [1.0])

    def test_masks_on_other_grids_are_matched_in_mm(self):
        first, _ = self.masks()
        affine = numpy.diag([2.0, 2.0, 5.0, 1.0])
        affine[:3, 3] = (7, 8, 9)
        fine = palpate.Mask(first.repeat(2, axis=0), spacing=(1, 2, 5), origin=(6.5, 8, 9))
        found = palpate.compare(palpate.Mask(first, affine=affine), fine)
        self.assertEqual(found.dice, 1.0)
        self.assertEqual(found.volumes[0], found.volumes[1])

    def test_open_meshes_have_no_volume(self):
        sphere = palpate.Model([70.0]).mesh(10)
        found = palpate.compare((sphere.points, sphere.triangles[:500]), sphere)
        self.assertTrue(numpy.isnan(found.dice) and numpy.isnan(found.volumes[0]))
        self.assertTrue(numpy.isnan(found.to_first.signed_mean))
        self.assertFalse(numpy.isnan(found.to_reference.signed_mean))

    def test_what_is_no_body_is_refused(self):
        model = palpate.Model([70.0])
        with self.assertRaisesRegex(palpate.Error, "the mask has no voxels"):
            palpate.compare(model, numpy.zeros((3, 3, 3)))
        with self.assertRaisesRegex(palpate.Error, "tolerance"):
            palpate.compare(model, model, tolerances=[-1])
        with self.assertRaises((TypeError, ValueError)):
            palpate.compare(model, "mask.nii.gz")


class Arguments(unittest.TestCase):
    def test_types_and_strides_do_not_matter(self):
        model, along = bumpy(), directions().astype(numpy.float32)
        wanted = model.points(along.astype(float))
        wide = numpy.zeros((500, 6), dtype=numpy.float32)
        wide[:, ::2] = along
        for given in (along, wide[:, ::2], numpy.asfortranarray(along), along.tolist(), along.astype(">f4")):
            numpy.testing.assert_array_equal(model.points(given), wanted)

    def test_one_vector_gives_one_result(self):
        model = bumpy()
        self.assertEqual(model.points([0, 0, 1]).shape, (3,))
        self.assertEqual(model.radii([0, 0, 1]).shape, ())
        self.assertEqual(model.curvature([0, 0, 1]).principal.shape, (2,))
        self.assertEqual(palpate.Tracker(palpate.Scene()).follow([0, 0, 1]).shape, ())

    def test_no_vectors_give_no_results(self):
        self.assertEqual(bumpy().points(numpy.zeros((0, 3))).shape, (0, 3))

    def refused(self, error, message, function, *given, **named):
        with self.assertRaisesRegex(error, message):
            function(*given, **named)

    def test_shapes_and_types_are_named(self):
        model, scene = bumpy(), palpate.Scene()
        self.refused(ValueError, r"directions: .*\(n, 3\).*\(3, 2\)", model.points, numpy.zeros((3, 2)))
        self.refused(ValueError, r"points: .*\(4,\)", model.nearest, numpy.zeros(4))
        self.refused(TypeError, "directions: .*complex128", model.points, numpy.zeros((2, 3), complex))
        self.refused(TypeError, "directions: an array", model.points, [[1, 2], [3]])
        self.refused(TypeError, "points: .*object", model.nearest, None)
        self.refused(ValueError, "coefficients: .* 5", palpate.Model, numpy.ones(5))
        self.refused(ValueError, r"center: .*\(3,\)", palpate.Model, [1.0], center=[1, 2])
        self.refused(ValueError, r"mask: .*\(i, j, k\)", palpate.fit_mask, numpy.ones((4, 4)))
        self.refused(ValueError, "kind: .*'round'", palpate.fit_mask, numpy.ones((4, 4, 4)), kind="round")
        both = {"affine": numpy.eye(4), "spacing": (1, 1, 1)}
        self.refused(ValueError, "not both", palpate.fit_mask, numpy.ones((4, 4, 4)), **both)
        self.refused(ValueError, r"affine: .*\(4, 4\)", palpate.Field, numpy.ones((4, 4, 4)), 1, affine=numpy.eye(3))
        self.refused(ValueError, "index 4", scene.add_mesh, numpy.eye(3), [[0, 1, 4]])
        self.refused(TypeError, "triangles: .*float64", scene.add_mesh, numpy.eye(3), [[0.0, 1.0, 2.0]])

    def test_messages_of_the_library_are_errors(self):
        self.refused(palpate.Error, "direction 1 is zero", bumpy().points, [[1, 0, 0], [0, 0, 0]])
        self.refused(palpate.Error, "absent.json", palpate.read_model, "absent.json")
        self.refused(palpate.Error, "no voxels", palpate.fit_mask, numpy.zeros((4, 4, 4)))
        self.refused(palpate.Error, "above 0", palpate.fit_mask, numpy.ones((4, 4, 4)), spacing=(1, 1, -1))
        self.refused(palpate.Error, "radial", palpate.Model(numpy.eye(3, 4)).radii, [1, 0, 0])
        self.refused(palpate.Error, "id", palpate.Scene().add, ball(), id=0)


class Touch(unittest.TestCase):
    def test_force_is_stiffness_times_depth(self):
        scene = palpate.Scene(tool_radius=1.0)
        self.assertEqual(scene.add(ball(20.0), stiffness=0.4), 1)
        probes = numpy.zeros((60, 3))
        probes[:, 1] = numpy.linspace(25.0, 19.0, 60)
        contacts = palpate.Tracker(scene).follow(probes)
        self.assertEqual(contacts.dtype, palpate.contact_dtype)
        depth = numpy.maximum(21.0 - probes[:, 1], 0.0)
        numpy.testing.assert_array_equal(contacts["id"], depth > 0.0)
        numpy.testing.assert_allclose(contacts["depth"], depth, atol=1e-9)
        numpy.testing.assert_allclose(contacts["force"][:, 1], 0.4 * depth, atol=1e-9)

    def test_structures_have_the_next_free_id(self):
        scene = palpate.Scene()
        mesh = ball().mesh(8)
        self.assertEqual(scene.add(ball(), id=5), 5)
        self.assertEqual(scene.add_mesh(mesh.points, mesh.triangles), 6)

    def test_places_that_are_not_finite_touch_nothing(self):
        scene = palpate.Scene()
        scene.add(ball())
        contacts = palpate.Tracker(scene).follow([[0, 25, 0], [0, 20, 0], [0, numpy.nan, 0]])
        self.assertEqual(contacts["id"].tolist(), [0, 1, 0])

    def test_trackers_outlive_their_scene(self):
        scene = palpate.Scene()
        scene.add(ball())
        tracker = palpate.Tracker(scene)
        del scene
        self.assertEqual(tracker.follow([[0, 25, 0], [0, 20, 0]])["id"].tolist(), [0, 1])

    def test_sessions_push_a_simulated_hand(self):
        scene = palpate.Scene()
        scene.add(ball())
        with palpate.Session("simulated") as session:
            with self.assertRaisesRegex(palpate.Error, "no scene yet"):
                session.read()
            session.show(scene)
            self.assertTrue(session.lead_hand([0.0, 19.0, 0.0]))
            # In real time; the limit is ctest's.
            while session.read().is_ramping or session.read().force[1] <= 0.1:
                time.sleep(0.01)
            self.assertEqual((session.read().id, session.problem), (1, ""))
        with self.assertRaisesRegex(palpate.Error, "closed"):
            session.read()


class Threads(unittest.TestCase):
    def order_with(self, work):
        """What happens first while a thread works, if threads give way only when they have to."""
        order = []

        def run():
            order.append("begin")
            work()
            order.append("end")

        worker = threading.Thread(target=run)
        worker.start()  # returns once the worker runs and gives way
        order.append("meanwhile")
        worker.join()
        return order

    def test_work_lets_other_threads_run(self):
        model = bumpy(degree=40)
        many = directions(100_000)
        near = 25.0 * many[:200]
        points = model.points(many[:20_000])
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)
        try:
            for name, work in {
                "curvature": lambda: model.curvature(many),
                "nearest": lambda: model.nearest(near),
                "mesh": lambda: model.mesh(200),
                "fit_points": lambda: palpate.fit_points(points, 40),
            }.items():
                with self.subTest(name):
                    self.assertEqual(self.order_with(work), ["begin", "meanwhile", "end"])
        finally:
            sys.setswitchinterval(interval)

    def test_threads_share_a_model(self):
        queries = 25.0 * directions(4000)
        wanted = bumpy().nearest(queries).distances
        model = bumpy()  # its search is prepared by the first of the threads
        parts = [None] * 4

        def run(n):
            parts[n] = model.nearest(queries[1000 * n : 1000 * (n + 1)]).distances

        threads = [threading.Thread(target=run, args=(n,)) for n in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        numpy.testing.assert_array_equal(numpy.concatenate(parts), wanted)


class Relations(unittest.TestCase):
    def test_two_boxes_are_as_far_as_their_faces(self):
        mask = numpy.zeros((40, 20, 20), bool)
        one, other = mask.copy(), mask.copy()
        one[3:13, 4:16, 4:16] = True
        other[21:33, 4:16, 4:16] = True
        found = palpate.relate(one, other, margins=[5, 12], definition="ibsi")
        self.assertEqual(found.kind, "apart")
        self.assertAlmostEqual(found.distance, 8.0, places=9)
        self.assertAlmostEqual(found.offset[0], 19.0, places=6)
        self.assertEqual(found.near_areas.shape, (2, 2))
        self.assertEqual(found.near_volumes[0, 0], 0.0)
        self.assertGreater(found.near_volumes[1, 0], 0.2)

    def test_shape_of_a_model_is_that_of_its_ball(self):
        model = palpate.Model([5.0 * numpy.sqrt(4.0 * numpy.pi)])
        shape = palpate.shape(model)
        self.assertAlmostEqual(shape.sphericity, 1.0, places=3)
        self.assertAlmostEqual(shape.area, 100.0 * numpy.pi, delta=0.1)
        self.assertAlmostEqual(shape.thickness.distances.mean(), 10.0, delta=0.02)

    def test_definitions_differ_in_the_steps_of_voxels(self):
        axes = numpy.arange(30) - 14.5
        ball = sum(numpy.meshgrid(axes**2, axes**2, axes**2)) < 100.0
        smooth = palpate.shape(ball)
        steps = palpate.shape(palpate.Mask(ball, affine=numpy.eye(4)), definition="ibsi")
        self.assertGreater(steps.area, 1.05 * smooth.area)
        self.assertAlmostEqual(smooth.area, 400.0 * numpy.pi, delta=30.0)
        with self.assertRaises(ValueError):
            palpate.shape(ball, definition="voxels")

    def test_open_meshes_are_refused(self):
        mesh = palpate.Model([5.0]).mesh(4)
        with self.assertRaises(palpate.Error):
            palpate.relate((mesh.points, mesh.triangles[:50]), mesh)


class Statistics(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(3)
        self.age = random.normal(60, 8, 30)
        self.group = ["a", "b", "c"] * 10
        self.outcomes = random.normal(size=(30, 42))
        self.model = palpate.LinearModel("~ age + group", {"age": self.age, "group": self.group})

    def test_least_squares_are_those_of_numpy(self):
        self.assertEqual(self.model.columns, ["(Intercept)", "age", "groupb", "groupc"])
        group = numpy.array(self.group)
        design = numpy.column_stack([numpy.ones(30), self.age, group == "b", group == "c"]).astype(float)
        numpy.testing.assert_array_equal(self.model.matrix, design)
        expected = numpy.linalg.lstsq(design, self.outcomes, rcond=None)[0]
        numpy.testing.assert_allclose(self.model.fit(self.outcomes).values, expected, rtol=1e-9, atol=1e-10)

    def test_missing_values_leave_cases_out(self):
        age = list(self.age)
        age[4] = None
        age[7] = float("nan")
        model = palpate.LinearModel("~ age", {"age": age}, references=None)
        self.assertEqual(len(model.cases), 28)
        self.assertNotIn(4, model.cases)
        outcomes = self.outcomes.copy()
        outcomes[4] = numpy.nan
        kept = palpate.LinearModel("~ age", {"age": numpy.delete(self.age, [4, 7])})
        numpy.testing.assert_allclose(
            model.fit(outcomes).values, kept.fit(numpy.delete(self.outcomes, [4, 7], axis=0)).values
        )

    def test_references_change_the_level_that_is_left_out(self):
        model = palpate.LinearModel("~ group", {"group": self.group}, references=[("group", "b")])
        self.assertEqual(model.columns, ["(Intercept)", "groupa", "groupc"])

    def test_permutations_agree_with_the_tests_and_between_runs(self):
        surface = palpate.displacement(palpate.Model([70.0]), frequency=2)
        first = self.model.permute("age", self.outcomes, surface.areas, surface.triangles, permutations=199)
        again = self.model.permute("age", self.outcomes, surface.areas, surface.triangles, permutations=199)
        numpy.testing.assert_array_equal(first.enhanced_p, again.enhanced_p)
        numpy.testing.assert_allclose(first.statistic**2, self.model.test("age", self.outcomes).f, rtol=1e-9)
        self.assertTrue((first.family_p >= first.p).all())

    def test_displacement_moves_points_along_normals(self):
        surface = palpate.displacement(palpate.Model([70.0, 0.0, 0.0, 0.0]), frequency=3)
        self.assertEqual(surface.map.shape, (92, 4))
        radius = 70.0 / numpy.sqrt(4 * numpy.pi)
        numpy.testing.assert_allclose(surface.points, radius * surface.normals, atol=1e-12)
        numpy.testing.assert_allclose(surface.map[:, 0], 1 / numpy.sqrt(4 * numpy.pi))
        # Along z: the harmonic of degree 1 and order 0 is a shift.
        numpy.testing.assert_allclose(surface.map[:, 2], numpy.sqrt(3 / (4 * numpy.pi)) * surface.normals[:, 2], atol=1e-12)

    def test_refuses_in_a_sentence(self):
        with self.assertRaisesRegex(palpate.Error, "no column size"):
            palpate.LinearModel("~ size", {"age": self.age})
        with self.assertRaisesRegex(ValueError, "differ in length"):
            palpate.LinearModel("~ age", {"age": self.age, "group": ["a"]})
        with self.assertRaisesRegex(ValueError, "one row per case"):
            self.model.fit(self.outcomes[:5])
        with self.assertRaisesRegex(ValueError, "no term size"):
            self.model.test("size", self.outcomes)
        with self.assertRaisesRegex(palpate.Error, "not finite"):
            self.model.fit(self.outcomes * numpy.nan)
        with self.assertRaisesRegex(ValueError, "areas"):
            self.model.permute("age", self.outcomes, [1.0], [[0, 1, 2]])


if __name__ == "__main__":
    unittest.main()
