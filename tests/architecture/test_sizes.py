"""Sizes and words: a file or function past its limit means two things live in one room."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from architecture.sources import PACKAGE, ROOT, VENDORED
from architecture.table import FILE_LINES, FUNCTION_LINES
from table import each

PYTHON = sorted(
    path for folder in ("src", "tests", "examples") for path in (ROOT / folder).rglob("*.py")
)
TEXT = sorted(
    path
    for folder in ("src", "tests", "examples", "docs")
    for path in (ROOT / folder).rglob("*")
    if path.suffix in {".py", ".pyx", ".pxi", ".c", ".h", ".md", ".yaml", ".html", ".js"}
    and path.name != "_abi.c"
    and path.parent != VENDORED
)

# left open, run from text, or true on one machine only; the words are split to not find themselves
OPEN = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b|NotImplemented" r"Error")
RUNS_TEXT = re.compile(r"(?<![\w.])(eval|ex" r"ec|sympify|parse_expr)\(|\bpickle\.lo" r"ads?\(")
MACHINE = re.compile(r"(?<![\w.~$}])/(work|home|root|opt|Users)/")


def relative(path: Path) -> str:
    return str(path.relative_to(ROOT))


@cache
def content(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def found(pattern: re.Pattern[str], paths: list[Path]) -> list[str]:
    """Places where the pattern occurs, as ``file:line text``."""
    return [
        f"{relative(path)}:{number} {line.strip()[:80]}"
        for path in paths
        if pattern.search(content(path))
        for number, line in enumerate(content(path).splitlines(), 1)
        if pattern.search(line)
    ]


def test_files_are_short() -> None:
    sources = [path for path in TEXT if path.suffix in {".py", ".pyx", ".pxi", ".c", ".h"}]
    lines = {relative(path): len(content(path).splitlines()) for path in sources}
    assert not {name: n for name, n in lines.items() if n > FILE_LINES}


def functions(node: ast.AST) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    """Functions inside a node; expressions, which are most of a tree, hold none."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef):
            yield child
        if not isinstance(child, ast.expr):
            yield from functions(child)


@each("path", PYTHON)
def test_functions_are_short(path: Path) -> None:
    sizes = {
        f"{node.name}:{node.lineno}": (node.end_lineno or node.lineno) - node.lineno + 1
        for node in functions(ast.parse(content(path)))
    }
    assert not {name: n for name, n in sizes.items() if n > FUNCTION_LINES}


def test_nothing_is_left_open() -> None:
    assert not found(OPEN, TEXT)


def test_no_text_is_run_as_code() -> None:
    assert not found(RUNS_TEXT, [path for path in TEXT if PACKAGE in path.parents])


def test_sympy_takes_no_text() -> None:
    """Without ``strict=True`` it runs text as Python."""
    calls = [
        (f"{relative(path)}:{node.lineno}", {ast.unparse(key) for key in node.keywords if key.arg})
        for path in PYTHON
        if PACKAGE in path.parents
        for node in ast.walk(ast.parse(content(path)))
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in ("sympify", "parse_expr", "S")
    ]
    assert calls
    assert not [place for place, keys in calls if "strict=True" not in keys]


def test_no_path_of_a_machine() -> None:
    assert not found(MACHINE, TEXT)


def test_no_folder_of_leftovers() -> None:
    names = {path.stem for path in PYTHON}
    assert not names & {"utils", "util", "helpers", "helper", "misc", "common", "manager"}
