#!/usr/bin/env python3
"""`make release` refuses a tree that is no release, and makes the same archive again."""
import hashlib
import pathlib
import re
import sys
import tarfile
import tempfile
import unittest

sys.dont_write_bytecode = True
from folders import copy, run, write_tool

FILES = ("cmake/release.sh", "CMakeLists.txt", "include/claque/base.h", "lib/python/pyproject.toml", ".gitignore")
MAKE = """
case "$2" in
test) exit ${TESTS:-0} ;;
wheel) mkdir -p out/wheel; echo wheel >out/wheel/claque-${WHEEL:-1.2.3}-py3-none-manylinux_2_36_x86_64.whl ;;
package)
    mkdir -p out/packages
    for name in claque libclaque1; do echo $name >out/packages/${name}_1.2.3_amd64.deb; done ;;
*) exit 9 ;;
esac
"""


class Release(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.clone = pathlib.Path(temporary.name).resolve() / "clone"
        copy(self.clone, *FILES)
        self.edit("CMakeLists.txt", r"(?<=project\(claque VERSION )[0-9.]+", "1.2.3")
        for name, number in (("MAJOR", 1), ("MINOR", 2), ("PATCH", 3)):
            self.edit("include/claque/base.h", rf"(?<=#define CLQ_VERSION_{name} )[0-9]+", str(number))
        self.edit("lib/python/pyproject.toml", r'(?<=^version = ")[0-9.]+', "1.2.3")
        sections = "## 1.2.3 - 2026-11-28\n\n- One.\n\n## 1.2.2 - 2026-11-27\n"
        (self.clone / "CHANGELOG.md").write_text("This page says it.\n\n" + sections)
        write_tool(self.clone.parent / "tools" / "make", MAKE)
        self.git("init", "-q")
        self.commit()

    def edit(self, file, pattern, text):
        path = self.clone / file
        changed, count = re.subn(pattern, text, path.read_text(), flags=re.M)
        self.assertEqual(count, 1, f"{file} has no {pattern}")
        path.write_text(changed)

    def git(self, *words):
        identity = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false")
        status, said = run(self.clone, "git", *identity, *words)
        self.assertEqual(status, 0, said)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "A release")

    def release(self, *words, **variables):
        return run(self.clone, "cmake/release.sh", *words, **variables)

    def assert_refused(self, sentence, *words, **variables):
        status, said = self.release(*words, **variables)
        self.assertEqual(status, 1, said)
        refusal = said.splitlines()[-1]
        self.assertRegex(refusal, "^release: " + sentence)
        self.assertFalse((self.clone / "out" / "release").exists())

    def test_is_refused_when_a_file_has_another_version(self):
        for file, pattern, says in (
            ("include/claque/base.h", r"(?<=#define CLQ_VERSION_PATCH )3", "include/claque/base.h has version '1.2.4'"),
            ("lib/python/pyproject.toml", r'(?<=^version = "1.2.)3', "lib/python/pyproject.toml has version '1.2.4'"),
        ):
            before = (self.clone / file).read_text()
            self.edit(file, pattern, "4")
            self.assert_refused(says + ", CMakeLists.txt 1.2.3: ", "--check")
            (self.clone / file).write_text(before)

    def test_is_refused_without_its_section_in_the_changelog(self):
        for heading in ("Unreleased", "1.2.3", "1.2.2 - 2026-11-28", "1.2.3 - soon"):
            self.edit("CHANGELOG.md", r"\A.*\n\n## .*", f"This page says it.\n\n## {heading}")
            self.assert_refused(f"CHANGELOG.md begins with section '{heading}': name it '1.2.3 - ", "--check")
        (self.clone / "CHANGELOG.md").unlink()
        self.assert_refused("CHANGELOG.md is missing", "--check")

    def test_is_refused_with_a_second_section_of_its_version(self):
        self.edit("CHANGELOG.md", r"1\.2\.2", "1.2.3")
        self.assert_refused("CHANGELOG.md has two sections 1.2.3: raise the version in CMakeLists.txt, ", "--check")

    def test_is_refused_when_files_differ_from_the_commit(self):
        self.edit("CMakeLists.txt", r"\A", "# A line more.\n")
        self.assert_refused("1 files differ from commit [0-9a-f]+, the first is CMakeLists.txt: ", "--check")
        self.commit()
        (self.clone / "new.txt").write_text("new")
        self.assert_refused("1 files differ from commit [0-9a-f]+, the first is new.txt: ", "--check")

    def test_is_refused_when_its_tag_is_another_commit(self):
        self.git("tag", "v1.2.3")
        self.assertEqual(self.release("--check")[0], 0)
        self.edit("CHANGELOG.md", r"One", "Two")
        self.commit()
        self.assert_refused("tag v1.2.3 is commit ", "--check")

    def test_is_refused_in_a_folder_that_is_no_clone(self):
        (self.clone / ".git").rename(self.clone.parent / "elsewhere")
        self.assert_refused(".* is no clone of the repository", "--check")

    def test_is_refused_when_a_test_fails_or_the_wheel_has_another_version(self):
        self.assert_refused("make test failed", TESTS="1")
        self.assert_refused("there is no file out/wheel/claque-1.2.3-", WHEEL="1.2.2")

    def test_has_all_files_with_their_sums_and_the_same_archive_again(self):
        archives = []
        for _ in range(2):
            status, said = self.release()
            self.assertEqual(status, 0, said)
            folder = self.clone / "out" / "release"
            sums = dict(reversed(line.split()) for line in (folder / "SHA256SUMS").read_text().splitlines())
            self.assertEqual(set(sums), {f.name for f in folder.iterdir()} - {"SHA256SUMS"})
            for name, digest in sums.items():
                self.assertEqual(hashlib.sha256((folder / name).read_bytes()).hexdigest(), digest)
            self.assertEqual(len(sums), 4, sums)
            archives.append(sums["claque-1.2.3.tar.gz"])
        self.assertEqual(*archives)
        with tarfile.open(folder / "claque-1.2.3.tar.gz") as archive:
            self.assertIn("claque-1.2.3/include/claque/base.h", archive.getnames())


if __name__ == "__main__":
    unittest.main()
