"""Stubs of the classes that users hold, for type checkers: from what their verbs stand for."""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

from architecture.sources import PACKAGE, Import, imports_of, tree
from cardan.api.faces import FACES
from golden.functions import literal

BUILT_IN = {"None", "bool", "complex", "dict", "float", "int", "list", "object", "str", "tuple"}
NAME = re.compile(r"(?<![.\w])[A-Za-z_]\w*")
TEXT = re.compile(r"\"[^\"]*\"|'[^']*'")
WIDTH = 100  # of a line, to a linter
HEAD = '''\
"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

'''
# what stands for a function in a class
KINDS = ("verb", "attribute", "maker")
# name of a record -> module and name of the class that users hold
HELD = {
    record.partition(":")[2]: (held.partition(":")[0], held.partition(":")[2])
    for record, held in FACES.items()
}


def modules() -> list[str]:
    """Modules of ``api`` whose classes have verbs."""
    paths = sorted((PACKAGE / "api").glob("*.py"))
    marks = tuple(f" = {kind}(" for kind in KINDS)
    return [path.stem for path in paths if any(mark in path.read_text("utf-8") for mark in marks)]


def held(annotation: str) -> str:
    """An annotation with classes that users hold in place of records."""
    return NAME.sub(lambda m: HELD[m[0]][1] if m[0] in HELD else m[0], annotation)


@dataclass(frozen=True)
class Verb:
    """One line ``name = verb("module:function")`` or ``attribute(...)``."""

    owner: str
    name: str
    target: str
    kind: str

    @property
    def module(self) -> str:
        """Of its function."""
        return self.target.partition(":")[0]

    @cached_property
    def function(self) -> Any:
        """What it stands for."""
        return getattr(import_module(self.module), self.target.partition(":")[2])

    @property
    def signature(self) -> inspect.Signature:
        """Of its function."""
        return inspect.signature(self.function)

    @property
    def arguments(self) -> list[inspect.Parameter]:
        """Of its function, but for the object itself."""
        return list(self.signature.parameters.values())[self.kind != "maker" :]

    @property
    def annotations(self) -> list[str]:
        """Of its arguments but the first, and of what it returns."""
        return [*(one.annotation for one in self.arguments), self.signature.return_annotation]


@cache
def verbs(module: str) -> tuple[Verb, ...]:
    """The verbs of the classes of a module of ``api``."""
    return tuple(
        Verb(node.name, line.targets[0].id, line.value.args[0].value, line.value.func.id)
        for node in tree(PACKAGE / "api" / f"{module}.py").body
        if isinstance(node, ast.ClassDef)
        for line in node.body
        if isinstance(line, ast.Assign)
        and isinstance(line.value, ast.Call)
        and getattr(line.value.func, "id", "") in KINDS
    )


def path(module: str) -> Path:
    """Of the stub of a module."""
    return PACKAGE / "api" / f"{module}.pyi"


def stub(module: str) -> str:
    """The stub of a module of ``api``."""
    parts = []
    for node in tree(PACKAGE / "api" / f"{module}.py").body:
        if isinstance(node, ast.ClassDef):
            parts.append(_class(module, node))
        elif isinstance(node, ast.FunctionDef) and node.name[0] != "_":
            parts.append(_written(node, 0))
    return HEAD + "\n".join(_imports(module)) + "\n\n" + "\n".join(parts)


def _class(module: str, node: ast.ClassDef) -> str:
    kind = getattr(import_module(f"cardan.api.{module}"), node.name)
    lines = [f"@{ast.unparse(one)}\n" for one in node.decorator_list]
    lines.append(f"class {node.name}({', '.join(map(ast.unparse, node.bases))}):\n")
    lines.append(_indented(f'"""{inspect.getdoc(kind)}\n"""'))
    own = {verb.name: verb for verb in verbs(module) if verb.owner == node.name}
    for line in node.body:
        if isinstance(line, ast.FunctionDef) and line.name[0] != "_":
            lines.append(_written(line, 4))
        elif isinstance(line, ast.Assign) and line.targets[0].id in own:  # type: ignore[attr-defined]
            lines.append(_method(kind, own[line.targets[0].id]))  # type: ignore[attr-defined]
    return "".join(lines)


