#!/usr/bin/env python3
"""docs.py SOURCE_DIR [CLAQUE]: holds the pages and the comments against the tree.

Pages (*.md): the first line says what the page is for; every path, link and make target exists; every clq_ and CLQ_
name is declared in include/claque, every other name in code type occurs in the sources; README.md has at most 10 kB.
Every `claque SUBCOMMAND --option` is one that the command CLAQUE lists in its help; without CLAQUE, one that
samples/cli has. Refusals: so is every option in brackets. Comments of sources: every file that they name exists. Header
comments: every clq_ name is declared.
"""
import pathlib
import re
import subprocess
import sys

ENDINGS = ("h", "cpp", "c", "py", "sh", "toml", "in", "md", "png", "svg", "txt", "awk")
GENERATED = ("build/", "out/")
TOP = ("animcache", "build", "cmake", "docs", "include", "lib", "meshsplit", "out", "passes", "samples", "tests")
NAME = re.compile(r"\b(?:clq_[a-z0-9_]+|CLQ_[A-Z0-9_]+)\b")


class Tree:
    """What pages and comments are compared with."""

    def __init__(self, root, claque):
        self.root, self.claque = root, claque
        listed = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True).stdout.split("\n")
        if not any(listed):  # a source archive
            found = [str(p.relative_to(root)) for p in root.rglob("*")]
            listed = [f for f in found if not f.startswith((*GENERATED, ".git/"))]
        self.files = [f for f in listed if f and (root / f).is_file()]
        self.folders = {str(p) for f in self.files for p in pathlib.PurePosixPath(f).parents}
        self.base_names = {f.rsplit("/", 1)[-1] for f in self.files}
        self.stems = {n.rsplit(".", 1)[0] for n in self.base_names}
        self.pages = {f: self.text(f) for f in self.files if f.endswith(".md") and not f.startswith("tests/")}
        kinds = re.compile(r"\.(h|cpp|c|py|sh|in|toml|awk|txt|json|abi)$|Makefile$|Doxyfile$")
        sources = [f for f in self.files if kinds.search(f) and not f.startswith("tests/abi/v1/")]
        self.sources = {f: self.text(f) for f in sources if f != "tests/abi/docs.py"}
        code = "\n".join(
            re.sub(r"/\*.*?\*/|//[^\n]*", " ", t, flags=re.S) if re.search(r"\.(h|cpp|c)$", f) else t
            for f, t in self.sources.items()
        )
        self.words = set(re.findall(r"[A-Za-z_][A-Za-z0-9_]*", code))
        headers = {f: t for f, t in self.sources.items() if f.startswith("include/claque/")}
        code = re.sub(r"/\*.*?\*/", " ", "\n".join(headers.values()), flags=re.S)
        self.declared = set(NAME.findall(code)) | {n + "_init" for n in re.findall(r"_INIT\((clq_[a-z0-9_]+)\)", code)}
        structs = re.findall(r"typedef (?:struct|enum) clq_[a-z0-9_]+ \{(.*?)\n?\} (clq_[a-z0-9_]+);", code, re.S)
        self.members = {name: set(re.findall(r"[A-Za-z_][A-Za-z0-9_]*", body)) for body, name in structs}
        self.targets = set(re.search(r"^\.PHONY:((?:.*\\\n)*.*)$", self.text("Makefile"), re.M).group(1).split())
        self.help = {}

    def text(self, path):
        return (self.root / path).read_text(errors="replace")

    def exists(self, path):
        path = path.rstrip("/")
        return path.startswith(GENERATED) or path in ("build", "out") or path in self.files or path in self.folders

    def options(self, words):
        """The options of `claque WORDS`, or None where there is no such subcommand."""
        key = " ".join(words)
        if key not in self.help:
            if self.claque:
                said = subprocess.run([self.claque, *words, "--help"], capture_output=True, text=True)
                text = said.stdout if " ".join(["Usage: claque", *words]) + " " in said.stdout else ""
                own = re.sub(r"^Subcommands:.*", "", text, flags=re.S | re.M)
                self.help[key] = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", own)) if text else None
            else:
                cli = "\n".join(t for f, t in self.sources.items() if f.startswith("samples/cli/"))
                names = ",".join(["--help", *re.findall(r'"([A-Za-z-]*,?-[a-z,-]+)"', cli)])
                self.help[key] = set(names.split(",")) if all(f'"{w}"' in cli for w in words) else None
        return self.help[key]


