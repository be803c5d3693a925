#!/usr/bin/env python3
"""setup_test.py SETUP.SH: cmake/setup.sh with a dpkg and an apt of this test's own, which know packages from files."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = {
    "dpkg-query": 'sed "s/$/ install ok installed/" "$T/installed"',
    "apt-cache": 'sed "s/$/:\\n  Candidate: 1/" "$T/offered"; echo "libosmesa7:\n  Candidate: (none)"',
    "apt-get": 'echo "$*" >> "$T/calls"; case $1 in update) cp "$T/archive" "$T/offered" ;;\n'
    "install) for w in \"$@\"; do case $w in -* | install) ;; *) echo \"$w\" >> \"$T/installed\" ;; esac; done ;; esac",
    "id": 'cat "$T/uid"',
    "sudo": "exit 1",
}


class Setup(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        for name, script in TOOLS.items():
            (self.folder / name).write_text(f"#!/bin/sh\n{script}\n")
            (self.folder / name).chmod(0o755)
        text = pathlib.Path(SETUP).read_text()
        listed = text.split("packages='")[1].split("'")[0].split("\n")
        self.packages = [line.split() for line in listed if line]
        self.write(archive=[name for line in self.packages for name in line[1].split("|")], uid=["0"])

    def write(self, **files):
        for name in ("installed", "offered", "calls"):
            (self.folder / name).touch()
        for name, lines in files.items():
            (self.folder / name).write_text("".join(line + "\n" for line in lines))

    def lines(self, name):
        return (self.folder / name).read_text().split("\n")[:-1]

    def names(self, *groups):
        return {line[1].split("|")[0] for line in self.packages if line[0] in groups}

    def setup(self, *words):
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "T": str(self.folder)}
        return subprocess.run([SETUP, *words], cwd=self.folder, env=environment, capture_output=True, text=True)

    def test_installs_each_group_with_those_before_it(self):
        for groups in (["run"], ["run", "command"], ["run", "command", "all"], ["run", "command", "all", "wheel"]):
            self.assertEqual(self.setup(groups[-1]).returncode, 0)
            self.assertEqual(set(self.lines("installed")), self.names(*groups))

    def test_does_nothing_where_all_is_installed(self):
        self.setup()
        self.write(calls=[], uid=["1000"])
        done = self.setup()
        self.assertEqual((done.returncode, done.stdout, done.stderr, self.lines("calls")), (0, "", "", []))

    def test_prints_the_command_where_it_may_not_install(self):
        self.write(uid=["1000"], offered=self.lines("archive"))
        done = self.setup("run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install --no-install-recommends g++ cmake ", done.stderr)
        self.assertEqual(self.lines("calls"), [])

    def test_takes_the_alternative_that_the_suite_has(self):
        self.write(archive=[name for name in self.lines("archive") if name != "libclang-rt-14-dev"])
        self.assertEqual(self.setup("fuzz").returncode, 0)
        self.assertIn("libclang-rt-dev", self.lines("installed"))

    def test_names_what_a_suite_lacks_in_a_line_and_goes_on(self):
        self.write(archive=[name for name in self.lines("archive") if name != "libosmesa6"])
        for uid in ("0", "1000"):
            self.write(uid=[uid])
            done = self.setup("run")
            self.assertEqual(done.returncode, 0, done.stderr)
            said = [line for line in done.stdout.split("\n") if "libosmesa6" in line]
            left_out = "so this is left out: contexts of OSMesa; those of EGL serve"
            self.assertEqual(said, [f"this suite has no libosmesa6, {left_out}"])

    def test_asks_for_nothing_optional_without_lists_of_packages(self):
        self.setup("run")
        self.write(uid=["1000"], offered=[], installed=sorted(set(self.lines("installed")) - {"libosmesa6"}))
        self.assertEqual(self.setup("run").returncode, 0)
        self.write(installed=sorted(set(self.lines("installed")) - {"cmake"}))
        done = self.setup("run")
        self.assertEqual((done.returncode, done.stderr.split("recommends")[-1]), (1, " cmake\n"))

    def test_refuses_a_suite_without_a_package_that_claque_needs(self):
        self.write(archive=[name for name in self.lines("archive") if name != "libopenmesh-dev"])
        done = self.setup("run")
        self.assertEqual(done.returncode, 1)
        self.assertIn("this suite has no libopenmesh-dev, which claque needs", done.stderr)

    def test_refuses_an_unknown_group(self):
        self.assertEqual(self.setup("nothing").returncode, 2)


if __name__ == "__main__":
    SETUP = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
