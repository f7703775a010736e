"""The errors cardan raises. Each says what, where (the user's names) and what to do."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from difflib import get_close_matches
from reprlib import Repr
from typing import Any
from unicodedata import normalize


class CardanError(Exception):
    """Any error of cardan."""


class ModelError(CardanError, ValueError):
    """The scene or a file that describes it is at fault."""


class TopologyError(CardanError, ValueError):
    """The bodies and joints do not form a usable graph."""


class DerivationError(CardanError, ValueError):
    """Equations of the asked kind do not exist for this system."""


class StructuralZero(DerivationError, ZeroDivisionError):
    """Expressions of a scene divide by what is zero at all of its states."""


class CodegenError(CardanError, ValueError):
    """C cannot be written for a function."""


class BuildError(CardanError, RuntimeError):
    """A compiler is missing or failed, or a build did not pass its check."""


class CompilerMissing(BuildError):
    """There is no C compiler here; functions are evaluated in Python then."""


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


class NoteOnFiles(str):
    """A note on the files of this machine, which neither scenes nor models that are saved keep."""

    __slots__ = ()


def lasting(notes: Iterable[str]) -> list[str]:
    """Notes without those on the files of this machine."""
    return [note for note in notes if not isinstance(note, NoteOnFiles)]


class ModelWarning(UserWarning):
    """Something in a scene that may not be meant."""


class ImpossibleWarning(ModelWarning):
    """Numbers of a scene that nothing real has; ``cardan check`` counts them as errors."""


class BuildWarning(UserWarning):
    """Compiled code is kept elsewhere than it should be, or there is none."""


class SolveWarning(UserWarning):
    """Numbers failed, but what was computed is kept."""


# of the runs of an ensemble, whose threads have no line of the caller; None elsewhere
_COLLECTED: ContextVar[list[str] | None] = ContextVar("collected", default=None)


@contextmanager
def collected_warnings() -> Iterator[list[str]]:
    """Messages of warnings of models and numbers in this thread, which are not given meanwhile."""
    messages: list[str] = []
    token = _COLLECTED.set(messages)
    try:
        yield messages
    finally:
        _COLLECTED.reset(token)


# while something runs whose result depends on whether it warns
_WATCHED: ContextVar[list[str] | None] = ContextVar("watched", default=None)


@contextmanager
def watched_warnings() -> Iterator[list[str]]:
    """Messages of the warnings of this thread, which are given nevertheless."""
    messages: list[str] = []
    token = _WATCHED.set(messages)
    try:
        yield messages
    finally:
        _WATCHED.reset(token)


def warn(message: str, category: type[Warning]) -> None:
    """Warn at the line of the caller's code, however deep in cardan the reason was found."""
    watched = _WATCHED.get()
    if watched is not None:
        watched.append(message)
    messages = _COLLECTED.get()
    if messages is not None and not issubclass(category, BuildWarning):
        messages.append(message)
        return
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and _inside(frame.f_globals.get("__name__", "")):
        frame, level = frame.f_back, level + 1
    warnings.warn(message, category, stacklevel=level)


def _inside(module: str) -> bool:
    return module.partition(".")[0] in ("cardan", "contextlib")


def counted(number: int, one: str, many: str = "") -> str:
    """A number with its noun, such as ``"1 body"``, ``"2 bodies"``.

    Args:
        number: How many.
        one, many: The noun; many is one with an s if left out.
    """
    return f"{number} {one if number == 1 else many or one + 's'}"


def miscounted(where: str, size: int, entries: Sequence[str]) -> str:
    """Why so many values do not fit the entries that they are given for."""
    names = ", ".join(entries)
    return f"{where}: {counted(size, 'value')}, expected {len(entries)}: {names}"


def listed(word: str, argument: object, example: str) -> list[str]:
    """Names out of what the user gave; one alone stands for itself.

    Raises:
        ModelError: they are not names.
    """
    names = [argument] if isinstance(argument, str) else argument
    entries = [*names] if isinstance(names, Iterable) else [None]
    if not all(isinstance(name, str) for name in entries):
        raise ModelError(f"{word}={brief(argument)}: give a list of names, such as ['{example}']")
    return [str(name) for name in entries]


def named(word: str, values: object, example: str) -> Mapping[str, Any]:
    """Values by name, as the user gave them; nothing of None.

    Raises:
        ModelError: it is something else.
    """
    if values is None:
        return {}
    if not isinstance(values, Mapping) or not all(isinstance(name, str) for name in values):
        raise ModelError(
            f"{word}={brief(values)}: give names with values, such as {word}={{{example}}}"
        )
    return values


def brief(value: object, most: int = 60) -> str:
    """A value in an error message: short, and never an error of its own."""
    shortened = _SHORT.repr(value)
    return shortened if len(shortened) <= most else f"{shortened[: most - 4]} ..."


_SHORT = Repr()
_SHORT.maxlevel, _SHORT.maxstring, _SHORT.maxother, _SHORT.maxlong = 3, 60, 60, 60


# letters of other alphabets that look like Latin ones
_ALIKE = str.maketrans(
    "аеѕіјорсухАВЕЅІЈКМНОРСТУХһԁԛԝΑΒΕΖΗΙΚΜΝΟΡΤΥΧονı",
    "aesijopcyxABESIJKMHOPCTYXhdqwABEZHIKMNOPTYXovi",
)


def looks(name: str) -> str:
    """Appearance of a name: equal for names that differ to a program but not to the eye."""
    return normalize("NFC", normalize("NFD", name).translate(_ALIKE))


def points(name: str) -> str:
    """A name with the code points that are not ASCII: ``'pеn' (U+0435)``."""
    foreign = ", ".join(f"U+{ord(letter):04X}" for letter in name if ord(letter) > 127)
    return f"'{name}' ({foreign or 'ASCII'})"


def near(name: object, candidates: Iterable[str]) -> str:
    """The end of an error message: the known names, and the likely one.

    Returns:
        Such as ``" Known: base, upper, forearm. Did you mean 'forearm'?"``.
    """
    # a set has another order in every process
    names = sorted(candidates) if isinstance(candidates, set | frozenset) else list(candidates)
    name = name if isinstance(name, str) else ""
    listed = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
    close = likely(name, names)
    same = [one for one in names if one != name and looks(one) == looks(name)]
    # base.x of a free joint may be base.qx or base.px
    head, _, last = name.rpartition(".")
    close = [
        f"{head}.{letter}{last}" for letter in "qp" if f"{head}.{letter}{last}" in names
    ] or close
    options = " or ".join(f"'{one}'" for one in close)
    hint = f" Did you mean {options}?" if close else ""
    if same:
        hint = f" Did you mean {points(same[0])}? It only looks like {points(name)}."
    return f" Known: {listed}.{hint}" if names else " There are none."


def likely(name: str, names: Sequence[str]) -> list[str]:
    """Names that a misspelt one may stand for: those that differ in case, or else the nearest."""
    same = [one for one in names if one.casefold() == name.casefold()]
    return same or get_close_matches(name, names, n=1)


def outside(value: float, lower: float | None, upper: float | None, unit: str = "") -> str:
    """Why a coordinate is not within the limits of its joint, in words; "" where it is."""
    unit = f" {unit}".rstrip()
    if lower is not None and value < lower:
        past = f"below the lower limit {lower:g}{unit}"
    elif upper is not None and value > upper:
        past = f"above the upper limit {upper:g}{unit}"
    else:
        return ""
    return f"the start {value:g}{unit} is {past}, and joint limits are ignored: give another start"
