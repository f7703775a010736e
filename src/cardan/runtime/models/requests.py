"""Derivatives that are asked for again and again, made once."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from inspect import signature
from typing import ParamSpec, TypeVar, cast

from ...errors import ArgumentError, brief
from ..calls.evaluation import Evaluation

P = ParamSpec("P")
R = TypeVar("R")
# blocks by which functions are differentiated, unless told
STANDARD = ("q", "u", "r", "p")
# stands for it where names are compared
EVERYTHING = object()


def once(make: Callable[P, R]) -> Callable[P, R]:
    """A method that makes something of a function and blocks or names, and makes it once.

    Whoever asks for it in a loop waits for the C alone.
    """
    plain, name = cast("Callable[..., R]", make), make.__name__
    usual = signature(make).parameters["wrt"].default

    @wraps(make)
    def ask(model: Evaluation, function: object, wrt: object = usual, **named: object) -> R:
        listed = tuple(wrt) if type(wrt) is list else wrt
        # equal names may mean other things: blocks whatever parameters are called, or what the
        # function reads of what stands for everything
        key: object = name, function, EVERYTHING if wrt is STANDARD else listed, type(listed)
        try:
            existing: R | None = None if named else model._derived.get(key)
        except TypeError:
            # an array of names has no hash; the request refuses what is not a name
            existing = key = None
        if existing is not None:
            return existing
        if isinstance(wrt, set | frozenset):
            raise ArgumentError(
                f"{name}: wrt={brief(wrt)}: results come in the order of what they are by, and a "
                "set has none. Give a list"
            )
        result = plain(model, function, wrt, **named)
        if key is not None:
            model._derived[key] = result
        return result

    return cast("Callable[P, R]", ask)
