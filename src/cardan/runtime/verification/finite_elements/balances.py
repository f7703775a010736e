"""Balances, tangents and rows of elements, judged by each other and by Lagrange's equations.

Tangents are differences of balances; balances are those of Lagrange's equations, of energies that
are judged by quadrature (:mod:`.shapes`), or lose what powers say.

Source: Lurie, Analytical Mechanics (2002), chapter 10, for speeds that are not rates.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from ..differences import BOUND, input_rates, missing, relative, ways, worst_of
from ..joint_motion import Array, cross, times
from ..rotations import quaternion
from . import element_events
from .members import NODE, Members

NO_LAW = "no law leads to it"
MATRICES = {"K": ("q", 0), "C": ("u", 0), "M": ("udot", 0), "R": ("q", 1), "G": ("u", 1)}


def _tangent(members: Members) -> float | str:
    """K, C, M, R and G."""
    kind, n = members.table.kind, members.count
    flat = members.call("balance_tangent") if kind.parts else np.zeros((n, 0))
    worst, nu = np.nan, kind.nu
    for name, (letter, bound) in MATRICES.items():
        rows = kind.m if bound else nu
        at = kind.parts.get(name)
        values = np.zeros((n, rows, nu)) if at is None else flat[:, at : at + rows * nu]
        values = values.reshape(n, rows, nu)
        if not rows:
            continue
        ends = slice(nu + kind.mp, None) if bound else slice(0, nu)
        scale = np.abs(values).max(axis=(1, 2), initial=0.0)
        for way in ways(n, nu):
            rate = members.along(way) if letter == "q" else way
            slope, off = members.slope(lambda b: members.call("balance", b), {letter: rate})
            size = np.abs(members.call("balance")).max(axis=-1, initial=0.0)
            error = missing(slope[:, ends], off, times(values, way), scale, size * 1e-3)
            worst = worst_of(worst, error)
    if "L" in kind.parts:
        worst = worst_of(worst, _by_multipliers(members, flat))
    return worst_of(worst, element_events.released(members)) if "H" in kind.parts else worst


def _by_multipliers(members: Members, flat: Array) -> float:
    """L: what multipliers do to the balance."""
    kind, n, worst = members.table.kind, members.count, np.nan
    at = kind.parts["L"]
    values = flat[:, at : at + kind.m * kind.nu].reshape(n, kind.m, kind.nu)
    scale = np.abs(values).max(axis=(1, 2), initial=0.0)
    for way in ways(n, kind.m):
        slope, off = members.slope(lambda b: members.call("balance", b), {"lam": way})
        worst = worst_of(
            worst, missing(slope[:, : kind.nu], off, -times(np.swapaxes(values, 1, 2), way), scale)
        )
    return worst


def rates_of(members: Members, moving: bool = True) -> dict[str, Array]:
    inputs = members.inputs
    rates = {"q": members.along(inputs["u"]), "t": np.ones((members.count, 1))}
    if inputs["r"].shape[-1]:
        rates["r"] = input_rates(members.model.inputs, inputs["r"])
    return rates | ({"u": inputs["udot"]} if moving else {})


def _gamma(members: Members) -> float | str:
    """G udot - gamma is the derivative of G u + g_t."""
    kind = members.table.kind
    ends = slice(kind.nu + kind.mp, None)
    drift, off = members.slope(lambda b: members.call("balance", b), rates_of(members))
    product, _ = members.slope(lambda b: members.call("balance", b), {"u": members.inputs["udot"]})
    expected = product[:, ends] - drift[:, ends]
    return missing(expected, off, members.call("gamma"), drift[:, ends], product[:, ends])


def balance(members: Members) -> float | str:
    """By its laws; without a tangent, nothing may change it besides."""
    error = _by_laws(members)
    if "balance_tangent" in members.table.kind.functions:
        return error
    constant = _tangent(members)
    if isinstance(error, str) or isinstance(constant, str):
        # that it stays as it is says nothing of its size
        return constant if not isinstance(constant, str) and constant > BOUND else error
    return worst_of(error, constant)


def _by_laws(members: Members) -> float | str:
    """Rows of constraints and what their multipliers do; forces by energies and powers."""
    kind = members.table.kind
    value, worst, judges = members.call("balance"), np.nan, 0
    if kind.m:
        judges, worst = 1, _rows(members, value)
    # what an element has, compiled or not yet: where it has losses, energy alone is not its law
    forms = {"energy", "power", "zdot"} & set(kind.functions)
    if kind.m or not forms <= set(members.codes):
        return worst if judges else NO_LAW
    if members.plain and forms == {"energy"}:
        judges, worst = 1, worst_of(worst, _lagrange(members, value[:, : kind.nu]))
    if forms and "zdot" not in forms:
        judges, worst = 1, worst_of(worst, _ledger(members, value[:, : kind.nu]))
    return worst if judges else NO_LAW


def _rows(members: Members, value: Array) -> float:
    """G u + g_t is the derivative of g; b has -Gᵀ lam in it."""
    kind, inputs, n = members.table.kind, members.inputs, members.count
    nu, mp = kind.nu, kind.mp
    slope, off = members.slope(
        lambda b: members.call("balance", b), rates_of(members, moving=False)
    )
    rates = value[:, nu + mp :]
    worst = missing(slope[:, nu : nu + mp], off, rates[:, :mp], rates, np.abs(inputs["u"]))
    still = members.call("balance", {"lam": np.zeros((n, kind.m))})[:, :nu]
    constraint_forces = value[:, :nu] - still + friction_of(members)
    power = (constraint_forces * inputs["u"]).sum(axis=-1)
    # what depends on speeds in the rows, times the multipliers
    explicit_rates = members.call("balance", {"u": np.zeros((n, nu))})[:, nu + mp :]
    expected = -((rates - explicit_rates) * inputs["lam"]).sum(axis=-1)
    terms = constraint_forces * inputs["u"]
    return worst_of(worst, relative((power - expected)[:, None], terms, expected[:, None]))


def friction_of(members: Members) -> Array:
    """Generalized forces (n, nu) of the friction that multipliers make."""
    kind, n, k = members.table.kind, members.count, members.table.kind.frictions
    if not k or "reaction_friction" not in members.codes:
        return np.zeros((n, kind.nu))
    coefficient, along, normal = friction_parts(members)
    size = np.linalg.norm(np.einsum("nkxm,nm->nkx", normal, members.inputs["lam"]), axis=-1)
    return np.asarray(np.einsum("nk,nku->nu", coefficient * size, along))


def friction_parts(members: Members) -> tuple[Array, Array, Array]:
    """Friction per force (n, k), its action (n, k, nu), forces by multipliers (n, k, 3, m)."""
    kind, n = members.table.kind, members.count
    k, nu = kind.frictions, kind.nu
    values = members.call("reaction_friction")
    coefficient, along, normal = np.split(values, [k, k + k * nu], axis=-1)
    return coefficient, along.reshape(n, k, nu), normal.reshape(n, k, 3, kind.m)


def _lagrange(members: Members, force: Array) -> float:
    """b = d/dt dT/du + omega x dT/domega - X(T - V), along every speed."""
    inputs, nu = members.inputs, members.table.kind.nu
    n = members.count

    def energies(blocks: Mapping[str, Array]) -> Array:
        return members.call("energy", blocks)

    def moving(blocks: Mapping[str, Array]) -> Array:
        return momenta(energies, blocks)

    rates, off = members.slope(moving, rates_of(members))
    p, expected = moving(inputs), rates.copy()
    for block, first in zip(members.blocks, members.starts[1], strict=False):
        if block.node and block.nq == NODE:
            turn = slice(first, first + 3)
            expected[:, turn] += cross(inputs["u"][:, turn], p[:, turn])
    for k in range(nu):
        unit = np.broadcast_to(np.eye(nu)[k], (n, nu))
        change, doubt = members.slope(energies, {"q": members.along(unit)})
        expected[:, k] -= change[:, 0] - change[:, 1]
        off = np.maximum(off, doubt)
    return missing(expected, off + _blur(members), force)


def momenta(energies: Callable[..., Array], blocks: Mapping[str, Array]) -> Array:
    """dT/du: T is of second degree in the speeds, differences of which are exact."""
    u = blocks["u"]
    p = np.zeros_like(u)
    for k, unit in enumerate(np.eye(u.shape[-1])):
        both = [energies({**blocks, "u": u + sign * unit})[:, 0] for sign in (1.0, -1.0)]
        p[:, k] = (both[0] - both[1]) / 2
    return p


def _generalized_momenta(members: Members) -> float:
    """dT/du, and the slope of T along coordinates: a form of two speeds, known by its squares."""
    inputs, nu = members.inputs, members.table.kind.nu

    def energies(blocks: Mapping[str, Array]) -> Array:
        return members.call("energy", blocks)[:, :1]

    def both(speeds: Array, second: Array) -> Array:
        return members.call("generalized_momenta", {"u": speeds, "udot": second})

    u, other = inputs["u"], inputs["udot"]
    value, p = both(u, u), momenta(energies, inputs)
    slopes, off, here = np.zeros_like(p), np.zeros(members.count), np.zeros(nu, dtype=bool)
    for block, a, b in zip(members.blocks, *members.starts, strict=False):
        if block.node:
            back = np.swapaxes(quaternion(inputs["q"][:, a : a + 4]), -1, -2)
            p[:, b + 3 : b + 6] = times(back, p[:, b + 3 : b + 6])
        else:
            here[b : b + block.nu] = True
    for k in np.flatnonzero(here):
        unit = np.broadcast_to(np.eye(nu)[k], p.shape)
        change, doubt = members.slope(energies, {"q": members.along(unit)})
        slopes[:, k], off = change[:, 0], np.maximum(off, doubt)
    mixed = (both(u + other, u + other) - both(u - other, u - other))[:, nu:] / 4
    bilinear = both(u, other)[:, nu:]
    return worst_of(
        relative(value[:, :nu] - p, p),
        missing(slopes, off, value[:, nu:], p),
        relative(bilinear - mixed, mixed, p),
    )


def _ledger(members: Members, force: Array) -> float:
    """b . u is the rate of the energy less the power."""
    inputs, n = members.inputs, members.count
    work = (force * inputs["u"]).sum(axis=-1)
    expected, off, terms = np.zeros(n), np.zeros(n), [force * inputs["u"]]
    if "energy" in members.codes:
        slope, off = members.slope(lambda b: members.call("energy", b), rates_of(members))
        expected, terms = slope.sum(axis=-1), [*terms, slope]
    if "power" in members.codes:
        power = members.call("power")
        expected, terms = expected - power.sum(axis=-1), [*terms, power]
    off = off + _blur(members) * np.abs(inputs["u"]).max(axis=-1, initial=0.0)
    return missing(expected[:, None], off, work[:, None], *terms)


def _blur(members: Members) -> Array:
    """What rounding of the inputs makes of the balance (n,)."""
    return members.blur(lambda at: (at.call("balance")[:, : at.table.kind.nu],))


def _geometric(members: Members) -> float:
    """Forces of second order in u, M u' + C u / 2, change by K u + C u' along the motion."""
    inputs, n = members.inputs, members.table.kind.nu

    def blocks(b: dict[str, Array]) -> Array:
        return members.call("geometric", b).reshape(-1, 3, n, n)

    def force(b: dict[str, Array]) -> Array:
        _, C, M = np.moveaxis(blocks(b), 1, 0)
        return times(M, b["udot"]) + times(C, b["u"]) / 2

    K, C, _ = np.moveaxis(blocks(dict(inputs)), 1, 0)
    rates = {"q": members.along(inputs["u"]), "u": inputs["udot"]}
    change, off = members.slope(force, rates)
    terms = [times(K, inputs["u"]), times(C, inputs["udot"])]
    return missing(change, off, terms[0] + terms[1], *terms)


LAWS: dict[str, Callable[[Members], float | str]] = {
    "balance": balance,
    "balance_tangent": _tangent,
    "geometric": _geometric,
    "gamma": _gamma,
    "power": balance,
    "generalized_momenta": _generalized_momenta,
}
