"""Derivatives that are asked for again and again, made once."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from inspect import signature
from typing import ParamSpec, TypeVar, cast

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
        key = name, function, EVERYTHING if wrt is STANDARD else listed, type(listed)
        try:
            existing: R | None = None if named else model._derived.get(key)
        except TypeError:
            # something in it is no name: the request says what
            existing = None
        if existing is None:
            existing = plain(model, function, wrt, **named)
            if type(function) in (str, tuple):
                model._derived[key] = existing
        return existing

    return cast("Callable[P, R]", ask)