def command_faults(tree, text):
    """What is wrong with the commands of claque and make in a piece of code."""
    for line in re.sub(r"\\\n", " ", text).split("\n"):
        for part in re.split(r"\||&&|;", line):
            words = re.sub(r"^(?:[A-Za-z_]+=\S*\s+)+", "", part.strip()).split()
            if words[:1] == ["make"]:
                for word in words[1:]:
                    if re.fullmatch(r"[a-z][a-z0-9-]*", word) and word not in tree.targets:
                        yield f"make has no target {word}"
                    if not re.fullmatch(r"[a-z][a-z0-9-]*", word) and "=" not in word:
                        break
            if not words or words[0].rsplit("/", 1)[-1] != "claque" or len(words) < 2:
                continue
            if words[1].startswith("-"):
                sub, rest = [], words[1:]
            elif re.fullmatch(r"[a-z]+", words[1]):
                words_of = ("colours", "frames", "parity")
                nested = tree.options(words[1:2]) is not None and len(words) > 2 and words[1] in words_of
                sub, rest = words[1:3] if nested else words[1:2], words[2:]
            else:
                continue
            options = tree.options(sub)
            if options is None:
                yield f"no subcommand 'claque {' '.join(sub)}'"
                continue
            for word in rest:
                option = re.match(r"\[?(--?[a-z][a-z-]*)", word)
                if option and option.group(1) not in options:
                    yield f"'claque {' '.join(sub)}' has no option {option.group(1)}"


def span_faults(tree, page, span):
    """What is wrong with a piece of code type within a line."""
    yield from command_faults(tree, span)
    for path in re.findall(r"(?<![\w./$~-])[\w.-]+(?:/[\w.*-]+)+/?", span):
        top = path.split("/")[0]
        if top == "claque" and "." in path:
            path = "include/" + path
        elif top not in TOP:
            continue
        if path.endswith("*"):
            path = path.rstrip("*")
            if any(f.startswith(path) for f in tree.files):
                continue
        source = re.sub(r"/([\w]+)$", r"/\1.", path)
        if not tree.exists(path) and not any(f.startswith(source) for f in tree.files):
            yield f"no file {path}"
    word, fences = span.strip(), "\n".join(re.findall(r"^```.*?^```", tree.pages[page], re.S | re.M))
    if re.fullmatch(r"[\w-]+\.(?:%s)" % "|".join(ENDINGS[:5]), word):
        if word not in tree.base_names and word not in fences and f"`{word}`:" not in tree.pages[page]:
            yield f"no file {word}"
    elif re.fullmatch(r"[A-Za-z_]\w*", word) and not NAME.fullmatch(word):
        if word not in tree.words and word not in tree.stems and word not in fences:
            yield f"no source has the name {word}"
    elif word.startswith("--"):
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", word):
            if not any(f'{option}"' in t or f"{option}," in t for t in tree.sources.values()):
                yield f"no source has the option {option}"


def name_faults(tree, text):
    """What is wrong with the names of the API in a text."""
    for found in re.finditer(r"(?<!libclaque/)\b((?:clq|CLQ)_\w+)(\.\.\.)?(?:\.(\w+))?", text):
        name, more, member = found.groups()
        if more or name.endswith("_") or text[found.end() : found.end() + 1] == "*":
            if not any(d.startswith(name) for d in tree.declared):
                yield f"no declaration begins with {name}"
        elif name not in tree.declared:
            yield f"{name} is not declared in include/claque"
        elif member and member not in tree.members.get(name, {member}):
            yield f"{name} has no member {member}"


def page_faults(tree, page, text):
    first = text.split("\n", 1)[0]
    if page == "README.md":
        if len(text.encode()) > 10_000:
            yield f"{len(text.encode())} bytes, more than 10000"
    elif not first.startswith("This page "):
        yield "the first line does not say what the page is for"
    for target in re.findall(r"\]\(([^)#]+)\)", text):
        at = (tree.root / page).parent / target
        if "://" not in target and not at.exists():
            yield f"no file {target}"
    for block in re.findall(r"^```.*?^```", text, re.S | re.M):
        yield from command_faults(tree, block)
        code = block if block.startswith("```c\n") else ""
        for member in re.findall(r"(?<=[\w\])])\.([a-z]\w*)(?=\s*(?:=|\[|\.))", code):
            if not any(member in members for members in tree.members.values()):
                yield f"no struct has the member {member}"
    prose = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    for span in re.findall(r"`([^`\n]+)`", prose):
        yield from span_faults(tree, page, span)
    yield from name_faults(tree, text)


