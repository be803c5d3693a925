#!/usr/bin/env python3
"""A wheel's bytes depend on contents and one time alone, and its check sees what is wrong."""

import os
import pathlib
import shutil
import sys
import tempfile
import unittest
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "cmake/wheel")]

import archive  # noqa: E402
import check  # noqa: E402

INFO = "claque-1.dist-info"


def tree(folder, order):
    for name in order:
        archive.write(folder / name, name)
    return folder


class Wheel(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        check.faults.clear()

    def packed(self, name, order):
        files = tree(self.folder / name, order)
        os.utime(files / order[0], (1, 1))
        archive.pack(files, files / INFO, self.folder / f"{name}.whl", 1764000001)
        return self.folder / f"{name}.whl"

    def test_equal_folders_give_equal_bytes(self):
        names = ["claque/b.py", f"{INFO}/WHEEL", "claque/a.py", "claque-1.data/scripts/claque"]
        first, second = self.packed("first", names), self.packed("second", names[::-1])
        self.assertEqual(first.read_bytes(), second.read_bytes())
        with zipfile.ZipFile(first) as wheel:
            self.assertEqual(wheel.namelist(), ["claque-1.data/scripts/claque", "claque/a.py", "claque/b.py",
                                                f"{INFO}/WHEEL", f"{INFO}/RECORD"])
            self.assertEqual(wheel.infolist()[0].external_attr >> 16, 0o100755)
            check.check_record(wheel, INFO)
        self.assertEqual(check.faults, [])

    def test_a_changed_file_differs_from_its_row(self):
        with zipfile.ZipFile(self.packed("first", ["claque/a.py", f"{INFO}/WHEEL"])) as wheel, \
                zipfile.ZipFile(self.folder / "changed.whl", "w") as changed:
            for name in wheel.namelist():
                changed.writestr(name, wheel.read(name).replace(b"claque/a.py", b"claque/a.pY", name == "claque/a.py"))
            changed.writestr("claque/more.py", "")
            check.check_record(changed, INFO)
        self.assertEqual(check.faults, ["RECORD lists other files than the wheel holds",
                                        "RECORD is wrong about claque/a.py"])

    @unittest.skipUnless(shutil.which("readelf"), "readelf is not there")
    def test_a_program_of_the_system_is_refused_by_name(self):
        program = self.folder / "claque/bin/sh"
        archive.copy(pathlib.Path(sys.executable).resolve(), program)
        check.check_elf(program, self.folder, [])
        self.assertIn("claque/bin/sh looks for libraries elsewhere", check.faults)
        self.assertIn("claque/bin/sh has a name that another package may have too", check.faults)


if __name__ == "__main__":
    unittest.main()
