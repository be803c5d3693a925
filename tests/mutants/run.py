#!/usr/bin/env python3
"""Breaks the code on purpose and demands that a test sees it.

run.py [--some N] [--jobs N] [PATTERN...]: puts each mutant whose name LAW/NAME matches a pattern into a copy of the
tree in build/mutants, builds the tests that it names, and runs them. A mutant that no longer applies, that does not
compile, or that no test sees is a failure. With --some, N mutants chosen by the committed tree; those whose tests are
skipped on this machine are then told and not tried. README.md beside this file describes the files.

Mutants whose places do not overlap share one build: each place becomes `claque_mutant(id) ? mutant : code`, and the
environment variable CLAQUE_MUTANT chooses. A mutant marked `alone` replaces the text itself, in a build of its own.
"""
import argparse
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from mutants import fail, grouped, place_edits, read_mutants, texts_of

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
ROOT = SOURCE / "build" / "mutants"
TREE = ROOT / "tree"
BUILD = TREE / "build" / "mutants"
LOG = ROOT / "log"


def read_tree():
    """The files of the tree, which may change while this runs: {name: bytes}."""
    return {name: (SOURCE / name).read_bytes() for name in tree_files()}


def tree_files():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=SOURCE, capture_output=True,
                            text=True)
    if listed.returncode == 0:
        return [name for name in listed.stdout.splitlines() if (SOURCE / name).is_file()]
    found = []
    for folder, folders, names in os.walk(SOURCE):
        folders[:] = [f for f in folders if f not in ("build", "out", ".git")]
        found += [os.path.relpath(os.path.join(folder, name), SOURCE) for name in names]
    return found


def write_tree(source, texts):
    """Makes the copy the tree with these texts; a file of equal bytes keeps its time, so that it is not built again."""
    for name, original in source.items():
        copy = TREE / name
        content = texts[name].encode() if name in texts else original
        if not copy.is_file() or copy.read_bytes() != content:
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(content)
            copy.chmod((SOURCE / name).stat().st_mode)
    for folder, folders, files in os.walk(TREE):
        folders[:] = [f for f in folders if f != "build"]
        for name in files:
            if os.path.relpath(os.path.join(folder, name), TREE) not in source:
                os.remove(os.path.join(folder, name))
    shared = ROOT / "shared"
    if (SOURCE.parent / "shared").is_dir() and not shared.exists():
        shared.symlink_to((SOURCE.parent / "shared").resolve())


def run_logged(command, environment=None, limit_s=None):
    """The exit status; None if it did not end in time."""
    with open(LOG, "w") as log:
        try:
            return subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, cwd=BUILD, timeout=limit_s,
                                  env={**os.environ, **(environment or {})}).returncode
        except subprocess.TimeoutExpired:
            return None


def log_tail(lines=15):
    return "\n".join(LOG.read_text(errors="replace").splitlines()[-lines:])


COMPILE = {"CCACHE_BASEDIR": str(TREE), "CCACHE_SLOPPINESS": "pch_defines,time_macros"}


def configure():
    BUILD.mkdir(parents=True, exist_ok=True)
    if (BUILD / "build.ninja").exists():
        return
    flags = "-O1 -DNDEBUG"
    command = ["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
               f"-DCMAKE_CXX_FLAGS={flags}", f"-DCMAKE_C_FLAGS={flags}", "-DCMAKE_UNITY_BUILD=ON",
               "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12", "-DCLAQUE_TESTS=ON", "-DCLAQUE_BENCHMARKS=OFF"]
    if shutil.which("ccache"):
        command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", "-DCMAKE_C_COMPILER_LAUNCHER=ccache"]
    if run_logged(command, COMPILE) != 0:
        fail(f"the copy cannot be configured\n{log_tail()}")


def build(targets, jobs):
    return run_logged(["cmake", "--build", str(BUILD), "-j", str(jobs), "--target", *sorted(targets)], COMPILE) == 0


def executable_of(target):
    found = [path for path in (BUILD / "tests").rglob(target) if path.is_file() and os.access(path, os.X_OK)]
    if len(found) != 1:
        fail(f"{target} is no program of the tests")
    return found[0]


def cases_of(report):
    return [case for suite in report.get("testsuites", []) for case in suite.get("testsuite", [])]


def run_test(test, limit_s, mutant_id=0):
    """What happened, in a word, with the name of the first test that saw the mutant; and the seconds."""
    target, pattern, variables = test
    report = ROOT / "report.json"
    report.unlink(missing_ok=True)
    program = executable_of(target)
    environment = dict(variable.split("=", 1) for variable in variables)
    environment["CLAQUE_MUTANT"] = str(mutant_id)
    environment["XDG_CACHE_HOME"] = str(ROOT / "cache")
    begun = time.monotonic()
    command = [str(program), f"--gtest_filter={pattern}", f"--gtest_output=json:{report}"]
    status = run_logged(command, environment, limit_s)
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


def check_baseline(mutants, may_skip):
    """Every named test passes when no mutant is chosen; returns the seconds of each that is not skipped."""
    seconds = {}
    for test in sorted({test for mutant in mutants for test in mutant.tests}):
        if part := part_without_test(test):
            fail(f"no test of {test[0]} is named {part}")
        happened, what, taken = run_test(test, 1800)
        if happened == "skipped" and may_skip:
            continue
        if happened != "passed":
            fail(f"without a mutant, {' '.join(test[:2])} {happened}: {what}\n{log_tail()}")
        seconds[test] = taken
    return seconds


def try_mutant(mutant, seconds):
    """Result and remark."""
    tests = [test for test in mutant.tests if test in seconds]
    if not tests:
        return "untried", "skipped here: " + ", ".join(" ".join(test[:2]) for test in mutant.tests)
    for test in tests:
        happened, what, _ = run_test(test, 60 + 20 * seconds[test], mutant.id)
        if happened in ("failed", "crashed", "endless"):
            return happened, what
    if len(tests) < len(mutant.tests):
        return "untried", "its other tests are skipped here"
    return "SURVIVES", ", ".join(" ".join(test[:2]) for test in mutant.tests)


def targets_of(mutants):
    return {test[0] for mutant in mutants for test in mutant.tests}


def without_absent_targets(placed, source, report):
    """Leaves out mutants whose tests this machine does not build."""
    write_tree(source, {})
    configure()
    built = set(re.findall(r"(?m)^build (\w+): phony", (BUILD / "build.ninja").read_text()))
    left = []
    for mutant, places in placed:
        absent = targets_of([mutant]) - built
        if absent:
            report(mutant, "untried", "not built here: " + ", ".join(sorted(absent)))
        else:
            left.append((mutant, places))
    return left


def try_groups(placed, source, jobs, may_skip, report):
    if may_skip:
        placed = without_absent_targets(placed, source, report)
    groups = grouped(placed)
    if groups and groups[0][0][0].alone:
        groups.insert(0, [])
    everything = [mutant for mutant, _ in placed]
    seconds = None
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
                fail(f"the copy does not build\n{log_tail(30)}")
            else:  # finds the one that does not compile
                groups = [group[: len(group) // 2], group[len(group) // 2:]] + groups
            continue
        if seconds is None:
            seconds = check_baseline(everything, may_skip)
        for mutant in mutants:
            report(mutant, *try_mutant(mutant, seconds))


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
