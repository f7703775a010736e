"""Functions of lower rooms as methods of what users hold, imported on first use."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import wraps
from importlib import import_module
from typing import Any


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

    def method(self) -> Callable[..., Any]:
        """The method."""
        function = getattr(import_module(self.module), self.function)

        @wraps(function)
        def method(self: object, /, *given: Any, **named: Any) -> Any:
            return function(self, *given, **named)

        signature = inspect.signature(function)
        first, *others = signature.parameters.values()
        itself = first.replace(name="self", annotation=first.empty)
        method.__dict__["__signature__"] = signature.replace(parameters=[itself, *others])
        method.__name__, method.__qualname__ = self.name, f"{self.owner.__qualname__}.{self.name}"
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
