"""Columns of derivatives along coordinates as they are stored.

Where a coordinate moves as a speed says, its column is the one along the speed, which has a
recursion of its own; columns of a unit quaternion follow from those along its three speeds; other
coordinates are differentiated as they stand. A quaternion counts by its direction: along itself
nothing changes.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import inner
from .context import Context
from .directions import Direction, directions

# column of a coordinate: numbers of directions and the node by which each counts
Shares = list[tuple[int, int]]


def along_coordinates(c: Context) -> tuple[list[Direction], list[Shares]]:
    """Directions to differentiate along, and what column of every coordinate is made of them."""
    g, system = c.k.graph, c.k.system
    along = directions(c.k, "q", c.names)
    turns = len(along)
    for m, name in enumerate(c.names["q"]):
        along.append(Direction("stored", m, name, {g.var("q", m): ONE}))
    # as they stand, unless speeds say more
    shares: list[Shares] = [[(turns + m, ONE)] for m in range(system.nq)]
    moves = [{g.nodes[leaf][2]: node for leaf, node in d.seeds.items()} for d in along[:turns]]
    for n, move in enumerate(moves):
        if list(move.values()) == [ONE]:
            shares[next(iter(move))] = [(n, ONE)]
    for joint in system.joints:
        if joint.q >= 0 and joint.element.quaternion is not None:
            slots = range(
                joint.q + joint.element.quaternion, joint.q + joint.element.quaternion + 4
            )
            _rotation_shares(c, slots, moves, shares)
    used = sorted({n for entry in shares for n, _ in entry})
    number = {n: k for k, n in enumerate(used)}
    return [along[n] for n in used], [[(number[n], f) for n, f in entry] for entry in shares]


def combined(
    g: Graph, columns: Sequence[Sequence[int]], shares: Sequence[Shares]
) -> list[list[int]]:
    """Columns of the coordinates from those along the directions."""
    rows = range(len(columns[0]) if columns else 0)
    return [
        [inner(g, [columns[n][i] for n, _ in s], [f for _, f in s]) for i in rows] for s in shares
    ]


def _rotation_shares(
    c: Context, slots: range, moves: Sequence[dict[int, int]], shares: list[Shares]
) -> None:
    """Columns of a unit quaternion, from its three speeds where these alone move it."""
    g = c.k.graph
    turns = [n for n, move in enumerate(moves) if move and set(move) <= set(slots)]
    if len(turns) == 3 and not c.k.chosen:
        # qdot = N w with Nᵀ N = 1/4: a change dq is one along the speeds by 4 Nᵀ dq
        for m in slots:
            shares[m] = [(n, g.mul(g.const(4.0), moves[n].get(m, ZERO))) for n in turns]
        return
    # less what the change along the quaternion itself would do
    q = {m: g.var("q", m) for m in slots}
    plain = {m: shares[m][0][0] for m in slots}
    for m in slots:
        shares[m] = [(plain[j], g.sub(ONE if j == m else ZERO, g.mul(q[j], q[m]))) for j in slots]
