#!/usr/bin/env python3
"""What judges replays with a guest can fail."""
import pathlib
import tempfile
import types
import unittest

import replays

PROGRAM = types.SimpleNamespace(frames=3)
ALONE = replays.Replay([("a", "x"), ("b", "y"), ("c", "z"), ("d", "w")], {})
GUEST = replays.Replay([("a", "x"), ("b", "1"), ("c", "2"), ("d", "3")], {})
GUESTS = {guard: GUEST for guard in replays.LEFT_BY}


def changed(replay, number, frame):
    frames = list(replay.frames)
    frames[number] = frame
    return replay._replace(frames=frames)


class Failures(unittest.TestCase):
    def expect(self, words, alone=ALONE, again=ALONE, **guests):
        failed = replays.failures(PROGRAM, alone, again, {**GUESTS, **guests})
        if words:
            self.assertEqual(len(failed), 1, failed)
            self.assertIn(words, failed[0])
        else:
            self.assertEqual(failed, [])

    def test_are_none_if_only_the_corner_changes(self):
        self.expect("")

    def test_leave_out_the_first_frame(self):
        self.expect("", full=changed(GUEST, 0, ("!", "!")))

    def test_name_pixels_outside_the_corner(self):
        self.expect("full: pixels outside the corner changed in 1 frames", full=changed(GUEST, 3, ("!", "3")))
        self.expect("", none=changed(GUEST, 3, ("!", "3")))

    def test_name_a_guest_that_is_not_seen(self):
        self.expect("the corner of 1 frames", minimal=changed(GUEST, 2, ALONE.frames[2]))

    def test_name_state_that_no_list_has(self):
        self.expect("full: a draw left GL_FOG", full=GUEST._replace(left={"GL_FOG": "minimal"}))
        self.expect("minimal: a draw left GL_FOG", minimal=GUEST._replace(left={"GL_FOG": "none"}))
        self.expect("none: a draw left GL_FOG", none=GUEST._replace(left={"GL_FOG": "nowhere"}))
        self.expect("", none=GUEST._replace(left={"GL_FOG": "none", "GL_BLEND": "minimal"}))

    def test_name_replays_that_do_not_agree_or_end_early(self):
        self.expect("two replays alone differ outside", again=changed(ALONE, 1, ("!", "y")))
        self.expect("none: 3 frames instead of 4", none=GUEST._replace(frames=GUEST.frames[:3]))

    def test_read_what_the_witness_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "seen.txt"
            path.write_text("left none GL_FRONT GL_AMBIENT\nframe 0 a1 b2\n")
            self.assertEqual(replays.read(path), replays.Replay([("a1", "b2")], {"GL_FRONT GL_AMBIENT": "none"}))


if __name__ == "__main__":
    unittest.main()
