"""Reads the source tree: modules, and what each imports where. Nothing is executed."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src" / "cardan"
# files of others, as they come
VENDORED = PACKAGE / "codegen" / "fmu" / "headers"


@dataclass(frozen=True)
class Import:
    """One import: of ``name`` from ``target``, in ``source``, inside ``function`` ("" outside).

    Attributes:
        kind: ``"module"`` and ``"function"`` run; ``"type"`` stands under ``if TYPE_CHECKING``,
            ``"string"`` is the dotted name of a module in a text.
    """

    source: str
    target: str
    name: str
    function: str
    line: int
    kind: str

    def __str__(self) -> str:
        inside = f" in {self.function}" if self.function else ""
        return f"{self.source}:{self.line}{inside} imports {self.target}"


def module_name(path: Path) -> str:
    """Dotted name of a file of the package, such as ``cardan.ir.graph``."""
    parts = ("cardan", *path.relative_to(PACKAGE).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def modules() -> dict[str, Path]:
    """Every module of the package by dotted name."""
    return {module_name(path): path for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), filename=str(path))


class _Reader(ast.NodeVisitor):
    """Collects imports."""

    def __init__(self, name: str, path: Path) -> None:
        self.name = name
        self.package = name if path.name == "__init__.py" else name.rpartition(".")[0]
        self.scope: list[str] = []
        self.depth = 0
        self.typing = False
        self.found: list[Import] = []

    def _enter(self, node: ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        is_function = not isinstance(node, ast.ClassDef)
        self.scope.append(node.name)
        self.depth += is_function
        self.generic_visit(node)
        self.depth -= is_function
        self.scope.pop()

    visit_ClassDef = visit_FunctionDef = visit_AsyncFunctionDef = _enter

    def visit_If(self, node: ast.If) -> None:
        names = {getattr(node.test, "id", ""), getattr(node.test, "attr", "")}
        self.visit(node.test)
        before, self.typing = self.typing, self.typing or "TYPE_CHECKING" in names
        for child in node.body:
            self.visit(child)
        self.typing = before
        for child in node.orelse:
            self.visit(child)

    def visit_Constant(self, node: ast.Constant) -> None:
        # such as "cardan.analyses.linear.modes:modes"
        target = node.value.partition(":")[0] if isinstance(node.value, str) else ""
        if target in modules() and target != "cardan":
            self._add(target, "", node.lineno, "string")

    def _add(self, target: str, name: str, line: int, kind: str = "") -> None:
        function = ".".join(self.scope) if self.depth else ""
        usual = "type" if self.typing else "function" if function else "module"
        self.found.append(Import(self.name, target, name, function, line, kind or usual))

    def visit_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            self._add(alias.name, "", node.lineno)

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        base = node.module or ""
        if node.level:
            parts = self.package.split(".")
            above = ".".join(parts[: len(parts) - node.level + 1])
            base = f"{above}.{base}" if base else above
        for alias in node.names:
            # from a package one may take a module or a name
            inner = f"{base}.{alias.name}"
            self._add(inner if inner in modules() else base, alias.name, node.lineno)


@cache
def imports_of(name: str) -> tuple[Import, ...]:
    """Every import of a module, whatever its kind."""
    reader = _Reader(name, modules()[name])
    reader.visit(tree(modules()[name]))
    return tuple(reader.found)


@cache
def all_imports() -> tuple[Import, ...]:
    """Every import of the package, whatever its kind."""
    return tuple(found for name in modules() for found in imports_of(name))


@cache
def imports() -> tuple[Import, ...]:
    """Every import statement of the package that can run."""
    return tuple(found for found in all_imports() if found.kind in ("module", "function"))


def room(module: str) -> str:
    """The top-level package a module of cardan belongs to: ``cardan.ir.graph`` -> ``ir``."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else "__init__"


def reached(start: str) -> set[str]:
    """All modules, ours and others', that importing ``start`` loads outside functions."""
    outside: dict[str, set[str]] = {}
    for found in imports():
        if not found.function:
            outside.setdefault(found.source, set()).add(found.target)
    seen: set[str] = set()
    stack = [start]
    while stack:
        name = stack.pop()
        if name in seen:
            continue
        seen.add(name)
        # a module runs the packages around it first
        parts = name.split(".")
        stack.extend(".".join(parts[:i]) for i in range(1, len(parts)))
        stack.extend(outside.get(name, ()))
    return seen
