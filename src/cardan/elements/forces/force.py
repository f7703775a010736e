"""Interface of the force elements; each is one file."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, Protocol

from ...errors import ModelError, brief
from ...ir.arithmetic import Scalar
from ...ir.function import live
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...literature import HasSource
from ...records import dataclass
from ..formulas import Lines, Shapes
from ..internal_states import (
    Change,
    EventSpec,
    Impulse,
    Internal,
    Jumped,
    Mode,
    ModeConstraint,
    Solved,
)
from ..limits import Limit, judge
from ..quantity import Direction, Quantity, Units, Value, annotated, quantities_of, take

LINE, JOINT, FRAME = "line", "joint", "frame"


class Motion(Protocol):
    """Quantities of the moving system that an element may read; in ground axes unless stated.

    Frames and joints are numbers of the system graph.
    """

    graph: Graph

    def position(self, frame: int) -> Matrix: ...
    def rotation(self, frame: int) -> Matrix: ...
    def velocity(self, frame: int) -> Matrix: ...
    def angular_velocity(self, frame: int) -> Matrix: ...
    def spin(self, frame: int) -> Matrix:
        """Angular velocity of a frame (3, 1), in its own axes."""

    def arm(self, start: int, end: int) -> Matrix:
        """From the origin of a frame to that of another (3, 1), in axes of the latter."""

    def in_frame(self, x: Matrix, start: int, end: int) -> Matrix:
        """A vector in axes of a frame (3, 1), in those of another."""

    def q(self, joint: int) -> Matrix: ...
    def u(self, joint: int) -> Matrix: ...
    @property
    def time(self) -> Scalar: ...


@dataclass(frozen=True)
class Load:
    """A wrench on a frame: force at its origin and torque, (3, 1) each.

    They are given in axes of the ground, or of the frame ``axes``.
    """

    frame: int
    torque: Matrix
    force: Matrix
    axes: int = 0


@dataclass(frozen=True)
class JointLoad:
    """A generalized force (nu_joint, 1) along the speeds of a joint."""

    joint: int
    force: Matrix


@dataclass(frozen=True)
class RotorBody:
    """The body ``<element>.rotor`` that an element needs besides those of the scene.

    It turns about a line of what carries it, and has inertia about that line alone.

    Attributes:
        inertia: About the line [kg m^2].
        joint: Name of the joint along whose axis, in whose parent it turns; "" for ``axis`` in
            ``frame``.
        ratio: Its turns per turn of that joint, where it follows that; else it has a coordinate.
        frame, axis: What carries it, and the line.
        speed: At which it turns, where that is prescribed [rad/s].
    """

    inertia: Value
    joint: str = ""
    ratio: Value | None = None
    frame: Any = None
    axis: Direction | None = None
    speed: Value | None = None


@dataclass(frozen=True)
class Action:
    """One thing an element does.

    Attributes:
        loads: Wrenches on frames.
        joint_loads: Forces along joint speeds.
        potential: Its potential energy at the present time and inputs, where it has one.
        constant: Whether that depends on the position and parameters alone; then its power stays
            out of the ledger.
    """

    loads: tuple[Load, ...] = ()
    joint_loads: tuple[JointLoad, ...] = ()
    potential: Scalar | None = None
    constant: bool = True

    @property
    def stored(self) -> Scalar | None:
        """The potential energy that the ledger counts."""
        return self.potential if self.constant else None


@dataclass(frozen=True)
class Places:
    """Attachments and states of an element.

    Attributes:
        motion: The moving system.
        data: Its quantities by name; ``mass``, ``com`` (3, 1) and ``inertia`` (3, 3) of the body
            where it acts by mass, about the center of mass and in axes of the body.
        frames, joints: Numbers of its frames and joints, by role; of the body as ``body``.
        z: Its internal states (their number, 1).
        s: Its modes (their number, 1).
        reaction_force: What stands for the force that follows from the reaction of its joint; None
            where the element is not :attr:`ForceElement.by_reaction`.
    """

    motion: Motion
    data: Mapping[str, Matrix]
    frames: Mapping[str, int]
    joints: Mapping[str, int]
    z: Matrix
    s: Matrix
    reaction_force: Scalar | None = None


class ForceElement(HasSource, ABC):
    """A force between frames or along joints.

    An element with a conservative and another part returns two actions, the first with its
    potential, so that the energy ledger can tell stored from lost. One that keeps something
    itself says so by :meth:`internals` and :meth:`modes`, and what becomes of it by
    :meth:`rates`, :meth:`signs` and :meth:`change`.
    """

    kind: ClassVar[str]
    units: ClassVar[Units] = {}
    # of what its formulas read; see :mod:`..formulas`
    symbol_shapes: ClassVar[Shapes] = {}
    # True where its potential is the energy of a strain
    strained: ClassVar[bool] = True
    # True where ``joint`` must have one coordinate
    _one_coordinate: ClassVar[bool] = False

    def __post_init__(self) -> None:
        take(self, self.kind, self.units)
        self.judge()

    def quantities(self) -> dict[str, Quantity]:
        """The user's values by name; become ``data``."""
        return quantities_of(self, self.units)

    def frames(self) -> dict[str, Any]:
        """The frames (or bodies) it acts on, by role."""
        # None says nothing where a frame may be left out, and is refused elsewhere
        return {
            name.removeprefix("frame_"): place
            for name, place in annotated(self, "Place").items()
            if place is not None or not hasattr(type(self), name)
        }

    def joints(self) -> dict[str, str]:
        """The names of the joints it acts on, by role."""
        return annotated(self, "JointName")

    def masses(self) -> tuple[Any, ...] | None:
        """The bodies it acts on by their mass, () for all that have some but those of its frames.

        It acts on each of them by itself, and its field ``bodies`` says on which. None: masses are
        no matter to it.
        """
        return None

    @abstractmethod
    def act(self, at: Places) -> tuple[Action, ...]:
        """Its actions."""

    def formulas(self, at: Places) -> Lines:
        """What it does, as formulas for readers; () where none are written.

        F and M are force at the origin of a frame and moment on it in ground axes, tau the force
        along the speeds of a joint; frames and joints have their role as index where there are two.
        """
        return ()

    def acts_on(self) -> tuple[str, str]:
        """Receiver of ``motion["<name>.force"]``, and the role of that joint or frame.

        Returns:
            ``LINE``, ``JOINT`` or ``FRAME``, and the role; two empty texts where it exerts none.
        """
        if self.straight():
            return LINE, "a"
        for what, roles in ((JOINT, self.joints()), (FRAME, self.frames())):
            if roles:
                return what, next(iter(roles))
        return "", ""

    def paired(self) -> bool:
        """True when all it does comes in pairs, between its frames or across its joints."""
        return False

    @property
    def by_reaction(self) -> bool:
        """True when it has a force that follows from the reaction of its joint."""
        return False

    def reaction_force(self, at: Places) -> Scalar:
        """That force per force of reaction across the line of the joint."""
        raise TypeError(f"{self.kind} has no force that follows from a reaction")

    @property
    def title(self) -> str:
        """Kind and place, for messages."""
        return " ".join(
            [self.kind, *(f"of joint {brief(name)}" for name in self.joints().values())]
        )

    def limits(self) -> tuple[Limit, ...]:
        """Limits of its numbers."""
        return ()

    def judge(self) -> None:
        """Refuse numbers out of their limits.

        Raises:
            ModelError: one is.
        """
        # of a field that is several quantities each has limits of its own
        parts = {name: quantity.value for name, quantity in self.quantities().items()}
        judge(self.title, self.limits(), {**vars(self), **parts})

    def misfit(self, sliding: bool) -> str:
        """Why it does not fit a joint that slides, or one that turns; "" if it does."""
        return ""

    def straight(self) -> bool:
        """True when it is a spring of a stiffness and a free length along the line from a to b."""
        return False

    def linear(self) -> tuple[str, ...]:
        """Quantities that its forces, and its rotor, are linear in together: what data can tell."""
        return ()

    # what it keeps itself

    def internals(self) -> tuple[Internal, ...]:
        """Its continuous internal states."""
        return ()

    def modes(self) -> tuple[Mode, ...]:
        """Its discrete states."""
        return ()

    def events(self) -> tuple[EventSpec, ...]:
        """Events of the element."""
        return ()

    def locked_velocities(self) -> tuple[tuple[str, str], ...]:
        """Names and units of the velocities that it holds in some modes."""
        return ()

    def rates(self, at: Places) -> Matrix:
        """Time derivatives of its internal states (their number, 1)."""
        return at.z

    def holds(self, at: Places) -> tuple[ModeConstraint, ...]:
        """The velocities that :meth:`locked_velocities` names."""
        return ()

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        """A number for each of its events, which happens where that falls through zero.

        What cannot happen in the present mode, and every tick, has the value 1.
        """
        return ()

    def impulses(self, at: Places, jumped: Jumped) -> tuple[Impulse, ...]:
        """Jumps of velocities at events; also those that it bears at events of others."""
        return ()

    def change(self, at: Places, jumped: Jumped) -> Change:
        """New states at events, its own and those of others."""
        return Change()

    def rotor(self) -> RotorBody | None:
        """The body it needs besides those of the scene; its joint has the role ``rotor``."""
        return None

    def rotor_inertia(self, data: Mapping[str, Matrix]) -> dict[str, Matrix]:
        """Inertia (nu, nu) it adds to the speeds of a joint, by role; such as a geared rotor."""
        return {}


