"""``Args:`` and ``Attributes:`` of docstrings name what is there."""

import ast
import re

from architecture.sources import PACKAGE

ENTRY = re.compile(r"\w+(, \*{0,2}\w+)*")


def entries(node: ast.AST, section: str) -> list[str]:
    """Names that a section of a docstring describes, and lines that are no description."""
    lines = (ast.get_docstring(node) or "").splitlines()  # type: ignore[arg-type]
    if f"{section}:" not in lines:
        return []
    found: list[str] = []
    for line in lines[lines.index(f"{section}:") + 1 :]:
        if line and not line.startswith("    "):
            break
        if line and not line.startswith("     "):
            head = line.strip().partition(":")[0].replace("*", "")
            found += head.split(", ") if ENTRY.fullmatch(head) else [line.strip()]
    return found


def parameters(node: ast.FunctionDef) -> set[str]:
    a = node.args
    every = (*a.posonlyargs, *a.args, a.vararg, *a.kwonlyargs, a.kwarg)
    return {x.arg for x in every if x is not None}


def members(node: ast.ClassDef) -> set[str]:
    """Fields, properties and what methods set."""
    found = {x.name for x in node.body if isinstance(x, ast.FunctionDef)}
    for x in ast.walk(node):
        if isinstance(x, ast.Attribute) and isinstance(x.ctx, ast.Store):
            found.add(x.attr)
        if isinstance(x, ast.AnnAssign | ast.Assign):
            targets = [x.target] if isinstance(x, ast.AnnAssign) else x.targets
            found |= {t.id for t in targets if isinstance(t, ast.Name)}
    return found


def test_docstrings_describe_what_exists() -> None:
    wrong = []
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef):
                stale = set(entries(node, "Args")) - parameters(node)
            elif isinstance(node, ast.ClassDef):
                stale = set(entries(node, "Attributes")) - members(node)
            else:
                continue
            wrong += [f"{path}:{node.lineno} {node.name}: {x}" for x in sorted(stale)]
    assert not wrong, "\n".join(wrong)
