"""Parameters, inputs and outputs as declared, and the placeholders of expressions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..records import dataclass

if TYPE_CHECKING:
    import sympy


@dataclass(frozen=True)
class Declared:
    """A declared parameter or input.

    Attributes:
        name: Its name, that of its symbol.
        value: Default value in SI.
        unit: SI unit, "" where none was given.
        stated: True where a unit was given (then it is checked where the symbol is used).
    """

    name: str
    value: float
    unit: str
    stated: bool


@dataclass(frozen=True)
class Placeholder:
    """A symbol that stands for a component of the motion of a frame or a joint.

    Attributes:
        quantity: position velocity acceleration angular_velocity rotation q u.
        place: The frame or body; the joint name (for q and u).
        wrt, in_: Frames or bodies against which and in whose axes; None for the ground.
        component: Row-major entry; the component name (for q and u).
    """

    quantity: str
    place: Any
    wrt: Any
    in_: Any
    component: Any


@dataclass(frozen=True)
class Output:
    """A named expression to be computed, in SI."""

    name: str
    expression: sympy.Expr
    unit: str


@dataclass(frozen=True)
class Constraint:
    """A named expression that is kept at 0, in SI."""

    name: str
    expression: sympy.Expr
    unit: str
