"""Mutants change the line that they name, and outdated ones are found."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Utilities"))
import mutants

SOURCE = "int F()\n{\n  int a = 1;\n  Use(a,\n      a);\n  Use(b);\n  Use(b);\n}\n"


def mutant(old, new="", **more):
    return {"file": "F.cxx", "old": old, "new": new, "breaks": "F", **more}


class Mutants(unittest.TestCase):
    def test_replaces_the_line(self):
        self.assertEqual(
            mutants.mutated(SOURCE, mutant("int a = 1;", "int a = 2;")),
            SOURCE.replace("  int a = 1;", "int a = 2;"),
        )

    def test_deletes_the_line(self):
        self.assertNotIn("int a", mutants.mutated(SOURCE, mutant("int a = 1;")))

    def test_knows_a_line_that_was_broken(self):
        self.assertIn("}", mutants.mutated(SOURCE, mutant("Use(a, a);")))
        self.assertNotIn("Use(a", mutants.mutated(SOURCE, mutant("Use(a, a);")))

    def test_needs_exactly_one_place(self):
        for old in ["int c = 1;", "int a", "Use(b);"]:
            with self.assertRaises(ValueError):
                mutants.mutated(SOURCE, mutant(old))

    def test_finds_all_that_is_out_of_date(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "F.cxx").write_text(SOURCE)
            table = {
                "group": [{"files": "F", "tests": []}],
                "mutant": [
                    mutant("int a = 1;"),
                    mutant("int a = 1;"),
                    mutant("int c = 1;"),
                    mutant("int a = 1;", "int a = 2;", file="G.cxx"),
                ],
            }
            self.assertEqual(len(mutants.problems_of(table, pathlib.Path(folder))), 3)

    def test_keeps_rows_of_mutants_that_were_not_run_again(self):
        table = {
            "mutant": [
                mutant("int a = 1;"),
                mutant("int a = 1;", "int a = 2;"),
                mutant("Use(a, a);"),
                mutant("Use(b);", equivalent="no reason"),
            ]
        }
        first, second, third, _ = table["mutant"]
        results = mutants.results_of(table, {id(first): "F.Works", id(second): None})
        known = mutants.killers_in(results, table)
        self.assertEqual(known, {id(first): "F.Works", id(second): None})
        self.assertEqual(mutants.results_of(table, known), results)
        page = mutants.page_of(table, known)
        self.assertIn("1 of 2 mutants are killed; 1 more are harmless, with the reason; 1 were not run yet.", page)
        self.assertIn("| `.` | 4 | 1 | 1 |", page)
        page = mutants.page_of(table, {**known, id(second): "F.Works", id(third): "F.Works"})
        self.assertIn("3 of 3 mutants are killed; 1 more", page)
        self.assertNotIn("yet", page)



if __name__ == "__main__":
    unittest.main()
