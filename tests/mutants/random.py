#!/usr/bin/env python3
"""Changes the code at random and measures how many of the changes a test sees.

random.py --count N [--seed S] [--area A] [--jobs N] [--json FILE] [--list]: draws N statements of lib, passes,
meshsplit and animcache, and one change of each (operators.py), by hashes of the seed alone. A build of the copy in
build/mutants has them all; the environment chooses. Each test runs once and tells which places it reaches. Then each
change is tried by the tests that reach its place, shortest first, until one fails, for five minutes at most. A test
that fails without a change counts for nothing. --area: a folder (lib/figures and samples are drawn from in no other
way), with the tests that areas.txt names for it; or `any`, one that the seed chooses. --list: shows the draw alone.

Survivors are reported with place, change and the tests that ran; they are no failure. Those that equal.txt names are
apart: they change nothing that a test could see. A run with --json that was ended goes on when it is called again.
README.md beside this file.
"""
import sys

sys.path.append(sys.path.pop(0))  # Python's own `random` comes first
sys.dont_write_bytecode = True
import argparse
import hashlib
import itertools
import json
import os
import pathlib
import re
import resource
import shlex
import subprocess
import time

import kept
from cases import cases_of
from copied_tree import BUILD, HERE, LOG, ROOT, SOURCE, TREE, build, configure, log_tail, read_tree, write_tree
from mutants import fail
from operators import applied, population_of
from workers import Workers

FOLDERS = ("animcache/", "lib/", "meshsplit/", "passes/")
APART = ("lib/figures/", "lib/python/")
LIMIT_S = 300
MEMORY = 8 << 30  # of each process: a mutant that allocates for ever ends before the machine does
INCLUDE = '#include "tests/mutants/switch.h"\n#line 1\n'


class Mutant:
    def __init__(self, file, change):
        self.file, self.change = file, change
        self.id, self.result, self.remark, self.ran = 0, "", "", []

    def without_line(self):
        return f"{self.file}  {self.change.kind}: {self.change.what}"

    def __str__(self):
        return f"{self.file}:{self.change.line}  {self.change.kind}: {self.change.what}"


def hashed(*words):
    return hashlib.sha256("/".join(map(str, words)).encode()).digest()


def areas():
    lines = (HERE / "areas.txt").read_text().splitlines()
    return {area: tests.split() for area, _, tests in (line.partition(":") for line in lines if line[:1] != "#")}


def last_commit():
    said = subprocess.run(["git", "rev-parse", "HEAD"], cwd=SOURCE, capture_output=True, text=True)
    if said.returncode != 0:
        fail("there is no commit whose hash would choose: --seed WORD does")
    return said.stdout.strip()


def equal_ones():
    """Mutants that change nothing, as lines without their numbers; a reason is indented below each."""
    return {line.strip() for line in (HERE / "equal.txt").read_text().splitlines() if line[:1] not in ("#", " ", "")}


def drawn(source, area, seed):
    """A mutant of each statement, in the order of the draw; and how many statements there are."""
    found = []
    for file in sorted(source):
        inside = file.startswith(area + "/") if area else file.startswith(FOLDERS) and not file.startswith(APART)
        if inside and file.endswith((".cpp", ".h")):
            for number, (_, changes) in enumerate(population_of(source[file].decode())):
                found.append((hashed(seed, file, number), file, changes))
    for digest, file, changes in sorted(found, key=lambda one: one[0]):
        kinds = sorted({change.kind for change in changes})
        kind = kinds[int.from_bytes(digest[:8], "big") % len(kinds)]
        changes = [change for change in changes if change.kind == kind]
        yield Mutant(file, changes[int.from_bytes(digest[8:16], "big") % len(changes)])


def compile_commands():
    """{file of the tree: how it is compiled by itself}, also of files that are compiled in batches."""
    commands = {}
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        del words[words.index("-o"):words.index("-o") + 2], words[words.index("-c"):]
        path = pathlib.Path(entry["file"])
        batch = path.read_text() if "Unity" in path.parts else f'#include "{path}"'
        for file in re.findall(r'#include "([^"]+)"', batch):
            commands.setdefault(os.path.relpath(file, TREE), words)
    return commands


