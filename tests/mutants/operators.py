"""The changes that random.py tries at a statement: one operator, argument, constant or call is another or none."""
import collections
import re

from statements import ASSIGNMENTS, TOKEN, Code

# `code` is what the build replaces, [start, end) of the file, by `mutant` when the mutant is chosen; `what` changed, on
# which line. way: `value` (an expression), `statement` (statements, perhaps none). word: see Changes.constexpr.
Change = collections.namedtuple("Change", "kind line what start end mutant way word")

OTHERS = {"comparison": {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="},
          "bound": {"<": "<=", ">": ">=", "<=": "<", ">=": ">"},
          "sign": {"+": "-", "-": "+", "*": "/", "/": "*"},
          "&& for ||": {"&&": "||", "||": "&&"}}
NAMES = {"min": "max", "max": "min", "fmin": "fmax", "fmax": "fmin", "floor": "ceil", "ceil": "floor"}
# Whose arguments may change places.
ALIKE = {"min", "max", "fmin", "fmax", "hypot", "dot", "distance", "swap", "tie"}
NO_CALLS = {"if", "while", "for", "switch", "catch", "return", "sizeof", "decltype", "alignof", "noexcept", "throw"}
NEVER_DROPPED = {"return", "throw", "delete", "new", "co_return"}
DECLARES = re.compile(r"(?:const|static|constexpr|auto|unsigned|thread_local|inline|volatile|long|short)\b"
                      r"|[A-Za-z_][\w:]*(?:<.*>)?(?:::\w+)?(?:\s*[&*]+\s*|\s+)[A-Za-z_]\w*\s*"
                      r"(?:=(?!=)|[{;,(\[]|$)", re.S)


def is_float(number):
    return not number.startswith(("0x", "0X")) and re.search(r"[.eEfF]", number) is not None


def other_number(number):
    """Another half as large; a tolerance a thousand times as large."""
    if not is_float(number):
        return f"({number} + 1)"
    suffix = "f" if number[-1] in "fF" else ""
    if float(number.rstrip("fFlL").replace("'", "")) == 0:
        return "1.0" + suffix
    return f"({number} * {'1000.0' if re.search('[eE]-', number) else '1.5'}{suffix})"


class Changes:
    """Those of one unit."""

    def __init__(self, code, unit):
        self.code, self.unit, self.found = code, unit, []
        self.tokens = code.tokens
        text = code.span(unit.first, unit.last)
        self.declares = unit.kind in ("declaration", "constant") or unit.kind == "statement" and \
            unit.keyword not in NEVER_DROPPED and bool(DECLARES.match(text))
        self.word = self.constexpr()

    def element(self, i):
        """The tokens [first, last) of the argument, operand or right side round a token; None where there is none."""
        first, last, opening = self.unit.first, self.unit.last, None
        for j in range(i - 1, self.unit.first - 1, -1):
            if self.code.match.get(j, -1) > i:
                first, last, opening = j + 1, self.code.match[j], j
                break
        j = start = first
        within = opening is not None or self.unit.kind == "head"  # where each element is a value
        is_value = within
        while j < last:
            text = self.tokens[j].text
            if j not in self.code.quiet and (text in (",", ";") or text == ":" and opening is None
                                             and self.unit.keyword == "for"):
                if j > i:
                    break
                start, is_value = j + 1, within
            elif j < i and text in ASSIGNMENTS or j == start and text in ("return", "co_return", "throw"):
                start, is_value = j + 1, True
            j = self.code.match.get(j, j) + 1
        return (start, j) if is_value and start <= i < j else None

    def says(self, i):
        """Whether a token stands in a text, as those of refusals are, or in a type."""
        if i in self.code.quiet:
            return True
        around = [j for j in range(self.unit.first, i) if self.code.match.get(j, -1) > i]
        lists = [(j + 1, self.code.match[j]) for j in around] or [(self.unit.first, self.unit.last)]
        return any(self._has_text(*one, i) for one in lists)

    def _has_text(self, first, last, i):
        """Whether the element round a token of a list has a text with blanks, or comes after a format."""
        start = j = first
        while j < last:
            if self.tokens[j].text in (",", ";") and j not in self.code.quiet:
                if j > i or any(t.kind == "text" and "%" in t.text for t in self.tokens[start:j]):
                    break
                start = j + 1
            j = self.code.match.get(j, j) + 1
        return j < i or any(t.kind == "text" and t.text[0] == '"' and " " in t.text for t in self.tokens[start:j])

    def add(self, kind, i, what, edits):
        """edits: [(token, last token, text)] in the element round token i, or else in the whole statement."""
        if self.says(i):
            return
        element, way = self.element(i), "value"
        if element is None:
            if self.declares or self.unit.kind != "statement" or self.tokens[self.unit.first].text in NEVER_DROPPED:
                return
            element, way = (self.unit.first, self.unit.last), "statement"
        inside = all(element[0] <= first and last <= element[1] for first, last, _ in edits)
        if not inside or "\n#" in self.code.span(*element):
            return
        start, end = self.tokens[element[0]].start, self.tokens[element[1] - 1].end
        mutant, at = "", start
        for first, last, text in sorted(edits):
            mutant += self.code.text[at:self.tokens[first].start] + text
            at = self.tokens[last - 1].end
        mutant += self.code.text[at:end]
        if way == "statement":
            mutant, end = mutant + ";", self.tokens[self.unit.last].end
        self.found.append(Change(kind, self.code.line(self.tokens[i].start), what, start, end, mutant, way, self.word))

    def constexpr(self):
        """(start, end, text instead) of the word that would forbid to choose; None without it."""
        for i in range(self.unit.first, self.unit.last):
            if self.tokens[i].text == "constexpr":
                is_member = self.unit.kind == "constant" and self.tokens[i - 1].text == "static"
                return self.tokens[i].start, self.tokens[i].end, "inline const" if is_member else "const"
        return None

    def context(self, i, reach=4):
        first, last = max(self.unit.first, i - reach), min(self.unit.last, i + reach + 1)
        return " ".join(self.code.span(first, last).split())

    def one(self, kind, i, text):
        self.add(kind, i, f"{self.tokens[i].text} -> {text} in `{self.context(i)}`", [(i, i + 1, text)])

    def is_counted(self, i):
        """Whether a comparison is one of integers, where one more or less is a change."""
        near = " ".join(t.text for t in self.tokens[max(self.unit.first, i - 6):min(self.unit.last, i + 7)])
        if any(t.kind == "number" and is_float(t.text) for t in self.tokens[max(self.unit.first, i - 3):i + 4]):
            return False
        beside = "number" in (self.tokens[i - 1].kind, self.tokens[i + 1].kind)
        return self.unit.keyword == "for" or beside or re.search(r"size \(|count", near) is not None

    def of_token(self, i):
        token, text = self.tokens[i], self.tokens[i].text
        before, after = self.tokens[i - 1], self.tokens[i + 1]
        if before.text == "operator":
            return
        if token.kind == "number":
            self.one("constant", i, other_number(text))
        elif text in ("true", "false"):
            self.one("constant", i, "false" if text == "true" else "true")
        elif text in NAMES and before.text == "::" and self.tokens[i - 2].text == "std" and after.text in ("(", "<"):
            self.one("min for max", i, NAMES[text])
        elif token.kind == "op" and self.code.spaced(i) and i not in self.code.quiet:
            for kind, others in OTHERS.items():
                if text in others and (kind != "bound" or self.is_counted(i)):
                    self.one(kind, i, others[text])
            if text in "+-" and after.text in ("1", "1u"):
                self.add("bound", i, f"{text} {after.text} left out of `{self.context(i)}`", [(i, i + 2, "")])
        elif text == "-" and token.end == after.start and not (before.kind in ("word", "number") and
                                                              before.text != "return" or before.text in (")", "]")):
            self.add("sign", i, f"- left out of `{self.context(i)}`", [(i, i + 1, "")])
        if text == "(" and i > self.unit.first and self.is_call(i):
            self.swaps(i)

    def is_call(self, i):
        before = self.tokens[i - 1]
        return before.kind == "word" and before.text not in NO_CALLS | ALIKE or \
            before.text == ">" and i - 1 in self.code.quiet

    def swaps(self, i):
        arguments, start, j = [], i + 1, i + 1
        while j <= self.code.match[i]:
            if j == self.code.match[i] or self.tokens[j].text == "," and j not in self.code.quiet:
                arguments.append((start, j))
                start = j + 1
            j = self.code.match.get(j, j) + 1
        for a, b in zip(arguments, arguments[1:]):
            if a[0] == a[1] or b[0] == b[1]:
                continue
            first, second = self.code.span(*a), self.code.span(*b)
            if first != second and not any(c in first + second for c in '"{;'):
                self.add("swapped arguments", i - 1, f"`{' '.join(first.split())}` and `{' '.join(second.split())}` of "
                         f"{self.tokens[i - 1].text}", [(*a, second), (*b, first)])

    def of_statement(self):
        unit, tokens = self.unit, self.tokens
        if unit.kind != "statement" or self.declares or unit.keyword in NEVER_DROPPED or \
                "\n#" in self.code.span(unit.first, unit.last):
            return
        j, operator, several = unit.first, None, False
        while j < unit.last:
            if tokens[j].text in ASSIGNMENTS or tokens[j].text in ("++", "--"):
                operator = operator or j
            several |= tokens[j].text == ","
            j = self.code.match.get(j, j) + 1
        text = " ".join(self.code.span(unit.first, unit.last).split())
        start, end, line = tokens[unit.first].start, tokens[unit.last].end, self.code.line(tokens[unit.first].start)
        if operator is None:
            if tokens[unit.last - 1].text == ")" and tokens[unit.last].text == ";":
                self.found.append(Change("dropped call", line, f"`{text}` left out", start, end, "", "statement", None))
        elif tokens[operator].text != "=" and not several:
            self.found.append(Change("dropped +=", line, f"`{text}` left out", start, end, "", "statement", None))
            if tokens[operator].text in ("+=", "-=", "*=", "|="):
                mutant = self.code.text[start:tokens[operator].start] + "=" + self.code.text[tokens[operator].end:end]
                self.found.append(Change("dropped +=", line, f"{tokens[operator].text} -> = in `{text}`", start, end,
                                         mutant, "statement", None))


def changes_of(code, unit):
    changes = Changes(code, unit)
    i = unit.first
    while i < unit.last:
        if changes.tokens[i].text == "{" and code.is_body(i):  # a lambda, whose statements are units
            i = code.match[i]
        else:
            changes.of_token(i)
        i += 1
    changes.of_statement()
    return changes.found


def population_of(text):
    """[(unit, its changes)] of a file, in the order of the text, without units that have none."""
    code = Code(text)
    units = sorted(set(code.units()), key=lambda unit: unit.first)
    return [(unit, found) for unit in units if (found := changes_of(code, unit))]


def on_one_line(code):
    return "".join(" " if found.lastgroup == "skip" else found[0] for found in TOKEN.finditer(code))


def applied(text, numbered):
    """The text in which each (id, change) is there to be chosen; a change inside another is kept in its code. Lines
    keep their numbers."""
    def render(start, end, pieces):
        out, at = "", start
        while pieces:
            first, last, make = pieces.pop(0)
            within = [piece for piece in pieces if piece[1] <= last]
            pieces = [piece for piece in pieces if piece[0] >= last]
            out, at = out + text[at:first] + make(lambda: render(first, last, within)), last
        return out + text[at:end]

    def chosen(key, change):
        if change.way == "value":
            return lambda old: f"(::claque_mutant({key}) ? ({on_one_line(change.mutant)}) : ({old()}))"
        return lambda old: f"{{ if (::claque_mutant({key})) {{ {on_one_line(change.mutant)} }} else {{ {old()} }} }}"

    pieces = [(change.start, change.end, chosen(key, change)) for key, change in numbered]
    for start, end, instead in {change.word for _, change in numbered if change.word}:
        pieces.append((start, end, lambda old, instead=instead: instead))
    return render(0, len(text), sorted(pieces, key=lambda piece: (piece[0], -piece[1])))
