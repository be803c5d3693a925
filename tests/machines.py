#!/usr/bin/env python3
"""Runs libclaque's tests for other machines (foreign.sh), one after the other, and ends with one table.

machines.py [--jobs N] [MACHINE...]: i386, arm64, mingw, nehalem; without names, all. A machine whose compiler or
emulator is missing is named in the table, with the packages that it needs. The exit status is 1 if a test failed.
"""
import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import time

from gtest_reports import cases_of
from named_runs import run_named

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent
ABOUT = {
    "i386": "32-bit x86",
    "arm64": "64-bit ARM, QEMU",
    "mingw": "64-bit Windows, Wine",
    "nehalem": "x86-64 without AVX, QEMU",
}

Result = collections.namedtuple("Result", "machine passed failed skipped left_out absent seconds")


def programs_of(text):
    """(passed, [failed]) of the tests that ctest ran and that are no GoogleTest programs."""
    passed, failed = 0, []
    for name, end in re.findall(r"^ *\d+/\d+ Test +#\d+: (\S+) \.* *(?:\*\*\*)?(\w+)", text, re.M):
        if name.endswith("_test"):
            continue
        if end == "Passed":
            passed += 1
        else:
            failed.append(f"{name} ({end})")
    return passed, failed


def run(machine, jobs):
    folder = SOURCE / "out" / "machines" / machine
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    began = time.monotonic()
    done = subprocess.run(
        [str(HERE / "foreign.sh"), machine, str(jobs)],
        cwd=SOURCE,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env={**os.environ, "GTEST_OUTPUT": f"json:{'Z:' if machine == 'mingw' else ''}{folder}/"},  # Wine's name for /
    )
    (folder / "log").write_text(done.stdout)
    absent = re.search(r"^skipped: test-\w+ needs (.*)$", done.stdout, re.M)
    passed, failed, skipped = cases_of(folder)
    more, broken = programs_of(done.stdout)
    failed += broken
    if done.returncode != 0 and not failed:
        failed.append(f"foreign.sh ended with {done.returncode}; see {folder / 'log'}")
    if done.returncode == 0 and not absent and passed + more == 0:
        failed.append(f"no test ran; see {folder / 'log'}")
    left_out = re.findall(r"^left out: (.*)$", done.stdout, re.M)
    return Result(
        machine, passed + more, failed, skipped, left_out, absent.group(1) if absent else "", time.monotonic() - began
    )


def table_of(results):
    lines = ["| machine | tests passed | failed | skipped | left out | minutes |", "|---|---|---|---|---|---|"]
    for r in results:
        name = f"{r.machine} ({ABOUT[r.machine]})"
        if r.absent:
            lines.append(f"| {name} | absent: needs {r.absent} | | | | |")
        else:
            skipped = sum(len(names) for names in r.skipped.values())
            lines.append(
                f"| {name} | {r.passed} | {len(r.failed)} | {skipped} | {len(r.left_out)} | {r.seconds / 60:.1f} |"
            )
    for r in results:
        lines += [f"{r.machine} failed: {name}" for name in r.failed]
        lines += [f"{r.machine} skipped {', '.join(names)}: {reason}" for reason, names in r.skipped.items()]
        lines += [f"{r.machine} left out {words}" for words in r.left_out]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("machines", nargs="*", metavar="MACHINE", help=", ".join(ABOUT))
    given = parser.parse_args()
    run_named(
        parser, given.machines, ABOUT, lambda name: run(name, given.jobs), table_of, SOURCE / "out" / "machines.md"
    )


if __name__ == "__main__":
    main()
