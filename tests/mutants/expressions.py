"""Whether a piece of C++ is a whole part of the code round it: parentheses or braces round it change nothing."""
import re

PRECEDENCE = {op: level for level, ops in enumerate((
    (",",),
    ("=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "?", ":"),
    ("||",), ("&&",), ("|",), ("^",), ("&",),
    ("==", "!="), ("<", ">", "<=", ">="), ("<<", ">>"), ("+", "-"), ("*", "/", "%"))) for op in ops}
UNARY, POSTFIX = 20, 30
# Operators of which `a op (b op c)` is `(a op b) op c`.
GROUPS_ALIKE = ("&&", "||", "|", "&", "^")
TOKEN = re.compile(r"""\s+|//[^\n]*|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])+'|[A-Za-z_]\w*|\.?\d(?:[eEpP][+-]|[\w.'])*"""
                   r"""|<<=|>>=|->|::|\+\+|--|[-+*/%&|^=!<>]=|&&|\|\||<<|>>|.""", re.S)
ARGUMENTS = re.compile(r"(?<=\w)<[\w:,*&\s]*(?:<[\w:,*&\s]*>[\w:,*&\s]*)*>(?=\s*[({:]|\s+\w+[({;=]|>)")
CLOSES = set(")]")
WORDS_BEFORE_OPERANDS = {"return", "case", "else", "throw", "co_return"}
WORDS_OF_STATEMENTS = {"if", "else", "for", "while", "do", "switch", "case", "return", "break", "continue", "try",
                       "catch", "goto"}
WORDS_OF_DECLARATIONS = {"const", "static", "constexpr", "auto", "unsigned", "struct", "class", "enum", "using",
                         "thread_local", "inline", "namespace", "template"}
TYPE_AND_NAME = re.compile(r"(?!return\b|delete\b|throw\b|new\b|goto\b)[A-Za-z_][\w:]*(?:<[^;=()]*>)?(?:\s*[&*]+|\s)\s*"
                           r"[A-Za-z_]\w*\s*(?:=(?!=)|\{|;|\(|\[)")
AHEAD_OF_STATEMENTS = {"{", "}", ";", ")", ":", "else", "do"}


def tokens_of(text):
    text = ARGUMENTS.sub(lambda found: " " * len(found[0]), text)  # of templates
    return [t for t in TOKEN.findall(text) if not t.isspace() and not t.startswith("//")]


def is_operand(token):
    return token in CLOSES or token not in WORDS_BEFORE_OPERANDS and bool(re.match(r"[\w\"'.]", token[-1]))


def binds(token, before):
    """The precedence of an operator after a token, or nothing."""
    if token in (".", "->", "::", "["):
        return POSTFIX
    if token in ("!", "~", "++", "--") or token in "+-*&" and not (before and is_operand(before)):
        return UNARY
    return PRECEDENCE.get(token)


def loosest(tokens):
    """The operator outside parentheses that binds the least, and its precedence."""
    depth, before, found = 0, "", ("", POSTFIX)
    for token in tokens:
        if token in "([{":
            depth += 1
        elif token in ")]}":
            depth -= 1
        elif depth == 0:
            level = binds(token, before)
            if level is not None and level < found[1]:
                found = (token, level)
        before = token
    return found


def is_statement(code):
    return code.rstrip()[-1] in ";}"


def is_whole(text, start, end):
    return (is_whole_statement if is_statement(text[start:end]) else is_whole_expression)(text, start, end)


def is_whole_statement(text, start, end):
    """A statement that begins where one may, is no part of an `if` with an `else`, and declares nothing."""
    code = text[start:end]
    first = tokens_of(code)[0]
    if first == "else" or first == "if" and tokens_of(text[end:end + 80])[:1] == ["else"]:
        return False
    if first in WORDS_OF_DECLARATIONS or TYPE_AND_NAME.match(code):
        return False
    ahead = tokens_of(re.sub(r"(?m)^#.*$", "", text[max(0, start - 400):start]))
    return not ahead or ahead[-1] in AHEAD_OF_STATEMENTS


def is_whole_expression(text, start, end):
    if tokens_of(text[start:end])[0] in WORDS_OF_STATEMENTS | WORDS_OF_DECLARATIONS:
        return False
    operator, level = loosest(tokens_of(text[start:end]))
    if operator == ",":  # parentheses would make one argument of several
        return False
    begin = max(text.rfind(";", 0, start), text.rfind("}", 0, start)) + 1
    ahead, behind = tokens_of(text[begin:start]), tokens_of(text[end:end + 80])
    if ahead:
        before = binds(ahead[-1], ahead[-2] if len(ahead) > 1 else "")
        if before is not None and ahead[-1] not in ("?", ":", "=", "[", ","):
            if before > level or before == level and not (ahead[-1] == operator and operator in GROUPS_ALIKE):
                return False
    if behind:
        after = POSTFIX if behind[0] == "(" else binds(behind[0], ")")
        if after is not None and after > level:
            return False
    return True
