#!/usr/bin/env python3
"""Runs the zone law, the guard tests and the picture tests on other implementations of GL, and ends with one table.

run.py [--build FOLDER] [--mesa FOLDER] [DRIVER...]: without names, all. In each folder of --mesa lie unpacked packages
of one other Mesa (mesa.sh). Laws are exact everywhere. Pictures may differ from the first driver's in the shares of
shares.txt. What is not installed is named in the table and counts as absent, not as passed. The exit status is 1 if a
test failed or a driver did not start.
"""
import argparse
import collections
import os
import pathlib
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
sys.path.insert(0, str(HERE.parent))

import drivers  # noqa: E402
import pictures  # noqa: E402
import services  # noqa: E402
from gtest_reports import cases_of  # noqa: E402

GROUPS = {
    "zone law": ("gl_zone_law_test", "gl_split_law_test", "gl_figure_law_test"),
    "guard": ("gl_host_state_test", "gl_stack_test", "gl_hooks_test", "gl_torture_test"),
    "pictures": ("gl_strategies_test", "gl_parts_test", "gl_shadow_test"),
}
BETWEEN_KINDS = "*WithOsmesaAndEgl"  # takes both, whatever is named

Result = collections.namedtuple("Result", "driver absent says passed failed skipped shares seconds")


def run_tests(build, group, driver, environment, folder):
    """(number of passed cases, [failed], {reason: [skipped]}) of a group."""
    reports = folder / group.replace(" ", "-")
    reports.mkdir()
    leave_out = ":".join([BETWEEN_KINDS, *(names for names, _ in driver.left_out)])
    environment = {**environment, "GTEST_OUTPUT": f"json:{reports}/", "GTEST_FILTER": f"-{leave_out}"}
    ended = []
    for test in GROUPS[group]:
        with open(reports / f"{test}.log", "w") as log:
            try:
                done = subprocess.run(
                    [str(build / "tests/gl" / test)], env=environment, stdout=log, stderr=log, timeout=1800, check=False
                )
                end = f"ended with {done.returncode}"
            except subprocess.TimeoutExpired:
                end = "did not end"
        if not (reports / f"{test}.json").exists():
            ended.append(f"{test} {end}; see {log.name}")
    passed, failed, skipped = cases_of(reports)
    return passed, failed + ended, skipped


def run_pictures(build, driver, environment, reference, folder, allowed):
    """(shares by scene, what GL says, [failed])."""
    shares, failed, says = {}, [], ""
    for scene in pictures.SCENES:
        try:
            drawn = {}
            for strategy in pictures.STRATEGIES:
                drawn[strategy], says = pictures.draw(
                    build / "samples/claque", scene, strategy, environment, folder
                )
        except (pictures.Failed, subprocess.TimeoutExpired) as error:
            failed.append(str(error))
            continue
        for strategy in pictures.STRATEGIES[1:]:
            if pictures.differing(drawn["fused"], drawn[strategy])[0] != 0:
                failed.append(f"{scene}: {strategy} differs from fused")
        first = reference.setdefault(scene, drawn["fused"])
        shares[scene] = pictures.differing(first, drawn["fused"])
        limits = allowed.get((driver.shares or driver.name, scene), (0, 0))
        if any(share > limit for share, limit in zip(shares[scene], limits)):
            failed.append(f"{scene}: {percent(shares[scene])} of the pixels differ; {percent(limits)} may")
    if says and driver.says not in says:
        failed.append(f"something else was tested: {says}")
    return shares, says, failed


def percent(shares):
    return " / ".join(f"{100 * share:.3g} %" for share in shares)


def run(driver, build, reference, allowed):
    folder = SOURCE / "out" / "drivers" / driver.name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    absent = driver.absent()
    if absent:
        return Result(driver, absent, "", {}, [], {}, {}, 0)
    began = time.monotonic()
    passed, failed, skipped, shares, says = {}, [], {}, {}, ""
    try:
        with driver.running(folder) as environment:
            environment = {**os.environ, **environment}
            shares, says, failed = run_pictures(build, driver, environment, reference, folder, allowed)
            for group in GROUPS:
                passed[group], bad, left = run_tests(build, group, driver, environment, folder)
                failed += bad
                for reason, names in left.items():
                    skipped.setdefault(reason, []).extend(names)
    except services.Failed as error:
        failed.append(str(error))
    return Result(driver, "", says, passed, failed, skipped, shares, time.monotonic() - began)


def table_of(results):
    heads = [*GROUPS, "failed", *(f"{scene} differs / over {pictures.STEPS}" for scene in pictures.SCENES), "seconds"]
    lines = ["| driver | " + " | ".join(heads) + " |", "|---" * (len(heads) + 1) + "|"]
    for r in results:
        if r.absent:
            lines.append(f"| {r.driver.name} | absent: needs {r.absent} |" + " |" * (len(heads) - 1))
            continue
        cells = [str(r.passed.get(group, 0)) for group in GROUPS] + [str(len(r.failed))]
        cells += [percent(r.shares[scene]) if scene in r.shares else "" for scene in pictures.SCENES]
        lines.append(f"| {r.driver.name} | " + " | ".join(cells) + f" | {r.seconds:.0f} |")
    for r in results:
        name = r.driver.name
        lines += [f"{name} is {r.says}"] if r.says else []
        lines += [f"{name} left out {names}: {why}" for names, why in r.driver.left_out if not r.absent]
        lines += [f"{name} skipped {', '.join(names)}: {reason}" for reason, names in r.skipped.items()]
        lines += [f"{name} failed: {failure}" for failure in r.failed]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=SOURCE / "build" / "release")
    parser.add_argument("--mesa", type=pathlib.Path, help="a folder with a folder of unpacked packages for each Mesa")
    parser.add_argument("drivers", nargs="*", metavar="DRIVER")
    given = parser.parse_args()
    known = drivers.installed() + (drivers.unpacked(given.mesa) if given.mesa else [])
    names = [driver.name for driver in known]
    for name in given.drivers:
        if name not in names:
            parser.error(f"'{name}' is none of {', '.join(names)}")
    if known[0].absent():
        sys.exit(f"run.py: pictures are compared with {known[0].name}, which needs {known[0].absent()}")
    allowed = pictures.read_shares(HERE / "shares.txt")
    reference, results = {}, []
    for driver in known:
        if given.drivers and driver.name not in given.drivers and driver is not known[0]:
            continue
        print(f"{driver.name} ...", flush=True)
        results.append(run(driver, given.build, reference, allowed))
    text = table_of(results)
    print(text)
    (SOURCE / "out" / "drivers.md").write_text(text + "\n")
    sys.exit(1 if any(r.failed for r in results) else 0)


if __name__ == "__main__":
    main()
