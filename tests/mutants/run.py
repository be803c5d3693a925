#!/usr/bin/env python3
"""Breaks the code on purpose and demands that a test sees it.

run.py [--some N] [--jobs N] [PATTERN...]: puts each mutant whose name LAW/NAME matches a pattern into a copy of the
tree in build/mutants, builds the tests that it names, and runs them. A mutant that no longer applies, that does not
compile, or that no test sees is a failure. With --some, N mutants chosen by the committed tree; those whose tests are
skipped on this machine are then told and not tried. README.md beside this file describes the files.

Mutants whose places do not overlap share one build: each place becomes `claque_mutant(id) ? mutant : code`, and the
environment variable CLAQUE_MUTANT chooses. A mutant marked `alone` replaces the text itself, in a build of its own.
"""
import sys

sys.path.append(sys.path.pop(0))  # of two modules named `random`, Python's comes first
sys.dont_write_bytecode = True
import argparse
import fnmatch
import hashlib
import json
import os
import re
import subprocess
import time

from copied_tree import BUILD, HERE, LOG, ROOT, SOURCE, build, configure, log_tail, read_tree, run_logged, write_tree
from mutants import fail, grouped, place_edits, read_mutants, texts_of
from workers import Workers


def executable_of(target):
    found = [path for path in (BUILD / "tests").rglob(target) if path.is_file() and os.access(path, os.X_OK)]
    if len(found) != 1:
        fail(f"{target} is no program of the tests")
    return found[0]


def cases_of(report):
    return [case for suite in report.get("testsuites", []) for case in suite.get("testsuite", [])]


def run_test(test, folder, limit_s, mutant_id=0):
    """What happened, in a word, with the name of the first test that saw the mutant; and the seconds."""
    target, pattern, variables = test
    report, files = folder / "report.json", folder / "files"
    report.unlink(missing_ok=True)
    files.mkdir(exist_ok=True)
    program = executable_of(target)
    environment = dict(variable.split("=", 1) for variable in variables)
    environment["CLAQUE_MUTANT"] = str(mutant_id)
    environment["XDG_CACHE_HOME"] = str(folder / "cache")
    environment["TMPDIR"] = environment["TEST_TMPDIR"] = str(files)
    begun = time.monotonic()
    command = [str(program), f"--gtest_filter={pattern}", f"--gtest_output=json:{report}", "--gtest_fail_fast"]
    status = run_logged(command, environment, limit_s, folder / "log")
    seconds = time.monotonic() - begun
    if status is None:
        return "endless", f"{target} after {limit_s:.0f} s", seconds
    cases = cases_of(json.loads(report.read_text())) if report.exists() else []
    failed = [f"{case['classname']}.{case['name']}" for case in cases if case.get("failures")]
    if failed:
        return "failed", failed[0], seconds
    if status != 0:
        return "crashed", f"{target} with status {status}", seconds
    ran = [case for case in cases if case.get("status") == "RUN"]
    skipped = [f"{case['classname']}.{case['name']}" for case in ran if case.get("result") == "SKIPPED"]
    if not ran:
        return "missing", f"no test of {target} is named {pattern}", seconds
    if skipped:
        return "skipped", skipped[0], seconds
    return "passed", "", seconds


def part_without_test(test):
    """A part of the filter that matches no test of the program, or None."""
    for part in test[1].split("-")[0].split(":"):
        listed = subprocess.run([str(executable_of(test[0])), "--gtest_list_tests", f"--gtest_filter={part}"],
                                capture_output=True, text=True).stdout
        if not re.search(r"(?m)^  \S", listed):
            return part
    return None


def check_baseline(mutants, may_skip, workers):
    """The seconds of each named test that passes when no mutant is chosen, and why one of the others did not."""
    def check(test, folder):
        if part := part_without_test(test):
            return None, f"no test of {test[0]} is named {part}"
        happened, what, taken = run_test(test, folder, 1800)
        if happened == "passed" or happened == "skipped" and may_skip:
            return taken if happened == "passed" else None, ""
        return None, f"without a mutant, {' '.join(test[:2])} {happened}: {what}\n{log_tail(folder / 'log')}"

    seconds, wrong = {}, {}
    tests = sorted({test for mutant in mutants for test in mutant.tests})
    for test, (taken, why) in zip(tests, workers.each(check, tests)):
        if why:
            wrong[test] = why
            print(why, flush=True)
        elif taken is not None:
            seconds[test] = taken
    return seconds, wrong


