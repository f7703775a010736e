"""Arguments that every kind of run takes: the start, the method, its tolerances."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import (
    ArgumentError,
    ModelError,
    ModelWarning,
    SolveError,
    brief,
    near,
    outside,
    warn,
)
from ...records import dataclass
from ...runtime.calls.argument_values import numbers
from ...runtime.models.initial import start_of
from ...runtime.models.loaded_model import LoadedModel
from ...schema.integrators import INTEGRATORS, Integrator
from ...schema.rows import having
from .alpha_methods import Alpha, GeneralizedAlpha, method_of
from .signals import Signals

Values = Mapping[str, ArrayLike]
DEFAULT = "DOP853"
MOST_STEPS = 1e12
STEPS = 10_000  # of a fixed step without step=
# where none is given. Derivatives have the error of their motion, and whoever descends along them
# compares costs that lie close together
RTOL, DERIVATIVE_RTOL = 1e-6, 1e-9
LARGEST_ATOL, RATIO = 1e-9, 1e-3  # atol where none is given: at most, and of rtol
PARTS = 1000  # of the span: longest step past functions of the caller, which tell nothing ahead
VOID = 10  # times rtol: an atol above that decides about all entries up to such a size
SMALLEST = 1e-100  # squares of errors over an atol below this overflow
TIGHTEST = 2.5e-14  # below this rtol the error of a step drowns in rounding


@dataclass(frozen=True)
class Settings:
    """Settings of the solver.

    Attributes:
        method: The integrator.
        rtol, atol: Tolerances of an adaptive one.
        step: Step of a fixed one, first step of an adaptive one (0: it chooses) [s].
        max_step: Largest step of an adaptive one [s].
        description: The same to print.
        reason: Why this method, where nobody asked for it.
    """

    method: Integrator
    rtol: float
    atol: float
    step: float
    max_step: float
    description: str
    reason: str = ""

    def by(self, method: Integrator, reason: str) -> Settings:
        """The same with another method."""
        limits = self.rtol, self.atol, self.step, self.max_step
        return Settings(method, *limits, self.description, reason)


def default_rtol(rtol: float | None, sensitivity: str | Sequence[str]) -> float:
    """The tolerance as it was given, else that of motions, or of those with sensitivities."""
    if rtol is not None:
        return rtol
    return DERIVATIVE_RTOL if sensitivity else RTOL


def settings(
    method: str | GeneralizedAlpha | Alpha,
    rtol: float,
    atol: float | None,
    step: float | None,
    max_step: float | None,
    length: float | None,
) -> Settings:
    """Checked settings.

    Args:
        method: Name of an integrator, or ``"auto"``; or one with choices of its own.
        rtol, atol, step, max_step: As ``simulate`` takes them; atol None: as rtol has it.
        length: Duration of the run, None if it has no end yet [s].

    Raises:
        ModelError: an unknown method, a number that is not positive, an option that the method
            does not take.
    """
    chosen = integrator(method)
    if chosen.fixed_step_on_request and step is not None:
        chosen = replace(chosen, adaptive=False)
    atol = matching_atol(rtol) if atol is None else atol
    for name, value in (("rtol", rtol), ("atol", atol)):
        if not isinstance(value, int | float | np.number):
            raise ModelError(
                f"{name}={brief(value)}: one number is wanted, for all entries of the state"
            )
        if not (math.isfinite(value) and value >= 0) or rtol == atol == 0:
            raise ModelError(f"{name}={value:g}: tolerances are positive numbers, one may be 0")
    # below the rounding of the state the controller would never accept a step
    if rtol == 0 and atol < SMALLEST:
        raise ModelError(
            f"atol={atol:g}: no error is as small as that; with rtol=0 give {SMALLEST:g} or more"
        )
    for name, option in (("step", step), ("max_step", max_step)):
        if option is not None and not (math.isfinite(option) and option > 0):
            raise ModelError(f"{name}={option:g}: it must be a positive time [s]")
    if not chosen.adaptive:
        return _fixed(chosen, step, max_step, length)
    description = f"rtol {rtol:g}, atol {atol:g}"
    if 0 < rtol < TIGHTEST:
        description += f" (as {TIGHTEST:g}: double precision ends there)"
        rtol = TIGHTEST
    if rtol * VOID < atol and rtol > 0:
        description += f" (atol decides: rtol counts for entries above {atol / rtol:.2g} alone)"
    description += f", first step {step:g} s" if step is not None else ""
    description += f", steps up to {max_step:g} s" if max_step is not None else ""
    return Settings(chosen, rtol, atol, step or 0.0, max_step or math.inf, description)


def watched(
    how: Settings, input_signals: Signals, length: float, max_step: float | None
) -> Settings:
    """Settings whose steps are short enough to notice what input functions do.

    Args:
        how: The settings.
        input_signals: The inputs.
        length: Duration of the run [s].
        max_step: What the caller said about it; None: nothing.
    """
    continuous = input_signals.functions and input_signals.sample is None
    if not continuous or max_step is not None or not how.method.adaptive:
        return how
    description = f"{how.description}, steps up to 1/{PARTS} of the span as inputs are functions"
    return replace(how, max_step=length / PARTS, description=description)


def matching_atol(rtol: object) -> float:
    """The absolute tolerance that goes with a relative one where none is given."""
    if not isinstance(rtol, int | float | np.number) or not rtol > 0:
        return LARGEST_ATOL
    return min(LARGEST_ATOL, RATIO * float(rtol))


def _fixed(
    chosen: Integrator, step: float | None, max_step: float | None, length: float | None
) -> Settings:
    if max_step is not None:
        raise ModelError(f"max_step= goes with an adaptive method; {chosen.name} takes step=")
    if step is None and length is None:
        raise ModelError(f"{chosen.name} needs step= [s] here")
    taken = step if step is not None else (length or 0.0) / STEPS
    if length is not None and length / taken > MOST_STEPS:
        raise ModelError(
            f"step={taken:g}: {length:g} s would take {length / taken:.2g} steps; give a longer one"
        )
    origin = "" if step is not None else f", 1/{STEPS} of the span as none was given"
    return Settings(chosen, 0.0, 1.0, taken, math.inf, f"step {taken:g} s{origin}")


def integrator(name: str | GeneralizedAlpha | Alpha) -> Integrator:
    """An integrator by its name, or with choices of its own.

    Raises:
        ModelError: there is none.
    """
    if isinstance(name, GeneralizedAlpha):
        return method_of(name)
    if isinstance(name, Alpha):
        raise ModelError(
            f"method={name} are coefficients: method=cd.GeneralizedAlpha(coefficients=...) has them"
        )
    if name == "auto":
        return INTEGRATORS[DEFAULT]
    if name not in INTEGRATORS:
        same = next((n for n in INTEGRATORS if n.lower() == str(name).lower()), None)
        hint = f" Did you mean '{same}'?" if same else near(name, [*INTEGRATORS, "auto"])
        raise ModelError(f"method '{name}' does not exist.{hint}")
    return INTEGRATORS[name]


@dataclass(frozen=True)
class Start:
    """Start of a run.

    Attributes:
        x: The state (nx,).
        defaulted: Those of its entries that nobody named.
        closure_tol: Residual, in sizes of the mechanism, up to which loops count as closed because
            redundant conditions disagree; 0 where they agree.
        followers: ``"q"`` and ``"u"`` -> joints that follow from loops in closed form, and the
            values that were named for them.
    """

    x: Array
    defaulted: tuple[str, ...]
    closure_tol: float = 0.0
    followers: Mapping[str, Values] = field(default_factory=dict)


def start_key(x: Array, q: object, u: object, t: float, r: Array) -> bytes:
    """Key of what a start of a model follows from: starts with equal keys are equal."""
    key = hashlib.blake2b(np.float64(t).tobytes() + np.asarray(r).tobytes())
    for named in (q, u):
        # values of names stand in the state: which were named decides what is held
        names = sorted(map(str, named)) if isinstance(named, Mapping) else named is None
        key.update(repr(names).encode())
    key.update(x.tobytes())
    return key.digest()


def start(model: LoadedModel, x0: object, q: object, u: object, z: object = None) -> Start:
    """The initial state from ``x0`` or from ``q``, ``u`` and ``z``, each by names or as an array.

    Raises:
        ModelError: both given, or an unknown name. ArgumentError: wrong shape.
        SolveError: a value that is not finite.
    """
    names = _numbers_by_name(q, u, z) if x0 is None else None
    latest = None if names is None else model._derived.get(Start)
    if latest is not None and latest[0] == names:
        # the same names and numbers again
        same: Start = latest[1]
        begin = Start(same.x.copy(), same.defaulted, followers=same.followers)
    else:
        begin = _start(model, x0, q, u, z)
        if names is not None:
            model._derived[Start] = names, replace(begin, x=begin.x.copy())
    if isinstance(q, Mapping):
        _within_limits(model, begin.x, q)
    return begin


def _numbers_by_name(*blocks: object) -> tuple[tuple[tuple[str, float], ...], ...] | None:
    """The numbers of every block by their names; None if something else is among them."""
    listed = []
    for block in blocks:
        if block is not None and type(block) is not dict:
            return None
        pairs = tuple(block.items()) if block else ()
        if not all(type(number) is float for _, number in pairs):
            return None
        listed.append(pairs)
    return tuple(listed)


def _start(model: LoadedModel, x0: object, q: object, u: object, z: object) -> Start:
    """The initial state as :func:`start` gives it, limits not looked at."""
    refuse_second(x0, {"q": q, "u": u, "z": z})
    coordinates, speeds, internals = model.coordinates, model.speeds, model.internals
    if x0 is not None:
        x = _array("x0", x0, (*coordinates, *speeds, *internals))
        nq, nu = len(coordinates), len(speeds)
        q, u, z = x[:nq], x[nq : nq + nu], x[nq + nu :]
    names = {
        letter: _by_entry(letter, value, entries)
        for letter, value, entries in (("q", q, coordinates), ("u", u, speeds), ("z", z, internals))
    }
    dependents: dict[str, Values] = {}
    for letter, places in model._layout.followers.items():
        if places:
            dependents[letter] = {k: v for k, v in names[letter].items() if k in places}
            names[letter] = {k: v for k, v in names[letter].items() if k not in places}
    return Start(*start_of(model, names["q"], names["u"], names["z"]), followers=dependents)


def refuse_second(x0: object, blocks: Mapping[str, object]) -> None:
    """Refuse a start that is given twice.

    Args:
        x0: The whole state, or None.
        blocks: ``"q"``, ``"u"`` and ``"z"`` -> what was given for these blocks, or None.

    Raises:
        ModelError: both are given.
    """
    also = [f"{letter}=" for letter, value in blocks.items() if value is not None]
    if x0 is None or not also:
        return
    raise ModelError(
        f"the start is given twice: by {' and '.join(also)} besides x0=, which holds coordinates, "
        "speeds and internal states. Leave one out, or give blocks: q=x0[..., :model.nq], "
        "u={...}; of a result such as model.assemble(...): "
        "q=result.q, u={...}"
    )


def _within_limits(model: LoadedModel, x: Array, named: Values) -> None:
    """Warn of coordinates that were named outside the limits of their joints."""
    for joint in having(model.manifest.joints, "limits"):
        first, size = joint.q or (0, 0)
        if size == 1 and (joint.name in named or model.coordinates[first] in named):
            limits, unit = joint.limits, model.manifest.coordinates[first].unit
            problem = outside(float(x[first]), limits.get("lower"), limits.get("upper"), unit)
            if problem:
                warn(f"joint '{joint.name}': q: {problem}", ModelWarning)


def blocks(x0: object, q: object, u: object) -> tuple[Any, Any]:
    """Arguments for q and for u: names, a whole block, or None."""
    return (x0, x0) if x0 is not None else (q, u)


def _by_entry(letter: str, value: object, entries: tuple[str, ...]) -> Values:
    if value is None or isinstance(value, Mapping):
        return value or {}
    return dict(zip(entries, _array(letter, value, entries).tolist(), strict=True))


def _array(name: str, value: object, entries: tuple[str, ...]) -> Array:
    array = numbers(name, value)
    if array.shape != (len(entries),):
        raise ArgumentError(
            f"{name} has shape {array.shape}, expected ({len(entries)},): {', '.join(entries)}"
        )
    bad = np.flatnonzero(~np.isfinite(array))
    if len(bad):
        raise SolveError(f"{name}: '{entries[bad[0]]}' is {array[bad[0]]}; it must be finite")
    return array
