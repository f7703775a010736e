"""What a user writes where a number is wanted, and what it is measured in."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from ..ir.graph import Graph

# What the fields of joints and forces hold, by the name in their annotation: readers and writers
# of files go by it. ``Any`` is a value: a number, an expression or rows of them.
Direction = Any  # "x", "-z" or three values
Place = Any  # a frame, a body or its name
Bodies = Any  # a body or its name, several, or () for all that have mass
JointName = str  # the name of a joint
BeamName = Any  # a beam or its name
LocalNames = Any  # names of the element's own coordinates


@dataclass(frozen=True)
class Ready:
    """Expressions that are made already, in a graph of their own, as the value of a quantity.

    Attributes:
        graph: Where they are; its leaves are atoms by the names of symbols.
        rows, columns: Their shape.
        nodes: The entries, row by row.
    """

    graph: Graph = field(repr=False)
    rows: int
    columns: int
    nodes: tuple[int, ...] = field(repr=False)


@dataclass(frozen=True)
class Quantity:
    """A value as written: becomes expressions when the system graph is built.

    Attributes:
        value: A number, a SymPy expression or symbol, or a nested sequence of them; measured data
            enter as SymPy expressions made by :func:`cardan.table`. Or :class:`Ready`.
        unit: Unit of every entry, "" where dimensionless.
        ratio: True for axes, rotations and ratios, where exact +-1 is structural too.
        local: Symbols in it that stand for the owner's own coordinates; they become atoms.
        labels: Names of the entries, row by row; () for x, y, z of a 3-vector, 1x1 has none.
    """

    value: Any
    unit: str = ""
    ratio: bool = False
    labels: tuple[str, ...] = ()
    local: tuple[str, ...] = ()


def written_unit(unit: str, sliding: bool) -> str:
    """A unit of two forms, such as "N*m*s/rad|N*s/m", as it holds for a joint."""
    return unit.split("|")[-1 if sliding else 0]
