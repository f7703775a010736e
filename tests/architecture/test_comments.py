"""Long functions of the rooms that compute say what their steps are.

Counted are lines with a comment, over the lines of functions above 25 lines, docstrings left out.
A comment that only repeats the line below it, or beside it, is not counted.
"""

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

from architecture.sources import PACKAGE

LEAST = 5.0  # lines with a comment in 100 lines
LONG = 25
ROOMS = ("kernels", "analyses", "passes", "runtime/sparse")
DIRECTIVE = re.compile(r"# ?(fmt|type|noqa)\b")
WORD = re.compile(r"[A-Za-z]{3,}")
C_FUNCTION = re.compile(r"^[A-Za-z_][^;{}=]*\([^;{}]*\)\s*\{\s*$", re.M)


def python_functions(text: str) -> Iterator[tuple[list[str], dict[int, str]]]:
    """Lines of every function without its docstring, and its comments by line number in there."""
    comments = {
        token.start[0]: token.string.lstrip("# ")
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type == tokenize.COMMENT and not DIRECTIVE.match(token.string)
    }
    lines = text.splitlines()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            # below the signature, or below the docstring
            signature = [x.end_lineno or 0 for x in (*node.args.args, node.returns) if x]
            start = max(node.lineno, *signature, 0) + 1
            if ast.get_docstring(node):
                start = (node.body[0].end_lineno or start) + 1
            numbers = range(start, (node.end_lineno or start) + 1)
            yield (
                [lines[k - 1] for k in numbers],
                {k - start: comments[k] for k in numbers if k in comments},
            )


def c_functions(text: str) -> Iterator[tuple[list[str], dict[int, str]]]:
    """Lines of every function body, and the comments in it by line number in there."""
    for match in C_FUNCTION.finditer(text):
        end = text.find("\n}", match.end())
        body = text[match.end() : end].split("\n")[1:]
        comments, inside = {}, False
        for k, line in enumerate(body):
            started = line.find("/*")
            if inside or started >= 0:
                comments[k] = line[0 if inside else started :].split("*/")[0].strip("/* ")
                inside = "*/" not in line[max(started, 0) :]
        yield body, comments


def says_more(comment: str, k: int, lines: list[str], comments: dict[int, str]) -> bool:
    """True unless the words of a comment stand in the code beside it or below it."""
    code = lines[k].replace(comment, "")
    below = k + 1
    while below < len(lines) and (below in comments or not lines[below].strip()):
        below += 1
    code += lines[below] if below < len(lines) else ""
    words, there = set(WORD.findall(comment.lower())), code.lower()
    return bool(words) and sum(word not in there for word in words) > len(words) / 3


def density(paths: list[Path]) -> float:
    """Lines with a comment in 100 lines of long functions."""
    total = commented = 0
    for path in paths:
        functions = python_functions if path.suffix == ".py" else c_functions
        for lines, comments in functions(path.read_text("utf-8")):
            if len(lines) > LONG:
                total += len(lines)
                commented += sum(says_more(c, k, lines, comments) for k, c in comments.items())
    return 100.0 * commented / max(1, total)


@pytest.mark.parametrize("room", ROOMS)
def test_long_functions_say_what_their_steps_are(room: str) -> None:
    paths = [p for p in (PACKAGE / room).rglob("*.[pch]*") if p.suffix in (".py", ".c", ".h")]
    assert density([p for p in paths if "built" not in p.parts]) >= LEAST


def test_a_comment_that_repeats_the_code_is_not_counted() -> None:
    body = "".join(f"    x{k} = {k}\n" for k in range(LONG))
    repeated = f"def f():\n    # solve the step\n    step = solve(1)\n{body}"
    said = f"def f():\n    # Newton on the stage values\n    step = solve(1)\n{body}"
    counted = [
        sum(says_more(c, k, lines, comments) for k, c in comments.items())
        for text in (repeated, said)
        for lines, comments in python_functions(text)
    ]
    assert counted == [0, 1]
