"""Every public name of cardan with its signature, as text."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from functools import cache, cached_property
from importlib import import_module
from types import ModuleType
from typing import Any

import cardan as cd
from architecture.sources import imports_of, modules
from cardan.api.faces import verb
from cardan.elements.centerlines.centerline import Centerline
from cardan.elements.forces.force import ForceElement
from cardan.elements.joints.joint import Joint
from cardan.elements.sections.section import Section
from cardan.equations.constraints.treatments.treatment import Treatment
from cardan.scene.shape import Shape
from golden.verbs import HELD, held

NAME = re.compile(r"[A-Za-z_]\w*")
# elements and what treats constraints: users make them, the compiler calls their methods
MADE = (Joint, ForceElement, Treatment, Centerline, Section, Shape, Exception)


@cache
def public() -> dict[str, Any]:
    """Name -> what stands there: names of cardan, and the classes that their functions return."""
    found = {f"cardan.{name}": getattr(cd, name) for name in cd.__all__}
    for name, value in list(found.items()):
        if inspect.ismodule(value):
            found |= {f"{name}.{own}": x for own, x in _of_module(value)}
    known = set(filter(inspect.isclass, found.values()))
    for value in list(found.values()):
        if not _is_made(value):
            for one in _returned(value) - known:
                assert found.setdefault(one.__name__, one) is one, f"two classes {one.__name__}"
    return dict(sorted(found.items()))


def _is_made(value: Any) -> bool:
    return inspect.isclass(value) and issubclass(value, MADE)


def _of_module(module: ModuleType) -> Iterator[tuple[str, Any]]:
    """What a module defines for others."""
    for name, value in vars(module).items():
        listed = name in getattr(module, "__all__", ())
        own = getattr(value, "__module__", None) == module.__name__ or listed
        if not name.startswith("_") and own and (inspect.isclass(value) or callable(value)):
            yield name, value


def _returned(value: Any) -> set[type]:
    """Classes of cardan in the annotations of what a function or the methods of a class return."""
    members = [one for _, one in _members(value)] if inspect.isclass(value) else [value]
    found = set()
    for one in members:
        function = _function(one)
        for name in NAME.findall(_result(function)):
            kind = _named(name, function)
            ours = inspect.isclass(kind) and kind.__module__.partition(".")[0] == "cardan"
            if ours and not _is_made(kind):
                found.add(kind)
    return found


def _named(name: str, function: Any) -> Any:
    """What a name in an annotation means where the function stands; of records, what users have."""
    if name in HELD:
        return getattr(import_module(HELD[name][0]), HELD[name][1])
    function = inspect.unwrap(function)
    if name in function.__globals__:
        return function.__globals__[name]
    # imported for type checkers only
    for one in imports_of(function.__module__):
        if one.name == name and one.target in modules():
            return getattr(import_module(one.target), name, None)
    return None


def _result(function: Any) -> str:
    """The annotation of what a function returns."""
    return str(getattr(function, "__annotations__", {}).get("return", ""))


def _function(member: Any) -> Any:
    """What a method, property or class method runs."""
    if isinstance(member, property):
        return member.fget
    if isinstance(member, cached_property):
        return member.func
    if isinstance(member, classmethod | staticmethod):
        return member.__func__
    return member


def _members(kind: type) -> Iterator[tuple[str, Any]]:
    """Public methods, properties and fields of a class, those of its bases in cardan included."""
    found: dict[str, Any] = {}
    for base in reversed(kind.__mro__):
        if base.__module__.partition(".")[0] != "cardan":
            continue
        found |= {name: str(note) for name, note in vars(base).get("__annotations__", {}).items()}
        found |= {
            name: value
            for name, value in vars(base).items()
            if callable(value) or isinstance(value, verb | property | cached_property | classmethod)
        }
    for name, value in sorted(found.items()):
        if name[0] != "_":
            # what a verb stands for is imported on first use
            yield name, getattr(kind, name) if isinstance(value, verb) else value


def signature(function: Any) -> str:
    """The arguments of a callable, the same in every process and version of Python."""
    try:
        found = inspect.signature(function)
    except (TypeError, ValueError):
        return "(...)"
    parts, bare = [], False
    for one in found.parameters.values():
        star = {one.VAR_POSITIONAL: "*", one.VAR_KEYWORD: "**"}.get(one.kind, "")
        if one.kind == one.KEYWORD_ONLY and not bare:
            parts.append("*")
        bare = bare or one.kind in (one.KEYWORD_ONLY, one.VAR_POSITIONAL)
        note = "" if one.annotation is one.empty else f": {_note(one.annotation)}"
        default = "" if one.default is one.empty else f" = {_value(one.default)}"
        parts.append(f"{star}{one.name}{note}{default}")
    result = found.return_annotation
    arrow = "" if result is found.empty else f" -> {_note(result)}"
    return f"({', '.join(parts)}){arrow}"


def _note(annotation: Any) -> str:
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    return held(text)


def _value(default: Any) -> str:
    """A default; of objects whose text is their address, the kind."""
    if isinstance(default, set | frozenset):
        return "{" + ", ".join(sorted(map(_value, default))) + "}"
    text = repr(default)
    return f"<{type(default).__name__}>" if " at 0x" in text else text


def lines() -> Iterator[str]:
    """The listing, one name per line."""
    for name, value in public().items():
        if inspect.ismodule(value):
            yield f"{name}: module"
        elif inspect.isclass(value):
            bases = ", ".join(base.__name__ for base in value.__bases__)
            yield f"{name}: class({bases})"
            yield f"{name}{signature(value)}"
            if _is_made(value):
                continue
            for own, member in _members(value):
                yield f"{name}.{_line(own, member)}"
        elif callable(value):
            yield f"{name}{signature(value)}"
        else:
            yield f"{name}: {type(value).__name__}"


def _line(name: str, member: Any) -> str:
    """A method, property or field."""
    if isinstance(member, str):
        return f"{name}: {_note(member)}"
    if isinstance(member, property | cached_property):
        return f"{name}: property -> {_note(_result(_function(member)))}"
    function = _function(member)
    word = {classmethod: "classmethod ", staticmethod: "staticmethod "}.get(type(member), "")
    return f"{name}: {word}{signature(function)}" if word else f"{name}{signature(function)}"
