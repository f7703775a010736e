"""Small motions as x' = A x + B r in independent increments and speeds, constraints eliminated.

Increments e along the speeds, changes v of the speeds and z of internal states obey

    e' = E e + v,   v' and z' as derivatives of the accelerations say,   Gp e = 0,   R e + G v = 0.

Some increments and speeds are independent; which, is chosen by pivoting and does not change with
time, so that the equations of the others hold to first order about accelerating states too.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13; R. A.
Wehage, E. J. Haug, J. Mech. Design 104 (1982) for the partition.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from scipy.linalg import qr

from ...arrays import Array, Integers
from ...errors import ModelError, SolveError
from ...records import dataclass
from ..systems.dynamic_system import DynamicSystem, Moment, Tangents, dense
from ..systems.saddle_point import Dense, Singular, split

# places of the independent increments and speeds
Choice: TypeAlias = tuple[Integers, Integers]
LEADING = 1e3  # times the share in motions that others need to be chosen instead
DEPENDENT = 1e10  # condition beyond which a choice of independent ones is none
# speeds up to which full matrices are made: a few dozen of 70 MB each
FULL = 3000


@dataclass(frozen=True, eq=False)
class FirstOrder:
    """x' = A x + B r, x = [independent increments, independent speeds, internal states].

    Attributes:
        A, B: (n, n), (n, nr).
        e, v: Independent increments and speeds, as places of speeds.
        increments, speeds: All increments and changes of speeds by x, (nu, n) each.
    """

    A: Array
    B: Array
    e: Integers
    v: Integers
    increments: Array
    speeds: Array

    @property
    def choice(self) -> Choice:
        """Choice of independent coordinates, for others to use as well."""
        return self.e, self.v


def first_order(
    system: DynamicSystem,
    at: Moment,
    locked: Sequence[int] = (),
    tau: Array | None = None,
    choice: Choice | None = None,
) -> FirstOrder:
    """Small motions about a motion that is at a given moment.

    Args:
        system: The system.
        at: A state on the constraints; accelerations are those of the motion.
        locked: Speeds (places) that are held.
        tau: Forces along the speeds (nu,) that act besides those of the scene, such as hold.
        choice: Independent increments and speeds, where they are not to be chosen anew.

    Raises:
        ModelError: so many speeds that full matrices are out of the question.
    """
    columns, nu, nz = system.columns, len(system.columns), len(system.internals)
    if nu > FULL:
        raise ModelError(
            f"model '{system.name}' has {nu} speeds: the matrices of its first-order form are "
            f"full, and more than {FULL} speeds are too many. model.modes() and "
            "model.equilibrium() take sparse ones; or let beams have fewer elements"
        )
    # scaled linear constraints: R e + G v = 0
    tangents = system.tangents(at)
    G, R = (dense(x) / system.rows[:, None] * columns for x in (tangents.G, tangents.R))
    lock_rows = np.eye(nu)[list(locked)]
    weights = np.where(system.leading, LEADING, 1.0)
    independent_e, independent_v = (None, None) if choice is None else choice
    # null spaces of the position and of all constraint rows: independent increments e, speeds v
    allowed, e = chosen(np.concatenate([G[system.positions], lock_rows]), weights, independent_e)
    moving, v = chosen(np.concatenate([G, lock_rows]), weights, independent_v)
    # speeds that keep R e + G v = 0 where increments change, with the independent ones as they are
    independent_e = np.concatenate([G, lock_rows, np.eye(nu)[v]])
    gap = np.concatenate([R @ allowed, np.zeros((len(independent_e) - len(G), len(e)))])
    follow = -np.linalg.lstsq(independent_e, gap)[0]
    remaining = np.zeros((nu, nz))
    increments = np.concatenate([allowed, np.zeros((nu, len(v))), remaining], axis=1)
    speeds = np.concatenate([follow, moving, remaining], axis=1)
    unit = np.concatenate([columns[e], columns[v], np.ones(nz)])
    increments, speeds = (x * columns[:, None] / unit for x in (increments, speeds))
    states = np.eye(nz, len(unit), len(unit) - nz)
    # chain rule: accelerations and internal rates along the chosen basis
    internal = system.rates(at, tau)
    rates = internal.along @ increments + internal.by_u @ speeds + internal.by_z @ states
    by_r = internal.by_r
    if len(locked):
        answer = unit_force_accelerations(system, at, locked, tangents)
        rates, by_r = (_with_lock_forces(answer, locked, x) for x in (rates, by_r))
    # in the axes of the observer: e' = E e + v and v' + W v
    E, W = system.observer(at)
    kinematic = E @ increments + speeds
    A = np.concatenate([kinematic[e], (rates[:nu] - W @ speeds)[v], rates[nu:]])
    B = np.concatenate([np.zeros((len(e), by_r.shape[1])), by_r[:nu][v], by_r[nu:]])
    return FirstOrder(A, B, e, v, increments, speeds)


def eigenvalues(system: DynamicSystem, at: Moment, locked: Sequence[int], tau: Array) -> Any:
    """Growth rates of small motions (n,) [1/s]; None where accelerations are not determined."""
    try:
        return np.linalg.eigvals(first_order(system, at, locked, tau).A)
    except (SolveError, Singular, np.linalg.LinAlgError):
        return None


def unit_force_accelerations(
    system: DynamicSystem, at: Moment, places: Sequence[int], tangents: Tangents | None = None
) -> Array:
    """Accelerations (nu, k) that unit forces along speeds make, constraints kept."""
    columns, tangent = system.columns, tangents or system.tangents(at)
    M = dense(tangent.M) * columns * columns[:, None]
    G = dense(tangent.G) / system.rows[:, None] * columns
    push = np.eye(len(columns))[list(places)] * columns
    answer = Dense().solve(M, G, push.T, np.zeros((len(G), len(push))))[0]
    return answer * columns[:, None]


def _with_lock_forces(answer: Array, locked: Sequence[int], rates: Array) -> Array:
    """Rates (nu + nz, n) after forces that keep what is held."""
    corrected = rates.copy()
    corrected[: len(answer)] -= (
        answer @ np.linalg.lstsq(answer[list(locked)], rates[list(locked)])[0]
    )
    return corrected


def chosen(G: Array, weights: Array, independent: Integers | None = None) -> tuple[Array, Integers]:
    """A basis (n, k) of what G allows, with the unit matrix in the rows that are chosen.

    Args:
        G: Constraints (m, n), without units.
        weights: How much each entry is preferred (n,): coordinates of joints do not depend on who
            looks at them.
        independent: The choice, where it is made.

    Raises:
        SolveError: what is wanted does not determine the others.
    """
    basis = split(G)[2]
    k = basis.shape[1]
    rows = independent
    if rows is None:
        order = qr(basis.T * weights, mode="r", pivoting=True)[1] if k else np.zeros(0, np.intp)
        rows = np.sort(order[:k])
    if len(rows) != k or (k and np.linalg.cond(basis[rows]) > DEPENDENT):
        raise SolveError("independent coordinates were chosen elsewhere: they are none here")
    if k == len(basis):
        return np.eye(k), rows
    return basis @ np.linalg.inv(basis[rows]), rows
