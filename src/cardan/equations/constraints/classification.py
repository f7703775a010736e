"""Kinds of the constraints of a system, and those on speeds that could be on positions.

A row a(q) u = 0 follows from positions where the motions that all such rows allow commute along it:
a is then closed on them (Frobenius). Both are measured at random positions: the derivatives of a
along two allowed motions, exchanged, less a of their commutator.

Source: E. J. Saletan, A. H. Cromer, Theoretical Mechanics (1971), section 4.1; H. Flanders,
Differential Forms, section 7.3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...ir.function import live
from ...ir.interpreter import evaluate
from ...records import dataclass
from ..functions import blocks
from .constraints import POSITION, rows
from .feasibility import search, value

if TYPE_CHECKING:
    from ..record import EquationRecord

STATES = 3
STEP = 1e-5  # of differences
SMALL = 1e-6  # what differences leave of 0, relative to the rows


@dataclass(frozen=True)
class Classified:
    """One constraint.

    Attributes:
        name, owner: Of its multiplier, and the joint or relation it belongs to.
        level: ``"position"`` or ``"velocity"``.
        rheonomic: Whether time or inputs stand in it.
        integrable: Whether it follows from positions: always at position level.
    """

    name: str
    owner: str
    level: str
    rheonomic: bool
    integrable: bool

    def __str__(self) -> str:
        kind = "rheonomic" if self.rheonomic else "scleronomic"
        what = "holonomic" if self.integrable else "nonholonomic"
        note = ""
        if self.integrable and self.level != POSITION:
            note = "; note: it is integrable, so that it could be written for positions"
        return f"{self.name}: {self.level} level, {kind}, {what}{note}"


@dataclass(frozen=True)
class Classification:
    """The constraints of a system by kind.

    Attributes:
        rows: In the order of the multipliers.
    """

    rows: tuple[Classified, ...]

    def __str__(self) -> str:
        return "\n".join(str(row) for row in self.rows) or "no constraints"


def classification(equations: EquationRecord, seed: int = 1) -> Classification:
    """Look at all constraints.

    Args:
        equations: Of any system.
        seed: Of the positions at which integrability is measured.
    """
    every = rows(equations.system)
    if not every:
        return Classification(())
    function = equations.function("constraint_rates")
    timed = []
    for node in function.outputs[0].nodes:
        kinds = {function.graph.nodes[i][:2] for i in live(function.graph, [node])}
        timed.append(bool({("var", "t"), ("var", "r")} & kinds))
    fast = [k for k, row in enumerate(every) if row.level != POSITION]
    closed = _integrable(equations, len(every) - len(fast), fast, seed) if fast else set[int]()
    classified = [
        Classified(row.name, row.owner, row.level, timed[k], row.level == POSITION or k in closed)
        for k, row in enumerate(every)
    ]
    return Classification(tuple(classified))


def _integrable(
    equations: EquationRecord, position_count: int, fast: list[int], seed: int
) -> set[int]:
    """Rows of velocities that together are closed on the motions they allow."""
    samples = [_Sample(equations, q) for q in _places(equations, position_count, seed)]
    left = set(fast)
    while left:
        # rows that are not closed let more motions in: look again without them
        chosen = [*range(position_count), *sorted(left)]
        bad = {k for sample in samples for k in sample.bent(chosen, left)}
        if not bad:
            break
        left -= bad
    return left


def _places(equations: EquationRecord, position_count: int, seed: int) -> list[Array]:
    """Random positions (nq,) at which loops are closed."""
    system = equations.system
    start = np.array([default for _, _, default in blocks.coordinates(system)])
    offsets = np.random.default_rng(seed).normal(0.0, 0.3, (STATES, system.nu))
    defaults = blocks.defaults(equations.system)
    move = equations.function("integrate")
    q = evaluate(move, {**defaults, "q": start, "du": offsets}, "numpy")["q"]
    q = np.broadcast_to(q, (STATES, len(start))).astype(np.float64)
    if position_count:
        names = ("constraints", "constraint_jacobian", "integrate")
        q = search({name: equations.function(name) for name in names}, defaults, q)
    return list(q)


class _Sample:
    """Rows and their exterior derivatives at one position."""

    def __init__(self, equations: EquationRecord, q: Array) -> None:
        self.defaults, self.q = blocks.defaults(equations.system), q
        self.jacobian = equations.function("constraint_jacobian")
        self.rates = equations.function("qdot")
        nu, nq = equations.system.nu, len(q)
        self.N = self._kinematics(q)
        # derivatives of G (nu, m, nu) and of the motions N (nu, nq, nu) along every speed
        self.G = self._rows(q)
        sides = [(q + STEP * way, q - STEP * way) for way in self.N.T]
        bend = np.array([(self._rows(a) - self._rows(b)) / (2 * STEP) for a, b in sides])
        turn = np.array(
            [(self._kinematics(a) - self._kinematics(b)) / (2 * STEP) for a, b in sides]
        ).reshape(nu, nq, nu)
        # commutators of the speeds, as speeds: c[:, i, j] of motions i and j
        moved = np.einsum("iqj->qij", turn) - np.einsum("jqi->qij", turn)
        commutator = np.einsum("uq,qij->uij", np.linalg.pinv(self.N), moved)
        curl = np.einsum("imj->mij", bend) - np.einsum("jmi->mij", bend)
        self.exterior: Array = curl - np.einsum("mu,uij->mij", self.G, commutator)

    def _rows(self, q: Array) -> Array:
        rows: Array = value(self.jacobian, {**self.defaults, "q": q[np.newaxis]}, 1)[0]
        return rows

    def _kinematics(self, q: Array) -> Array:
        nu = self.jacobian.outputs[0].shape[1]
        basis = np.concatenate([np.zeros((1, nu)), np.eye(nu)])
        rates = value(self.rates, {**self.defaults, "q": q[np.newaxis], "u": basis}, len(basis))
        return np.asarray(rates[1:] - rates[0]).T

    def bent(self, chosen: list[int], candidates: set[int]) -> set[int]:
        """Rows that are not closed on what the chosen rows allow."""
        G = self.G[chosen]
        _, s, Vt = np.linalg.svd(G)
        rank = int(np.sum(s > 1e-9 * s.max(initial=1e-300)))
        free = Vt[rank:].T
        nonintegrable = set()
        for k in candidates:
            form = free.T @ self.exterior[k] @ free
            size = max(1.0, float(np.abs(self.exterior[k]).max()), float(np.abs(self.G[k]).max()))
            if form.size and np.abs(form).max() > SMALL * size:
                nonintegrable.add(k)
        return nonintegrable
