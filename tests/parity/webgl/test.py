#!/usr/bin/env python3
"""Holds a WebGL renderer, written from docs/parity.md, against claque, and ends with one table.

test.py CLAQUE BUILD OUT [NAME...]: the claque command, a folder for three.js and the scenes, and one for the reports
and the table. Without names, all cases. What this machine lacks is named, and all is skipped. The exit status is 1 if a
case failed.
"""
import argparse
import collections
import json
import pathlib
import shutil
import subprocess
import sys
import time

import cases

HERE = pathlib.Path(__file__).resolve().parent
ASSETS = HERE.parents[3] / "shared" / "assets"
# Packages, and the programs of which one is enough.
TOOLS = {"chromium": ("/usr/lib/chromium/chromium", "/usr/bin/chromium"), "nodejs": ("node",), "npm": ("npm",)}

Row = collections.namedtuple("Row", "case people verdict measures wrong seconds")


def said_by(*command):
    """(exit status, what it printed) of a command that may fail."""
    done = subprocess.run([str(c) for c in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout.strip()


def has_to(*command):
    status, text = said_by(*command)
    if status != 0:
        raise RuntimeError(f"{pathlib.Path(command[0]).name} ended with {status}: {text}")
    return text


def install_three(build):
    """three.js in the version of package.json, in the build folder; without lock files, scripts and questions."""
    build.mkdir(parents=True, exist_ok=True)
    wanted = json.loads((HERE / "package.json").read_text())["dependencies"]["three"]
    there = build / "node_modules" / "three"
    if there.is_dir() and json.loads((there / "package.json").read_text())["version"] == wanted:
        return there
    shutil.copy(HERE / "package.json", build)
    options = ["--ignore-scripts", "--no-package-lock", "--no-audit", "--no-fund", "--loglevel=error"]
    has_to("npm", "install", "--prefix", build, *options)
    return there


class Bench:
    """Exports and captures each scene once, however many cases draw it."""

    def __init__(self, claque, build, out):
        self.claque, self.build, self.out, self.known = claque, build, out, set()
        self.three = install_three(build)

    def scene(self, case):
        scene, reference = self.build / f"{case.scene}-scene", self.build / f"{case.scene}-reference"
        if case.scene not in self.known:
            what = [ASSETS / case.what if "." in case.what else case.what, *case.options]
            has_to(self.claque, "parity", "export", *what, "--out", scene)
            has_to(self.claque, "parity", "capture", *what, "--out", reference)
            self.known.add(case.scene)
        return scene, reference

    def draw(self, case):
        """(exit status, text, folder of the result)"""
        scene, _ = self.scene(case)
        result = self.build / f"{case.name}-result"
        shutil.rmtree(result, ignore_errors=True)
        more = ["--break", case.mistake] if case.mistake else []
        status, text = said_by("node", HERE / "render.mjs", scene, result, "--three", self.three,
                               "--driver", case.driver, "--times", case.times, *more)
        return status, text, result

    def compare(self, case, result):
        """(verdict, measures by name)"""
        _, reference = self.scene(case)
        report = self.out / f"{case.name}.json"
        report.unlink(missing_ok=True)
        status, text = said_by(self.claque, "parity", "compare", reference, result, "--tolerance", case.tolerance,
                               "--json", report, "--html", self.out / f"{case.name}.html")
        if status > 1 or not report.is_file():
            raise RuntimeError(text)
        read = json.loads(report.read_text())
        return read["verdict"], read["measures"]

    def run(self, case):
        began, people, verdict, measures = time.monotonic(), 0, "", {}
        try:
            status, text, result = self.draw(case)
            if status != 0:
                wrong = case.wrong_without_result(text)
            else:
                json_of_result = json.loads((result / "capture.json").read_text())
                people = json_of_result["actors"]
                verdict, measures = self.compare(case, result)
                wrong = case.wrong_in(verdict, measures, json_of_result["renderer"])
        except RuntimeError as error:
            wrong = str(error)
        return Row(case, people, verdict, measures, wrong, time.monotonic() - began)

    def look_at_report(self, case):
        """What is wrong with the page of a comparison in a wide or a narrow window. Spoiled pages must be refused."""
        page = self.out / f"{case.name}.html"
        status, text = said_by("node", HERE / "report.mjs", page, self.out)
        faults = [text] if status else []
        for fault, (good, bad) in cases.SPOILED.items():
            spoiled = self.build / "spoiled.html"
            spoiled.write_text(page.read_text().replace(good, bad, 1))
            status, text = said_by("node", HERE / "report.mjs", spoiled, self.build)
            if status == 0 or fault not in text:
                faults.append(f"a spoiled page passes, where {fault!r}: {text}")
        return "\n".join(faults)


def table_of(rows):
    lines = ["| case | driver | people | ids differ | pixels over 2 LSB | has to | does | seconds |",
             "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        number = lambda name: f"{r.measures[name]['value']:.2g}" if name in r.measures else ""
        lines.append(f"| {r.case.name} | {r.case.driver}{f', {r.case.times} times' if r.case.times > 1 else ''} "
                     f"| {r.people or ''} | {number('actor_ids.different')} | {number('colour.over_2')} "
                     f"| {r.case.wanted} | {'no' if r.wrong else 'yes'} | {r.seconds:.1f} |")
    lines += [f"{r.case.name}: {r.wrong}" for r in rows if r.wrong]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("claque", "build", "out"):
        parser.add_argument(name, type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(case.name for case in cases.ALL))
    given = parser.parse_args()
    unknown = set(given.names) - {case.name for case in cases.ALL}
    if unknown:
        parser.error(f"no case {', '.join(sorted(unknown))}")
    absent = [package for package, programs in TOOLS.items() if not any(map(shutil.which, programs))]
    if absent:
        print(f"skipped: test-webgl needs {' '.join(absent)} (apt-get install {' '.join(absent)})")
        return 0
    given.out.mkdir(parents=True, exist_ok=True)
    bench = Bench(given.claque, given.build, given.out)
    rows, faults = [], 0
    for case in cases.ALL:
        if given.names and case.name not in given.names:
            continue
        print(f"{case.name} ...", flush=True)
        if "." in case.what and not (ASSETS / case.what).is_file():
            print(f"skipped: {ASSETS / case.what} is not here")
            continue
        rows.append(bench.run(case))
        if case.report and not rows[-1].wrong:
            text = bench.look_at_report(case)
            faults += bool(text)
            print(text or f"the report of {case.name} reads at 1024 and at 390 pixels", flush=True)
    text = table_of(rows)
    print(text)
    (given.out / "table.md").write_text(text + "\n")
    return 1 if faults or any(r.wrong for r in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
