"""Files of mutants, and what a build of several of them holds."""
import re
import sys
import zlib

from expressions import is_statement, is_whole


class Mutant:
    def __init__(self, name, where):
        self.name, self.where = name, where
        self.edits = []  # (file, lines to find, lines to put)
        self.tests = []  # (target, filter, environment)
        self.alone = False
        self.id = zlib.crc32(name.encode()) & 0x7FFFFFFF


def fail(text):
    sys.exit(f"tests/mutants: {text}")


def read_mutants(path):
    """One law: [name], then lines `test TARGET FILTER [VARIABLE=VALUE...]`, `file PATH`, `-` (find) and `+` (put)."""
    mutants, file = [], None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        where = f"{path.name}:{number}"
        word, _, rest = line.partition(" ")
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            mutants.append(Mutant(f"{path.stem}/{line.strip('[] ')}", where))
            file = None
        elif not mutants:
            fail(f"{where}: a line before the first [name]")
        elif word == "file":
            file = rest.strip()
        elif word == "alone":
            mutants[-1].alone = True
        elif word == "test":
            target, pattern, *environment = rest.split()
            mutants[-1].tests.append((target, pattern, tuple(environment)))
        elif word in "-+" and file:
            edits = mutants[-1].edits
            if word == "-" and (not edits or edits[-1][2] or edits[-1][0] != file):
                edits.append((file, [], []))
            if not edits:
                fail(f"{where}: a line to put without one to find")
            edits[-1][1 if word == "-" else 2].append(rest)
        else:
            fail(f"{where}: neither file, test, alone, nor - or + after a file: {line}")
    for mutant in mutants:
        if not mutant.tests or not mutant.edits or not all(put for _, _, put in mutant.edits):
            fail(f"{mutant.where}: {mutant.name} lacks a test, a line to find or a line to put")
    return mutants


def place_edits(mutant, source):
    """[(file, start, end, text)] of a mutant, or a sentence why it does not apply. All white space is equal."""
    places = []
    for file, find, put in mutant.edits:
        if file not in source:
            return None, f"there is no {file}"
        words = " ".join(find).split()
        found = list(re.finditer(r"\s+".join(map(re.escape, words)), source[file].decode()))
        if len(found) != 1:
            return None, f"{file} has its lines {len(found)} times"
        if words == " ".join(put).split():
            return None, "it changes nothing"
        text, start, end = source[file].decode(), found[0].start(), found[0].end()
        if not mutant.alone and not is_whole(text, start, end):
            return None, f"{' '.join(words)} is neither a whole expression nor a whole statement of {file}"
        places.append((file, start, end, "\n".join(put)))
    return places, ""


def share_build(places, others):
    """Whether no place of one overlaps a place of the other in part."""
    return all(a[0] != b[0] or a[2] <= b[1] or b[2] <= a[1] or a[1:3] == b[1:3] for a in places for b in others)


def grouped(placed):
    """Lists of mutants with their places that can share a build; `alone` ones by themselves."""
    groups, single = [], []
    for mutant, places in placed:
        if mutant.alone:
            single.append([(mutant, places)])
            continue
        group = next((g for g in groups if all(share_build(places, others) for _, others in g)), None)
        if group is None:
            groups.append(group := [])
        group.append((mutant, places))
    return groups + single


def switched(old, choices):
    """Code that is `old` unless one of the (id, text) is chosen: an expression, or statements without declarations."""
    if is_statement(old):
        mutated = " else ".join(f"if (::claque_mutant({key})) {{ {text}\n}}" for key, text in choices)
        return f"{{ {mutated} else {{ {old} }} }}"
    return "(" + "".join(f"::claque_mutant({key}) ? ({text}) : " for key, text in choices) + f"({old}))"


def texts_of(group, source):
    """The files that a build of these mutants changes."""
    places = {}
    for mutant, edits in group:
        for file, start, end, text in edits:
            places.setdefault(file, {}).setdefault((start, end), []).append((mutant.id, text))
    texts = {}
    for file, spans in places.items():
        text = source[file].decode()
        for (start, end), choices in sorted(spans.items(), reverse=True):
            new = choices[0][1] if group[0][0].alone else switched(text[start:end], choices)
            text = text[:start] + new + text[end:]
        texts[file] = text if group[0][0].alone else f'#include "tests/mutants/switch.h"\n{text}'
    return texts
