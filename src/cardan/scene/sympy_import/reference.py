"""Reference values by SymPy of written equations: every build is compared with them.

Loads SymPy.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy
from sympy.physics.mechanics import dynamicsymbols

from ...arrays import Array
from ...records import dataclass
from .constraints import Bound
from .names import Names
from .numbers import numbers
from .sources import Source

SEED = 5
TIME = 0.3
# how far coordinates are drawn from 0, again and again until everything is finite there
REACHES = (0.6, 0.2, 1.2, 3.0) * 6
STATE_COUNT = 3
# speeds beyond which one state must do: M is stored
MANY = 20


@dataclass(frozen=True)
class State:
    """Numbers at a state on the constraints.

    Attributes:
        values: Symbol, function of time or derivative -> number.
        M: (nu, nu). f: (nu,). G: (m, nu), rows as of ``Bound.velocities``.
    """

    values: Mapping[sympy.Expr, float]
    M: Array
    f: Array
    G: Array


def states(source: Source, names: Names, bound: Bound) -> list[State]:
    """States at which everything is finite; fewer where that is rare."""
    rng, states_list = np.random.default_rng(SEED), list[State]()
    count = STATE_COUNT if len(source.u) <= MANY else 1
    for reach in REACHES:
        values = bound.moved(_drawn(rng, reach, names, bound))
        state = None if values is None else _state(source, names, bound, values)
        if state is not None:
            states_list.append(state)
        if len(states_list) == count:
            break
    return states_list


def _drawn(
    rng: np.random.Generator, reach: float, source_names: Names, bound: Bound
) -> dict[sympy.Expr, float]:
    """Values of all plain symbols."""
    values = {sympy.Symbol("t"): TIME}
    values |= {x: float(reach * rng.uniform(-1, 1)) for x in bound.q}
    values |= {x: float(rng.uniform(-1, 1)) for x in bound.u}
    names = [*source_names.inputs.values(), *(x.name for x in bound.input_rates.values())]
    names += [x.name for x in bound.input_rates]
    values |= {sympy.Symbol(n): float(rng.uniform(-1, 1)) for n in dict.fromkeys(names)}
    return values | {sympy.Symbol(name): value for name, value in source_names.parameters.items()}


def _state(
    source: Source, names: Names, bound: Bound, values: Mapping[sympy.Expr, float]
) -> State | None:
    """The numbers at a state, None where one is not finite."""
    t, values_there = dynamicsymbols._t, dict(values)
    values_there |= {x: values[sympy.Symbol(name)] for x, name in names.names.items()}
    values_there |= {d: 0.0 for x in source.zero for d in (x, x.diff(t))}
    rates = numbers(source.rates, values_there)
    values_there |= {x.diff(t): rate for x, rate in zip(source.q, rates, strict=True)}
    nu = len(source.u)
    flat = np.array(numbers([*source.M, *source.f], values_there))
    G = bound.matrix(values)
    if not all(np.isfinite(x).all() for x in (flat, G, rates)):
        return None
    return State(values_there, flat[: nu * nu].reshape(nu, nu), flat[nu * nu :], G)


def samples(
    source: Source, names: Names, bound: Bound, states_list: Sequence[State], solved: bool
) -> tuple[dict[str, object], ...]:
    """The reference as plain data for the manifest.

    Args:
        solved: Whether M is the identity in what was made of the equations, and f is u'.
    """
    return tuple(_sample(source, names, bound, state, solved) for state in states_list)


def _sample(
    source: Source, names: Names, bound: Bound, state: State, solved: bool
) -> dict[str, object]:
    value = {x.name: v for x, v in state.values.items() if isinstance(x, sympy.Symbol)}
    M, f = state.M, state.f
    if solved:
        M, f = np.eye(len(f)), np.asarray(np.linalg.solve(M, f), dtype=np.float64)
    rows, right = _balance(source, bound, state)
    inputs = [*names.inputs.values(), *(x.name for x in bound.input_rates.values())]
    return {
        "held": [*bound.positions, *bound.speeds],
        "t": TIME,
        "q": [value[name] for name in names.q],
        "u": [value[name] for name in names.u],
        "r": {name: value[name] for name in inputs},
        "p": dict(names.parameters),
        "qdot": numbers(source.rates, state.values),
        "M": M.tolist(),
        "f": f.tolist(),
        "rows": rows.tolist(),
        "right": right.tolist(),
    }


def _balance(source: Source, bound: Bound, state: State) -> tuple[Array, Array]:
    """Rows A and b of A u' = b: SymPy's own, or M u' = f where constraints do no work, and G."""
    nu = len(state.f)
    if source.balance is not None:
        left, right = (np.array(numbers(list(x), state.values)) for x in source.balance)
        if np.isfinite(left).all() and np.isfinite(right).all():
            return left.reshape(-1, nu), right
    _, sizes, across = np.linalg.svd(state.G) if len(state.G) else (0, np.zeros(0), np.eye(nu))
    free = across[np.count_nonzero(sizes > 1e-10) :]
    rows = np.vstack([free @ state.M, state.G])
    gamma = bound.at(bound.gamma, state.values)
    return rows, np.concatenate([free @ state.f, gamma])
