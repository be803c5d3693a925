"""The statements of a C++ file that clang-format laid out: where each begins and ends, without a compiler.

The layout says what a token means: `a < b` compares, `a<b>` is a template, `a * b` multiplies, `a *b` declares.
"""
import bisect
import collections
import re

TOKEN = re.compile(r"""(?P<skip>^[ \t]*\#(?:\\\n|[^\n])*|\s+|//[^\n]*|/\*.*?\*/)"""
                   r"""|(?P<text>(?:u8|[uUL])?(?:R"(?P<d>[^(]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*")|'(?:\\.|[^'\\])+')"""
                   r"""|(?P<number>\.?\d(?:[eEpP][+-]|'?[\w.])*)|(?P<word>[A-Za-z_]\w*)"""
                   r"""|(?P<op><<=|>>=|->|::|\+\+|--|[-+*/%&|^=!<>]=|&&|\|\||<<|>>|\.\.\.|.)""", re.S | re.M)
Token = collections.namedtuple("Token", "text kind start end")
# `first` and `last` are tokens, and `last` is none of it; kind: head (of an `if`), statement, declaration, constant.
Unit = collections.namedtuple("Unit", "kind keyword first last")

HEADS = {"if", "while", "for", "switch", "catch"}
PASSED_OVER = {"using", "typedef", "static_assert", "friend", "extern", "goto", "break", "continue", "asm"}
AFTER_PARAMETERS = {")", "const", "noexcept", "override", "final", "mutable"}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}


