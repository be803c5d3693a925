#!/usr/bin/env python3
"""places.py SOURCE_DIR [FILE CODE]: holds the places of mutants against the code.

Each has to be there once, and to be a whole expression or whole statements: a mutant shares its build with others, so
that its place gets parentheses, and those must change nothing. FILE CODE: one more place.
"""
import pathlib
import sys

sys.dont_write_bytecode = True
from mutants import Mutant, place_edits, read_mutants


class Tree(dict):
    """The files below a folder, each read when it is asked for."""

    def __init__(self, root):
        super().__init__()
        self.root = root

    def __contains__(self, name):
        return (self.root / name).is_file()

    def __missing__(self, name):
        self[name] = (self.root / name).read_bytes()
        return self[name]


def main():
    root = pathlib.Path(sys.argv[1])
    mutants = [mutant for path in sorted((root / "tests/mutants").glob("*.mutants")) for mutant in read_mutants(path)]
    if len(sys.argv) == 4:
        asked = Mutant("asked/for", "the command line")
        asked.edits.append((sys.argv[2], [sys.argv[3]], ["0"]))
        mutants.append(asked)
    source = Tree(root)
    reasons = [(mutant.where, place_edits(mutant, source)[1]) for mutant in mutants]
    bad = [f"{where}: {why}" for where, why in reasons if why]
    print("\n".join(bad) if bad else f"{len(mutants)} mutants, each of which has its places")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