def compiles(mutant, source, commands, number):
    folder = os.path.dirname(mutant.file)
    words = commands.get(mutant.file) or next(
        (commands[file] for file in sorted(commands) if file.startswith(folder + "/")), None)
    if words is None:  # a folder of headers alone
        top = mutant.file.split("/")[0]
        words = next(commands[file] for file in sorted(commands) if file.startswith(top + "/"))
    trial = TREE / folder / f"trial-{number}{pathlib.Path(mutant.file).suffix}"
    trial.write_text(INCLUDE + applied(source[mutant.file].decode(), [(1, mutant.change)]))
    try:
        return subprocess.run([*words, "-fsyntax-only", "-w", "-Werror=vla", "-x", "c++", str(trial)], cwd=BUILD,
                              capture_output=True).returncode == 0
    finally:
        trial.unlink()


def those_that_compile(order, source, count, workers):
    """The first `count` that do, with numbers; and those before the last of them that do not."""
    commands, kept, broken = compile_commands(), [], []
    while len(kept) < count:
        batch = list(itertools.islice(order, count - len(kept)))
        if not batch:
            break
        results = workers.each(lambda one, folder: compiles(one, source, commands, folder.name), batch)
        for mutant, good in zip(batch, results):
            (kept if good else broken).append(mutant)
    return kept, broken


def write_mutants(mutants, source):
    for number, mutant in enumerate(mutants, 1):
        mutant.id = number
    texts = {file: INCLUDE + applied(source[file].decode(), [(m.id, m.change) for m in mutants if m.file == file])
             for file in {mutant.file for mutant in mutants}}
    write_tree(source, texts)


def lines_of(mutant, source):
    """The lines that it changes, with that of a `constexpr` that others need."""
    text, change = source[mutant.file].decode(), mutant.change
    first = min(change.start, change.word[0]) if change.word else change.start
    return range(text.count("\n", 0, first) + 1, text.count("\n", 0, change.end) + 2)


def places_named(errors):
    """The files and lines that a compiler's errors name. A header's path may be relative to the build's folder."""
    copy = r"(?:/mutants/tree|(?<!\S)\.\./\.\.)/"
    return set(re.findall(copy + r"([^\s:.][^\s:]*):(\d+):\d+:\s+(?:error|required|note)", errors))


def built(mutants, source, targets, jobs):
    """Builds all, without those that do not compile where they are included; which are returned."""
    broken = []
    while True:
        write_mutants(mutants, source)
        if build(targets, jobs):
            return mutants, broken
        errors = LOG.read_text(errors="replace")
        named = places_named(errors)
        bad = [one for one in mutants if any((one.file, str(line)) in named for line in lines_of(one, source))] or \
            [one for one in mutants if one.file in {file for file, _ in named}]
        if not bad:
            fail(f"the copy does not build\n{log_tail(lines=30)}")
        broken += bad
        mutants = [mutant for mutant in mutants if mutant not in bad]


def baseline(cases, workers, draw):
    """The cases that pass, shortest first, with what each reaches; kept for a run that goes on with the draw."""
    if (known := kept.baseline_of(cases, draw)) is not None:
        return known

    def reach(case, folder):
        reached = folder / "reached"
        happened, case.seconds = case.run(folder, case.limit_s, reached=reached)
        case.reached = frozenset(map(int, reached.read_text().split())) if reached.exists() else frozenset()
        return happened

    results = list(zip(cases, workers.each(reach, cases)))
    for case, happened in results:
        if happened not in ("passed", "skipped"):
            print(f"without a change, {case.name} {happened}, and counts for nothing", flush=True)
    passed = [case for case, happened in results if happened == "passed"]
    passed.sort(key=lambda case: (case.seconds, case.name))
    if draw:
        kept.write_baseline(passed, draw)
    return passed


