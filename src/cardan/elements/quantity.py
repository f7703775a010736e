"""Values that users write in place of numbers, with their units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, fields
from typing import TYPE_CHECKING, Any, TypeAlias

from ..errors import ModelError, brief
from ..ir.graph import Graph
from ..records import dataclass
from .validation import axis, number, vector

if TYPE_CHECKING:
    import sympy

# What the fields of joints and forces hold, by the name in their annotation: readers and writers
# of files go by it.
Value: TypeAlias = "float | sympy.Expr"  # a number or an expression; a matrix of SymPy too
Rows = Any  # one value or rows of them
Direction = Any  # "x", "-z" or three values
Vector = Any  # three values
Pair = Any  # one value for both directions across a beam, or two
Place = Any  # a frame, a body or its name
Bodies = Any  # a body or its name, several, or () for all that have mass
JointName = str  # the name of a joint
BeamName = Any  # a beam or its name
LocalNames = Any  # names of the element's own coordinates
Curves = Any  # measured functions by direction


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
        units: Of the entries, row by row, where they differ.
    """

    value: Rows
    unit: str = ""
    ratio: bool = False
    labels: tuple[str, ...] = ()
    local: tuple[str, ...] = ()
    units: tuple[str, ...] = ()


# in place of a unit: the field is a direction or a ratio, where exact +-1 is structural too
RATIO = "ratio"
# unit by the name of a field
Units = Mapping[str, str]


def take(element: Any, who: str, units: Units) -> None:
    """Check the fields of an element by their annotations, numbers by their units, as written.

    Args:
        element: A frozen record; None stays where it is the default of a field.
        who: What it is called in messages.
        units: By the names of the fields that are quantities.

    Raises:
        ModelError: a field holds something else.
    """
    for entry in fields(element):
        value = getattr(element, entry.name)
        if value is None and entry.default is None:
            continue
        if entry.type == "Direction":
            value = axis(who, entry.name, value)
        elif entry.type == "Vector":
            value = vector(who, entry.name, value, 3)
        elif entry.name in units:
            value = number(who, entry.name, value)
        elif entry.type == "bool" and type(value).__name__ not in ("bool", "bool_"):
            raise ModelError(f"{who}: {entry.name} is True or False, not {brief(value)}")
        object.__setattr__(element, entry.name, value)


def quantities_of(element: object, units: Units) -> dict[str, Quantity]:
    """The fields that have units and are given, in the order of these."""
    values = {name: getattr(element, name) for name in units}
    return {
        name: Quantity(value, "", ratio=True)
        if units[name] == RATIO
        else Quantity(value, units[name])
        for name, value in values.items()
        if value is not None
    }


def annotated(element: Any, annotation: str) -> dict[str, Any]:
    """The fields with an annotation, by name."""
    return {f.name: getattr(element, f.name) for f in fields(element) if f.type == annotation}


def written_unit(unit: str, sliding: bool) -> str:
    """A unit of two forms, such as "N*m*s/rad|N*s/m", as it holds for a joint."""
    return unit.split("|")[-1 if sliding else 0]
