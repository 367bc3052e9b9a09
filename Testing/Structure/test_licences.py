"""The archive may hold libraries under permissive licences and the LGPL, but not under the GPL."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Utilities"))
import licences


class Licences(unittest.TestCase):
    def test_accepts_permissive_licences_and_the_lgpl(self):
        for licence in ["MIT", "BSD-3-clause and IJG", "LGPL-2.1+", "Apache-2.0"]:
            self.assertTrue(licences.is_allowed(licence), licence)

    def test_accepts_an_alternative_to_the_gpl(self):
        self.assertTrue(licences.is_allowed("LGPL-3 or GPL-2"))
        self.assertTrue(licences.is_allowed(licences.RUNTIME))

    def test_refuses_the_gpl_and_what_is_unknown(self):
        for licence in ["GPL-2+", "BSD-3-clause and GPL-2", "GPL-2 or GPL-3", "unknown", "AGPL-3"]:
            self.assertFalse(licences.is_allowed(licence), licence)

    def test_leaves_out_our_own_libraries(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ["libPalpateCore.so.0.2", "libpalpate.so.1", "libz.so.1"]:
                pathlib.Path(folder, name).touch()
            found = [path.name for path in licences.bundled(pathlib.Path(folder))]
        self.assertEqual(found, ["libz.so.1"])


if __name__ == "__main__":
    unittest.main()
