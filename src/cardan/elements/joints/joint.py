"""What every joint states in its one file."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from ...ir.matrix import Matrix
from ..quantity import Quantity


@dataclass(frozen=True)
class Component:
    """A named coordinate or speed of a joint.

    Attributes:
        name: "" where the joint has only one, else such as "w", "px", "angle".
        unit: SI unit.
        default: Value where the user names none (1 for the scalar part of a quaternion).
    """

    name: str
    unit: str
    default: float = 0.0


class Joint(ABC):
    """A joint between a parent frame P and a child frame C that coincide at the default q.

    All methods work on expressions; ``data`` are the quantities of :meth:`quantities`, converted.
    6-vectors have the angular part first.
    """

    kind: ClassVar[str]
    source: ClassVar[str]
    # the quantity that is the line of all motion, "" if there is none: joint frames may be turned
    # about it and moved along it
    line: ClassVar[str] = ""
    # which coordinate is an angle about that line and nothing else
    angle: ClassVar[int | None] = None

    @property
    @abstractmethod
    def coordinates(self) -> tuple[Component, ...]:
        """The coordinates q of the joint, in order."""

    @property
    def speeds(self) -> tuple[Component, ...]:
        """The speeds u of the joint, in order; by default the rates of the coordinates."""
        return tuple(Component(c.name, (c.unit or "1") + "/s") for c in self.coordinates)

    def quantities(self) -> dict[str, Quantity]:
        """What the user wrote about this joint, by name."""
        return {}

    @abstractmethod
    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        """R_PC (3, 3) and p_PC (3, 1) in P axes."""

    @abstractmethod
    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        """Modes of motion S (6, nu): velocity of C against P at the origin of C, in C axes."""

    @abstractmethod
    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        """Complementary modes T (6, 6 - nu): Tᵀ S = 0, [S T] regular; in C axes."""

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        """qdot = N(q) u; by default u."""
        return u

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        """u of given rates of the coordinates; by default qdot."""
        return qdot

    def convective(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix | None:
        """Acceleration of C against P at the origin of C that needs no udot (6, 1), in C axes.

        As seen from P: Sdot u and [0; omega x v]. None, the default, has it derived from S;
        a joint whose terms cancel says zero.
        """
        return None

    def integrate(self, q: Matrix, du: Matrix, **data: Matrix) -> Matrix:
        """q moved by the finite increment du along the speeds; by default q + du."""
        return q + du

    def difference(self, q0: Matrix, q1: Matrix, **data: Matrix) -> Matrix:
        """The du with integrate(q0, du) = q1; by default q1 - q0."""
        return q1 - q0

    @property
    def quaternion(self) -> int | None:
        """Index in q of the scalar part of a unit quaternion that must be kept normalized."""
        return None

    @property
    def domain(self) -> str:
        """Where the coordinates are regular, in words; "" where they are everywhere."""
        return ""
