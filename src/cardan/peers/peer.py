"""Adapters of other programs, and the contestants they give."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field
from typing import Any

from ..api.comparison import Scene
from ..arrays import Array
from ..records import dataclass

# what is compared; derivatives are those of forward dynamics by q and u
FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "derivatives")


@dataclass(frozen=True)
class States:
    """States at which functions are called, in our coordinates.

    Attributes:
        q: (n, nq). u: (n, nu).
        third: (n, nu): tau of forward dynamics and its derivatives, udot of inverse dynamics.
    """

    q: Array
    u: Array
    third: Array

    def __len__(self) -> int:
        return len(self.q)


@dataclass(frozen=True)
class Contender:
    """A program that can be called on one mechanism.

    Attributes:
        title: Program, version, compiler.
        functions: What it can do, of ``FUNCTIONS``.
        start: ``start(function, states)`` makes a run ready: ``run(repeats)`` calls the function
            so often at every state and returns the seconds per call.
        results: ``results(function, states)`` in our coordinates, (n, ...); derivatives (n, 2, nu,
            nu) by q and by u.
        references: What must stay alive meanwhile.
    """

    title: str
    functions: tuple[str, ...]
    start: Callable[[str, States], Callable[[int], float]] = field(repr=False)
    results: Callable[[str, States], Array] = field(repr=False)
    references: tuple[Any, ...] = field(default=(), repr=False)


@dataclass(frozen=True)
class Peer:
    """Another program.

    Attributes:
        name: As people call it.
        package: What to install from PyPI.
        missing: Why it cannot take part here, "" if it can.
        refusal: Why it cannot take part on a tree with joints of these names, "" if it can.
        contender: Makes the program for a mechanism.
        closed: Makes it for a mechanism with loops; None where it has none.
    """

    name: str
    package: str
    missing: Callable[[], str] = field(repr=False)
    refusal: Callable[[Scene, Sequence[str]], str] = field(repr=False)
    contender: Callable[[Scene], Contender] = field(repr=False)
    closed: Callable[[Any], Contender] | None = field(repr=False, default=None)


def installed(module: str, package: str) -> str:
    """Message where a module is missing, "" where it is installed."""
    from importlib.util import find_spec

    return "" if find_spec(module) else f"not installed: pip install {package}"
