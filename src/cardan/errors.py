"""The errors cardan raises. Each says what, where (the user's names) and what to do."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from functools import wraps
from typing import Any, ParamSpec, TypeVar


class CardanError(Exception):
    """Any error of cardan."""


class ModelError(CardanError, ValueError):
    """The scene or a file that describes it is at fault."""


class TopologyError(CardanError, ValueError):
    """The bodies and joints do not form a usable graph."""


class DerivationError(CardanError, ValueError):
    """Equations of the asked kind do not exist for this system."""


class CodegenError(CardanError, ValueError):
    """C cannot be written for a function."""


class BuildError(CardanError, RuntimeError):
    """A compiler is missing or failed, or a build did not pass its check."""


class CompilerMissing(BuildError):
    """There is no C compiler here; functions are evaluated in NumPy then."""


class ArgumentError(CardanError, ValueError, TypeError):
    """An argument of a function is missing, or is not of the kind or shape it must have."""


class FunctionError(ArgumentError):
    """A function that the caller gave raised in a run, or gave no number.

    Attributes:
        motion: What ``simulate`` had computed until then, a :class:`cardan.Trajectory`; None
            elsewhere.
    """

    motion: Any = None


class SolveError(CardanError, ArithmeticError):
    """Numbers failed: a state outside its domain, a singular matrix, a run that broke down."""


class BuildWarning(UserWarning):
    """Compiled code is kept elsewhere than it should be, or there is none."""


class SolveWarning(UserWarning):
    """Numbers failed, but what was computed is kept."""


def listed(word: str, given: object, example: str) -> list[str]:
    """Names out of what the user gave; one alone stands for itself.

    Raises:
        ModelError: they are no names.
    """
    names = [given] if isinstance(given, str) else given
    found = [*names] if isinstance(names, Iterable) else [None]
    if not all(isinstance(name, str) for name in found):
        raise ModelError(f"{word}={given!r}: give a list of names, such as ['{example}']")
    return [str(name) for name in found]


def named(word: str, given: object, example: str) -> Mapping[str, Any]:
    """Values by name, as the user gave them; nothing of None.

    Raises:
        ModelError: it is something else.
    """
    if given is None:
        return {}
    if not isinstance(given, Mapping) or not all(isinstance(name, str) for name in given):
        raise ModelError(f"{word}={given!r}: give names with values, such as {word}={{{example}}}")
    return given


P = ParamSpec("P")
R = TypeVar("R")


def spelled(function: Callable[P, R]) -> Callable[P, R]:
    """A function that tells misspelt arguments by the near ones.

    Raises:
        ArgumentError: on a call with a keyword that it does not have.
    """
    code = function.__code__
    known = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]

    @wraps(function)
    def called(*given: P.args, **named: P.kwargs) -> R:
        unknown = next((name for name in named if name not in known), None)
        if unknown is None:
            return function(*given, **named)
        names = [name for name in known if name not in ("self", "model")]
        raise ArgumentError(
            f"{function.__name__}({unknown}=...): there is no such argument.{near(unknown, names)}"
        )

    return called


def near(name: str, known: Iterable[str]) -> str:
    """The end of an error message: the known names, and the likely one.

    Returns:
        Such as ``" Known: base, upper, forearm. Did you mean 'forearm'?"``.
    """
    names = list(known)
    listed = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    close = [one for one in names if one.casefold() == name.casefold()]
    close = close or get_close_matches(name, names, n=1)
    hint = f" Did you mean '{close[0]}'?" if close else ""
    return f" Known: {listed}.{hint}" if names else " There are none."
