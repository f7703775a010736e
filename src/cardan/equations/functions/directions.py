"""Directions in which the arguments of a function change: the columns of its derivatives."""

from __future__ import annotations

from dataclasses import field

from ...errors import DerivationError, near
from ...ir.derivative import forward
from ...ir.graph import ONE
from ...records import dataclass
from ...schema.blocks import DIRECTIONS
from ..kinematics.kinematics import Kinematics


@dataclass(frozen=True)
class Direction:
    """One column.

    Attributes:
        block: Letter of the block that changes.
        index: Entry; of q: the speed along which it changes.
        name: For the reader.
        seeds: Leaf -> its change.
    """

    block: str
    index: int
    name: str
    seeds: dict[int, int] = field(repr=False)


def directions(k: Kinematics, wrt: str, names: dict[str, tuple[str, ...]]) -> list[Direction]:
    """The columns of one block, or of one parameter or input.

    Args:
        k: Motion of the tree.
        wrt: Letter of a block, or the name of a parameter or input. ``"q"`` stands for nu
            columns: the coordinates change as they do at unit speeds.
        names: Entries of every block.

    Raises:
        DerivationError: there is no such block or name.
    """
    if wrt == "q":
        return _along_speeds(k, names["u"])
    if wrt in DIRECTIONS:
        return [_entry(k, wrt, n, name) for n, name in enumerate(names[wrt])]
    for block in ("p", "r"):
        if wrt in names[block]:
            return [_entry(k, block, names[block].index(wrt), wrt)]
    names_available = [*DIRECTIONS, *names["p"], *names["r"]]
    raise DerivationError(
        f"derivative: '{wrt}' is not a block ({', '.join(DIRECTIONS)}), parameter or input."
        f"{near(wrt, names_available)}"
    )


def is_single(wrt: str) -> bool:
    """True when there is one column, and no axis for it: t, and parameters and inputs by name."""
    return wrt == "t" or wrt not in DIRECTIONS


def _entry(k: Kinematics, block: str, index: int, name: str) -> Direction:
    return Direction(block, index, name, {k.graph.var(block, index): ONE})


def _along_speeds(k: Kinematics, names: tuple[str, ...]) -> list[Direction]:
    """Columns of N in qdot = N(q) u + n(t, q) as changes of q."""
    g, system, directions_of_speeds = k.graph, k.system, []
    for n, name in enumerate(names):
        column = forward(g, k.rates.nodes, {g.var("u", n): ONE})
        seeds = {g.var("q", m): node for m, node in enumerate(column) if node}
        directions_of_speeds.append(Direction("q", n, name, seeds))
    assert len(directions_of_speeds) == system.nu
    return directions_of_speeds