def comment_faults(tree, path, text):
    hashed = path.endswith((".py", ".sh", ".txt", ".toml")) or not re.search(r"\.\w+$", path)
    comment = re.compile(r"(?:^|\s)#[^!\n]*" if hashed else r"//[^\n]*|/\*.*?\*/", re.S)
    comments = "\n".join(comment.findall(text))
    if path.startswith("include/claque/"):
        yield from name_faults(tree, comments)
    if not hashed:
        names = re.findall(r"\b\w+::(\w+)|(?<![\w.>-])([a-z]\w+)\(\)|`(?:\w+\.)?([A-Za-z_]\w*)`", comments)
        for name in ("".join(found) for found in names):
            if name not in tree.words and name not in tree.stems:
                yield f"no code has the name {name}"
    folder = path.rsplit("/", 1)[0]
    for name in re.findall(r"(?<![\w./-])((?:[\w-]+/)*[\w-]+\.(?:h|cpp|py|md))\b", comments):
        if name.startswith("claque/"):
            name = "include/" + name
        top = name.split("/")[0]
        known = (
            name in tree.files
            if "/" in name and top in TOP
            else (
                name in tree.base_names
                or f"{folder}/{name}" in tree.files
                or any(f.endswith("/" + name) for f in tree.files)
            )
        )
        if not known and not name.startswith(GENERATED) and not name.startswith(("GL/", "EGL/", "OpenMesh/", "CLI/")):
            yield f"no file {name}"


def sentence_faults(tree, path, text):
    """What is wrong with the options that refusals of trajectories name in brackets: `claque play` has to have them."""
    if path.startswith("lib/asset/trajectories/") and path.endswith(".cpp"):
        for option in re.findall(r"\((--[a-z][a-z-]+)", text):
            if option not in (tree.options(["play"]) or ()):
                yield f"'claque play' has no option {option}"


def prove(tree):
    """Each kind of fault is found where it is put in."""
    page = "docs/guide.md"
    cases = [
        ("`lib/none/at_all.h`", "no file"),
        ("`clq_crowd_place`", "not declared"),
        ("clq_crowd_def.distance_near of", "no member"),
        ("`claque render --no-such`", "no option"),
        ("`claque nosuch`", "no subcommand"),
        ("`make nosuch`", "no target"),
        ("```\nclaque bench odeon --no-such\n```\n", "no option"),
        ("[a](nothing.md)", "no file"),
        ("`nothing.cpp`", "no file"),
        ("`qwertzuiop`", "no source"),
        ("`--qwertzuiop 3`", "no source"),
        ("```c\ndef.nothing = 1;\n```\n", "no struct"),
    ]
    for text, wanted in cases:
        found = list(page_faults(tree, page, "This page is one.\n\n" + text + "\n"))
        if len(found) < 1 or not any(wanted in f for f in found):
            yield f"docs.py does not see what is wrong with {text!r}: {found}"
    if not list(page_faults(tree, page, "A page.\n")):
        yield "docs.py does not see that a first line is wrong"
    for text in ("// see nothing.cpp\n", "// see base::qwertzuiop\n", "/* qwertzuiop() */", "// `qwertzuiop`\n"):
        if not list(comment_faults(tree, "lib/base/error.h", text)):
            yield f"docs.py does not see that the comment {text!r} names nothing"
    if not list(sentence_faults(tree, "lib/asset/trajectories/vsp.cpp", "give format (--qwertzuiop)")):
        yield "docs.py does not see that a refusal names an option that is not there"
    if list(
        page_faults(tree, page, "This page is one.\n`lib/frame`, `claque/crowd.h`, `make run`, clq_crowd_def.seed\n")
    ):
        yield "docs.py sees faults where there are none"


def main():
    tree = Tree(pathlib.Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else "")
    faults = list(prove(tree))
    for page, text in tree.pages.items():
        faults += [f"{page}: {fault}" for fault in page_faults(tree, page, text)]
    for path, text in tree.sources.items():
        found = [*comment_faults(tree, path, text), *sentence_faults(tree, path, text)]
        faults += [f"{path}: {fault}" for fault in found]
    print("\n".join(dict.fromkeys(faults)) or f"{len(tree.pages)} pages and {len(tree.sources)} sources")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
