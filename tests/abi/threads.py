#!/usr/bin/env python3
"""threads.py SOURCE_DIR: every function of include/claque says on which threads it may be called, and a test does so.

threads.py --tests prints those tests as a pattern for ctest -R, threads.py --targets their programs.

It says so in its own comment ("Threads: any."), in the comment of the functions that it stands below without one, or
in the first comment of its header, which holds for all calls of the header that say nothing themselves. threads.txt
names a test for each statement; a statement there is the beginning of one in a header.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "mutants"))
from filters import faults

TOKEN = re.compile(r"/\*.*?\*/|\bCLQ_API\b[^;]*?\b(clq_\w+)\s*\([^;]*;|\}\s*\w*;", re.S)
SAYS = re.compile(r"\bThreads:\s+(.*?)(?:\s*GL:|\s*\*/|\.\s)", re.S)


def one_line(comment):
    return re.sub(r"\s*\n \*\s+", " ", comment)


def functions_of(text):
    """(function, the comment above it or above the declarations that it follows)."""
    comment = ""
    for token in TOKEN.finditer(re.sub(r"(?m)^#.*$", "", text)):
        words = token.group()
        if words.startswith("/*"):
            comment = words
        elif words.startswith("CLQ_API"):
            yield token.group(1), comment
        else:
            comment = ""


def statements_of(root):
    """{function: what it says, or None}."""
    said = {}
    for header in sorted((root / "include/claque").glob("*.h")):
        text = header.read_text()
        first = re.search(r"/\*.*?\*/", text, re.S).group()
        for name, comment in functions_of(text):
            found = SAYS.search(one_line(comment)) or SAYS.search(one_line(first))
            said[name] = found.group(1).strip(" .") if found else None
    return said


def main():
    table = [line.split(": ") for line in (HERE / "threads.txt").read_text().splitlines()
             if line and not line.startswith("#")]
    tests = [test.split() for _, test in table]
    if sys.argv[1] == "--targets":
        print(*sorted({target for target, _ in tests}))
        return 0
    if sys.argv[1] == "--tests":
        print("^(" + "|".join(sorted({re.escape(name) for _, name in tests})) + ")$")
        return 0
    root = pathlib.Path(sys.argv[1])
    said, bad, used = statements_of(root), [], set()
    for name, words in said.items():
        if words is None:
            bad.append(f"{name} says nothing of threads")
            continue
        while words.startswith("as clq_"):
            words = said.get(words[3:]) or f"as {words[3:]}, which says nothing"
        best = max((one for one, _ in table if words.startswith(one)), key=len, default=None)
        if best is None:
            bad.append(f"{name}: threads.txt names no test for '{words}'")
        used.add(best)
    bad += [f"threads.txt: no header says '{one}'" for one in dict(table) if one not in used]
    bad += faults(root, [("threads.txt", *test) for test in tests])
    print("\n".join(bad) if bad else f"{len(said)} functions say on which threads they may be called")
    return 1 if bad or len(said) < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
