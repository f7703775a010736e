"""The Jacobian of the right-hand side with respect to the state as it is stored.

Implicit integrators iterate on the stored coordinates. Where these move as a speed says, their
column is the one along the speed, which has a recursion of its own; columns of a unit quaternion
follow from those along its three speeds; other coordinates are differentiated as they stand.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.function import Output
from ...ir.graph import ONE, ZERO
from ...ir.matrix import inner
from .context import Context, recipe
from .derivatives import columns_of, with_mass_matrix
from .directions import Direction, directions
from .functions import rhs

# column of a coordinate: numbers of directions and the node by which each counts
Shares = list[tuple[int, int]]


@recipe
def rhs_jacobian(c: Context) -> tuple[Output, ...]:
    """d rhs / d x (nx, nx), x = [q, u, z], / d t (nx), and, where there are inputs, / d r.

    A unit quaternion counts by its direction: along itself nothing changes.
    """
    c, g = with_mass_matrix(c), c.k.graph
    along, shares = _coordinates(c)
    blocks = [directions(c.k, block, c.names) for block in ("u", "z", "t", "r")]
    outputs = rhs(c)
    columns = columns_of(c, "rhs", outputs, [*along, *(d for block in blocks for d in block)])
    by_q = [
        [inner(g, [columns[n][i] for n, _ in s], [f for _, f in s]) for i in range(len(columns[0]))]
        for s in shares
    ]
    # what is left comes as it was asked for: u, z, t, r
    further, state_count = columns[len(along) :], c.k.system.nu + c.k.system.nz
    rows = [name for output in outputs for name in output.entries]
    states = (*c.names["q"], *c.names["u"], *c.names["z"])
    by_t = Output(
        "d_t", (len(rows),), tuple(further[state_count]), tuple(f"{row},t" for row in rows)
    )
    result = (_matrix("d_x", rows, states, [*by_q, *further[:state_count]]), by_t)
    return (
        (*result, _matrix("d_r", rows, c.names["r"], further[state_count + 1 :]))
        if blocks[3]
        else result
    )


def _matrix(
    name: str, rows: Sequence[str], names: Sequence[str], by: Sequence[Sequence[int]]
) -> Output:
    """Columns as a matrix, row by row."""
    nodes = tuple(column[i] for i in range(len(rows)) for column in by)
    entries = tuple(f"{row},{column}" for row in rows for column in names)
    return Output(name, (len(rows), len(names)), nodes, entries)


def _coordinates(c: Context) -> tuple[list[Direction], list[Shares]]:
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
    return [along[n] for n in used], [[(number[n], f) for n, f in own] for own in shares]


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
