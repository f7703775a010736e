"""Events of elements, judged by what holds for all of them.

Values of events read accelerations and multipliers only where they say so. Gaps fall with the
velocities along which impulses act, and these are the velocities that modes hold; a hold lets go
where its force would pull. Where nothing happens nothing changes.

Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from ..differences import missing, relative, ways, worst_of
from ..joint_motion import Array, times
from .members import Members

# kinds of rows of "jumps", and their numbers, as kernels/finite_elements/mesh_jumps.h has them
UNILATERAL, RESPONSE = (1, 2), 3
KIND, ACTIVE, MISSING, RELEASE, ROW = range(5)
NO_LAW = "no law leads to it"


def signs(members: Members) -> float | str:
    """What they read; gaps along the motion; forces of holds that only push."""
    value, judges = members.call("signs"), 0
    worst = np.nan
    if (value[:, -1] == 0).any():
        judges, worst = 1, worst_of(worst, _unread(members, value))
    for error in (*_gaps(members), *_pulls(members, value), *_jams(members, value)):
        judges, worst = 1, worst_of(worst, error)
    return worst if judges else NO_LAW


def _unread(members: Members, value: Array) -> float:
    """Without the mark of it a value does not depend on accelerations and multipliers."""
    inputs = members.inputs
    other = {name: 1.0 - 3.0 * inputs[name] for name in ("udot", "lam")}
    change = np.abs(members.call("signs", other) - value)[value[:, -1] == 0]
    return relative(change, value[value[:, -1] == 0])


def _gaps(members: Members) -> Iterator[float]:
    """The value of an impact falls as its impulse is fast, where it is not constant in a mode."""
    inputs, kind = members.inputs, members.table.kind
    if "jumps" not in members.codes or not kind.jumps:
        return
    rates = {"q": members.along(inputs["u"])}
    slope, off = members.slope(lambda b: members.call("signs", b), rates)
    numbers, J = jumps(members.call("jumps"), kind.jumps)
    for k in range(min(kind.jumps, kind.ne)):
        clear = np.isin(numbers[:, k, KIND], UNILATERAL) & (np.abs(slope[:, k]) > off)
        if clear.any():
            speed = times(J, inputs["u"])[clear, k : k + 1]
            yield missing(slope[clear, k : k + 1], off[clear], speed, np.abs(inputs["u"][clear]))


def _pulls(members: Members, value: Array) -> Iterator[float]:
    """One value is the force of a hold along the impulse that would push."""
    kind, inputs = members.table.kind, members.inputs
    if not kind.m or "jumps" not in members.codes:
        return
    numbers, J = jumps(members.call("jumps", {"e": np.zeros_like(inputs["e"])}), kind.jumps)
    force = -(
        members.call("balance") - members.call("balance", {"lam": np.zeros_like(inputs["lam"])})
    )[:, : kind.nu]
    for k in range(kind.jumps):
        active = np.isin(numbers[:, k, KIND], UNILATERAL) & (numbers[:, k, ACTIVE] != 0)
        active &= (force != 0).any(axis=-1)
        if active.any():
            row = J[active, k]
            push = (force[active] * row).sum(axis=-1) / (row * row).sum(axis=-1)
            gap = np.abs(value[active, :-1] - push[:, None]).min(axis=-1)
            yield relative(gap[:, None], push[:, None])


def _jams(members: Members, value: Array) -> Iterator[float]:
    """For every friction by a reaction one value is how certain it is, less a constant."""
    k, tau = members.table.kind.frictions, members.inputs["tau"]
    for friction in range(k):
        shifted = tau.copy()
        shifted[:, friction] += 1.0
        change = (members.call("signs", {"tau": shifted}) - value)[:, :-1]
        yield relative(np.sort(change, axis=-1) - np.eye(change.shape[-1])[-1], np.ones((1, 1)))


def impulses(members: Members) -> float | str:
    """Missing speeds grow along the velocities of impulses; these are held in some modes."""
    kind, n, worst, judges = members.table.kind, members.count, np.nan, 0
    if not kind.jumps:
        return 0.0
    numbers, J = jumps(members.call("jumps"), kind.jumps)
    for way in ways(n, kind.nu):
        for k in range(kind.jumps):
            acts = (numbers[:, k, KIND] != RESPONSE) & (numbers[:, k, ACTIVE] != 0)
            if not acts.any():
                continue
            # missing speeds are (1 + restitution) of the velocity, or itself, or nothing
            along = J[:, k] * (times(J, way)[:, k] / (J[:, k] ** 2).sum(axis=-1))[:, None]
            parts = [
                members.slope(lambda b: members.call("jumps", b), {"u": rate})
                for rate in (way, along)
            ]
            index = ROW * k + MISSING
            first, second = (slope[acts, index : index + 1] for slope, _ in parts)
            doubt = sum(off[acts] for _, off in parts)
            judges, worst = 1, worst_of(worst, missing(first, doubt, second, np.abs(J[acts, k])))
    for error in _constrained(members, J):
        judges, worst = 1, worst_of(worst, error)
    return worst if judges else NO_LAW


def _constrained(members: Members, J: Array) -> Iterator[float]:
    """Impulses act along rows that modes hold."""
    kind = members.table.kind
    if not kind.released:
        return
    G = members.constraint_rows()[:, kind.m - kind.released :]
    active = (G != 0).any(axis=(1, 2))
    if not active.any():
        return
    inverse = np.linalg.pinv(G[active])
    for k in range(kind.jumps):
        row = J[active, k]
        yield relative(
            row - times(np.swapaxes(G[active], 1, 2), times(np.swapaxes(inverse, 1, 2), row)), row
        )


def released(members: Members) -> float:
    """H is 1 on the diagonal of rows that hold nothing, else 0; their forces vanish."""
    kind, n = members.table.kind, members.count
    at = kind.parts["H"]
    H = members.call("balance_tangent")[:, at : at + kind.m**2].reshape(n, kind.m, kind.m)
    diagonal, G = np.einsum("nii->ni", H), members.constraint_rows()
    worst = float(np.abs(H - diagonal[:, :, None] * np.eye(kind.m)).max(initial=0.0))
    holds = (G != 0).any(axis=-1)
    worst = max(worst, float(np.abs(diagonal - np.where(holds, 0.0, 1.0)).max(initial=0.0)))
    lam = members.inputs["lam"] * diagonal
    forces = members.call("balance", {"lam": lam}) - members.call("balance", {"lam": 0.0 * lam})
    return worst_of(worst, relative(forces[:, : kind.nu], np.ones((n, 1))))


def change(members: Members) -> float | str:
    """Where nothing happens states stay; behind what happens modes are some that there are."""
    kind, inputs = members.table.kind, members.inputs
    z, s = kind.states
    # speeds as the modes hold them
    u = inputs["u"].copy()
    if kind.m:
        rates = members.call("balance")[:, kind.nu + kind.mp :]
        u -= times(np.linalg.pinv(members.constraint_rows()), rates)
    calm = {"e": np.zeros_like(inputs["e"]), "u": u, "du": u}
    expected = np.concatenate([inputs["z"][:, :z], inputs["s"][:, :s]], axis=-1)
    worst = relative(members.call("change", calm) - expected, expected, np.ones((len(u), 1)))
    behind = members.call("change")[:, z:]
    for k in range(s):
        rows = members.model.manifest.s
        entries = members.table.s
        allowed = [] if entries is None else [int(v) for v in rows[entries[0, k]].labels]
        if allowed and not np.isin(behind[:, k], allowed).all():
            worst = np.inf
    return worst


def jumps(values: Array, count: int) -> tuple[Array, Array]:
    """Numbers (n, count, 4) of rows of "jumps", and gradients (n, count, nu) of velocities."""
    n = len(values)
    split = count * ROW
    return values[:, :split].reshape(n, count, ROW), values[:, split:].reshape(n, count, -1)


LAWS: dict[str, Callable[[Members], float | str]] = {
    "signs": signs,
    "jumps": impulses,
    "change": change,
}