def constant(*quantities: Matrix, blocks: Sequence[str] = ("p",)) -> bool:
    """True where all quantities depend on parameters alone, so that a potential may hold them.

    Args:
        quantities: What is asked.
        blocks: On which they may depend.
    """
    leaves = (x.graph.nodes[i] for x in quantities for i in live(x.graph, x.nodes))
    return all(n[0] != "atom" and (n[0] != "var" or n[1] in blocks) for n in leaves)


def potential(energy: Scalar, *quantities: Matrix) -> tuple[Scalar | None, bool]:
    """The potential energy of an action, and whether that is constant.

    There is none where the motion itself changes what the energy is made of: such a force works on
    the system. Where time or inputs do, it is that at the present time.

    Args:
        energy: Of the strain.
        quantities: What it is made of besides the strain.
    """
    independent = constant(*quantities, blocks=("p", "t", "r"))
    return (energy if independent else None), constant(*quantities)


# cure for joints with several coordinates
CHAIN = (
    "Make it of Revolute and Prismatic joints, with bodies of mass 0 between them: three Prismatic "
    "joints move as a Translation"
)


def refuse_several(name: str, element: ForceElement, coordinates: Sequence[object]) -> None:
    """Refuse an element on a joint with several coordinates that needs one.

    Raises:
        ModelError: there are several.
    """
    if element._one_coordinate and len(coordinates) > 1:
        raise ModelError(
            f"force '{name}': joint '{getattr(element, 'joint', '')}' has {len(coordinates)} "
            f"coordinates; {element.kind} needs a joint with one. "
            f"{CHAIN}"
        )


def one_coordinate(motion: Motion, joint: int, who: str) -> tuple[Scalar, Scalar]:
    """Coordinate and speed of a joint that must have one.

    Raises:
        ModelError: it has another number.
    """
    q, u = motion.q(joint), motion.u(joint)
    if q.rows != 1 or u.rows != 1:
        raise ModelError(
            f"{who}: the joint has {q.rows} coordinates; this element needs a joint with one. "
            f"{CHAIN}"
        )
    return q[0], u[0]
