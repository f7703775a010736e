"""Counts of what shall become less, each by the name it has in ``ratchet.json``."""

from __future__ import annotations

import ast
import io
import math
import re
import tokenize
from collections.abc import Iterable, Iterator
from pathlib import Path

from architecture.sources import PACKAGE, ROOT, VENDORED, Import, all_imports, modules, room, tree
from architecture.table import ORDER

API = ROOT / "tests" / "golden" / "api.txt"
WORDS = frozenset(Path(__file__).with_name("private_words.txt").read_text("utf-8").split())
# names that are given or called in C
C_NAME = re.compile(r"\b[a-zA-Z_]\w*\b(?=\s*(?:\(|=[^=]|;))")
TEMPORARY = re.compile(r"\bw?real (\w+) =")
ENTRY = re.compile(r"^\s*(\w+)\[(\d+)\] = (?!\w+;)", re.MULTILINE)
BLOCK = 35  # the last entry of a bare array that stands for a place in a 6 x 6 matrix
OPERATOR = re.compile(r"(mul|add|sub|div|neg|solve|select)(_\d+)?$")
NUMBERED = re.compile(r".*?_(\d+)$")
PLACE = re.compile(r"_[0-6]_[0-6]$")  # in a small matrix
FAR = 20


def counts() -> dict[str, int]:
    """What ``ratchet.json`` holds, counted now.

    Files are counted in tens and lines in thousands, both upward: a mend may need a line.
    """
    nameless, far = temporaries()
    words, anything = names()
    texts = [path.read_text("utf-8") for path in modules().values()]
    # a folder's docstring alone makes no file
    texts = [text for text in texts if len(text.splitlines()) > 1]
    return {
        "upward imports": len(upward()),
        "largest circle": largest_circle(all_imports()),
        "largest circle that runs": largest_circle(x for x in all_imports() if x.kind != "type"),
        '"mesh" in': sum('"mesh" in' in line for text in texts for line in text.splitlines()),
        "** in public signatures": sum("**" in x for x in API.read_text("utf-8").splitlines()),
        "private words": words,
        "Any": anything,
        "nameless temporaries": nameless,
        "temporaries numbered past 20": far,
        "tens of files": math.ceil(len(texts) / 10),
        "thousands of code lines": math.ceil(sum(map(code_lines, texts)) / 1000),
    }


def code_lines(text: str) -> int:
    """Lines without blanks, comments and docstrings."""
    skipped = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT}
    lines: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in skipped and token.type != tokenize.ENDMARKER:
            lines.update(range(token.start[0], token.end[0] + 1))
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(
            node
        ):
            lines -= set(range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1))
    return len(lines)


def pairs(found: Iterable[Import]) -> set[tuple[str, str, str]]:
    """Kind, source and target of imports between modules of the package."""
    known = modules()
    return {(x.kind, x.source, x.target) for x in found if x.target in known}


def upward() -> set[tuple[str, str, str]]:
    """Imports of a room that stands above the importing one, of whatever kind."""
    place = {name: k for k, name in enumerate(ORDER)}
    return {
        (kind, source, target)
        for kind, source, target in pairs(all_imports())
        if place.get(room(target), -1) > place.get(room(source), len(place))
    }


def largest_circle(found: Iterable[Import]) -> int:
    """Modules in the largest set of which each reaches all others."""
    ahead: dict[str, set[str]] = {name: set() for name in modules()}
    for _, source, target in pairs(found):
        if source != target:
            ahead[source].add(target)
    return max(map(len, circles(ahead)))


def circles(ahead: dict[str, set[str]]) -> Iterator[list[str]]:
    """Strongly connected components.

    Source: R. Sedgewick, K. Wayne, Algorithms, 4th ed., 4.2 (Kosaraju and Sharir).
    """
    back: dict[str, set[str]] = {name: set() for name in ahead}
    for source, targets in ahead.items():
        for target in targets:
            back[target].add(source)
    seen: set[str] = set()
    order = [name for start in ahead for name in _finished(start, ahead, seen)]
    seen = set()
    for start in reversed(order):
        part = list(_finished(start, back, seen))
        if part:
            yield part


def _finished(start: str, ahead: dict[str, set[str]], seen: set[str]) -> Iterator[str]:
    """What is reached from a start and was not seen, each behind all that it reaches."""
    if start in seen:
        return
    seen.add(start)
    stack = [(start, iter(sorted(ahead[start])))]
    while stack:
        name, left = stack[-1]
        step = next((x for x in left if x not in seen), None)
        if step is None:
            stack.pop()
            yield name
        else:
            seen.add(step)
            stack.append((step, iter(sorted(ahead[step]))))


def names() -> tuple[int, int]:
    """Names that are given with a word of no meaning to the field; uses of ``Any``.

    Names of files, classes, functions, arguments and variables.
    """
    words = anything = 0
    for path in [*PACKAGE.rglob("*.c"), *PACKAGE.rglob("*.h")]:
        if path.parent == VENDORED:
            continue
        words += sum(map(_private, C_NAME.findall(path.read_text("utf-8"))))
    for path in modules().values():
        words += path.stem in WORDS
        for node in ast.walk(tree(path)):
            words += sum(_private(name.strip("_")) for name in _given(node))
            anything += isinstance(node, ast.Name) and node.id == "Any"
    return words, anything


def _private(name: str) -> int:
    """How many words of no meaning a name has, each once."""
    return len(WORDS.intersection(name.lower().split("_")))


def _given(node: ast.AST) -> list[str]:
    """Names that a node gives."""
    if isinstance(node, ast.FunctionDef):
        return [node.name, *(one.arg for one in node.args.args + node.args.kwonlyargs)]
    if isinstance(node, ast.ClassDef):
        return [node.name]
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        return [node.id]
    return (
        [node.attr] if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) else []
    )


def temporaries() -> tuple[int, int]:
    """Temporaries of ``generated/`` with a number or an operator for a name; those past 20."""
    nameless = far = 0
    for path in sorted((ROOT / "generated").glob("*/*.c")):
        text = path.read_text("utf-8")
        # computed entries of bare arrays past a 6 x 6 block have no name either
        entries = [f"{a}_{i}" for a, i in ENTRY.findall(text) if a != "out" and int(i) > BLOCK]
        for name in TEMPORARY.findall(text) + entries:
            number = NUMBERED.match(name)
            if OPERATOR.match(name):
                nameless += 1
            elif number and not PLACE.search(name):
                nameless += 1
                far += int(number[1]) > FAR
    return nameless, far
