"""Absurd arguments, and workers in which public functions are called with them."""

from __future__ import annotations

import inspect
import os
import pickle
import re
import resource
import signal
import tempfile
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from decimal import Decimal
from fractions import Fraction
from functools import partial
from importlib import import_module
from itertools import product
from numbers import Real
from pathlib import Path
from typing import Any

import numpy as np
import scipy.signal  # noqa: F401
import sympy

import cardan as cd
from cardan.errors import brief

# here: an import that a limit of time ends stays broken
with suppress(ImportError):
    import matplotlib.pyplot  # noqa: F401

MEMORY = 4 << 30  # bytes of addresses that a worker may have more than its parent
PATIENCE = 2.0  # seconds that one call may take: long runs are not fault
# how Python says that a call does not fit a signature
FIT = re.compile(
    r"\((missing|got (an unexpected|multiple|some)|takes|too many)|\(\) (missing|got|takes)"
)


def absurd() -> dict[str, Any]:
    """About 50 arguments that fit almost nowhere, by what they are."""
    x = sympy.Symbol("x")
    nested: list[Any] = []
    for _ in range(3000):
        nested = [nested]
    return {
        "None": None,
        "True": True,
        "False": False,
        "0": 0,
        "1": 1,
        "-1": -1,
        "2**63": 2**63,
        "10**30": 10**30,
        "-10**30": -(10**30),
        "10**400": 10**400,
        "0.5": 0.5,
        "-0.5": -0.5,
        "1e300": 1e300,
        "1e-300": 1e-300,
        "nan": float("nan"),
        "inf": float("inf"),
        "-inf": float("-inf"),
        "1j": 1j,
        "''": "",
        "'x'": "x",
        "'no such name'": "no such name",
        "'nul'": "a\0b",
        "'long'": "a" * 10_000,
        "bytes": b"x",
        "[]": [],
        "()": (),
        "{}": {},
        "set()": set(),
        "[1]": [1],
        "[.1, .2]": [0.1, 0.2],
        "(0, 1, 2)": (0, 1, 2),
        "[nan, 1]": [float("nan"), 1.0],
        "['x']": ["x"],
        "[None]": [None],
        "ragged": [[1, 2], [3]],
        "nested": nested,
        "{'nope': 1}": {"nope": 1},
        "{'': None}": {"": None},
        "{1: 2}": {1: 2},
        "{'a': 'b'}": {"a": "b"},
        "object": object(),
        "class": int,
        "function": lambda *given: None,
        "raises": _raises,
        "array()": np.array(1.0),
        "array(0)": np.zeros(0),
        "array(2, 2)": np.zeros((2, 2)),
        "array of text": np.array(["a", "b"]),
        "array of objects": np.array([None, {}], dtype=object),
        "array of complex": np.array([1j, 2j]),
        "x": x,
        "1/x": 1 / x,
        "path": Path("/no/such/place"),
        "generator": (k for k in (1, "a")),
        "slice": slice(None),
        "fraction": Fraction(1, 3),
        "decimal": Decimal("1e400"),
        "date": date(2000, 1, 1),
    }


OWN = "raised by a function of the caller"


def _raises(*given: Any) -> Any:
    raise KeyError(OWN)


class Late(BaseException):
    """A call took its time."""


@dataclass(frozen=True)
class Leak:
    """A call that ended in anything else than a result or an error of cardan."""

    call: str
    error: str
    where: str

    def __str__(self) -> str:
        return f"{self.call}: {self.error} [{self.where}]"


@dataclass
class Count:
    """How many calls ended how."""

    answered: int = 0
    refused: int = 0
    late: int = 0

    @property
    def calls(self) -> int:
        return self.answered + self.refused + self.late


def options_of(function: Callable[..., Any]) -> dict[str, inspect.Parameter]:
    """Named arguments, those behind ``**options`` too: the docstring says whose they are."""
    own = inspect.signature(function).parameters
    found = {n: p for n, p in own.items() if p.kind not in (p.VAR_KEYWORD, p.VAR_POSITIONAL)}
    if any(p.kind is p.VAR_KEYWORD for p in own.values()):
        for path in re.findall(r":(?:func|class):`cardan\.([\w.]+)`", function.__doc__ or ""):
            room, name = path.rsplit(".", 1)
            for n, p in inspect.signature(
                getattr(import_module(f"cardan.{room}"), name)
            ).parameters.items():
                if p.kind is p.KEYWORD_ONLY:
                    found.setdefault(n, p)
    return {n: p for n, p in found.items() if n not in ("self", "model") and n[0] != "_"}


def judged(
    name: str,
    function: Callable[..., Any],
    given: Mapping[str, Any],
    every: int = 1,
    first: int = 0,
) -> tuple[Count, list[Leak]]:
    """Call a function with each absurd argument in the place of each of its own, in a worker.

    Args:
        name: For what is printed.
        function: Bound, if it is a method.
        given: Arguments with which it works.
        every, first: One of so many calls, counted from the first.
    """
    count, leaks = Count(), []
    for key, leak in _in_worker(name, partial(_work, name, function, given, every, first)):
        if leak is not None:
            leaks.append(leak)
        else:
            setattr(count, key, getattr(count, key) + 1)
    return count, leaks


