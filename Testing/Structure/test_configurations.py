"""Configures whichever optional packages are absent, and says which part is left out; the demonstration's and the tests'
configurations share a folder and compile nothing twice.

    test_configurations.py CMAKE SOURCE-FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE, SOURCE = sys.argv[1:3]

# What hides a package of the next configuration in the same folder, whatever an earlier one found, and a word of the
# message that has to name what is left out.
PACKAGES = {
    "GTest": ("-DCMAKE_DISABLE_FIND_PACKAGE_GTest=", "libgtest-dev"),
    "benchmark": ("-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=", "libbenchmark-dev"),
    "GSL": ("-DCMAKE_DISABLE_FIND_PACKAGE_GSL=", "libgsl-dev"),
    "OpenMP": ("-DCMAKE_DISABLE_FIND_PACKAGE_OpenMP=", "OpenMP"),
    "OpenIGTLink": ("-DCMAKE_DISABLE_FIND_PACKAGE_OpenIGTLink=", "libopenigtlink-dev"),
    "pybind11": ("-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=", "pybind11-dev"),
    "Python3": ("-DCMAKE_DISABLE_FIND_PACKAGE_Python3=", "python3-dev"),
    "Qt5": ("-DCMAKE_DISABLE_FIND_PACKAGE_Qt5=", "libvtk9-qt-dev"),
}
# Results of searches for libraries and programs; empty ones are not searched for again.
SEARCHES = ["PKG_CONFIG_EXECUTABLE", "PALPATE_SHARP_LIBRARY", "PALPATE_CCACHE", "PALPATE_DOXYGEN"]


def configure(folder, *arguments, preset="benchmarks", **environment):
    """Standard output of a configuration that has to succeed without a warning."""
    command = [CMAKE, "--no-warn-unused-cli", "--preset", preset, "-S", SOURCE, "-B", folder, *arguments]
    done = subprocess.run(
        command, cwd=SOURCE, text=True, capture_output=True, env={**os.environ, **environment}
    )
    assert done.returncode == 0 and not done.stderr, f"{command}\n{done.stdout}{done.stderr}"
    return done.stdout


def hide(*names):
    """Arguments that hide some of PACKAGES and show the others."""
    return [argument + ("ON" if name in names else "OFF") for name, (argument, _) in PACKAGES.items()]


def commands(folder):
    """The command that compiles each source."""
    entries = json.loads(pathlib.Path(folder, "compile_commands.json").read_text())
    return {entry["file"]: entry["command"] for entry in entries}


def rules(folder):
    return pathlib.Path(folder, "build.ninja").read_text()


class Configurations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = cls.scratch.name

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_demonstration_needs_no_optional_package_and_tests_follow_in_its_folder(self):
        configure(self.folder, preset="demo")
        demonstration = commands(self.folder)
        for part in ["HarmonicsTests", "PalpateBenchmarks", "pybind11"]:
            self.assertNotIn(part, rules(self.folder))
        output = configure(self.folder)
        self.assertNotIn("left out", output)
        for part in ["HarmonicsTests", "PalpateBenchmarks", "pybind11"]:
            self.assertIn(part, rules(self.folder))
        everything = commands(self.folder)
        self.assertGreater(len(everything), len(demonstration))
        for file, command in demonstration.items():
            self.assertEqual(everything[file], command)

    def test_each_absent_package_leaves_out_what_needs_it_and_says_so(self):
        # Two groups, since one package's message may hide another's; each alone with PALPATE_PROVE.
        groups = [["GTest", "OpenIGTLink", "pybind11", "Qt5"], ["benchmark", "GSL", "OpenMP", "Python3"]]
        if "PALPATE_PROVE" in os.environ:
            groups = [[name] for name in PACKAGES]
        for group in groups:
            output = configure(self.folder, *hide(*group))
            for name in group:
                with self.subTest(name):
                    self.assertIn(PACKAGES[name][1], output)

    def test_nothing_but_googletest_may_be_there(self):
        searches = [f"-D{search}=" for search in SEARCHES]
        configure(self.folder, *hide(*PACKAGES), *searches, preset="demo")
        configure(self.folder, *hide(*(PACKAGES.keys() - {"GTest"})), *searches)

    def test_programs_libraries_and_virtual_bus_may_be_absent(self):
        searches = [f"-D{search}=" for search in SEARCHES]
        # pkg-config finds nothing new, and forgets umockdev.
        output = configure(
            self.folder, *hide(), *searches, "-U*umockdev*", PKG_CONFIG_LIBDIR=self.folder, PKG_CONFIG_PATH=""
        )
        self.assertIn("libsharp-dev", output)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
