"""The Jacobian of the right-hand side with respect to the state as it is stored.

Implicit integrators iterate on the stored coordinates; ``coordinate_columns`` makes their columns.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.function import Output
from .context import Context, recipe
from .coordinate_columns import along_coordinates, combined
from .derivatives import columns_of, with_mass_matrix
from .directions import directions
from .functions import rhs


@recipe
def rhs_jacobian(c: Context) -> tuple[Output, ...]:
    """d rhs / d x (nx, nx), x = [q, u, z], / d t (nx), and, where there are inputs, / d r.

    A unit quaternion counts by its direction: along itself nothing changes.
    """
    c, g = with_mass_matrix(c), c.k.graph
    along, shares = along_coordinates(c)
    blocks = [directions(c.k, block, c.names) for block in ("u", "z", "t", "r")]
    outputs = rhs(c)
    columns = columns_of(c, "rhs", outputs, [*along, *(d for block in blocks for d in block)])
    by_q = combined(g, columns, shares)
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
