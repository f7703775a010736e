"""Interface of the joints; each is one file."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any, ClassVar

from ...ir.matrix import Matrix
from ...literature import HasSource
from ...records import dataclass
from ..limits import Limit, judge
from ..quantity import Direction, Quantity, Units, Value, quantities_of, take


@dataclass(frozen=True)
class Component:
    """A named coordinate or speed of a joint.

    Attributes:
        name: "" where the joint has only one, else such as "qw", "px", "angle".
        unit: SI unit.
        default: Value where the user names none (1 for the scalar part of a quaternion).
        reach: The joint is regular where the coordinate is smaller in size; None without such a
            bound.
        alone: Whether the name stands by itself, without that of the joint.
        of: The coordinate whose derivative a speed is, where their names do not say it.
    """

    name: str
    unit: str
    default: float = 0.0
    reach: float | None = None
    alone: bool = False
    of: str = ""


@lru_cache(maxsize=64)
def single(unit: str) -> tuple[Component, ...]:
    """The only coordinate of a joint, made once for all joints."""
    return (Component("", unit),)


@lru_cache(maxsize=256)
def _rates(coordinates: tuple[Component, ...]) -> tuple[Component, ...]:
    """The rates of coordinates, made once for all joints with the same ones."""
    return tuple(Component(c.name, (c.unit or "1") + "/s") for c in coordinates)


def entries(head: str, components: Sequence[Component]) -> list[str]:
    """Names of the coordinates or speeds of a joint: the bare one where there is only one."""
    return [c.name if c.alone else f"{head}.{c.name}" if c.name else head for c in components]


@dataclass(frozen=True)
class Step:
    """A turn about a line, or a slide along it, by one coordinate.

    Attributes:
        component: Name of the coordinate.
        axis: The line, in the frame that the steps before lead to.
        slides: Along it, not about it.
    """

    component: str
    axis: Direction
    slides: bool = False


ROTATIONS = tuple(Component(name, "rad") for name in ("rx", "ry", "rz"))
POSITIONS = tuple(Component(name, "m") for name in ("px", "py", "pz"))


def locked_across(axis: Direction, prefix: str) -> tuple[Component, Component]:
    """Rotations ("r") or positions ("p") along the two directions across an axis.

    They are called by the letters of the axes where the axis is one of them, else by 1 and 2.
    """
    k, sign = letter(axis)
    names = "12" if k is None else ("yzx"[k] + "zxy"[k])[::sign]
    unit = "rad" if prefix == "r" else "m"
    return Component(prefix + names[0], unit), Component(prefix + names[1], unit)


def locked_along(axis: Direction, prefix: str) -> str:
    """Name of the rotation ("r") or position ("p") along an axis; 3 if it is not a letter."""
    k, _ = letter(axis)
    return prefix + ("3" if k is None else "xyz"[k])


def letter(axis: Direction) -> tuple[int | None, int]:
    """Axis of the frame along a direction of three entries, with its sign."""
    filled = [(k, x) for k, x in enumerate(axis) if not (isinstance(x, float) and x == 0.0)]
    if len(filled) == 1 and isinstance(filled[0][1], float) and abs(filled[0][1]) == 1.0:
        return filled[0][0], int(filled[0][1])
    return None, 1


class Joint(HasSource, ABC):
    """A joint between a parent frame P and a child frame C.

    The frames coincide at the default q of every kind that is :attr:`coincident`.

    All methods work on expressions; ``data`` are the quantities of :meth:`quantities`, converted.
    6-vectors have the angular part first. In the spanning tree a joint adds its motion
    (``pose``, ``motion``); where it closes a loop it holds the rest (``closure``, ``slip``), or
    the child at the pose of its coordinates.
    """

    kind: ClassVar[str]
    units: ClassVar[Units] = {}
    title: ClassVar[str] = ""
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
        return _rates(tuple(self.coordinates))

    def __post_init__(self) -> None:
        take(self, self.called, self.units)
        judge(self.called, self.limits(), vars(self))

    def limits(self) -> tuple[Limit, ...]:
        """Limits of its numbers."""
        return ()

    @property
    def called(self) -> str:
        """Name for messages."""
        return self.title or f"{self.kind} joint"

    def quantities(self) -> dict[str, Quantity]:
        """The user's values for this joint, by name."""
        return quantities_of(self, self.units)

    @abstractmethod
    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        """R_PC (3, 3) and p_PC (3, 1) in P axes."""

    @abstractmethod
    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        """Modes of motion S (6, nu): velocity of C against P at the origin of C, in C axes."""

    @abstractmethod
    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        """Complementary modes T (6, 6 - nu): Tᵀ S = 0, [S T] regular; in C axes."""

    def steps(self) -> tuple[Step, ...]:
        """Turns and slides that do the same one after the other; () where none do."""
        return ()

    def rates(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix:
        """qdot = N(q) u; by default u."""
        return u

    def speeds_of(self, q: Matrix, qdot: Matrix, **data: Matrix) -> Matrix:
        """u of given rates of the coordinates; by default qdot."""
        return qdot

    def bracket(self, u: Matrix, v: Matrix) -> Matrix:
        """Change of u beyond the rate of a displacement along the speeds, (nu, 1).

        Displacing a motion with the speeds u by v along the speeds changes u by dv/dt + bracket:
        the Lie bracket of the group of the joint, bilinear and skew. Nothing, the default, where
        speeds are rates of coordinates.

        Source: Hamel, Z. Math. Phys. 50 (1904); Lurie, Analytical Mechanics (2002), section 1.8.
        """
        return Matrix.zeros(u.graph, u.rows)

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

    def tangent(self, du: Matrix) -> Matrix:
        """T: a change of du moves integrate(q, du) along the speeds by T times it; by default 1."""
        return Matrix.identity(du.graph, len(du))

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        """Residuals of a relative pose that vanish where the joint closes a loop.

        Nothing, the default, of a joint that :attr:`closes_by_coordinates`.
        They are smooth and of full rank at every pose the joint allows. They may vanish at
        isolated other branches, such as a reversed axis, which :meth:`assembly_signs` tells apart.

        Args:
            R: R_PC, (3, 3).
            p: p_PC in P axes [m], (3, 1).

        Returns:
            (m, 1), m = 6 minus the number of speeds, rotations [rad] before lengths [m].
        """
        return Matrix.zeros(R.graph, 0)

    @property
    def locked(self) -> tuple[Component, ...]:
        """Names and units of the rows of :meth:`closure`.

        The multiplier of a row in rad is a torque [N m], of a row in m a force [N].
        """
        return ()

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        """Numbers (k, 1) that are positive at every pose the joint allows, while one of them is
        not at the other poses where the closure vanishes; by default there are none."""
        return Matrix.zeros(R.graph, 0)

    @property
    def closes_by_coordinates(self) -> bool:
        """True when a pose alone does not say if the joint allows it:

        it keeps its coordinates where it closes a loop.
        """
        return False

    @property
    def bodiless(self) -> bool:
        """True when the coordinates move no body: what moves by them is written in equations."""
        return False

    @property
    def samples(self) -> Sequence[Mapping[str, Any]]:
        """Reference values of another program at some states: a build is compared with them.

        Plain data as in the manifest; nothing where a build is judged by the bodies.
        """
        return ()

    @property
    def lacks(self) -> Mapping[str, str]:
        """Functions that no system with this joint has, and why."""
        return {}

    @property
    def coincident(self) -> bool:
        """True when parent and child frame coincide at the default coordinates."""
        return True

    @property
    def follows(self) -> tuple[str, Value, Value] | None:
        """Leader, ratio and offset of a joint whose coordinate follows that of another."""
        return None

    def slip(self, R: Matrix, p: Matrix, twist: Matrix, **data: Matrix) -> Matrix | None:
        """Velocities (k, 1) [m/s] that vanish beyond the derivative of the closure, or None.

        Args:
            R, p: The relative pose, as in :meth:`closure`.
            twist: Velocity of C against P at the origin of C, in C axes, (6, 1); the result is
                linear in it. In the spanning tree it is S u.
        """
        return None

    def sliding(self, q: Matrix, u: Matrix, **data: Matrix) -> Matrix | None:
        """The velocities of :meth:`slip` by coordinates and speeds, or None.

        A joint that knows a shorter form of them gives that.
        """
        return self.slip(*self.pose(q, **data), self.motion(q, **data) @ u, **data)

    @property
    def slips(self) -> tuple[Component, ...]:
        """Names and units of the rows of :meth:`slip`."""
        return ()

    def reversed(self) -> Joint:
        """The joint with parent and child exchanged, in the same coordinates and speeds.

        Where all motion is along one line it is the same kind along the opposite direction.
        """
        if not self.line:
            return Reversed(self)
        back = tuple(-x if x else x for x in getattr(self, self.line))
        changed: Joint = replace(self, **{self.line: back})  # type: ignore[type-var]
        return changed

    @property
    def quaternion(self) -> int | None:
        """Index in q of the scalar part of a unit quaternion that must be kept normalized."""
        return None

    @property
    def domain(self) -> str:
        """Region in which the coordinates are regular, in words; "" where they are everywhere."""
        return ""


def _shared(name: str) -> Any:
    """A property or method that a joint and its reversal share."""
    return property(lambda self: getattr(self.element, name))


@dataclass(frozen=True)
class Reversed(Joint):
    """A joint whose child carries its parent: the same pose, speeds and data, told backwards.

    Args:
        element: The joint as declared.
    """

    element: Joint

    # told alike in both directions
    coordinates = _shared("coordinates")
    speeds = _shared("speeds")
    quantities = _shared("quantities")
    locked = _shared("locked")
    closes_by_coordinates = _shared("closes_by_coordinates")
    coincident = _shared("coincident")
    follows = _shared("follows")
    sliding = _shared("sliding")
    slips = _shared("slips")
    rates = _shared("rates")
    speeds_of = _shared("speeds_of")
    bracket = _shared("bracket")
    integrate = _shared("integrate")
    difference = _shared("difference")
    tangent = _shared("tangent")
    quaternion = _shared("quaternion")
    domain = _shared("domain")

    def __post_init__(self) -> None:
        object.__setattr__(self, "kind", self.element.kind)
        object.__setattr__(self, "source", self.element.source)

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        return _inverse(*self.element.pose(q, **data))

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        R, p = self.element.pose(q, **data)
        angular, sliding = _halves(self.element.motion(q, **data))
        rotated = R @ angular
        return Matrix.vstack(-rotated, -(R @ sliding + p.skew @ rotated))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        R, p = self.element.pose(q, **data)
        torques, forces = _halves(self.element.constrained(q, **data))
        rotated = R @ forces
        return Matrix.vstack(-(R @ torques + p.skew @ rotated), -rotated)

    def closure(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return self.element.closure(*_inverse(R, p), **data)

    def assembly_signs(self, R: Matrix, p: Matrix, **data: Matrix) -> Matrix:
        return self.element.assembly_signs(*_inverse(R, p), **data)

    def slip(self, R: Matrix, p: Matrix, twist: Matrix, **data: Matrix) -> Matrix | None:
        angular, sliding = _halves(twist)
        rotated = R @ angular
        back = Matrix.vstack(-rotated, -(R @ sliding + p.cross(rotated)))
        return self.element.slip(*_inverse(R, p), back, **data)

    def reversed(self) -> Joint:
        return self.element

    @property
    def rotation(self) -> Any:
        """Rotation parametrization of the joint, None without one."""
        return getattr(self.element, "rotation", None)


def _inverse(R: Matrix, p: Matrix) -> tuple[Matrix, Matrix]:
    """Pose of P in C of the pose of C in P."""
    return R.T, -(R.T @ p)


def _halves(x: Matrix) -> tuple[Matrix, Matrix]:
    return x.block(slice(0, 3)), x.block(slice(3, 6))
