#!/usr/bin/env python3
"""filters.py SOURCE_DIR [TARGET FILTER]: holds the filters of mutants against the tests of their targets.

Each part of a filter (between colons) has to match a test in the folder of its target; a part that matches none would
let its mutant be seen by the others, or by nothing. TARGET FILTER: one more filter, for the test of this program.
"""
import functools
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from mutants import read_mutants

TEST = re.compile(r"^(TYPED_)?TEST(_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.M)
INSTANCE = re.compile(r"^INSTANTIATE_TEST_SUITE_P\(\s*(\w+)\s*,\s*(\w+)", re.M)


@functools.lru_cache(maxsize=None)
def meet(a, b):
    """Whether some text matches both patterns, of which * is any text and ? any letter."""
    if not a and not b:
        return True
    if a[:1] == "*" and (meet(a[1:], b) or (b and meet(a, b[1:]))):
        return True
    if b[:1] == "*" and (meet(a, b[1:]) or (a and meet(a[1:], b))):
        return True
    if not a or not b or "*" in (a[0], b[0]):
        return False
    return (a[0] == b[0] or "?" in (a[0], b[0])) and meet(a[1:], b[1:])


def tests_of(folder):
    """The tests in a folder's sources as GoogleTest names them, with * for the names of parameters."""
    text = "\n".join(path.read_text(errors="replace") for path in sorted(folder.rglob("*.cpp")))
    prefixes = {}
    for prefix, suite in INSTANCE.findall(text):
        prefixes.setdefault(suite, []).append(prefix)
    names = set()
    for typed, kind, suite, name in TEST.findall(text):
        if typed:
            names.add(f"{suite}/*.{name}")
        elif kind == "_P":
            names.update(f"{prefix}/{suite}.{name}/*" for prefix in prefixes.get(suite, []))
        else:
            names.add(f"{suite}.{name}")
    return names


def targets_in(tests):
    """{target: folders}: several folders may use one name on different machines."""
    found = {}
    for lists in tests.rglob("CMakeLists.txt"):
        for target in re.findall(r"(?:claque_test|add_executable)\(\s*(\w+)", lists.read_text()):
            found.setdefault(target, []).append(lists.parent)
    return found


def faults(root, filters):
    targets, tests = targets_in(root / "tests"), {}
    for where, target, pattern in filters:
        if target not in targets:
            yield f"{where}: no CMakeLists.txt of tests has the target {target}"
            continue
        names = set()
        for folder in targets[target]:
            names |= tests.setdefault(folder, None) or tests_of(folder)
        for part in pattern.split("-")[0].split(":"):
            if not any(meet(part, name) for name in names):
                yield f"{where}: no test of {target} matches {part}"


def main():
    root = pathlib.Path(sys.argv[1])
    filters = [(mutant.where, target, pattern) for path in sorted((root / "tests/mutants").glob("*.mutants"))
               for mutant in read_mutants(path) for target, pattern, _ in mutant.tests]
    if len(sys.argv) == 4:
        filters.append(("the command line", *sys.argv[2:]))
    bad = list(faults(root, filters))
    print("\n".join(bad) if bad else f"{len(filters)} filters, each part of which matches a test")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
