"""Finite increments of coordinates along the speeds, joint by joint."""

from __future__ import annotations

from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ..functions.dynamics import Dynamics


def integrated(d: Dynamics) -> Matrix:
    """The coordinates (nq, 1) that the increment ``du`` leads to from ``q``."""
    system = d.k.system
    nodes = [ZERO] * system.nq
    start, step = d.block("q", system.nq), d.block("du", system.nu)
    for i, joint in enumerate(system.joints):
        if joint.q >= 0:
            q, u = _slots(d, i)
            moved = joint.element.integrate(start.block(q), step.block(u), **d.k.data[i])
            nodes[q] = moved.nodes
    return Matrix(d.k.graph, system.nq, 1, nodes)


def difference(d: Dynamics) -> Matrix:
    """The increment (nu, 1) that leads from ``q0`` to ``q``."""
    system = d.k.system
    nodes = [ZERO] * system.nu
    start, end = d.block("q0", system.nq), d.block("q", system.nq)
    for i, joint in enumerate(system.joints):
        if joint.q >= 0:
            q, u = _slots(d, i)
            step = joint.element.difference(start.block(q), end.block(q), **d.k.data[i])
            nodes[u] = step.nodes
    return Matrix(d.k.graph, system.nu, 1, nodes)


def _slots(d: Dynamics, i: int) -> tuple[slice, slice]:
    """Places of a joint's coordinates and speeds."""
    joint = d.k.system.joints[i]
    q, u = joint.q, joint.u
    return slice(q, q + len(joint.element.coordinates)), slice(u, u + len(joint.element.speeds))
