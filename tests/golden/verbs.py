"""What type checkers read of the verbs of a compiled model: a stub, from what they stand for."""

from __future__ import annotations

import inspect
import re
import textwrap
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from typing import Any

from architecture.sources import PACKAGE, imports_of, tree
from cardan.api.compiled_model import CompiledModel
from golden.functions import literal

SOURCE = PACKAGE / "api" / "compiled_model.py"
STUB = SOURCE.with_suffix(".pyi")
BUILT_IN = {"None", "bool", "complex", "dict", "float", "int", "list", "str", "tuple"}
NAME = re.compile(r"(?<![.\w])[A-Za-z_]\w*")
TEXT = re.compile(r"\"[^\"]*\"|'[^']*'")
HEAD = '''\
"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

'''


def _body() -> Any:
    """The class as it is written."""
    return next(node for node in tree(SOURCE).body if getattr(node, "name", "") == "CompiledModel")


@cache
def verbs() -> dict[str, str]:
    """Method -> ``"module:name"`` of its function."""
    return {
        node.targets[0].id: node.value.args[0].value
        for node in _body().body
        if getattr(getattr(getattr(node, "value", None), "func", None), "id", "") == "verb"
    }


def stub() -> str:
    """``api/compiled_model.pyi``."""
    text = _indented(f'"""{inspect.getdoc(CompiledModel)}\n"""')
    methods = "\n".join(map(_method, verbs()))
    head = f"@final\nclass CompiledModel(LoadedModel):\n{text}\n"
    return HEAD + "\n".join(_imports()) + "\n\n" + head + methods


def _indented(text: str, depth: int = 4) -> str:
    return textwrap.indent(text, " " * depth) + "\n"


def _method(name: str) -> str:
    method = getattr(CompiledModel, name)
    lines, starred = ["self"], False
    found = inspect.signature(method)
    for one in list(found.parameters.values())[1:]:
        if one.kind is one.KEYWORD_ONLY and not starred:
            lines.append("*")
            starred = True
        star = "**" if one.kind is one.VAR_KEYWORD else ""
        default = "" if one.default is one.empty else f" = {literal(one.default)}"
        lines.append(f"{star}{one.name}: {one.annotation}{default}")
    rows = "".join(f"        {line},\n" for line in lines)
    text = f'"""{inspect.getdoc(method)}\n"""'
    return f"    def {name}(\n{rows}    ) -> {found.return_annotation}:\n{_indented(text, 8)}"


def _imports() -> Iterator[str]:
    """Import statements of what the annotations name, in the order of a linter."""
    found: dict[str, set[str]] = defaultdict(set)
    found["typing"].add("final")
    found["cardan.runtime.models.loaded_model"].add("LoadedModel")
    known: dict[str, str] = {}
    for name, target in verbs().items():
        module = target.partition(":")[0]
        for word in sorted(_words(name)):
            # the same name of a type stands for the same type wherever it is imported from
            known.setdefault(word, _origin(word, module))
            found[known[word]].add(word)
    ours = {module for module in found if module.startswith("cardan.")}
    foreign = {module for module in found if module.startswith("numpy")}
    for group in (set(found) - ours - foreign, foreign, ours):
        for module in sorted(group):
            place = f"..{module.removeprefix('cardan.')}" if module in ours else module
            yield f"from {place} import {', '.join(sorted(found[module]))}"
        if group is not ours:
            yield ""


def _words(verb: str) -> set[str]:
    """Names in the annotations of a method."""
    signature = inspect.signature(getattr(CompiledModel, verb))
    texts = [one.annotation for one in list(signature.parameters.values())[1:]]
    found = NAME.findall(TEXT.sub("", " ".join([*texts, signature.return_annotation])))
    return set(found) - BUILT_IN


def _origin(word: str, module: str) -> str:
    """The module from which another one has a name."""
    return next((one.target for one in imports_of(module) if one.name == word), module)
