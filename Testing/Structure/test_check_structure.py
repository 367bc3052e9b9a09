"""The checker passes on a small clean repository and fails on each planted violation."""

import json
import pathlib
import tempfile
import unittest

from check_structure import Checker

TABLE = {
    "externals": {"Eigen": ["Eigen/*"], "VTK": ["vtk*"], "Qt": ["Q*"]},
    "modules": {
        "Modules/Low": {"level": 0, "modules": [], "externals": ["Eigen"]},
        "Modules/High": {"level": 1, "modules": ["Low"], "externals": ["VTK"]},
    },
    "sources": ["Modules"],
    "largest_file_lines": 20,
    "largest_folder_lines": 30,
    "most_public_headers": 4,
}
PAGE = (
    "| level | module | purpose | may use | packages |\n"
    "| 0 | `Modules/Low` | vectors | – | Eigen |\n"
    "| 1 | `Modules/High` | things | Low | VTK |\n"
)
CLEAN = {
    "CMake/PalpatePublicHeaders.cmake": "set(PALPATE_PUBLIC_HEADERS\n  Vector)\n",
    "Documentation/Architecture.md": PAGE,
    "Modules/Low/README.md": "",
    "Modules/Low/Vector.h": "#include <Eigen/Core>\n#include <vector>\n#include <sys/stat.h>\n",
    "Modules/Low/Vector.cxx": '#include "Vector.h"\n',
    "Modules/High/README.md": "",
    "Modules/High/vtk.module": "NAME\n  Palpate::High\nDEPENDS\n  Palpate::Low\n  VTK::CommonCore\n",
    "Modules/High/vtkThing.h": '#include "PalpateHighModule.h"\n#include "Vector.h"\n#include "vtkObject.h"\n',
    "Modules/High/vtkThing.cxx": '#include "vtkThing.h"\n',
    "Modules/High/Testing/TestThing.cxx": "#include <gtest/gtest.h>\n",
}


