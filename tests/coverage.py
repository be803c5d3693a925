#!/usr/bin/env python3
"""Measures which lines and branches of the library its tests run, folder by folder, and holds them to limits.

coverage.py [--jobs N] [--tests REGEX] [--keep]: runs the tests of build/coverage (preset `coverage`) and reads the
counts with gcovr, without branches of exceptions and those that cannot be reached. --tests runs those whose names
match; --keep adds to the counts of earlier runs. The exit status is 1 if a limit is missed or a test fails.
"""
import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
BUILD = SOURCE / "build" / "coverage"
OUT = SOURCE / "out" / "coverage.json"
ROOMS = ["lib", "passes", "meshsplit", "animcache"]
LEAST_LINES, LEAST_BRANCHES = 95.0, 90.0
LISTED = 15  # spots
# A kernel's text is compiled once for each instruction set. gcovr 5.2 ends where such functions of one name begin at
# other lines, and has no option against it.
GCOVR = [
    "/usr/bin/python3", "-c", "import sys; from gcovr import merging; "
    "merging.DEFAULT_MERGE_OPTIONS.ignore_function_lineno = True; "
    "from gcovr.__main__ import main; sys.exit(main())",
]


class Counts:
    def __init__(self):
        self.lines = self.lines_run = self.branches = self.branches_run = 0

    def add(self, other):
        self.lines += other.lines
        self.lines_run += other.lines_run
        self.branches += other.branches
        self.branches_run += other.branches_run

    def of_lines(self):
        return 100 * self.lines_run / self.lines if self.lines else 100.0

    def of_branches(self):
        return 100 * self.branches_run / self.branches if self.branches else 100.0


def counts_of(file):
    counts, missed = Counts(), []
    for line in file["lines"]:
        if line.get("gcovr/noncode"):
            continue
        counts.lines += 1
        counts.lines_run += line["count"] > 0
        if line["count"] == 0:
            missed.append(line["line_number"])
        for branch in line["branches"]:
            counts.branches += 1
            counts.branches_run += branch["count"] > 0
    return counts, missed


def spots_of(numbers):
    """Runs of lines that no test runs: (length, first, last)."""
    runs = []
    for number in numbers:
        if runs and number - runs[-1][1] <= 2:
            runs[-1][1] = number
            runs[-1][2] += 1
        else:
            runs.append([number, number, 1])
    return [(count, first, last) for first, last, count in runs]


def read_counts(jobs):
    OUT.parent.mkdir(exist_ok=True)
    command = [*GCOVR, "--root", str(SOURCE), "--object-directory", str(BUILD), "--json", str(OUT), "-j", str(jobs),
               "--exclude-throw-branches", "--exclude-unreachable-branches", "--gcov-ignore-parse-errors"]
    for room in ROOMS:
        command += ["--filter", f"{SOURCE}/{room}/"]
    subprocess.run(command + [str(BUILD)], cwd=SOURCE, check=True)
    return json.loads(OUT.read_text())["files"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--tests", help="only those whose names match")
    parser.add_argument("--keep", action="store_true", help="add to earlier runs")
    given = parser.parse_args()
    if not given.keep:
        for old in BUILD.rglob("*.gcda"):
            old.unlink()
    tests = ["ctest", "--test-dir", str(BUILD), "-j", str(given.jobs), "--output-on-failure", "-Q", "--no-tests=error",
             "--output-log", str(SOURCE / "out" / "coverage-tests.log")]
    (SOURCE / "out").mkdir(exist_ok=True)
    failed = subprocess.run(tests + (["-R", given.tests] if given.tests else [])).returncode != 0
    folders, spots, total = collections.defaultdict(Counts), [], Counts()
    for file in read_counts(given.jobs):
        counts, missed = counts_of(file)
        folders[os.path.dirname(file["file"])].add(counts)
        total.add(counts)
        spots += [(count, file["file"], first, last) for count, first, last in spots_of(missed)]
    print("| folder | lines | % | branches | % |\n|---|---|---|---|---|")
    for name, counts in [*sorted(folders.items()), ("all", total)]:
        print(f"| {name} | {counts.lines} | {counts.of_lines():.1f} | {counts.branches} | {counts.of_branches():.1f} |")
    print("\nlines that no test runs, the longest spots:")
    for count, file, first, last in sorted(spots, reverse=True)[:LISTED]:
        print(f"{count:5d}  {file}:{first}-{last}")
    if failed:
        print("coverage: tests failed: see out/coverage-tests.log", file=sys.stderr)
    missed = total.of_lines() < LEAST_LINES or total.of_branches() < LEAST_BRANCHES
    if missed:
        print(f"coverage: {LEAST_LINES} % of lines and {LEAST_BRANCHES} % of branches are wanted", file=sys.stderr)
    sys.exit(1 if failed or missed else 0)


if __name__ == "__main__":
    main()