def try_mutant(mutant, folder, seconds, wrong):
    """Result and remark."""
    if bad := [test for test in mutant.tests if test in wrong]:
        return "UNJUDGED", wrong[bad[0]].splitlines()[0]
    tests = [test for test in mutant.tests if test in seconds]
    if not tests:
        return "untried", "skipped here: " + ", ".join(" ".join(test[:2]) for test in mutant.tests)
    for test in tests:
        happened, what, _ = run_test(test, folder, 60 + 20 * seconds[test], mutant.id)
        if happened in ("failed", "crashed", "endless"):
            return happened, what
    if len(tests) < len(mutant.tests):
        return "untried", "its other tests are skipped here"
    return "SURVIVES", ", ".join(" ".join(test[:2]) for test in mutant.tests)


def targets_of(mutants):
    return {test[0] for mutant in mutants for test in mutant.tests}


def without_absent_targets(placed, source, may_skip, report):
    """Leaves out mutants whose tests this machine does not build, and reports them."""
    write_tree(source, {})
    configure()
    built = set(re.findall(r"(?m)^build (\w+): phony", (BUILD / "build.ninja").read_text()))
    left = []
    for mutant, places in placed:
        absent = targets_of([mutant]) - built
        if absent:
            report(mutant, "untried" if may_skip else "UNBUILT", "not built here: " + ", ".join(sorted(absent)))
        else:
            left.append((mutant, places))
    return left


def split(group, errors):
    """Two parts of a group that does not compile: those whose files have no errors and the others, or else halves."""
    files = set(re.findall(r"/mutants/tree/([^\s:]+):\d", "\n".join(errors)))
    suspects = [one for one in group if any(place[0] in files for place in one[1])]
    others = [one for one in group if one not in suspects]
    return [others, suspects] if others and suspects else [group[: len(group) // 2], group[len(group) // 2:]]


def try_groups(placed, source, jobs, may_skip, report):
    workers = Workers(jobs)
    placed = without_absent_targets(placed, source, may_skip, report)
    groups = grouped(placed)
    if groups and groups[0][0][0].alone:
        groups.insert(0, [])
    everything = [mutant for mutant, _ in placed]
    seconds = wrong = None
    while groups:
        group = groups.pop(0)
        mutants = [mutant for mutant, _ in group]
        write_tree(source, texts_of(group, source))
        configure()
        if not build(targets_of(mutants if seconds is not None else everything), jobs):
            errors = [line for line in LOG.read_text(errors="replace").splitlines() if "error:" in line]
            what = errors[0][-200:] if errors else "it does not link"
            if len(group) == 1:
                report(mutants[0], "BROKEN", what)
            elif not group:
                fail(f"the copy does not build\n{log_tail(lines=30)}")
            else:  # finds the one that does not compile
                groups = split(group, errors) + groups
            continue
        if seconds is None:
            seconds, wrong = check_baseline(everything, may_skip, workers)
        tried = workers.each(lambda one, folder: try_mutant(one, folder, seconds, wrong), mutants)
        for mutant, found in zip(mutants, tried):
            report(mutant, *found)


def chosen(mutants, count):
    """Others for each committed tree; the same for one tree, in whatever commit it is."""
    tree = subprocess.run(["git", "rev-parse", "HEAD^{tree}"], cwd=SOURCE, capture_output=True, text=True).stdout
    return sorted(mutants, key=lambda mutant: hashlib.sha256((tree + mutant.name).encode()).digest())[:count]


def selected(options):
    mutants = [mutant for path in sorted(HERE.glob("*.mutants")) for mutant in read_mutants(path)]
    if len({mutant.id for mutant in mutants}) != len(mutants):
        fail("two mutants have one name")
    patterns = options.patterns or ["*"]
    mutants = [mutant for mutant in mutants if any(fnmatch.fnmatch(mutant.name, pattern) for pattern in patterns)]
    return mutants if options.some is None else chosen(mutants, options.some)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("patterns", nargs="*", help="names of mutants, with * and ?; all without")
    parser.add_argument("--some", type=int, help="this many, chosen by the committed tree")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    mutants = selected(options)
    if not mutants:
        fail("no mutant has such a name")
    ROOT.mkdir(parents=True, exist_ok=True)
    wide = max(len(mutant.name) for mutant in mutants)
    results = []

    def report(mutant, result, remark):
        results.append(result)  # capitals: a failure
        print(f"{mutant.name:{wide}}  {result:8}  {remark}", flush=True)

    source = read_tree()
    placed = []
    for mutant in mutants:
        places, why = place_edits(mutant, source)
        placed.append((mutant, places)) if places else report(mutant, "STALE", why)
    if placed:
        try_groups(placed, source, options.jobs, options.some is not None, report)
    bad = sum(result.isupper() for result in results)
    untried = results.count("untried")
    print(f"{len(results)} mutants: {len(results) - bad - untried} seen, {bad} not" +
          (f", {untried} untried" if untried else ""))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