class CheckStructure(unittest.TestCase):
    def violations(self, table=TABLE, **changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            files = {"Testing/Structure/modules.json": json.dumps(table), **CLEAN, **changes}
            for name, text in files.items():
                if text is not None:
                    path = root / name
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_text(text)
            return Checker(root).check()

    def assert_one(self, fact, **changes):
        violations = self.violations(**changes)
        self.assertEqual(len(violations), 1, violations)
        self.assertIn(fact, violations[0])

    def test_clean_repository_is_green(self):
        self.assertEqual(self.violations(), [])

    def test_forbidden_package(self):
        self.assert_one("vtkObject.h of VTK", **{"Modules/Low/Extra.h": '#include "vtkObject.h"\n'})
        self.assert_one("QWidget of Qt", **{"Modules/High/Extra.h": "#include <QWidget>\n"})

    def test_forbidden_module(self):
        self.assert_one("of module High", **{"Modules/Low/Extra.h": "#include <vtkThing.h>\n"})

    def test_permission_that_is_not_used(self):
        table = json.loads(json.dumps(TABLE))
        table["modules"]["Modules/High"]["externals"].append("Qt")
        page = PAGE.replace("Low | VTK", "Low | VTK, Qt")
        self.assert_one("may use Qt, but does not", table=table, **{"Documentation/Architecture.md": page})

    def test_page_that_differs(self):
        for old, new, fact in (
            ("| 0 |", "| 1 |", "other level for Modules/Low"),
            ("things | Low", "things | –", "other modules for Modules/High"),
            ("| Low | VTK", "| Low | VTK, Qt", "other packages for Modules/High"),
            ("| 0 | `Modules/Low` | vectors | – | Eigen |\n", "", "lists Modules/Low 0 times"),
            ("| 0 |", "| 0 | `Modules/Low` | vectors | – | Eigen |\n| 0 |", "lists Modules/Low 2 times"),
        ):
            with self.subTest(fact):
                self.assert_one(fact, **{"Documentation/Architecture.md": PAGE.replace(old, new)})

    def test_forbidden_export_header(self):
        self.assert_one("PalpateHighModule.h", **{"Modules/Low/Extra.h": '#include "PalpateHighModule.h"\n'})

    def test_unknown_header(self):
        self.assert_one("no module or package", **{"Modules/Low/Extra.h": "#include <boost/any.hpp>\n"})

    def test_forbidden_module_dependency(self):
        self.assert_one("names module Other", **{"Modules/High/vtk.module": "NAME\n Palpate::High\nDEPENDS\n Palpate::Other\n"})

    def test_module_file_in_a_module_without_vtk(self):
        self.assert_one("without VTK", **{"Modules/Low/vtk.module": "NAME\n Palpate::Low\n"})

    def test_source_without_header(self):
        self.assert_one("no header", **{"Modules/Low/Lonely.cxx": "\n"})

    def test_module_without_page(self):
        self.assert_one("README", **{"Modules/Low/README.md": None})

    def test_file_that_is_too_long(self):
        self.assert_one("21 lines", **{"Modules/High/Testing/TestLong.cxx": "\n" * 21})

    def test_work_left_behind(self):
        self.assert_one("line 2", **{"Modules/High/Testing/TestThing.cxx": "\n// TO" "DO later\n"})

    def test_module_that_is_not_in_the_table(self):
        self.assert_one("modules.json", **{"Modules/New/README.md": ""})

    def test_same_header_in_two_modules(self):
        self.assert_one("of this name", **{"Modules/High/Vector.h": "\n"})

    def test_folders_that_include_each_other(self):
        files = {
            "CMake/PalpatePublicHeaders.cmake": "set(PALPATE_PUBLIC_HEADERS Inner Shared Vector)",
            "Modules/Low/Vector.h": '#include "Inner.h"\n#include <Eigen/Core>\n',
            "Modules/Low/Sub/Inner.h": '#include "Shared.h"\n',
            "Modules/Low/Other/Shared.h": "\n",
        }
        self.assertEqual(self.violations(**files), [])
        files["Modules/Low/Other/Shared.h"] = '#include "Vector.h"\n'
        violations = self.violations(**files)
        self.assertEqual(len(violations), 3, violations)  # one for each edge of the circle
        self.assertIn("circle", violations[0])

    def test_own_names_that_are_alike(self):
        def source(header, own):
            return f'#include "{header}"\nnamespace palpate\n{{\nnamespace\n{{\n{own}}} // namespace\n}}\n'

        files = {
            "Modules/Low/Vector.cxx": source("Vector.h", "bool IsLong(double a)\n{\n  return a > 1;\n}\n"),
            "Modules/Low/Line.h": "\n",
            "Modules/Low/Line.cxx": source("Line.h", "bool IsLong(const Line& l)\n{\n  return l.A;\n}\n"),
        }
        self.assertEqual(self.violations(**files), [])
        same = {"Modules/Low/Line.cxx": source("Line.h", "bool IsLong(double b)\n{\n  return b > 2;\n}\n")}
        self.assert_one("declares IsLong(double)", **{**files, **same})
        constant = {"Modules/Low/Line.cxx": source("Line.h", "constexpr double IsLong = 2.0;\n")}
        self.assert_one("declares IsLong as a function, Line.cxx as a constant", **{**files, **constant})
        aliases = {f"Modules/Low/{name}.cxx": source(f"{name}.h", f"using Is = {name};\n") for name in ("Vector", "Line")}
        self.assert_one("gives Is another meaning than Line.cxx does", **{**files, **aliases})
        separate = {"Modules/Low/CMakeLists.txt": "set_property(TARGET Low PROPERTY UNITY_BUILD OFF)\n"}
        self.assertEqual(self.violations(**{**files, **same, **separate}), [])

    def test_type_that_is_defined_twice(self):
        def header(namespace, own=False):
            plane = "struct Plane\n{\n  int Rows;\n};\n"
            plane = f"namespace\n{{\n{plane}}} // namespace\n" if own else plane
            return f"namespace {namespace}\n{{\nstruct Later;\n{plane}}}\n"

        files = {"Modules/Low/Vector.h": "#include <Eigen/Core>\n" + header("palpate")}
        self.assertEqual(self.violations(**files, **{"Modules/High/Plane.h": header("palpate::other")}), [])
        self.assertEqual(self.violations(**files, **{"Modules/High/Plane.h": header("palpate", own=True)}), [])
        self.assert_one("defines Plane, as Modules/Low/Vector.h", **files, **{"Modules/High/Plane.h": header("palpate")})

    def test_public_headers(self):
        page = "CMake/PalpatePublicHeaders.cmake"
        extra = {f"Modules/Low/{name}.h": "\n" for name in ("One", "Two", "Three")}
        self.assert_one("makes 5 headers public", **extra, **{page: "set(PALPATE_PUBLIC_HEADERS One Two Three Vector)"})
        violations = self.violations(**{page: "set(PALPATE_PUBLIC_HEADERS Gone Vector)"})
        self.assertIn(f"{page}: lists Gone.h, which does not exist", violations)
        self.assert_one("is public and includes Vector.h", **{page: "set(PALPATE_PUBLIC_HEADERS\n)"})

    def test_folder_that_is_too_long(self):
        files = {f"Modules/High/Testing/Test{name}.cxx": "\n" * 20 for name in "AB"}
        self.assert_one("has 41 lines", **files)
        files["Modules/High/Testing/Sub/TestB.cxx"] = files.pop("Modules/High/Testing/TestB.cxx")
        self.assertEqual(self.violations(**files), [])

    def test_long_line_of_prose(self):
        words = "word " * 24 + "end"
        self.assert_one("line 3 is longer", **{"Modules/Low/README.md": f"# Low\n\n{words}\n"})
        self.assert_one("line 1 is longer", **{"Documentation/Page.md": f"- {words}\n"})
        self.assert_one("line 2 is longer", **{"Documentation/Page.md": f"- item\n    {words}\n"})
        link = f"[Low](../Modules/Low/{'../Low/' * 20}README.md)"
        for exempt in (f"| {words} |", f"    {words}", f"```sh\n{words}\n```", f"![{words}](Page.md)", link):
            self.assertEqual(self.violations(**{"Documentation/Page.md": exempt + "\n"}), [])
        self.assertEqual(self.violations(**{"CHANGELOG.md": f"- {words}\n"}), [])

    def test_broken_link(self):
        page = "# Two words\n\n[a]({}) and [b](https://example.org/x)\n"
        for target in ("#two-words", "Architecture.md", "../Modules/Low/README.md"):
            self.assertEqual(self.violations(**{"Documentation/Page.md": page.format(target)}), [])
        self.assert_one("does not exist", **{"Documentation/Page.md": page.format("None.md")})
        self.assert_one("no such heading", **{"Documentation/Page.md": page.format("#three-words")})

    def test_table_that_points_upward(self):
        table = json.loads(json.dumps(TABLE))
        table["modules"]["Modules/Low"]["modules"] = ["High"]
        self.assertIn("not below", self.violations(table)[0])


if __name__ == "__main__":
    unittest.main()
