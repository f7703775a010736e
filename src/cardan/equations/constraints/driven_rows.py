"""Shares of prescribed joints in constraints that no joint makes.

Relations of the user and what elements hold read coordinates, speeds and frames that prescribed
joints move. Along these a multiplier pushes what drives the joint, as it pushes along every speed;
only what else changes with the time in a relation does work of its own.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.function import live
from ...ir.graph import ONE, ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...topology.system import Input, System
from ..kinematics.kinematics import Kinematics
from .constraints import VELOCITY, Constraints, rows

TIMED = (("var", "t"), ("var", "r"))


@dataclass(frozen=True)
class DrivenRows:
    """Rows of relations and of what elements hold, ``rate = G u + D rate_of_drive + still``.

    Attributes:
        shares: Row -> prescribed joint -> its entry in D, where it is not 0.
        still: Row -> what its rate is when nothing moves, where it is not 0.
    """

    shares: dict[int, dict[int, Scalar]]
    still: dict[int, Scalar]

    def along(self, i: int, multipliers: Matrix) -> Scalar:
        """Force of the multipliers (m, 1) along a prescribed joint."""
        total = Matrix.zeros(multipliers.graph, 1)[0]
        for row, shares in self.shares.items():
            if i in shares:
                total = total + multipliers[row] * shares[i]
        return total

    def power(self, chosen: Iterable[int], multipliers: Matrix) -> Scalar:
        """Power of rows on what moves by itself: ``lam G u`` without what drives supply."""
        total = Matrix.zeros(multipliers.graph, 1)[0]
        for row in chosen:
            if row in self.still:
                total = total - multipliers[row] * self.still[row]
        return total


def driven_rows(constraints: Constraints) -> DrivenRows:
    """Shares of prescribed joints in the rows that no joint makes.

    Prescribed coordinates become inputs, with rates of their own, and the rows are differentiated
    by these. A row that is not linear in the prescribed rates keeps all of its work.
    """
    k = constraints.k
    written = {entry.name for entry in k.system.constraints}
    numbers = [i for i, r in enumerate(constraints.rows) if r.switched or r.owner in written]
    if not numbers:
        return DrivenRows({}, {})
    system, first = _with_inputs(k.system)
    other = Kinematics(system, k.chosen)
    g, target = other.graph, k.graph
    rates = [Constraints(other).rates.nodes[i] for i in numbers]
    drives = {i: g.var("r", at + 1) for i, at in first.items()}
    moving = {g.var("u", s): ZERO for s in range(system.nu)} | dict.fromkeys(drives.values(), ZERO)
    meaning = dict[int, int]()
    for i, at in first.items():
        motion = k.system.joints[i].motion
        assert motion is not None
        values = k.resolve([motion.value, motion.rate, motion.acceleration])
        meaning |= {g.var("r", at + n): node for n, node in enumerate(values)}

    def copied(nodes: list[int]) -> list[Scalar]:
        """Expressions in what the inputs stand for."""
        return [Scalar(target, node) for node in rebuild(g, nodes, meaning, into=target)[1]]

    columns = {i: forward(g, rates, {drive: ONE}) for i, drive in drives.items()}
    shares, still = dict[int, dict[int, Scalar]](), dict[int, Scalar]()
    for n, row in enumerate(numbers):
        entries = {i: column[n] for i, column in columns.items() if column[n] != ZERO}
        zeros = moving
        if set(live(g, list(entries.values()))) & set(moving):
            entries, zeros = {}, {g.var("u", s): ZERO for s in range(system.nu)}
        if entries:
            shares[row] = dict(zip(entries, copied(list(entries.values())), strict=True))
        (value,) = copied(rebuild(g, [rates[n]], zeros, into=g)[1])
        if value.node != ZERO:
            still[row] = value
    return DrivenRows(shares, still)


def working(system: System) -> tuple[bool, ...]:
    """Of every relation whether it may do work of its own.

    It contains the time or an input, or speeds that need not vanish where all stand still.
    """
    levels = {row.owner: row.level for row in rows(system)}
    leaves = [live(system.graph, [entry.node]) for entry in system.constraints]
    timed = [any(system.graph.nodes[i][:2] in TIMED for i in order) for order in leaves]
    return tuple(
        has_time or levels[entry.name] == VELOCITY
        for entry, has_time in zip(system.constraints, timed, strict=True)
    )


def _with_inputs(system: System) -> tuple[System, dict[int, int]]:
    """The system with prescribed coordinates as inputs, and joint -> the first of its entries."""
    graph, inputs, joints = system.graph.fork(), list(system.inputs), list(system.joints)
    first = dict[int, int]()
    for i, joint in enumerate(joints):
        if joint.motion is None:
            continue
        first[i] = len(inputs)
        value, rate, acceleration = (graph.var("r", len(inputs) + n) for n in range(3))
        inputs += [Input(f"{joint.name} {n}", "", prescribes=not n) for n in range(3)]
        motion = replace(joint.motion, value=value, rate=rate, acceleration=acceleration)
        joints[i] = replace(joint, motion=motion)
    changed = replace(system, graph=graph, inputs=tuple(inputs), joints=tuple(joints))
    return changed, first
