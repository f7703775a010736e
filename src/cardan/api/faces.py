"""Records of lower rooms as users hold them: with their verbs."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import is_dataclass
from functools import cached_property, wraps
from importlib import import_module
from typing import Any, ParamSpec, TypeVar, cast

P = ParamSpec("P")
R = TypeVar("R")

# record -> the class of this room that adds its verbs; ``api`` fills it
FACES: dict[str, str] = {}


def face(result: object) -> Any:
    """The same object with the verbs that users call, and so for the records it consists of."""
    kind = type(result)
    target = FACES.get(f"{kind.__module__}:{kind.__qualname__}")
    if target is not None:
        module, _, name = target.partition(":")
        # records are frozen, and others may hold the same object
        object.__setattr__(result, "__class__", getattr(import_module(module), name))
    if is_dataclass(kind) and kind.__module__.startswith("cardan.analyses."):
        for part in vars(result).values():
            for one in part if isinstance(part, tuple | list) else (part,):
                if type(one).__name__.endswith("Record"):
                    face(one)
    return result


def faced(function: Callable[P, R]) -> Callable[P, R]:
    """A function whose result has the verbs that users call."""

    @wraps(function)
    def call(*arguments: P.args, **named: P.kwargs) -> R:
        return cast(R, face(function(*arguments, **named)))

    return call


class verb:
    """A function ``"module:name"`` as a method: what it takes first is the object.

    The first use puts a plain method in its place, with the signature and the docstring of the
    function.
    """

    def __init__(self, target: str) -> None:
        self.module, _, self.function = target.partition(":")

    def __set_name__(self, owner: type, name: str) -> None:
        self.owner, self.name = owner, name

    def __get__(self, instance: object, owner: type) -> Any:
        setattr(self.owner, self.name, self.method())
        return getattr(owner if instance is None else instance, self.name)

    def method(self) -> Any:
        """The method."""
        return self._named(_method(getattr(import_module(self.module), self.function)))

    def _named(self, method: Callable[..., Any]) -> Callable[..., Any]:
        method.__name__, method.__qualname__ = self.name, f"{self.owner.__qualname__}.{self.name}"
        return method


class attribute(verb):
    """A function ``"module:name"`` of the object alone, as a property; of records, called once."""

    def __init__(self, target: str, once: bool = False) -> None:
        super().__init__(target)
        self.once = once

    def method(self) -> Any:
        """The property."""
        method = super().method()
        if not self.once:
            return property(method)
        cached = cached_property(method)
        cached.__set_name__(self.owner, self.name)
        return cached


class maker(verb):
    """A function ``"module:name"`` that makes an object of the class, as a static method."""

    def method(self) -> staticmethod[..., object]:
        """The static method."""
        function = getattr(import_module(self.module), self.function)
        return staticmethod(self._named(faced(function)))


def _method(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function with ``self`` for its first argument, and results as users hold them."""

    @wraps(function)
    def method(self: object, /, *arguments: object, **named: object) -> Any:
        return face(function(self, *arguments, **named))

    signature = inspect.signature(function)
    first, *parameters_after_self = signature.parameters.values()
    itself = first.replace(name="self", annotation=first.empty)
    method.__dict__["__signature__"] = signature.replace(
        parameters=[itself, *parameters_after_self]
    )
    method.__doc__ = _without(first.name, inspect.getdoc(function) or "")
    return method


def _without(argument: str, text: str) -> str:
    """A docstring that says nothing of an argument, whose entry may go over several lines."""
    lines: list[str] = []
    skipping = False
    for line in text.splitlines():
        skipping = line.startswith(f"    {argument}: ") or (skipping and line[:5].isspace())
        if not skipping:
            lines.append(line)
    return "\n".join(lines).replace("Args:\n\n", "")