def _in_worker(name: str, work: Callable[[Any], None]) -> Iterator[tuple[str, Leak | None]]:
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        with os.fdopen(writing, "wb", buffering=0) as out:
            code = 1
            try:
                work(out)
                code = 0
            finally:
                os._exit(code)
    os.close(writing)
    last = f"{name}: the start"
    with os.fdopen(reading, "rb") as lines:
        while True:
            try:
                kind, told = pickle.load(lines)
            except EOFError:
                break
            if kind == "call":
                last = told
            elif kind == "leak":
                yield kind, told
            else:
                yield kind, None
    status = os.waitpid(child, 0)[1]
    if status:
        ended = os.WIFSIGNALED(status)
        number = signal.Signals(os.WTERMSIG(status)).name if ended else "an error of the test"
        yield "leak", Leak(last, f"the worker ended by {number}", "C")


def _limit() -> None:
    used = int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY, used + MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (600, 600))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 28, 1 << 28))


def _work(
    name: str,
    function: Callable[..., Any],
    given: Mapping[str, Any],
    every: int,
    first: int,
    out: Any,
) -> None:
    """What a worker does: all calls, each told before and after."""

    def late(*_: Any) -> None:
        raise Late

    _limit()
    os.chdir(tempfile.mkdtemp())
    warnings.simplefilter("ignore")
    signal.signal(signal.SIGALRM, late)
    null = os.open(os.devnull, os.O_RDWR)
    for stream in (1, 2):
        os.dup2(null, stream)
    # what is refused whatever the arguments are needs to name none of them
    always = _refusal(function, given)
    for k, (argument, what) in enumerate(product(options_of(function), absurd())):
        if k % every != first % every:
            continue
        # made anew: generators are used up, and arrays may be written to
        value = absurd()[what]
        pickle.dump(("call", f"{name}({argument}={what})"), out)
        call = {**given, argument: value}
        pickle.dump(_answer(name, function, call, argument, what, always), out)


def _refusal(function: Callable[..., Any], given: Mapping[str, Any]) -> str:
    """How a call with arguments that fit is refused; "" where it is not."""
    try:
        signal.setitimer(signal.ITIMER_REAL, PATIENCE)
        try:
            function(**given)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except cd.CardanError as error:
        return str(error)
    except BaseException:
        # arguments that do not fit the signature, or what the calls below find
        return ""
    return ""


def _answer(
    name: str,
    function: Callable[..., Any],
    given: dict[str, Any],
    argument: str,
    what: str,
    always: str,
) -> tuple[str, Leak | None]:
    """How a call ended, and the leak if it is one."""
    try:
        signal.setitimer(signal.ITIMER_REAL, PATIENCE)
        try:
            function(**given)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except cd.CardanError as error:
        if (
            str(error) == always
            or OWN in str(error)
            or names(str(error), argument, given[argument])
        ):
            return "refused", None
        return "leak", _leak(name, argument, what, error)
    except Late:
        return "late", None
    except BaseException as error:
        unfit = isinstance(error, TypeError) and FIT.search(str(error)) and not _deep(error)
        if unfit or OWN in str(error):
            return "refused", None
        return "leak", _leak(name, argument, what, error)
    return "answered", None


# what arguments are called in messages of functions that many others use
ALSO = {
    "r": ("inputs", "input"),
    "x": ("x0", "state"),
    "y": ("q", "u"),
    "q1": ("q",),
    "t_eval": ("t",),
    "motion": ("data",),
    "frame_a": ("frame"),
    "frame_b": ("frame",),
    "of": ("frame", "joint"),
    "function": ("derivative",),
}


def names(message: str, argument: str, value: Any) -> bool:
    """Whether a message says which argument is meant: by its name, or by what was given."""
    words = (argument.rstrip("_").removesuffix("s"), *ALSO.get(argument, ()))
    if any(re.search(rf"(?<![a-z]){word}s?(?![a-z])", message) for word in words):
        return True
    if isinstance(value, str) and value and message.startswith(value[:30]):
        return True
    parts = [value]
    if isinstance(value, Mapping):
        parts += [*value, *value.values()]
    elif isinstance(value, list | tuple):
        parts += value
    elif isinstance(value, np.ndarray):
        parts += list(value.flat)
    return any(text in message for one in parts for text in _told(one))


def _told(value: Any) -> list[str]:
    """How messages show a value."""
    found = [brief(value)]
    if isinstance(value, str):
        found += [f"'{value[:30]}", f"{value[:30]}:"] if value else ["''"]
    if isinstance(value, Path | sympy.Basic):
        found += [str(value), f"'{getattr(value, 'name', value)}'"]
    if isinstance(value, Real) and not isinstance(value, bool) and abs(value) < 10**300:
        found.append(f"{float(value):g}")
    return found


def _leak(name: str, argument: str, what: str, error: BaseException) -> Leak:
    text = f"{type(error).__name__}: {str(error)[:150]}"
    return Leak(f"{name}({argument}={what})", text, " < ".join(reversed(_places(error)[-3:])))


def _places(error: BaseException) -> list[str]:
    """Where an error went through, from the call down."""
    trace, places = error.__traceback__, []
    while trace is not None:
        file = Path(trace.tb_frame.f_code.co_filename)
        places.append(f"{file.parent.name}/{file.name}:{trace.tb_lineno}")
        trace = trace.tb_next
    return places


def _deep(error: BaseException) -> bool:
    """Whether an error comes from below the call itself and the check of its arguments."""
    own = f"{Path(__file__).parent.name}/{Path(__file__).name}:"
    here = (own, "cardan/arguments.py:", "api/faces.py:")
    return not all(place.startswith(here) for place in _places(error))