def _indented(text: str, depth: int = 4) -> str:
    return textwrap.indent(text, " " * depth) + "\n"


def _written(node: ast.FunctionDef, depth: int) -> str:
    """A method or function that stands in the module itself."""
    said = ast.get_docstring(node)
    lines = [f"@{ast.unparse(one)}" for one in node.decorator_list if ast.unparse(one) != "checked"]
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    lines.append(f"def {node.name}({ast.unparse(node.args)}){result}:")
    lines.append(f'    """{said}"""' if said and "\n" not in said else "    ...")
    if said and "\n" in said:
        lines[-1] = textwrap.indent(f'"""{said}\n"""', "    ")
    return _indented("\n".join(lines), depth)


def _method(kind: type, verb: Verb) -> str:
    lines, starred = ["self"] * (verb.kind != "maker"), False
    signature = verb.signature
    for one in verb.arguments:
        if one.kind is one.KEYWORD_ONLY and not starred:
            lines.append("*")
            starred = True
        star = "**" if one.kind is one.VAR_KEYWORD else ""
        default = "" if one.default is one.empty else f" = {literal(one.default)}"
        lines.append(f"{star}{one.name}: {held(one.annotation)}{default}")
    rows = "".join(f"        {line},\n" for line in lines)
    shown = getattr(kind, verb.name)
    text = f'"""{inspect.getdoc(shown)}\n"""'
    mark = {"attribute": "    @property\n", "maker": "    @staticmethod\n"}.get(verb.kind, "")
    result = held(signature.return_annotation)
    return f"{mark}    def {verb.name}(\n{rows}    ) -> {result}:\n{_indented(text, 8)}"


def _imports(module: str) -> Iterator[str]:
    """Import statements of what the annotations name, in the order of a linter."""
    found: dict[str, set[str]] = defaultdict(set)
    here = f"cardan.api.{module}"
    known: dict[str, str] = {}
    for verb in verbs(module):
        for word in sorted(_words(verb.annotations)):
            # the same name of a type stands for the same type wherever it is imported from
            where = HELD[word] if word in HELD else (_origin(word, verb.module), word)
            known.setdefault(where[1], where[0])
    for one in _named(module):
        known.setdefault(one.name, one.target)
    for word, where in known.items():
        if where != here:
            found[where].add(word)
    ours = {name for name in found if name.startswith("cardan.")}
    foreign = {name for name in found if name.startswith(("numpy", "matplotlib"))}
    for group in (set(found) - ours - foreign, foreign, ours):
        places = {_relative(name) if name in ours else name: name for name in group}
        # parents before siblings
        for place in sorted(places, key=lambda one: (not one.startswith(".."), one)):
            names = sorted(found[places[place]])
            line = f"from {place} import {', '.join(names)}"
            rows = "".join(f"    {name},\n" for name in names)
            yield line if len(line) <= WIDTH else f"from {place} import (\n{rows})"
        if group and group is not ours:
            yield ""


def _relative(name: str) -> str:
    inside = name.removeprefix("cardan.api.")
    return f".{inside}" if inside != name else f"..{name.removeprefix('cardan.')}"


def _named(module: str) -> Iterator[Import]:
    """What the module imports and its stub names."""
    words: set[str] = set()
    for node in tree(PACKAGE / "api" / f"{module}.py").body:
        parts: list[ast.AST] = []
        if isinstance(node, ast.ClassDef):
            parts += [*node.bases, *node.decorator_list]
        for one in ast.walk(node):
            if isinstance(one, ast.FunctionDef) and one.name[0] != "_":
                parts += [one.args, *([one.returns] if one.returns else [])]
        words |= {x.id for part in parts for x in ast.walk(part) if isinstance(x, ast.Name)}
    return (one for one in imports_of(f"cardan.api.{module}") if one.name in words)


def _words(annotations: list[str]) -> set[str]:
    """Names in annotations."""
    return set(NAME.findall(TEXT.sub("", " ".join(annotations)))) - BUILT_IN


def _origin(word: str, module: str) -> str:
    """The module from which another one has a name."""
    return next((one.target for one in imports_of(module) if one.name == word), module)
