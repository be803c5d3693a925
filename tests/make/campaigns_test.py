#!/usr/bin/env python3
"""`make ci-all` ends in time and names left-out steps; `make nightly` goes on after a failure and names it."""
import pathlib
import re
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
from folders import copy, run, write_tool

PASSED = "1/1 Test  #1: Suite.Test ...   Passed    0.01 sec"
CTEST = f"""
while [ $# -gt 0 ]; do [ "$1" = --output-log ] && echo '{PASSED}' >"$2"; shift; done
"""
NIGHTLY_MAKE = """
case "$2" in
good) echo "$@"; echo 'all 3 passed' ;;
bad) echo broken; echo 'make[1]: *** [Makefile:9: bad] Error 2'; exit 2 ;;
absent) echo 'skipped: test-absent needs wine' ;;
endless) sleep 600 ;;
esac
"""


class Campaigns(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.tree = pathlib.Path(temporary.name).resolve() / "tree"
        self.tools = self.tree.parent / "tools"
        copy(self.tree, "cmake/ci.sh", "cmake/nightly.sh")

    def ci(self, threads, last_s):
        for tool in ("make", "cmake", "c++"):
            write_tool(self.tools / tool, "")
        write_tool(self.tools / "ctest", CTEST)
        for script in ("tests/drivers/run.py", "tests/fuzz/run.py", "tests/mutants/random.py", "cmake/setup.sh"):
            write_tool(self.tree / script, "echo ran $0")
        write_tool(self.tree / "cmake/threads.sh", threads)
        write_tool(self.tree / "out/ci-nothing", "")
        return run(self.tree, "cmake/ci.sh", "build", "1", "all", LAST_S=str(last_s))

    def test_of_ci_run_all_when_there_is_time(self):
        status, said = self.ci("echo threads", 4140)
        self.assertEqual(status, 0, said)
        for words in ("threads\n", "ran tests/fuzz/run.py\n", "ran tests/mutants/random.py\n"):
            self.assertIn(words, said)
        self.assertNotIn("leaves out", said)
        self.assertTrue(said.endswith("\n100% tests passed, 0 tests failed out of 2\n"), said)

    def test_of_ci_end_a_step_and_leave_out_the_next_when_the_time_is_over(self):
        began = time.monotonic()
        status, said = self.ci("sleep 600", 4)
        self.assertEqual(status, 0, said)
        self.assertLess(time.monotonic() - began, 60)
        self.assertIn("which leaves out the rest of threads under ThreadSanitizer, fuzzers, mutants; ", said)
        self.assertNotIn("ran tests/fuzz", said)

    def test_of_ci_fail_when_a_step_fails(self):
        status, said = self.ci("echo a race; exit 3", 4140)
        self.assertEqual(status, 1, said)
        self.assertIn("a race\n", said)
        self.assertIn("\nfailed: ci-tsan\n", said)

    def test_of_a_night_go_on_after_failures_and_end_with_a_table(self):
        write_tool(self.tools / "make", NIGHTLY_MAKE)
        status, said = run(self.tree, "cmake/nightly.sh", "2", "bad", "endless", "absent", "good", LIMIT_S="1")
        self.assertEqual(status, 1, said)
        rows = dict(re.findall(r"(?m)^\| (\w+) \| ([^|]*) \|", said))
        self.assertEqual(rows, {"step": "result", "bad": "failed", "endless": "not ended after 1 s",
                                "absent": "skipped", "good": "passed"})
        self.assertIn("| all 3 passed |", said)
        self.assertIn("| broken |", said)
        self.assertTrue(said.endswith("failed: bad endless (logs in out/nightly)\n"), said)
        self.assertIn("JOBS=2", (self.tree / "out/nightly/good.log").read_text())

    def test_of_a_night_succeed_when_all_steps_do(self):
        write_tool(self.tools / "make", NIGHTLY_MAKE)
        status, said = run(self.tree, "cmake/nightly.sh", "2", "good")
        self.assertEqual(status, 0, said)

    def test_of_a_night_are_targets_of_make(self):
        source = pathlib.Path(__file__).resolve().parents[2]
        steps = re.search(r"steps='([^']*)'", (source / "cmake/nightly.sh").read_text()).group(1).split()
        targets = re.search(r"^\.PHONY:((?:.*\\\n)*.*)$", (source / "Makefile").read_text(), re.M).group(1).split()
        self.assertEqual([step for step in steps if step not in targets], [])


if __name__ == "__main__":
    unittest.main()