class Code:
    """Tokens of a text, which bracket closes which, and which tokens are arguments of templates."""

    def __init__(self, text):
        self.text = text
        self.tokens = [Token(m[0], m.lastgroup if m.lastgroup != "d" else "text", m.start(), m.end())
                       for m in TOKEN.finditer(text) if m.lastgroup != "skip"]
        self.tokens.append(Token("", "end", len(text), len(text)))
        self.match, self.quiet = {}, set()
        self.lines = [m.start() for m in re.finditer("\n", text)]
        opened = []
        for i, token in enumerate(self.tokens):
            if token.kind == "op" and token.text in "([{":
                opened.append(i)
            elif token.kind == "op" and token.text in ")]}" and opened:
                self.match[opened.pop()] = i
        for i in range(len(self.tokens)):
            if i not in self.quiet and self.tokens[i].text == "<" and self._opens_template(i):
                self._quieten(i)

    def _opens_template(self, i):
        before = self.tokens[i - 1]
        return before.text == "template" or before.kind == "word" and before.text != "operator" and \
            before.end == self.tokens[i].start

    def _quieten(self, i):
        depth, j = 0, i
        while j < len(self.tokens) and self.tokens[j].text not in (";", "{"):
            text = self.tokens[j].text
            depth += {"<": 1, ">": -1, ">>": -2}.get(text, 0)
            if depth <= 0:
                self.quiet.update(range(i, j + 1))
                return
            j = self.match.get(j, j) + 1

    def line(self, position):
        return bisect.bisect_left(self.lines, position) + 1

    def span(self, first, last):
        """The text from one token to before another."""
        return self.text[self.tokens[first].start:self.tokens[last - 1].end]

    def spaced(self, i):
        """Whether white space is on both sides of a token, as round a binary operator."""
        token = self.tokens[i]
        return self.text[token.start - 1].isspace() and self.text[token.end:token.end + 1].isspace()

    def is_body(self, i):
        """Whether the brace of an expression begins the body of a lambda."""
        before = self.tokens[i - 1].text
        if before in (")", "]", "mutable", "noexcept"):
            return True
        j = i - 1
        while self.tokens[j].kind == "word" or self.tokens[j].text in ("::", "*", "&") or j in self.quiet:
            j -= 1
        return self.tokens[j].text == "->" and self.tokens[j - 1].text in (")", "mutable")

    def units(self):
        found = []
        self._declarations(0, len(self.tokens) - 1, found)
        return found

    def _end_of(self, i, end, found, stops=(";",)):
        """The first stop outside brackets; the bodies of lambdas on the way are searched."""
        while i < end and not (self.tokens[i].text in stops and self.tokens[i].kind == "op"):
            if i in self.match:
                self._inside(i, found)
                i = self.match[i]
            i += 1
        return i

    def _inside(self, opening, found):
        if self.tokens[opening].text == "{" and self.is_body(opening):
            self._statements(opening + 1, self.match[opening], found)
            return
        i = opening + 1
        while i < self.match[opening]:
            if i in self.match:
                self._inside(i, found)
                i = self.match[i]
            i += 1

    def _declarations(self, i, end, found):
        """Those of a file, a namespace or a class."""
        tokens = self.tokens
        while i < end:
            text = tokens[i].text
            if text == "template" and i + 1 in self.quiet:
                i += 1
                while i in self.quiet:
                    i += 1
            elif text in ("public", "private", "protected") or text in ";}":
                i += 2 if tokens[i + 1].text == ":" else 1
            elif text in PASSED_OVER and not (text == "extern" and tokens[i + 1].kind == "text"):
                i = self._end_of(i, end, []) + 1
            elif text in ("namespace", "struct", "class", "union", "enum", "extern"):
                i = self._type(i, end, found, self._declarations)
            else:
                i = self._declaration(i, end, found)

    def _type(self, i, end, found, otherwise):
        """A namespace or type whose members are declarations; or a declaration that begins with such a word."""
        j = i
        while j < end and self.tokens[j].text not in (";", "{", "(", "=") or j in self.quiet:
            j += 1
        if self.tokens[j].text == "{":
            if self.tokens[i].text != "enum":
                self._declarations(j + 1, self.match[j], found)
            j = self.match[j]
            return j + 1 if self.tokens[i].text in ("namespace", "extern") else self._end_of(j + 1, end, []) + 1
        if self.tokens[j].text == ";":
            return j + 1
        return self._declaration(i, end, found) if otherwise == self._declarations else self._simple(i, end, found)

    def _declaration(self, i, end, found):
        """A function with its body, or anything up to a semicolon."""
        tokens, j, initialisers = self.tokens, i, False
        while j < end and tokens[j].text != ";":
            if tokens[j].text == ":" and tokens[j - 1].text in AFTER_PARAMETERS:
                initialisers = True
            if tokens[j].text == "{":
                before = tokens[j - 1].text
                after = tokens[self.match[j] + 1].text
                if before in AFTER_PARAMETERS or before == "}" or self.is_body(j) and not initialisers \
                        or initialisers and after not in (",", "{"):
                    if initialisers:
                        found.append(Unit("declaration", "", i, j))
                    self._statements(j + 1, self.match[j], found)
                    return self.match[j] + 1
            if j in self.match:
                self._inside(j, found)
                j = self.match[j]
            j += 1
        if any(token.text == "=" for token in tokens[i:j]) or any(token.text == "{" for token in tokens[i:j]):
            found.append(Unit("constant", "", i, j))
        return j + 1

    def _statements(self, i, end, found):
        tokens = self.tokens
        while i < end:
            text = tokens[i].text
            if text == "{":
                self._statements(i + 1, self.match[i], found)
                i = self.match[i] + 1
            elif text in (";", "else", "do", "try"):
                i += 1
            elif text in HEADS and tokens[i + 1].text == "(":
                self._inside(i + 1, found)
                found.append(Unit("head", text, i + 2, self.match[i + 1]))
                i = self.match[i + 1] + 1
            elif text == "if":  # constexpr
                i = self.match[i + 2] + 1
            elif text in ("case", "default"):
                i = self._end_of(i, end, [], (":",)) + 1
            elif text in PASSED_OVER:
                i = self._end_of(i, end, []) + 1
            elif text in ("struct", "class", "union", "enum"):
                i = self._type(i, end, found, self._statements)
            else:
                i = self._simple(i, end, found)

    def _simple(self, i, end, found):
        j = self._end_of(i, end, found)
        if j > i:
            found.append(Unit("statement", self.tokens[i].text, i, j))
        return j + 1
