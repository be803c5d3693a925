#!/usr/bin/env python3
"""Measures which lines and branches of the library its tests run, folder by folder, and holds them to limits.

coverage.py [--jobs N] [--tests REGEX | --programs REGEX] [--keep]: runs the tests of build/coverage (preset `coverage`)
and reads the counts with gcovr, without branches of exceptions and those that cannot be reached. Some of the rest are
no decision of the source: the compiler clears up after exceptions, and std functions that it inlines check. So the
table also counts the branches of lines with a condition, for which there is no limit. --tests runs those whose names
match; --programs runs those that are built and whose names match, with all cases in one process, which takes less
time; --keep adds to the counts of earlier runs. The exit status is 1 if a limit is missed or a test fails.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent
BUILD = SOURCE / "build" / "coverage"
OUT = SOURCE / "out" / "coverage.json"
ROOMS = ["lib", "passes", "meshsplit", "animcache"]
LEAST_LINES, LEAST_BRANCHES = 95.0, 90.0
LISTED = 15  # spots
ENVIRONMENT = {**os.environ, "XDG_CACHE_HOME": str(BUILD / "cache")}
CONDITION = re.compile(r"\b(?:if|for|while|switch|case|catch)\b|\?|&&|\|\|")
REFUSAL = re.compile(r"\b(?:fail|refuse|refused|refuse_without|require\w*|must|bad|bad_save|throw|warn)\b")
# Why a branch is not taken, as far as its line says it.
NO_LINE, NO_CONDITION, COPY, REFUSED, OTHER = (
    "in a line that no test runs", "in a line without a condition: clean-up and checks of inlined functions",
    "in copies of a line that was inlined or instantiated more than once", "a refusal or a warning",
    "another condition")
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
        self.chosen = self.chosen_run = 0  # branches of lines with a condition

    def add(self, other):
        self.lines += other.lines
        self.lines_run += other.lines_run
        self.branches += other.branches
        self.branches_run += other.branches_run
        self.chosen += other.chosen
        self.chosen_run += other.chosen_run

    def of_lines(self):
        return 100 * self.lines_run / self.lines if self.lines else 100.0

    def of_branches(self):
        return 100 * self.branches_run / self.branches if self.branches else 100.0

    def of_chosen(self):
        return 100 * self.chosen_run / self.chosen if self.chosen else 100.0


def reason_of(line, texts):
    """Why branches of a line are not taken."""
    if line["count"] == 0:
        return NO_LINE
    text = texts[line["line_number"] - 1].split("//")[0]
    conditions = len(CONDITION.findall(text))
    if conditions == 0:
        return NO_CONDITION
    if len(line["branches"]) > 4 * conditions:
        return COPY
    return REFUSED if REFUSAL.search(text + " ".join(texts[line["line_number"]:][:1])) else OTHER


def counts_of(file, reasons):
    counts, missed = Counts(), []
    texts = (SOURCE / file["file"]).read_text().splitlines()
    for line in file["lines"]:
        if line.get("gcovr/noncode"):
            continue
        counts.lines += 1
        counts.lines_run += line["count"] > 0
        if line["count"] == 0:
            missed.append(line["line_number"])
        has_condition = CONDITION.search(texts[line["line_number"] - 1].split("//")[0]) is not None
        for branch in line["branches"]:
            counts.chosen += has_condition
            counts.chosen_run += has_condition and branch["count"] > 0
            counts.branches += 1
            counts.branches_run += branch["count"] > 0
            if branch["count"] == 0:
                reasons[reason_of(line, texts)] += 1
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


def run_programs(pattern):
    """Runs each GoogleTest program once; False if one fails. Says how long each takes."""
    listed = subprocess.run(["ctest", "--test-dir", str(BUILD), "--show-only=json-v1"], capture_output=True, text=True,
                            check=True).stdout
    programs = {}  # their folders, as a program has the properties of any of its tests
    for test in json.loads(listed)["tests"]:
        command = test.get("command", [""])
        properties = {one["name"]: one["value"] for one in test.get("properties", [])}
        if "SKIP_REGULAR_EXPRESSION" in properties and re.fullmatch(pattern, os.path.basename(command[0])):
            programs[command[0]] = properties.get("WORKING_DIRECTORY", str(BUILD))
    (SOURCE / "out" / "coverage-tests.log").unlink(missing_ok=True)
    good = True
    for program, folder in sorted(programs.items()):
        begin = time.monotonic()
        with open(SOURCE / "out" / "coverage-tests.log", "a") as log:
            status = subprocess.run([program], cwd=folder, stdout=log, stderr=log, env=ENVIRONMENT).returncode
        name = os.path.basename(program)
        print(f"{name}: {time.monotonic() - begin:.0f} s{'' if status == 0 else ', failed'}", flush=True)
        good = good and status == 0
    return good


def run_tests(jobs, pattern):
    tests = ["ctest", "--test-dir", str(BUILD), "-j", str(jobs), "--output-on-failure", "-Q", "--no-tests=error",
             "--output-log", str(SOURCE / "out" / "coverage-tests.log")]
    return subprocess.run(tests + (["-R", pattern] if pattern else [])).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--tests", help="only those whose names match")
    parser.add_argument("--programs", help="those whose names match, each once")
    parser.add_argument("--keep", action="store_true", help="add to earlier runs")
    given = parser.parse_args()
    if not given.keep:
        for old in BUILD.rglob("*.gcda"):
            old.unlink()
    (SOURCE / "out").mkdir(exist_ok=True)
    failed = not (run_programs(given.programs) if given.programs else run_tests(given.jobs, given.tests))
    folders, spots, total = collections.defaultdict(Counts), [], Counts()
    reasons, files = collections.Counter(), []
    for file in read_counts(given.jobs):
        counts, missed = counts_of(file, reasons)
        files.append((counts.branches - counts.branches_run, file["file"], counts.branches))
        folders[os.path.dirname(file["file"])].add(counts)
        total.add(counts)
        spots += [(count, file["file"], first, last) for count, first, last in spots_of(missed)]
    print("| folder | lines | % | branches | % | of lines with a condition | % |\n|---|---|---|---|---|---|---|")
    for name, counts in [*sorted(folders.items()), ("all", total)]:
        print(f"| {name} | {counts.lines} | {counts.of_lines():.1f} | {counts.branches} | {counts.of_branches():.1f} "
              f"| {counts.chosen} | {counts.of_chosen():.1f} |")
    print("\nbranches that no test takes, by what their line says, and the files with the most:")
    for reason, count in reasons.most_common():
        print(f"{count:5d}  {reason}")
    for count, file, of in sorted(files, reverse=True)[:LISTED]:
        print(f"{count:5d}  {file}, of {of}")
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
