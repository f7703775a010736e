"""Gradients of weighted sums of results of elements, judged by differences of these results."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from ....schema.finite_elements import GRADIENTS
from ..differences import Blocks, missing, slope, ways, worst_of
from ..joint_motion import Array, times
from .members import Members

LETTERS = ("q", "u", "udot", "lam", "z", "s", "r", "t")


def _results(members: Members, form: str, blocks: Blocks | None) -> Array:
    """What a gradient is of (n, k), its weights in the order of v."""
    call, kind = members.call, members.table.kind
    read = [name for name in GRADIENTS[form] if name in kind.functions]
    if len(GRADIENTS[form]) == 1:
        return call(read[0], blocks)
    at = {**members.inputs, **(blocks or {})}
    n, nu, m = len(at["q"]), kind.nu, kind.m
    balance = call("balance", blocks) if "balance" in read else np.zeros((n, 0))
    missed = np.zeros((n, m))
    flat = call("balance_tangent", blocks) if m and "balance_tangent" in read else np.zeros((n, 0))
    for name, columns, block in (("G", nu, "udot"), ("H", m, "lam")):
        if m and name in kind.parts:
            first = kind.parts[name]
            matrix = flat[:, first : first + m * columns].reshape(n, m, columns)
            product = times(matrix, np.broadcast_to(at[block], (n, columns)))
            missed = missed + (product if name == "G" else -product)
    if "gamma" in read:
        missed = missed - call("gamma", blocks)
    levels = np.zeros((n, nu + kind.mp + m))
    levels[:, : balance.shape[1]] = balance
    zdot = call("zdot", blocks) if "zdot" in read else np.zeros((n, 0))
    return np.concatenate([levels, missed, zdot], axis=1)


def _law(form: str, members: Members) -> float | str:
    """A gradient along random ways of everything it is by."""
    kind, inputs, n = members.table.kind, members.inputs, members.count
    value, weights, at = members.call(form), inputs["v"], 0
    sizes = {"q": kind.nq, "u": kind.nu, "udot": kind.nu, "lam": kind.m, "z": kind.nz}
    sizes |= {"s": kind.ns, "r": inputs["r"].shape[-1], "t": 1}
    parts = dict[str, Array]()
    for letter, size in sizes.items():
        parts[letter], at = value[:, at : at + size], at + size
    by_data = value[:, at:]
    results = _results(members, form, None)
    scale = [np.abs(results * weights), np.abs(value[:, :at])]

    def weighed(blocks: Blocks) -> Array:
        change = _results(members, form, blocks)
        total: Array = (change * np.resize(weights, change.shape)).sum(axis=-1, keepdims=True)
        return total

    worst = np.nan
    for way in ways(n, at):
        rates, expected, first = dict[str, Array](), np.zeros(n), 0
        for letter, size in sizes.items():
            along, first = way[:, first : first + size], first + size
            if letter == "q":
                # quaternions keep their lengths
                along = members.along(np.resize(way, (n, kind.nu)))
            # modes are whole numbers
            if size and letter != "s":
                rates[letter] = along
                expected += (parts[letter] * along).sum(axis=-1)
        change, off = members.slope(weighed, rates)
        worst = worst_of(worst, missing(change, off, expected, *scale))
    # what no derivative is known of moves nothing here
    unknown = np.isnan(by_data).all(axis=0)
    by_data = np.where(unknown, 0.0, by_data)
    for way in ways(n, by_data.shape[1]) if by_data.shape[1] else ():
        way[:, unknown] = 0.0
        p, along = inputs["p"], np.zeros_like(inputs["p"])
        along[:, : way.shape[1]] = way * np.where(p == 0, 1.0, p)[:, : way.shape[1]]

        def moved(blocks: Blocks, p: Array = p, along: Array = along) -> Array:
            shift = blocks["shift"]
            count = len(shift) // n
            here = np.tile(p, (count, 1)) + shift * np.tile(along, (count, 1))
            return weighed({**{k: np.tile(x, (count, 1)) for k, x in inputs.items()}, "p": here})

        still, unit = np.zeros((n, 1)), np.ones((n, 1))
        change, off = slope(moved, {"shift": still}, {"shift": unit}, np.ones(n))
        expected = (by_data * along[:, : by_data.shape[1]]).sum(axis=-1)
        terms = np.abs(by_data * along[:, : by_data.shape[1]])
        worst = worst_of(worst, missing(change, off, expected, *scale, terms))
    return worst


LAWS: dict[str, Callable[[Members], float | str]] = {
    form: partial(_law, form) for form in GRADIENTS
}
