"""Gradients, changes and curvatures of results of elements, judged by differences of these results.

Curvatures are judged by differences of the gradients.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from itertools import accumulate

import numpy as np

from ....schema.finite_elements import (
    CHANGES,
    CURVATURES,
    DERIVATIVES,
    EVENT_DERIVATIVES,
    GRADIENTS,
    IMPULSE_DERIVATIVES,
)
from ...models.finite_elements.data_slopes import without_slopes
from ..differences import Blocks, missing, slope, ways, worst_of
from ..joint_motion import Array, times
from .members import Members


def _results(members: Members, form: str, blocks: Blocks | None = None) -> Array:
    """What a derivative is of (n, k), in the order of its weights."""
    call, kind = members.call, members.table.kind
    if form in IMPULSE_DERIVATIVES:
        return _impulse(members, blocks)
    read = [name for name in DERIVATIVES[form] if name in kind.functions]
    quantity = form.rpartition("_")[0]
    if quantity != "dynamics":
        return call(read[0], blocks)
    at = {**members.inputs, **(blocks or {})}
    n, nu, m = len(at["q"]), kind.nu, kind.m
    flat = call("balance_tangent", blocks) if "balance_tangent" in read else np.zeros((n, 0))

    def product(name: str, rows: int, block: str, columns: int) -> Array:
        """A matrix of the tangent times a block, (n, rows)."""
        if name not in kind.parts:
            return np.zeros((n, rows))
        first = kind.parts[name]
        matrix = flat[:, first : first + rows * columns].reshape(n, rows, columns)
        return times(matrix, np.broadcast_to(at[block], (n, columns)))

    balance = call("balance", blocks) if "balance" in read else np.zeros((n, 0))
    missed = product("G", m, "udot", nu) - product("H", m, "lam", m)
    if "gamma" in read:
        missed = missed - call("gamma", blocks)
    levels = np.zeros((n, nu + kind.mp + m))
    levels[:, : balance.shape[1]] = balance
    zdot = call("zdot", blocks) if "zdot" in read else np.zeros((n, 0))
    return np.concatenate([levels, missed, zdot], axis=1)


def _impulse(members: Members, blocks: Blocks | None) -> Array:
    """M udot - Gᵀ lam and G udot - H lam (n, nu + m)."""
    kind, at = members.table.kind, {**members.inputs, **(blocks or {})}
    nu, m, n = kind.nu, kind.m, len(at["q"])
    flat = members.call("balance_tangent", blocks)

    def matrix(name: str, rows: int, columns: int) -> Array:
        if name not in kind.parts:
            return np.zeros((n, rows, columns))
        first = kind.parts[name]
        entries: Array = flat[:, first : first + rows * columns]
        return entries.reshape(-1, rows, columns)

    udot, lam = (np.broadcast_to(at[name], (n, k)) for name, k in (("udot", nu), ("lam", m)))
    M, G, H = matrix("M", nu, nu), matrix("G", m, nu), matrix("H", m, m)
    balance = times(M, udot) - times(np.swapaxes(G, 1, 2), lam)
    return np.concatenate([balance, times(G, udot) - times(H, lam)], axis=1)


def _parts(members: Members, form: str) -> dict[str, slice]:
    """Where derivatives by every block are in a gradient, or changes of it in a direction."""
    kind = members.table.kind
    sizes = {"q": kind.nq, "u": kind.nu, "udot": kind.nu, "lam": kind.m, "z": kind.nz}
    sizes |= {"s": kind.ns, "r": members.inputs["r"].shape[-1], "t": 1}
    if form in EVENT_DERIVATIVES:
        sizes |= {"du": kind.nu, "tau": kind.frictions + kind.responses}
    ends = accumulate(sizes.values())
    return {name: slice(end - sizes[name], end) for name, end in zip(sizes, ends, strict=True)}


def _states(members: Members, form: str) -> int:
    """Where derivatives by data begin."""
    return max(int(part.stop) for part in _parts(members, form).values())


def _directions(members: Members, form: str) -> tuple[dict[str, Array], Array]:
    """Rates of blocks along a random way of all that is read but data; the way (n, k)."""
    parts, n = _parts(members, form), members.count
    way = ways(n, _states(members, form))[0]
    # quaternions keep their lengths, and modes are whole numbers
    way[:, parts["q"]] = members.along(ways(n, members.table.kind.nu)[0])
    way[:, parts["s"]] = 0.0
    return {name: way[:, part] for name, part in parts.items() if part.start < part.stop}, way


def _by_data(
    members: Members, results: Callable[[Blocks], Array], way: Array
) -> tuple[Array, Array]:
    """Slopes of results along a way of the first data, and how far they may be off."""
    n, inputs, along = members.count, members.inputs, np.zeros_like(members.inputs["p"])
    along[:, : way.shape[1]] = way

    def moved(blocks: Blocks) -> Array:
        shift = blocks["shift"]
        count = len(shift) // n
        here = {name: np.tile(x, (count, 1)) for name, x in inputs.items()}
        here["p"] = here["p"] + shift * np.tile(along, (count, 1))
        return results(here)

    still, unit = np.zeros((n, 1)), np.ones((n, 1))
    return slope(moved, {"shift": still}, {"shift": unit}, np.ones(n))


def _slopes(
    members: Members, form: str, results: Callable[[Blocks], Array], available: Array
) -> list[tuple[Array, Array, Array]]:
    """Ways of everything that is read, data last, slopes along them, and how far they may be off.

    Args:
        members, form: Whose results.
        results: Of blocks.
        available: Of every datum whether there is a derivative by it.
    """
    rates, way = _directions(members, form)
    none = np.zeros((members.count, len(available)))
    along = members.slope(results, rates)
    listed = [(np.hstack([way, none]), *along)]
    if available.any():
        p = members.inputs["p"][:, : len(available)]
        data = ways(members.count, len(available))[0] * np.where(p == 0, 1.0, p) * available
        listed.append((np.hstack([0.0 * way, data]), *_by_data(members, results, data)))
    return listed


def _gradient(form: str, members: Members) -> float | str:
    """A gradient of a weighted sum."""
    value, weights, worst = members.call(form), members.inputs["v"], np.nan
    states = _states(members, form)
    available, clean = _cleaned(members, value, states)
    if not clean:
        return np.inf
    for way, change, off in _slopes(members, form, partial(_results, members, form), available):
        terms = np.abs(change * weights)
        total, expected = (change * weights).sum(axis=-1), (value * way).sum(axis=-1)
        error = missing(total[:, None], off, expected, terms, np.abs(value * way))
        worst = worst_of(worst, error)
    return worst


def _cleaned(members: Members, value: Array, states: int) -> tuple[Array, bool]:
    """Of every datum whether there is a derivative by it; others become 0 where they were NaN.

    Args:
        members: Whose gradient it is.
        value: The gradient (n, k).
        states: How many of its entries are not by data.

    Returns:
        These flags, and whether all that has no derivative was NaN.
    """
    available = np.arange(value.shape[1] - states) >= without_slopes(
        members.model, members.table.kind
    )
    nowhere = np.concatenate([np.zeros(states, dtype=bool), ~available])
    clean = not np.isfinite(value[:, nowhere]).any()
    value[:, nowhere] = 0.0
    return available, clean


def _change(form: str, members: Members) -> float | str:
    """A change along a direction."""
    worst, states = np.nan, _states(members, form)
    count = members.inputs["v"].shape[1] - states
    available = np.arange(count) >= without_slopes(members.model, members.table.kind)
    for way, change, off in _slopes(members, form, partial(_results, members, form), available):
        value = members.call(form, {"v": way})
        worst = worst_of(worst, missing(change, off, value))
    return worst


def _curvature(form: str, members: Members) -> float | str:
    """A change of a gradient at fixed weights."""
    gradient, worst, states = GRADIENT_OF[form], np.nan, _states(members, form)
    count = len(members.codes[gradient].entry.vector)
    weights = members.inputs["v"][:, :count]

    def slopes(blocks: Blocks) -> Array:
        here = np.resize(weights, (len(blocks["q"]), count))
        return np.nan_to_num(members.call(gradient, {**blocks, "v": here}))

    available, _ = _cleaned(members, members.call(gradient, {"v": weights}), states)
    for way, change, off in _slopes(members, form, slopes, available):
        value = np.nan_to_num(members.call(form, {"v": np.hstack([weights, way])}))
        worst = worst_of(worst, missing(change, off, value))
    return worst


GRADIENT_OF: Mapping[str, str] = {f: f.replace("curvature", "gradient") for f in CURVATURES}
LAWS: dict[str, Callable[[Members], float | str]] = {
    **{form: partial(_gradient, form) for form in GRADIENTS},
    **{form: partial(_change, form) for form in CHANGES},
    **{form: partial(_curvature, form) for form in CURVATURES},
}
