#!/usr/bin/env python3
"""What compares pictures of drivers can fail."""
import pathlib
import tempfile
import unittest

import pictures

PICTURE = bytes(range(36))


def with_byte(number, value):
    return PICTURE[:number] + bytes([value]) + PICTURE[number + 1 :]


class Differing(unittest.TestCase):
    def test_sees_one_step_of_one_pixel(self):
        self.assertEqual(pictures.differing(PICTURE, PICTURE), (0, 0))
        self.assertEqual(pictures.differing(PICTURE, with_byte(7, 8)), (1 / 12, 0))

    def test_tells_roundings_from_edges(self):
        self.assertEqual(pictures.differing(PICTURE, with_byte(7, 7 + pictures.STEPS)), (1 / 12, 0))
        self.assertEqual(pictures.differing(PICTURE, with_byte(7, 8 + pictures.STEPS)), (1 / 12, 1 / 12))

    def test_takes_missing_pictures_for_different(self):
        self.assertEqual(pictures.differing(PICTURE, PICTURE[:-3]), (1, 1))
        self.assertEqual(pictures.differing(b"", b""), (1, 1))


class Shares(unittest.TestCase):
    def test_are_refused_by_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "shares.txt"
            for line in ("softpipe plaza 0.1", "softpipe plazza 0.1 0.2"):
                path.write_text(f"# a comment\n{line}\n")
                with self.assertRaisesRegex(ValueError, "shares.txt:2: "):
                    pictures.read_shares(path)

    def test_of_the_project_are_for_its_scenes(self):
        shares = pictures.read_shares(pathlib.Path(__file__).with_name("shares.txt"))
        self.assertIn(("softpipe", "plaza"), shares)
        self.assertTrue(all(0 <= over <= some <= 1 for some, over in shares.values()))


if __name__ == "__main__":
    unittest.main()
