"""Check that the constraints of a model are derivatives of each other.

G u + g_t must be the derivative of g along a motion, and G udot - gamma that of G u + g_t, at any
state, whether it fulfils the constraints or not. The motion is followed by central differences of
eighth order with several steps; the two that agree best say how well the derivative is known.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, ModelError
from ...records import dataclass
from ..models.initial import start_of
from .differences import REACH, central, input_rates

if TYPE_CHECKING:
    from ..models.finite_elements.elements import Elements
    from ..models.loaded_model import LoadedModel

RATES, JACOBIAN, GAMMA = "constraint_rates", "constraint_jacobian", "gamma"
CHECKED = (RATES, JACOBIAN)
# in no simple ratio: no fast wave looks like the same slow one at two of them
STEPS = (1e-2, 2.7e-3, 6.1e-4, 1.47e-4)
ENOUGH = 1e-12
# Derivatives that two steps know no better say nothing: something is not smooth there.
ROUGH = 1e-4
# What two steps agree on is known better than this many times their difference.
TRUSTED = 10.0
# Smaller terms of a row, in parts of the largest of all rows, are rounding of its differences.
SMALL = 1e-5
EPS = float(np.finfo(float).eps)
TIME, MOVE, INPUT = 0.3, 0.3, 0.3


@dataclass(frozen=True)
class Motion:
    """Motion of a model: blocks and their time derivatives.

    Attributes:
        t: Time [s], () or (n,).
        q, u, r: Coordinates (nq,), speeds (nu,), inputs (nr,), or (n, ...) at n times.
        qdot, udot, rdot: Their rates at the first of them.
    """

    t: Array
    q: Array
    u: Array
    r: Array
    qdot: Array
    udot: Array
    rdot: Array

    def after(self, h: Array) -> Motion:
        """The motion times h (n,) [s] later, to first order: all that a derivative feels."""
        steps = h[:, None]
        return replace(
            self,
            t=self.t + h,
            q=self.q + steps * self.qdot,
            u=self.u + steps * self.udot,
            r=self.r + steps * self.rdot,
        )


Level = Callable[[Motion], Array]


@dataclass(frozen=True)
class Levels:
    """The constraints of a model at three levels.

    Attributes:
        position: g (n, mp) at n times.
        rates: G u + g_t (n, m) at n times.
        product: G x (m,) and the largest term of each of its sums (m,), at one time for x (nu,).
        gamma: gamma (m,) at one time, None where no function gives it.
    """

    position: Level
    rates: Level
    product: Callable[[Motion, Array], tuple[Array, Array]]
    gamma: Level | None = None


def slope(f: Callable[[Array], Array], rounding: float = 0.0) -> tuple[Array, Array]:
    """Derivative (m,) at 0 of a function of times (n,) with values (n, m); how well it is known.

    Args:
        f: The function.
        rounding: Rounding error of its values, which limits the difference of two of them.
    """
    before = _difference(f, STEPS[0])
    derivative, doubt = before, np.full(before.shape, np.inf)
    for h in STEPS[1:]:
        now = _difference(f, h)
        # two steps may agree by chance, and among many rows some do
        change = np.maximum(np.abs(now - before), rounding / h)
        better = change < doubt
        derivative, doubt = np.where(better, now, derivative), np.where(better, change, doubt)
        if np.all(doubt <= ENOUGH * np.maximum(1.0, np.abs(derivative))):
            break
        before = now
    return derivative, doubt


def _difference(f: Callable[[Array], Array], h: float) -> Array:
    values = f(h * np.concatenate([REACH, -REACH]))
    return central(*np.split(values, 2)) / h


def errors(levels: Levels, at: Motion) -> dict[str, Array]:
    """Error of every row of G u + g_t, G and gamma over the largest term of the row, (m,) each.

    NaN where differences say nothing: the row is not smooth there.
    """
    now = at.after(np.zeros(1))
    rates, still = levels.rates(now)[0], levels.rates(replace(now, u=0 * now.u))[0]
    moved, largest = levels.product(at, at.u)
    size = np.maximum(largest, np.abs(still))
    # constraints are differences of places, which round by their distance from the origin
    far = EPS * np.abs(at.q).max(initial=1.0)
    exact, doubt = slope(lambda h: levels.position(at.after(h)), far)
    mp = len(exact)
    terms = np.maximum(size[:mp], np.abs(exact))
    result = {
        RATES: _relative(rates[:mp] - exact, doubt, terms),
        JACOBIAN: _relative(moved + still - rates, np.where(np.isfinite(rates), 0.0, np.inf), size),
    }
    if levels.gamma is not None:
        # rates are products of such differences and of speeds
        fast = far * np.abs(at.u).max(initial=1.0)
        change, doubt = slope(lambda h: levels.rates(at.after(h)), fast)
        product, largest = levels.product(at, at.udot)
        difference = product - levels.gamma(at) - change
        result[GAMMA] = _relative(difference, doubt, np.maximum(largest, np.abs(change)))
    return result


def _relative(difference: Array, doubt: Array, size: Array) -> Array:
    """Certain error over the size of its terms; no number where there is a slope is."""
    size = np.maximum(size, SMALL * size.max(initial=0.0))
    size = np.where(size > 0, size, 1.0)
    wrong = np.maximum(0.0, np.abs(difference) - TRUSTED * doubt) / size
    wrong = np.where(np.isfinite(difference), wrong, np.inf)
    return np.where(doubt <= ROUGH * size, wrong, np.nan)


def worst(levels: Levels, motions: Iterable[Motion]) -> dict[str, float]:
    """The largest error of every level at some motions; NaN where nothing could be compared."""
    collected: dict[str, list[Array]] = {}
    for at in motions:
        for name, rows in errors(levels, at).items():
            collected.setdefault(name, []).append(rows)
    joined = {name: np.concatenate(rows) for name, rows in collected.items()}
    # a level without rows says nothing
    return {name: float(np.fmax.reduce(rows)) for name, rows in joined.items() if len(rows)}


# where models are asked


def checks(
    model: LoadedModel, functions: Iterable[str] | None, states: int, seed: int
) -> dict[str, float | str]:
    """Error of every level of the constraints, or why it is not checked.

    Args:
        model: Its constraints are those of elements in tables or functions of their own.
        functions: Names that are checked; all that are loaded by default.
        states, seed: Number of random motions, and what they are drawn from.
    """
    if not model.manifest.multipliers:
        return {}
    if model.manifest.absolute:
        elements = model._source.results(model).mesh  # type: ignore[attr-defined]
        return said(of_elements(model, elements, states, seed))
    loaded = {name for name, of in model._functions if of is None}
    requested = [n for n in CHECKED if n in (loaded if functions is None else tuple(functions))]
    if not requested:
        return {}
    errors_by_name = of_functions(model, states, seed)
    if isinstance(errors_by_name, str):
        return dict.fromkeys(requested, errors_by_name)
    return {name: error for name, error in said(errors_by_name).items() if name in requested}


def said(largest_errors: Mapping[str, float]) -> dict[str, float | str]:
    """Errors, or why there are none."""
    rough = "not checked: the constraints are nowhere smooth"
    return {name: rough if np.isnan(error) else error for name, error in largest_errors.items()}


def _motions(
    model: LoadedModel,
    states: int,
    seed: int,
    move: Callable[[Array, Array], Array],
    qdot: Callable[[Array, Array, Array], Array],
) -> Iterable[Motion]:
    """Random motions near the initial position.

    Args:
        model: Whose.
        states, seed: How many, and what they are drawn from.
        move: Coordinates moved along speeds.
        qdot: Their rates at coordinates, speeds and inputs.
    """
    rng, time = np.random.default_rng(seed), np.asarray(TIME)
    # as the scene tells it: loops that no motion closes there say nothing against constraints
    start, r0 = start_of(model, {}, {})[0][: model.nq], model._layout.start("r")
    names = [row.name for row in model.manifest.inputs]
    for _ in range(states):
        q = move(start, MOVE * rng.uniform(-1, 1, model.nu))
        u, udot = rng.uniform(-1, 1, (2, model.nu))
        r = r0 + INPUT * np.maximum(1.0, np.abs(r0)) * rng.uniform(-1, 1, model.nr)
        yield Motion(time, q, u, r, qdot(q, u, r), udot, input_rates(names, r))


# elements in tables


# functions of elements that speak of constraints
SPOKEN = ("__balance", "__balance_tangent", "__gamma")


def binds(symbol: str) -> bool:
    """True when a function of an element may say something about constraints."""
    return symbol.endswith(SPOKEN)


def of_elements(model: LoadedModel, elements: Elements, states: int, seed: int) -> dict[str, float]:
    """The largest error of every level of a model in absolute coordinates."""
    from ..models.finite_elements.elements import State

    modes = model._layout.start("s")

    def state(at: Motion, k: int | None = None) -> State:
        t, q, u, r = (x if k is None else x[k] for x in (at.t, at.q, at.u, at.r))
        return State(q=q, u=u, t=float(t), r=r, s=modes)

    def balances(at: Motion, part: int) -> Array:
        return np.array([elements.balance(state(at, k))[part] for k in range(len(at.q))])

    def product(at: Motion, x: Array) -> tuple[Array, Array]:
        G = elements.tangent(state(at), ("G",))["G"]
        terms = abs(G.multiply(x[None, :])).max(axis=1).toarray()
        return G @ x, terms[:, 0]

    levels = Levels(
        lambda at: balances(at, 1),
        lambda at: balances(at, 2),
        product,
        lambda at: elements.gamma(state(at)),
    )
    drawn = _motions(model, states, seed, elements.move, lambda q, u, r: elements.rates(q, u))
    return worst(levels, drawn)


# joint coordinates


def of_functions(model: LoadedModel, states: int, seed: int) -> dict[str, float] | str:
    """The largest error of G u + g_t and G in joint coordinates; or why they are not checked.

    What is loaded is asked as it is compiled; the rest, g and qdot first, as it was derived.
    """
    from ...ir.interpreter import evaluate
    from ...ir.serialize import from_dict

    objects = model._objects
    try:
        names = ("constraints", "qdot", "integrate", *CHECKED)
        symbols = {name: objects.symbol(name) for name in names}
        texts = objects.saved()
        derived = {name: from_dict(texts[symbol]) for name, symbol in symbols.items()}
    except (ModelError, DerivationError, KeyError) as missing:
        return f"not checked: {missing}"
    p, modes, inner = model.parameters.vector, *(model._layout.start(name) for name in "sz")

    def saved(name: str, at: Mapping[str, object], shape: tuple[int, ...]) -> Array:
        inputs = {"p": p, "z": inner, "s": modes, **at}
        (value,) = evaluate(derived[name], inputs, "numpy").values()
        return np.broadcast_to(np.asarray(value, dtype=float), shape)

    def blocks(at: Motion) -> dict[str, Any]:
        return {"t": at.t[..., None], "q": at.q, "u": at.u, "r": at.r}

    def rates(at: Motion) -> Array:
        if (RATES, None) in model._functions:
            return model.constraint_rates(at.q, at.u, r=at.r, z=inner, s=modes, t=at.t)
        return saved(RATES, blocks(at), (len(at.q), model.nlam))

    def product(at: Motion, x: Array) -> tuple[Array, Array]:
        if (JACOBIAN, None) in model._functions:
            G = model.constraint_jacobian(at.q, r=at.r, s=modes, t=at.t)
        else:
            G = saved(JACOBIAN, blocks(at), (model.nlam, model.nu))
        return G @ x, np.abs(G * x).max(axis=-1, initial=0.0)

    position_count = sum(row.level == "position" for row in model.manifest.multipliers)
    levels = Levels(
        lambda at: saved("constraints", blocks(at), (len(at.q), position_count)), rates, product
    )
    t = np.array([TIME])
    drawn = _motions(
        model,
        states,
        seed,
        lambda q, du: saved("integrate", {"t": t, "q": q, "du": du}, q.shape),
        lambda q, u, r: saved("qdot", {"t": t, "q": q, "u": u, "r": r}, q.shape),
    )
    return worst(levels, drawn)
