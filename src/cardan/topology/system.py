"""The system graph: what the equations need to know about a scene, and nothing else.

Frozen records; expressions are node numbers of one :class:`~cardan.ir.graph.Graph`, matrices are
tuples of them, row by row. Bodies are numbered regularly (every parent before its children); the
ground is -1. The axes of a body are those of its inboard joint on the child side, with the origin
there, whatever frame the user described the body in; ``frames`` keep the user's.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from ..elements.forces.force import ForceElement
from ..elements.internal_states import EventSpec
from ..elements.joints.joint import Joint as JointElement
from ..elements.limits import NumberLimits
from ..ir.graph import ONE, ZERO, Graph
from ..records import dataclass
from .beams.segment_tables import Segment
from .superelements.part_of_system import PartOfSystem

Nodes = tuple[int, ...]
GROUND = -1
LENGTHS = ("length", "radius", "crown")  # of joints, by the names of their quantities


@dataclass(frozen=True)
class Parameter:
    """Entry of p. ``declared``: by ``model.parameter``; else a number of the scene."""

    name: str
    value: float
    unit: str
    declared: bool = False


@dataclass(frozen=True)
class Input:
    """Entry of r; an input that prescribes a motion takes three: value, rate, acceleration.

    ``prescribes``: of such a value; its rate and acceleration are the next two entries.
    """

    name: str
    unit: str
    default: float = 0.0
    prescribes: bool = False


@dataclass(frozen=True)
class Part:
    """A body of the user as part of a rigid body of the system.

    Attributes:
        name: The user's body.
        inboard: Index of the part it is fixed to within the same body, -1 for the first.
        joint: Name of the fixed joint that holds it; "" for the first.
        mass, first_moment, inertia: m, m c (3) and the inertia tensor about the origin (9) in
            axes of the system's body.
        frame: Index of its own frame in ``System.frames``.
        joint_frame: Index of the child frame of the fixed joint; that of ``frame`` for the first.
        reversed: The part is the parent of that joint, whose child is nearer to the ground.
    """

    name: str
    inboard: int
    joint: str
    mass: int
    first_moment: Nodes
    inertia: Nodes
    frame: int
    joint_frame: int
    reversed: bool = False


@dataclass(frozen=True)
class Turn:
    """Rotation from the axes of a body to those its quantities are written in.

    Attributes:
        axis: Index of the coordinate axis they are turned about.
        joints: (joint, sign) of the angles that add up to that turn.
    """

    axis: int
    joints: tuple[tuple[int, int], ...]


@dataclass(frozen=True)
class Body:
    """A rigid body with everything fixed to it. Index in the list = index of its inboard joint.

    Attributes:
        name: Name of its first part.
        parent: Body it is jointed to, -1 for the ground.
        parts: Bodies of the user; none where it only stands for the far side of a joint that closes
            a loop with coordinates of its own.
        mass, first_moment, inertia: Sums over its parts, or what the equations of motion need of
            them where inertia was regrouped.
        second_moment: The integral of x xᵀ dm (9) where regrouping gave it; else it follows from
            the inertia.
        turn: Set where vectors of the body are told in other axes than its own.
    """

    name: str
    parent: int
    mass: int
    first_moment: Nodes
    inertia: Nodes
    parts: tuple[Part, ...]
    second_moment: Nodes | None = None
    turn: Turn | None = None


@dataclass(frozen=True)
class Frame:
    """A frame fixed to a body (-1: ground): R_body_frame (9) and position (3) in body axes.

    ``part``: index of the part it belongs to (in ``System.ground_parts`` for the ground).
    """

    name: str
    body: int
    part: int
    rotation: Nodes
    position: Nodes


@dataclass(frozen=True)
class Coupling:
    """q = ratio q_leader + offset of a coupled joint; ``leader`` is a joint (= body) number."""

    leader: int
    ratio: int
    offset: int


@dataclass(frozen=True)
class Prescribed:
    """A joint moved by t or inputs: its coordinate, rate and acceleration.

    ``leader`` and ``ratio``: of a coupled joint the one that is driven, and its rate per rate of
    that; -1 where it is driven itself.
    """

    value: int
    rate: int
    acceleration: int
    leader: int = -1
    ratio: int = ONE


@dataclass(frozen=True)
class Joint:
    """The inboard joint of the body of the same number.

    Attributes:
        name: The user's name.
        element: Its kind.
        data: The element's quantities: name -> (rows, columns, nodes).
        parent_frame, child_frame: Indices in ``System.frames``, of the inner and the outer body.
        rotation, position: Parent-side joint frame in axes of the parent body, (9), (3).
        q, u: First slot in the system's q and u, -1 without slots (coupled or prescribed).
        coupling, motion: Set for a coupled or a prescribed joint.
        q0, u0: Initial values as named in the model.
        limits: (lower, upper, speed, effort) as far as given.
        offset: Added to the angle of a joint along a line.
        closure: Index in ``System.closures`` of the loop that determines its coordinates, -1
            for none.
        follows: Turns about the line about which the parent does, from the same axes at angle 0.
        reversed: Declared with the outer body as parent; element and data are told the other way.
        implicit: Made for a node of beams, or for a body that only beams hold: free from the
            ground. Both frames are origins there; ``q0`` is the pose in the reference
            configuration.
    """

    name: str
    element: JointElement
    data: dict[str, tuple[int, int, Nodes]]
    parent_frame: int
    child_frame: int
    rotation: Nodes
    position: Nodes
    q: int
    u: int
    coupling: Coupling | None = None
    motion: Prescribed | None = None
    q0: tuple[float, ...] | None = None
    u0: tuple[float, ...] | None = None
    limits: tuple[float | None, float | None, float | None, float | None] = (None,) * 4
    offset: int = 0
    follows: bool = False
    closure: int = -1
    reversed: bool = False
    implicit: bool = False


@dataclass(frozen=True)
class Cut:
    """A joint that closes a loop.

    Attributes:
        name, element, data: As of a :class:`Joint`.
        parent_frame, child_frame: Indices in ``System.frames``.
        base: The body from which both branches of the loop start, -1 for the ground.
        path: (joint, sign) of the tree joints of the loop: 1 on the branch of the child, -1 on
            that of the parent.
        rows: Which of its closing conditions are independent of each other, whatever the motion
            of the loop; the others hold by themselves.
        reason: Why this joint was cut.
        group: What the loop moves in: "planar", "spherical" or "".
        carrier: Number of the tree joint of this name: it keeps its coordinates and moves a body
            without mass or parts, which ``element`` holds on the child. None where the joint
            itself is ``element``.
    """

    name: str
    element: JointElement
    data: dict[str, tuple[int, int, Nodes]]
    parent_frame: int
    child_frame: int
    base: int
    path: tuple[tuple[int, int], ...]
    rows: tuple[int, ...]
    reason: str = ""
    group: str = ""
    carrier: int | None = None


def joint_lengths(joint: Joint | Cut) -> Nodes:
    """Lengths of a rod, or radii of a wheel and of its crown: two nodes, 0 where there are none."""
    lengths = [joint.data[name][2][0] for name in LENGTHS if name in joint.data]
    return (*lengths, ZERO, ZERO)[:2]


@dataclass(frozen=True)
class Closure:
    """A loop whose joints follow from the others in closed form.

    Attributes:
        cut: The joint that closes it.
        kind: How it is solved: a member of ``equations.closures``.
        unknown: The tree joints that follow, each after those it is carried by.
        branch: 1 or -1: which of the two solutions; of a leg that of its two turning joints.
        side: 1 or -1: which solution of the third joint of a leg.
        third: Number of that joint, -1 where there is none.
    """

    cut: Cut
    kind: str
    unknown: tuple[int, ...]
    branch: int
    side: int = 1
    third: int = -1


@dataclass(frozen=True)
class Force:
    """A force element with its data converted; frames and joints by number.

    ``z``, ``s``, ``e``: its first slots among internal states, modes and events.
    """

    name: str
    element: ForceElement
    data: dict[str, tuple[int, int, Nodes]]
    frames: dict[str, int]
    joints: dict[str, int]
    z: int = 0
    s: int = 0
    e: int = 0


@dataclass(frozen=True)
class Atom:
    """A placeholder the kinematics resolve, such as the x component of a velocity.

    Attributes:
        quantity: position velocity acceleration angular_velocity rotation q u.
        frame: Frame number (joint number for q and u).
        wrt, in_: Frame numbers: against which, in whose axes.
        component: Row-major entry.
    """

    quantity: str
    frame: int
    wrt: int = 0
    in_: int = 0
    component: int = 0


@dataclass(frozen=True)
class Named:
    """A named expression: an output with its unit."""

    name: str
    node: int
    unit: str = ""


@dataclass(frozen=True)
class System:
    """A scene as a graph with expressions.

    ``graph`` holds the expressions; copy it with ``graph.fork()`` before adding to it.
    ``cuts`` close the loops of the tree, but for ``closures``, which are solved in closed form;
    ``closable`` says which of the cuts could be, where that was not asked for;
    ``constraints`` are expressions that are kept at 0. ``segments`` are the beams: their ends are
    frames of bodies, and nodes that are on no body of the user are bodies without mass.
    ``frames[0]`` is the ground frame. ``snaps`` says which numbers of a file were snapped,
    ``structural`` which numbers (by dotted name) are part of the form of the equations, ``notes``
    what the user should know.
    """

    name: str
    graph: Graph = field(repr=False)
    gravity: Nodes
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    frames: tuple[Frame, ...] = field(repr=False)
    forces: tuple[Force, ...]
    parameters: tuple[Parameter, ...] = field(repr=False)
    inputs: tuple[Input, ...]
    outputs: tuple[Named, ...]
    atoms: dict[str, Atom] = field(repr=False)
    nq: int
    nu: int
    cuts: tuple[Cut, ...] = ()
    closures: tuple[Closure, ...] = ()
    closable: tuple[Closure, ...] = field(default=(), repr=False)
    constraints: tuple[Named, ...] = ()
    segments: tuple[Segment, ...] = ()
    superelements: tuple[PartOfSystem, ...] = ()
    ground_parts: tuple[Part, ...] = ()
    fixed: tuple[str, ...] = ()
    shapes: tuple[tuple[int, Mapping[str, object]], ...] = ()
    snaps: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    structural: dict[str, float] = field(default_factory=dict, repr=False)
    number_limits: tuple[NumberLimits, ...] = field(default=(), repr=False)

    def children(self, body: int) -> list[int]:
        """Bodies jointed outboard to a body (-1: to the ground)."""
        return [i for i, b in enumerate(self.bodies) if b.parent == body]

    @property
    def moving_joints(self) -> tuple[str, ...]:
        """Names of the joints of the tree, then of those that are cut."""
        cuts = (cut.name for cut in self.closing)
        return tuple(dict.fromkeys([*(joint.name for joint in self.joints), *cuts]))

    @property
    def closing(self) -> tuple[Cut, ...]:
        """The joints that close loops, those that are solved in closed form first."""
        return (*(closure.cut for closure in self.closures), *self.cuts)

    @property
    def speed_names(self) -> tuple[str, ...]:
        """Names of the speeds u: of the joint, with the component where it has several."""
        names = [""] * self.nu
        for joint in self.joints:
            speeds = joint.element.speeds if joint.u >= 0 else ()
            for k, speed in enumerate(speeds, joint.u):
                names[k] = f"{joint.name}_{speed.name}" if len(speeds) > 1 else joint.name
        return tuple(names)

    @property
    def closed(self) -> bool:
        """True when its speeds are bound by anything beyond the tree."""
        rolling = any(joint.element.slips for joint in self.joints)
        locking = any(force.element.locked_velocities() for force in self.forces)
        return bool(self.cuts or self.constraints) or rolling or locking

    @property
    def written(self) -> bool:
        """True when equations that were derived elsewhere move it, and not bodies."""
        return any(joint.element.bodiless for joint in self.joints)

    @property
    def nz(self) -> int:
        """Number of internal states of elements."""
        return sum(len(force.element.internals()) for force in self.forces)

    @property
    def ns(self) -> int:
        """Number of modes of elements."""
        return sum(len(force.element.modes()) for force in self.forces)

    @property
    def events(self) -> tuple[tuple[Force, EventSpec], ...]:
        """Everything that can happen, with the element it happens to."""
        return tuple((force, event) for force in self.forces for event in force.element.events())

    def depth(self) -> int:
        """Number of joints on the longest path from the ground."""
        depth: list[int] = []
        for body in self.bodies:
            depth.append(1 + (depth[body.parent] if body.parent >= 0 else 0))
        return max(depth, default=0)