def judge(mutant, cases, equal, folder):
    """Tries the cases that reach the place of a mutant, until one fails that passes again without it."""
    if mutant.result:
        return
    left_s = LIMIT_S
    for case in (case for case in cases if mutant.id in case.reached):
        limit_s = 20 + 20 * case.seconds
        happened, seconds = case.run(folder, min(limit_s, max(left_s, 1)), mutant.id)
        left_s -= seconds
        if happened == "endless" and left_s <= 0 and seconds < limit_s:
            mutant.remark = f"five minutes were over in {case.name}; "
            break
        mutant.ran.append(case.name)
        if happened in ("failed", "crashed", "endless"):
            again, _ = case.run(folder, limit_s)
            if again == "passed":
                mutant.result, mutant.remark = happened, case.name
                return
            mutant.remark = f"{case.name} fails now and then; "
        if left_s <= 0:
            mutant.remark = "five minutes were over; "
            break
    mutant.result = "EQUAL" if mutant.without_line() in equal else "SURVIVES" if mutant.ran else "UNREACHED"


def told(mutant):
    """A line; of a survivor also the tests that ran."""
    if mutant.result == "UNREACHED":
        return f"{mutant.result:9}  {mutant}  (no test runs it)"
    if mutant.result != "SURVIVES":
        return f"{mutant.result:9}  {mutant}  ({mutant.remark})"
    some = ", ".join(mutant.ran[:6]) + (f" and {len(mutant.ran) - 6} more" if len(mutant.ran) > 6 else "")
    return f"{mutant.result:9}  {mutant}  ({mutant.remark}{len(mutant.ran)} tests ran: {some})"


def summary(seed, area, mutants, broken):
    results = [mutant.result for mutant in mutants]
    equal, unreached = results.count("EQUAL"), results.count("UNREACHED")
    judged, missed = len(mutants) - equal, unreached + results.count("SURVIVES")
    return (f"seed {seed}, {area or 'all areas'}: {len(mutants)} random mutants, {judged - missed} seen, {missed} not "
            f"({unreached} that no test runs), {equal} equal, {100 * (judged - missed) / max(judged, 1):.0f} % of the "
            f"others seen; {len(broken)} more do not compile")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", help="any word; without, the hash of the last commit")
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--area", help="a folder, or `any`")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--json", type=pathlib.Path,
                        help="writes all of it into this file, and goes on with the draw that is there")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    options.seed = options.seed or last_commit()
    began, known = time.monotonic(), areas()
    area = options.area and options.area.rstrip("/")
    if area == "any":
        area = min(known, key=lambda name: hashed(options.seed, name))
    tests = next((known[name] for name in known if area and f"{area}/".startswith(name + "/")), None)

    def step(text):
        print(f"{time.monotonic() - began:.0f} s: {text}", flush=True)

    source = read_tree()
    order = drawn(source, area, options.seed)
    if options.list:
        print("\n".join(map(str, itertools.islice(order, options.count))))
        return
    files = hashed(*(f"{file} {hashlib.sha256(source[file]).hexdigest()}" for file in sorted(source))).hex()
    draw = dict(seed=options.seed, area=area, count=options.count, files=files)
    if options.json and options.json.exists():
        kept.take_report(options.json, draw, [])  # refuses one of another draw at once
    ROOT.mkdir(parents=True, exist_ok=True)
    write_tree(source, {})
    configure()
    workers = Workers(options.jobs)
    mutants, broken = those_that_compile(order, source, options.count, workers)
    if not mutants:
        fail(f"no statement of {area} can be changed")
    step(f"{len(mutants)} mutants compile by themselves, {len(broken)} before the last of them do not")
    targets = [f"tests/{folder}/all" for folder in tests] if tests else ["all"]
    mutants, more = built(mutants, source, targets, options.jobs)
    broken += more
    step("built")
    folders = tuple(f"tests/{folder}/" for folder in tests or [""])
    cases = [case for case in cases_of(BUILD) if not tests or f"{case.folder}/".startswith(folders)]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    passed = baseline(cases, workers, options.json and dict(draw, mutants=list(map(str, mutants))))
    step(f"{len(passed)} of {len(cases)} tests pass without a change")
    equal = equal_ones()
    if options.json and options.json.exists():
        step(f"{kept.take_report(options.json, draw, mutants)} were judged before")
    for mutant, _ in zip(mutants, workers.each(lambda one, folder: judge(one, passed, equal, folder), mutants)):
        print(told(mutant), flush=True)
        if options.json:
            kept.write_report(options.json, draw, mutants, broken)
    step(summary(options.seed, area, mutants, broken))


if __name__ == "__main__":
    main()
