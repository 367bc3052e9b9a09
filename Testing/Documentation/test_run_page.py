"""Blocks that fail and commands outside of blocks are found, and marked blocks are left alone."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import run_page

PAGE = """Text
    palpate fit stray.nii.gz

1. a list

   ```sh
   cat >a.json <<END
   {"a":
     1}
   END
   ```

   ```sh
   test "$(sed -n 2p a.json)" = "  1}"
   ```

<!-- not run: needs a display -->
```sh
false
```
```
palpate info stray.nii.gz
```
"""


class Pages(unittest.TestCase):
    def outcome(self, text):
        blocks, _ = run_page.blocks_of(text)
        with tempfile.TemporaryDirectory() as folder:
            return run_page.run(blocks, pathlib.Path(folder), pathlib.Path("/usr/bin"))

    def test_runs_blocks_of_a_list_in_one_folder_and_finds_commands_elsewhere(self):
        _, strays = run_page.blocks_of(PAGE)
        self.assertEqual(strays, [2, 22])
        self.assertEqual(self.outcome(PAGE), "")

    def test_names_the_line_of_the_block_that_fails(self):
        self.assertIn("line 3 ends with 1", self.outcome("a\n\n```sh\ntrue\nfalse\ntrue\n```\n"))
        self.assertIn("line 1 ends with", self.outcome("```sh\npalpate-that-is-not-there\n```\n"))


if __name__ == "__main__":
    unittest.main()
