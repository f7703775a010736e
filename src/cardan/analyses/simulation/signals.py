"""Inputs of a run: constants, values at times, functions of the user."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from inspect import Signature, signature
from typing import Any

import numpy as np

from ...arguments import Inputs
from ...arrays import Array
from ...errors import ArgumentError, FunctionError, ModelError, SolveError, brief, named, near
from ...records import dataclass
from ...runtime.calls.argument_values import numbers
from ...runtime.trajectory.input_history import PiecewiseInput, Recorded
from ...schema.entries import Entry
from .input_functions import CEntry, CFunction

InputFunction = Callable[[float, Array], float]


@dataclass(frozen=True)
class Checked:
    """A function of the caller, whose result must be a number.

    Attributes:
        who: What it is, for messages.
        function: f(t, x), or f(t).
        of_state: Whether it takes x.
    """

    who: str
    function: Callable[..., float]
    of_state: bool = True

    def __call__(self, t: float, x: Array) -> float:
        """The result.

        Raises:
            FunctionError: it is not a number, or the function raised, which is the cause.
        """
        try:
            value = self.function(t, x) if self.of_state else self.function(t)
        except Exception as problem:
            what = f"{type(problem).__name__}: {problem}"
            raise FunctionError(f"{self.who} raised at t = {t:.9g} s: {what}") from problem
        try:
            return float(value)
        except (TypeError, ValueError):
            at = f"at t = {t:.9g} s"
            one = np.size(value) == 1 and np.ndim(value) > 0
            cure = ". Return its entry, such as float(value[0])" if one else ""
            raise FunctionError(
                f"{self.who} gave {brief(value)}, which is not a number, {at}{cure}"
            ) from None


@dataclass(frozen=True)
class Signals:
    """All inputs of a run.

    Attributes:
        constants: r (nr,) with defaults and constants in place.
        tabulated: Inputs by values at times.
        functions: Index in r -> f(t, x), or its place in what a C function gives.
        sample: Time between two calls of the functions, None to call them at every stage [s].
        defaulted: Names of the inputs that were not given.
    """

    constants: Array
    tabulated: tuple[PiecewiseInput, ...]
    functions: dict[int, InputFunction | CEntry]
    sample: float | None
    defaulted: tuple[str, ...]

    def corners(self, start: float, end: float) -> list[float]:
        """Times strictly inside a span, in its direction, at which a step must end."""
        low, high = min(start, end), max(start, end)
        corners = {float(t) for signal in self.tabulated for t in signal.breaks if low < t < high}
        if self.functions and self.sample is not None:
            # samples lie on a grid from the start
            count = math.ceil((high - low) / self.sample - 1e-9)
            sign = 1 if end > start else -1
            corners |= {start + sign * k * self.sample for k in range(1, count)}
        return sorted(corners, reverse=end < start)

    def first(self, t: float) -> Array:
        """r (nr,) at the start; functions, which prescribe no motion, are not asked."""
        if not self.tabulated:
            return self.constants.copy()
        row: Array = self.recorded(np.array([t]), self.constants[None])(np.array([t]))[0]
        return row

    def recorded(self, t: Array, r: Array) -> Recorded:
        """The inputs of a run with values r (nt, nr) at its times t (nt,)."""
        called = tuple(self.functions)
        return Recorded(self.constants, self.tabulated, called, self.sample is not None, t, r)


def signals(
    rows: Sequence[Entry], values: Inputs | None, sample: float | None, span: tuple[float, float]
) -> Signals:
    """Inputs as they are given to ``simulate``.

    Args:
        rows: ``manifest.inputs``: name, unit, default.
        values: Name -> constant, ``(times, values)`` or ``f(t, x)``; of a function in C the names
            of all inputs that it gives.
        sample: Sampling time of the functions [s].
        span: Start and end of the run [s].

    Raises:
        ModelError: an unknown name; a function for a prescribed motion; values that do not cover
            the run; a sampling time without functions.
        ArgumentError: wrong shape. SolveError: a value that is not finite.
    """
    names = [str(row.name) for row in rows]
    settable = [n for n in names if not _derived(n, names)]
    constants = np.array([row.default or 0.0 for row in rows], dtype=np.float64)
    tabulated: list[PiecewiseInput] = []
    functions: dict[int, InputFunction | CEntry] = {}
    values = one_by_one(values)
    for name, value in named(
        "inputs", values, f"'{settable[0] if settable else 'force'}': 1.0"
    ).items():
        if name not in names:
            raise ModelError(f"inputs: there is no input '{name}'.{near(name, settable)}")
        k = names.index(name)
        if isinstance(value, CEntry):
            _refuse_motion(name, names)
            functions[k] = value
        elif callable(value):
            _refuse_motion(name, names)
            functions[k] = checked(f"inputs: the function of '{name}'", value)
        elif isinstance(value, tuple | list):
            tabulated += _table(name, k, value, f"{name}.rate" in names, span)
        else:
            constants[k] = _number(name, value)
    if sample is not None and not functions:
        raise ModelError("sample= is the time between two calls of input functions; none is given")
    if sample is not None and not (math.isfinite(sample) and sample > 0):
        raise ModelError(f"sample={sample:g}: the time between two calls must be positive")
    left = tuple(n for n in settable if n not in (values or {}))
    return Signals(constants, tuple(tabulated), functions, sample, left)


def one_by_one(values: Inputs | None) -> Inputs | None:
    """Values by the name of one input each, also those that a function in C gives together.

    Raises:
        ModelError: one input twice, a C function that stands for inputs at two places, several
            names of something else.
    """
    if values is None:
        return values
    single: dict[object, object] = {}
    for key, value in values.items():
        several = isinstance(key, tuple) and bool(key) and all(isinstance(n, str) for n in key)
        if not several and not isinstance(key, str):
            raise ModelError(
                f"inputs: {brief(key)}: give the name of an input, or names of several"
            )
        if several and not isinstance(value, CFunction):
            raise ModelError(
                f"inputs: {', '.join(key)}: several names go with a cd.CFunction, which gives all"
            )
        keys = key if several else (key,)
        if isinstance(value, CFunction):
            if any(isinstance(one, CEntry) and one.function == value for one in single.values()):
                raise ModelError(f"inputs: {value} twice: name all that it gives in one tuple")
            entries: list[object] = [CEntry(value, place) for place in range(len(keys))]
        else:
            entries = [value]
        for name, entry in zip(keys, entries, strict=True):
            if name in single:
                raise ModelError(f"inputs: '{name}' is given twice")
            single[name] = entry
    return single


def _derived(name: str, names: Sequence[str]) -> bool:
    """True when an entry of r is the rate or acceleration of another input."""
    base, _, last = name.rpartition(".")
    return last in ("rate", "acceleration") and base in names


def _refuse_motion(name: str, names: Sequence[str]) -> None:
    base = name.rpartition(".")[0] if _derived(name, names) else name
    if f"{base}.rate" in names:
        raise ModelError(
            f"inputs: '{base}' prescribes a motion, which needs rate and acceleration too: give "
            "(times, values), a constant, or write prescribed= as an expression in cd.t"
        )


def checked(who: str, function: Callable[..., float]) -> Checked:
    """A function that can be called with (t, x) or with t, as far as it can be told beforehand.

    Args:
        who: What it is, for messages.
        function: f(t, x), or f(t).

    Raises:
        ArgumentError: it takes something else, or the state would replace a default.
    """
    if isinstance(function, np.ufunc):
        # what it takes behind its numbers are places for results
        return Checked(who, function, of_state=function.nin > 1)
    try:
        arguments = signature(function)
    except ValueError:
        # built-in functions do not tell
        return Checked(who, function)
    if _binds(arguments, 0.0, None):
        second = [*arguments.parameters.values()][1:2]
        for one in second:
            if one.default is not one.empty:
                raise ArgumentError(
                    f"{who}: the state x would replace the default of '{one.name}': take (t, x, "
                    f"{one.name}=...), or (t, *, {one.name}=...) where x is not needed"
                )
        return Checked(who, function)
    if _binds(arguments, 0.0):
        return Checked(who, function, of_state=False)
    raise ArgumentError(f"{who} must take (t, x), time and state, or t alone; it takes {arguments}")


def _binds(arguments: Signature, *values: object) -> bool:
    """True if a function takes such positional arguments."""
    try:
        arguments.bind(*values)
    except TypeError:
        return False
    return True


def _number(name: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ArgumentError(
            f"inputs: '{name}' is {brief(value)}; give a number, (times, values) or a "
            "function f(t, x)"
        ) from None
    if not math.isfinite(number):
        raise SolveError(f"inputs: '{name}' is {number}. Every input must be finite")
    return number


def _table(
    name: str, k: int, value: Sequence[object], moves: bool, span: tuple[float, float]
) -> list[PiecewiseInput]:
    """Pieces through values at times: straight lines, or a smooth curve for a motion."""
    if len(value) != 2:
        raise ArgumentError(f"inputs: '{name}' has {len(value)} parts, expected (times, values)")
    times, values = (numbers(f"inputs: '{name}'", v) for v in value)
    _check_table(name, times, values, span)
    if moves:
        return _motion(name, k, times, values)
    # a jump is a time that stands twice
    width = np.diff(times)
    slope = np.divide(np.diff(values), width, out=np.zeros_like(width), where=width > 0)
    flat = np.zeros_like(slope)
    return [PiecewiseInput(k, times, np.stack([values[:-1], slope, flat, flat], axis=1))]


def _motion(name: str, k: int, times: Array, values: Array) -> list[PiecewiseInput]:
    """Value, rate and acceleration of a prescribed motion: a cubic spline and its derivatives;
    through three points a parabola, through two a straight line.
    """
    from scipy.interpolate import CubicSpline

    if not (np.diff(times) > 0).all():
        raise ModelError(
            f"inputs: '{name}' prescribes a motion, which has no jumps: give no time twice, so "
            "that rate and acceleration exist"
        )
    spline = CubicSpline(times, values)
    signals = []
    for order in range(3):
        c = (spline.derivative(order) if order else spline).c[::-1].T
        full = np.zeros((len(times) - 1, 4))
        full[:, : c.shape[1]] = c
        signals.append(PiecewiseInput(k + order, times, full))
    return signals


def _check_table(name: str, times: Array, values: Array, span: tuple[float, float]) -> None:
    if times.ndim != 1 or times.shape != values.shape or len(times) < 2:
        raise ArgumentError(
            f"inputs: '{name}' has times of shape {times.shape} and values of shape "
            f"{values.shape}; expected two equal lengths of at least 2"
        )
    for what, row in (("time", times), ("value", values)):
        bad = np.flatnonzero(~np.isfinite(row))
        if len(bad):
            raise SolveError(f"inputs: '{name}': {what} {bad[0]} is {row[bad[0]]}")
    if (np.diff(times) < 0).any():
        raise ModelError(f"inputs: the times of '{name}' must ascend; a time twice is a jump")
    if times[0] > min(span) or times[-1] < max(span):
        raise ModelError(
            f"inputs: '{name}' has values from {times[0]:g} s to {times[-1]:g} s, the run goes "
            f"from {min(span):g} s to {max(span):g} s. Add values at its ends"
        )
