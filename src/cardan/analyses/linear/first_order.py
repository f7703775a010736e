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
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from scipy.linalg import qr

from ...arrays import Array, Integers
from ...errors import ModelError, SolveError
from ..systems.dynamic_system import Contract, Moment, Tangents, dense
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
        """Which are independent, for others to choose alike."""
        return self.e, self.v


def first_order(
    system: Contract,
    at: Moment,
    held: Sequence[int] = (),
    tau: Array | None = None,
    choice: Choice | None = None,
) -> FirstOrder:
    """Small motions about a motion that is at a given moment.

    Args:
        system: The system.
        at: A state on the constraints; accelerations are those of the motion.
        held: Speeds (places) that are held.
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
    found = system.tangents(at)
    G, R = (dense(x) / system.rows[:, None] * columns for x in (found.G, found.R))
    hold = np.eye(nu)[list(held)]
    weights = np.where(system.leading, LEADING, 1.0)
    kept, wanted = (None, None) if choice is None else choice
    allowed, e = chosen(np.concatenate([G[system.positions], hold]), weights, kept)
    moving, v = chosen(np.concatenate([G, hold]), weights, wanted)
    # speeds that keep R e + G v = 0 where increments change, with the independent ones as they are
    kept = np.concatenate([G, hold, np.eye(nu)[v]])
    gap = np.concatenate([R @ allowed, np.zeros((len(kept) - len(G), len(e)))])
    follow = -np.linalg.lstsq(kept, gap)[0]
    rest = np.zeros((nu, nz))
    increments = np.concatenate([allowed, np.zeros((nu, len(v))), rest], axis=1)
    speeds = np.concatenate([follow, moving, rest], axis=1)
    unit = np.concatenate([columns[e], columns[v], np.ones(nz)])
    increments, speeds = (x * columns[:, None] / unit for x in (increments, speeds))
    states = np.eye(nz, len(unit), len(unit) - nz)
    own = system.rates(at, tau)
    rates = own.along @ increments + own.by_u @ speeds + own.by_z @ states
    by_r = own.by_r
    if len(held):
        answer = pushed(system, at, held, found)
        rates, by_r = (_kept(answer, held, x) for x in (rates, by_r))
    E, W = system.observer(at)
    turned = E @ increments + speeds
    A = np.concatenate([turned[e], (rates[:nu] - W @ speeds)[v], rates[nu:]])
    B = np.concatenate([np.zeros((len(e), by_r.shape[1])), by_r[:nu][v], by_r[nu:]])
    return FirstOrder(A, B, e, v, increments, speeds)


def eigenvalues(system: Contract, at: Moment, held: Sequence[int], tau: Array) -> Any:
    """How small motions grow (n,) [1/s]; None where accelerations are not determined."""
    try:
        return np.linalg.eigvals(first_order(system, at, held, tau).A)
    except (SolveError, Singular, np.linalg.LinAlgError):
        return None


def pushed(
    system: Contract, at: Moment, places: Sequence[int], tangents: Tangents | None = None
) -> Array:
    """Accelerations (nu, k) that unit forces along speeds make, constraints kept."""
    columns, found = system.columns, tangents or system.tangents(at)
    M = dense(found.M) * columns * columns[:, None]
    G = dense(found.G) / system.rows[:, None] * columns
    push = np.eye(len(columns))[list(places)] * columns
    answer = Dense().solve(M, G, push.T, np.zeros((len(G), len(push))))[0]
    return answer * columns[:, None]


def _kept(answer: Array, held: Sequence[int], rates: Array) -> Array:
    """Rates (nu + nz, n) after forces that keep what is held."""
    found = rates.copy()
    found[: len(answer)] -= answer @ np.linalg.lstsq(answer[list(held)], rates[list(held)])[0]
    return found


def chosen(G: Array, weights: Array, wanted: Integers | None = None) -> tuple[Array, Integers]:
    """A basis (n, k) of what G allows, with the unit matrix in the rows that are chosen.

    Args:
        G: Constraints (m, n), without units.
        weights: How much each entry is preferred (n,): coordinates of joints do not depend on who
            looks at them.
        wanted: The choice, where it is made.

    Raises:
        SolveError: what is wanted does not determine the others.
    """
    basis = split(G)[2]
    k = basis.shape[1]
    rows = wanted
    if rows is None:
        order = qr(basis.T * weights, mode="r", pivoting=True)[1] if k else np.zeros(0, np.intp)
        rows = np.sort(order[:k])
    if len(rows) != k or (k and np.linalg.cond(basis[rows]) > DEPENDENT):
        raise SolveError("independent coordinates were chosen elsewhere: they are none here")
    if k == len(basis):
        return np.eye(k), rows
    return basis @ np.linalg.inv(basis[rows]), rows
