"""What arrays give is what the program says of the same masks in files, to the last bit.

  test_command_line.py PROGRAM
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
import palpate

SPACING = numpy.array([0.8, 1.0, 2.5])  # mm
ORIGIN = numpy.array([30.0, -12.0, 5.0])
# Columns are the axes.
DIRECTION = numpy.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
PLACE = {"spacing": SPACING, "origin": ORIGIN, "direction": DIRECTION}


def egg():
    """A mask, with a smaller part that is left out."""
    x, y, z = (numpy.indices((50, 45, 18)).T * SPACING).T
    mask = ((x - 19) / 15) ** 2 + ((y - 22) / (13 + 0.2 * (x - 19))) ** 2 + ((z - 22) / 16) ** 2 <= 1
    mask[0:2, 0:2, 0] = True
    return mask.astype(numpy.uint8)


def write_nrrd(path, mask):
    vectors = " ".join("({},{},{})".format(*axis) for axis in (DIRECTION * SPACING).T)
    header = (
        f"NRRD0005\ntype: uint8\ndimension: 3\nsizes: {' '.join(map(str, mask.shape))}\n"
        "space: left-posterior-superior\nencoding: raw\n"
        f"space directions: {vectors}\nspace origin: ({','.join(map(str, ORIGIN))})\n\n"
    )
    path.write_bytes(header.encode() + mask.tobytes(order="F"))


class CommandLine(unittest.TestCase):
    def fitted(self, kind, degree):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder) / "egg.nrrd"
            write_nrrd(image, egg())
            options = ["--label", "1", "--model", kind, "--degree", str(degree), "--output", f"{folder}/out"]
            subprocess.run([PROGRAM, "fit", image, *options], check=True, capture_output=True)
            return palpate.read_model(next((pathlib.Path(folder) / "out").glob("*model*.json")))

    def test_models_are_the_same_to_the_last_bit(self):
        for kind in ("surface", "radial"):
            for degree in (4, 10):
                with self.subTest(kind, degree=degree):
                    wanted = self.fitted(kind, degree)
                    found = palpate.fit_mask(egg(), degree, kind, **PLACE)
                    self.assertEqual([*map(float.hex, found.center)], [*map(float.hex, wanted.center)])
                    numpy.testing.assert_array_equal(found.coefficients, wanted.coefficients)


def ellipsoid(center, axes, size=(50, 45, 18)):
    place = (numpy.indices(size).T * SPACING).T
    return sum(((place[n] - center[n]) / axes[n]) ** 2 for n in range(3)) <= 1


def bean(center=(19, 22, 22), sign=1):
    """Without symmetry along x or y."""
    x, y, z = (numpy.indices((50, 45, 18)).T * SPACING).T
    u, v, w = sign * (x - center[0]), y - center[1], z - center[2]
    return (u / 15) ** 2 + ((v + u * u / 40) / (9 + 0.2 * u)) ** 2 + (w / 14) ** 2 <= 1


class Folder:
    """A temporary folder, and the program in it."""

    def __enter__(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.temporary.__enter__())
        return self

    def __exit__(self, *problem):
        self.temporary.__exit__(*problem)

    def write(self, name, mask):
        (self.path / name).parent.mkdir(exist_ok=True)
        write_nrrd(self.path / name, mask.astype(numpy.uint8))
        return name

    def run(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.path, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def json(self, *words):
        return json.loads(self.run(*words, "--json"))

    def table(self, name):
        return list(csv.DictReader((self.path / name).read_text().splitlines()))


class Measures(unittest.TestCase):
    def equal(self, found, wanted):
        """To the last bit; NaN is null."""
        none = [float("nan") if one is None else one for one in numpy.ravel(wanted)]
        self.assertEqual([*map(float.hex, numpy.ravel(found).astype(float))], [*map(float.hex, map(float, none))])

    def equal_checks(self, found, wanted):
        self.assertEqual([one.name for one in found], [one["name"] for one in wanted])
        for one, other in zip(found, wanted):
            self.assertEqual((one.verdict, one.rule or None), (other["verdict"], other["rule"]))
            self.assertEqual(f"{one.name} {one.sentence}", other["sentence"])
            self.equal(one.volume, 1000 * other["volume_ml"])
            self.equal(one.p, other["p_case"])
            self.equal(one.place, other["place_mm"] or [None] * 3)
            self.assertEqual([rule.rule for rule in one.rules], [rule["rule"] for rule in other["statistics"]])
            self.equal([rule.value for rule in one.rules], [rule["value"] for rule in other["statistics"]])

    def test_checks_of_labels(self):
        labels = egg().astype(numpy.int16)
        labels[30:, 20:, 5:9] *= 2
        labels[ellipsoid((10, 22, 20), (4, 4, 6))] = 0  # a hole
        with Folder() as folder:
            wanted = folder.json("check", folder.write("labels.nrrd", labels))["cases"][0]["structures"]
        found = palpate.check(labels, **PLACE)
        self.assertIn("implausible", [one.verdict for one in found])
        self.equal_checks(found, wanted)

    def test_checks_of_masks_that_overlap(self):
        masks = {"a": ellipsoid((14, 22, 22), (9, 9, 15)), "b": ellipsoid((25, 22, 22), (9, 9, 15))}
        with Folder() as folder:
            for name, mask in masks.items():
                folder.write(f"masks/{name}.nrrd", mask)
            wanted = folder.json("check", "masks", "--as", "structures")["cases"][0]["structures"]
        self.equal_checks(palpate.check(masks, **PLACE), wanted)
        overlap = [rule for rule in palpate.check(masks, **PLACE)[0].rules if rule.rule == "overlap"]
        self.assertTrue(overlap[0].is_alarm)

    def test_groups_are_the_same_file(self):
        random = numpy.random.default_rng(5)
        masks = [ellipsoid((19, 22, 22), random.uniform(9, 12, 3)) for _ in range(22)]
        with Folder() as folder:
            for n, mask in enumerate(masks):
                folder.write(f"clean/case_{n:02}.nrrd", mask)
            folder.run("check", "clean", "--as", "cases", "--make-group", "wanted.json")
            odd = ellipsoid((19, 22, 22), (10, 10, 11)) | ellipsoid((33, 22, 22), (4, 4, 4))
            name = folder.write("odd.nrrd", odd)
            options = ["--group", "wanted.json", "--false-alarms", "10"]
            wanted = folder.json("check", name, *options)["cases"][0]["structures"]
            names = {1: wanted[0]["name"]}
            group = palpate.CheckGroup([palpate.MaskCase(mask, names=names, **PLACE) for mask in masks])
            group.write(folder.path / "found.json")
            self.assertEqual((folder.path / "found.json").read_text(), (folder.path / "wanted.json").read_text())
            read = palpate.read_check_group(folder.path / "wanted.json")
        self.equal_checks(palpate.check(odd, names=names, group=read, false_alarms=0.1, **PLACE), wanted)

    def test_mirror_images(self):
        left, right = bean((27, 22, 22)), bean((21, 22, 22), -1)
        with Folder() as folder:
            files = [folder.write("left.nrrd", left), folder.write("right.nrrd", right)]
            wanted = folder.json("compare", *files, "--mirror")
        found = palpate.compare(left, right, mirror=True, **PLACE)
        self.equal(found.mirror.shift, wanted["mirror"]["shift_mm"])
        self.assertAlmostEqual(numpy.degrees(found.mirror.turn), wanted["mirror"]["turn_deg"], places=12)
        both = wanted["distance"]["both"]
        self.equal(found.both[:4], [both["mean_mm"], both["rms_mm"], both["p95_mm"], both["max_mm"]])
        self.equal(found.areas[1], wanted["reference"]["area_mm2"])
        volume = found.volumes / 1000
        percent = 200 * (volume[0] - volume[1]) / (volume[0] + volume[1])
        self.assertAlmostEqual(percent, wanted["mirror"]["volume_asymmetry_percent"], places=9)

    def test_motion_with_a_landmark(self):
        before, after = bean(), bean((24, 20, 24))
        landmark = [24.5, 3.25, 20.5]
        with Folder() as folder:
            files = [folder.write("after.nrrd", after), folder.write("before.nrrd", before)]
            wanted = folder.json("compare", *files, "--landmark", ",".join(map(str, landmark)))["motion"]
        found = palpate.motion(before, after, landmarks=landmark, **PLACE)
        self.equal(found.shift, wanted["shift_mm"])
        self.equal(found.rest, wanted["rest_mm"])
        self.equal(found.landmarks, wanted["landmarks_mm"][0])

    def test_thickness_by_rays_and_calibre(self):
        size = (20, 20, 40)
        place = (numpy.indices(size).T * SPACING).T
        tube = (place[0] - 8) ** 2 + (place[1] - 10) ** 2 <= 25
        tube &= (place[2] > 5) & (place[2] < 95)
        with Folder() as folder:
            name = folder.write("tube.nrrd", tube)
            wanted = folder.json("relate", name, "--thickness", "rays", "--calibre")["organs"][0]
        found = palpate.calibre(tube, **PLACE)
        self.equal(found.length, wanted["calibre"]["length_mm"])
        sections = wanted["calibre"]["sections"]
        for column, key in zip(found[1:], ["along_mm", "center_mm", "axis", "area_mm2", "least_mm", "largest_mm"]):
            self.equal(column, [section[key] for section in sections])
        surface = palpate.shape(tube, thickness="rays", **PLACE).thickness
        corners = surface.points[surface.triangles]
        areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 6
        weights = numpy.bincount(surface.triangles.ravel(), numpy.repeat(areas, 3), len(surface.points))
        known = numpy.isfinite(surface.distances)
        mean = numpy.average(surface.distances[known], weights=weights[known])
        self.assertAlmostEqual(mean, wanted["thickness"]["mean_mm"], places=9)

    def test_registrations(self):
        mask = bean()
        surface = palpate.shape(mask, **PLACE).thickness.points[::40]
        c, s = numpy.cos(0.1), numpy.sin(0.1)
        points = (surface - 3) @ numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        with Folder() as folder:
            for name, list_of in ("moving.mrk.json", points), ("fixed.mrk.json", surface):
                controls = [{"label": str(n), "position": [*map(float, p)]} for n, p in enumerate(list_of)]
                markups = {"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": controls}
                (folder.path / name).write_text(json.dumps({"markups": [markups]}))
            name = folder.write("mask.nrrd", mask)
            for kind in ("rigid", "similarity", "affine"):
                with self.subTest(kind):
                    wanted = folder.json("register", "moving.mrk.json", name, "--kind", kind)
                    found = palpate.register_points(points, mask, kind=kind, **PLACE)
                    self.equal(found.map[:3], wanted["map"])
                    self.equal(found.rms, wanted["surface"]["rms_mm"])
                    wanted = folder.json("register", "moving.mrk.json", "fixed.mrk.json", "--kind", kind)
                    landmarks = palpate.register_landmarks(points, surface, kind=kind)
                    self.equal(landmarks.map[:3], wanted["map"])
                    other = bean((21, 20, 23))
                    wanted = folder.json("register", folder.write("other.nrrd", other), name, "--kind", kind)
                    bodies = palpate.register_bodies(other, mask, kind=kind, **PLACE)
                    self.equal(bodies.map[:3], wanted["map"])
                    self.equal(bodies.rms, wanted["surface"]["rms_mm"])
            self.compare_registered_models(folder, mask, name)

    def compare_registered_models(self, folder, mask, name):
        models = [palpate.fit_mask(one, 6, "surface", **PLACE) for one in (bean((21, 20, 23)), mask)]
        for n, model in enumerate(models):
            model.write(folder.path / f"model{n}.json")
        wanted = folder.json("register", "model0.json", "model1.json")
        self.equal(palpate.register_bodies(*models).map[:3], wanted["map"])
        wanted = folder.json("register", "model0.json", name)  # a model onto a mask
        self.equal(palpate.register_bodies(models[0], mask, **PLACE).map[:3], wanted["map"])

    def test_cohorts(self):
        random = numpy.random.default_rng(8)
        with Folder() as folder:
            table = "case,patient,side,months\n"
            for n in range(8):
                side = n % 2
                mask = ellipsoid((19, 22, 22), random.uniform(9, 12, 3) + (0, 2 * side, 0))
                folder.write(f"masks/p{n}.nrrd", mask)
                table += f"p{n},q{n // 2},{'LR'[side]},{n % 2 * 6 + n // 4}\n"
            (folder.path / "table.csv").write_text(table)
            options = ["--masks", "masks", "--model", "radial", "--degree", "4", "--permutations", "99"]
            columns = ["--covariates", "table.csv"]
            folder.run("cohort", "out", *options, *columns, "--asymmetry", "patient,side")
            self.compare_asymmetry(folder)
            folder.run("cohort", "out", *columns, "--repeated", "patient", "--formula", "~ months")
            self.compare_mixed(folder, [f"q{n // 2}" for n in range(8)], [n % 2 * 6 + n // 4 for n in range(8)])

    def compare_asymmetry(self, folder):
        models = [palpate.read_model(folder.path / f"out/p{n}/1/model.json") for n in range(8)]
        found = palpate.asymmetry(models[::2], models[1::2], flips=99)
        rows = folder.table("out/asymmetry_anova.csv")
        self.equal(found.squares, [float(row["squares_mm2"]) for row in rows])
        self.equal(found.degrees, [float(row["degrees"]) for row in rows])
        self.equal([found.f, found.p], [float(rows[1]["f"]), float(rows[1]["p"])])
        self.equal(found.individuals, [float(row["shape_mm"]) for row in folder.table("out/asymmetry.csv")])

    def compare_mixed(self, folder, patients, months):
        volume = [float(row["volume_ml"]) for row in folder.table("out/measures.csv")]
        found = palpate.LinearModel("~ months", {"months": months}).fit_mixed(volume, patients)
        row = next(row for row in folder.table("out/repeated.csv") if row["figure"] == "volume_ml")
        wanted = [float(row[key]) for key in ("estimate", "standard_error", "term_f", "term_df2", "term_p")]
        numbers = [found.values[1], found.errors[1], found.f[0], found.denominator_degrees[0], found.p[0]]
        self.equal(numbers, wanted)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
