"""Record of the finite-element formulation: places, kinds of elements, and tables of their members.

Unknowns sit in places: a node has position and unit quaternion, a joint the coordinates of its own.
Elements couple a few places and may own constraint rows. Elements of one kind share their
functions, whose inputs ``q u udot lam p`` are local: those of the element's places in their order,
of its rows, of its data. t and r are those of the whole scene.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapters 1 and 7.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import TypeAlias

import numpy as np

from ...arrays import Array, Integers
from ...elements.formulas import Lines, Shapes
from ...errors import DerivationError, near
from ...ir.function import Function
from ...ir.recursion import Recursion
from ...records import dataclass
from ...spatial.plane import Plane
from ...topology.system import System
from ..reading.counts import Counts
from .kinds import Kinds
from .overview import overview

Numbers: TypeAlias = Array

POSE = 7  # entries of the q of a node in space
# functions that kinds have where they are zero throughout, too
ALWAYS = ("outputs", "signs", "jumps", "change")


@dataclass(frozen=True)
class BlockKind:
    """Kind of the block of a place.

    Attributes:
        name: "node"; "plane_node" or "line<k>", where q just adds up; or one made of the kind of a
            joint.
        coordinates, speeds: Names of the entries of q and u behind the name of the place; "" where
            the name of the place is all.
        q_units, u_units: Their units.
        defaults: Entries of q where nothing is said.
        quaternion: Index in q of the scalar part of a unit quaternion, None without one.
        functions: ``move`` [q, T], ``qdot``, ``difference``; none where q just adds up.
        plane: Of a node of a plane how it stands in space, None of others.
    """

    name: str
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    q_units: tuple[str, ...]
    u_units: tuple[str, ...]
    defaults: tuple[float, ...]
    quaternion: int | None = None
    functions: Mapping[str, Function] = field(default_factory=dict, repr=False, compare=False)
    plane: Plane | None = None

    @property
    def nq(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def nu(self) -> int:
        """Number of speeds."""
        return len(self.speeds)


@dataclass(frozen=True)
class Places:
    """The places of a scene, and where their entries start in the q and u of the scene.

    Attributes:
        names: Of every place: that of a body or of a joint.
        kinds: The kinds there are.
        kind: Index in ``kinds`` of every place (n,).
    """

    names: Sequence[str] = field(repr=False)
    kinds: tuple[BlockKind, ...]
    kind: Integers = field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.names)

    @cached_property
    def q(self) -> Integers:
        """First entry of every place in q, then nq (n + 1,)."""
        return self._starts([kind.nq for kind in self.kinds])

    @cached_property
    def u(self) -> Integers:
        """First entry of every place in u, then nu (n + 1,)."""
        return self._starts([kind.nu for kind in self.kinds])

    @property
    def nq(self) -> int:
        """Number of coordinates of the scene."""
        return int(self.q[-1])

    @property
    def nu(self) -> int:
        """Number of speeds of the scene."""
        return int(self.u[-1])

    def _starts(self, sizes: Sequence[int]) -> Integers:
        counts = np.array([0, *sizes], dtype=np.intp)[1:][self.kind]
        return np.concatenate(([0], np.cumsum(counts))).astype(np.intp)


@dataclass(frozen=True)
class Kind:
    """A kind of element: what its members share.

    Attributes:
        name: A C identifier; the C name of a function is ``<kind>__<function>``.
        blocks: Of its places, in the order of its local q and u.
        rows: (name, unit) of its constraint rows behind the name of the member; those of positions
            come first.
        mp: Number of rows of position level.
        data: Names of the entries of p.
        functions: Those it has, by name:
            ``balance`` [b (nu), g (mp), rates G u + g_t (m)], b = M udot + h - f - Gᵀ lam;
            ``balance_tangent``: of [K, C, M (nu, nu), R, G (m, nu), H (m, m)] those that are not
            zero, with H of rows that no mode holds;
            ``gamma`` (m) with G udot = gamma; ``energy`` [kinetic, potential]; ``momentum`` (6)
            about the origin of the ground; ``zdot`` of its internal states; ``reaction`` (6):
            wrench of parent on child at the child joint frame in its axes; ``outputs`` and
            ``power``: see :attr:`Group.outputs`; ``signs``, ``jumps`` and ``change`` of its events:
            see :mod:`.element_events`. What is zero throughout is left out.
        source: Literature.
        formulas: (what it is, formula) for readers, in Python; between ends in space.
        symbol_shapes: Of what the formulas read; see :mod:`...elements.formulas`.
        element: Its element in the catalog, such as "revolute"; "body" of rigid bodies.
        part: "body", "joint", "force" or "beam"; "" of others.
        switched: Number of its rows that hold in some modes, the last ones.
        strain: ``"alone"`` where all it does at rest is the force of a strain whose energy it
            tells, ``"mixed"`` where it does more or tells more; "" where nothing is strained.
    """

    name: str
    blocks: tuple[BlockKind, ...]
    rows: tuple[tuple[str, str], ...]
    mp: int
    data: tuple[str, ...]
    functions: Mapping[str, Function] = field(repr=False, compare=False)
    source: str = ""
    formulas: Lines = field(default=(), repr=False)
    symbol_shapes: Shapes = field(default_factory=dict, repr=False, compare=False)
    element: str = ""
    part: str = ""
    switched: int = 0
    strain: str = ""

    @property
    def m(self) -> int:
        """Number of constraint rows."""
        return len(self.rows)

    @property
    def nq(self) -> int:
        """Number of local coordinates."""
        return sum(block.nq for block in self.blocks)

    @property
    def nu(self) -> int:
        """Number of local speeds."""
        return sum(block.nu for block in self.blocks)

    def c_name(self, function: str) -> str:
        """C name of one of its functions."""
        return f"{self.name}__{function}"


def unique(name: str, taken: set[str]) -> str:
    """A C identifier that no kind has yet, which is entered."""
    base = candidate = re.sub(r"\W", "_", name)
    number = 1
    while candidate in taken:
        number += 1
        candidate = f"{base}_{number}"
    taken.add(candidate)
    return candidate


@dataclass(frozen=True)
class Group:
    """The members of one kind, as a table.

    The data of member e are [common(p) (k1), own[e]] or [common(p)[e] (k1), own[e]].

    Attributes:
        kind: What they share.
        members: Their names.
        places: Indices of their places (n, number of blocks).
        rows: First of their rows of positions and first of their others among the multipliers of
            the scene (n, 2).
        common: Parameters p of the scene -> one output ``data``, (k1,) for all members or (n, k1);
            None without such data.
        attributes: Data that are numbers once and for all (n, k2).
        z, s: Entries of the scene's internal states and modes that are its local z and s (n, k);
            None where it reads none. ``zdot`` is that of the first of z.
        reactions: Joints of trees, by number in ``tree_joints``, to whose reactions the function of
            that name contributes (n, k).
        outputs, powers: Entries of the scene's outputs and powers to which the functions of that
            name contribute (n, k); contributions of several members to one entry add up. None
            without the function.
        events: Entries of the scene's events that are its own (n, ne); None where it has none.
    """

    kind: Kind
    members: Sequence[str] = field(repr=False)
    places: Integers = field(repr=False, compare=False)
    rows: Integers = field(repr=False, compare=False)
    common: Function | None = field(default=None, repr=False, compare=False)
    attributes: Numbers | None = field(default=None, repr=False, compare=False)
    z: Integers | None = field(default=None, repr=False, compare=False)
    s: Integers | None = field(default=None, repr=False, compare=False)
    reactions: Integers | None = field(default=None, repr=False, compare=False)
    outputs: Integers | None = field(default=None, repr=False, compare=False)
    powers: Integers | None = field(default=None, repr=False, compare=False)
    events: Integers | None = field(default=None, repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.members)


@dataclass(frozen=True)
class Frames:
    """Poses of the frames of a scene, in the order of ``System.frames``.

    Attributes:
        place: Index of the node, GROUND for the ground, ON_TREE for a body of a tree (n,).
        bodies: For frames on bodies of trees (group, member, number in ``bodies`` of the member).
        poses: Parameters p -> outputs ``rotation`` (n, 9), R from frame axes to those of the node,
            and ``position`` (n, 3) from its origin in its axes.
    """

    place: Integers = field(repr=False, compare=False)
    poses: Function = field(repr=False, compare=False)
    bodies: Mapping[int, tuple[int, int, int]] = field(default_factory=dict, repr=False)


@dataclass(frozen=True)
class FiniteElementRecord:
    """Equations of motion in absolute coordinates, element by element, see :func:`cardan.derive`.

    The whole system is M udot + h = f + Gᵀ lam with G udot = gamma: sums over all groups.

    Attributes:
        system: The system graph they belong to.
        places: Where coordinates and speeds live.
        groups: The elements.
        frames: Where the frames of the scene are fixed.
        joints: Joints that transmit a reaction -> (group, member) whose ``reaction`` it is.
        tree_joints: Joints inside of rigid trees; their reactions add up over elements.
        forces: Elements whose forces have names -> (group, member) whose ``element_forces`` it is.
        state_visits: [t, q, u, r, p] of the relative formulation -> [q, u] of this one, by bodies.
        results: (name, unit) of the outputs of the scene.
        powers: Names of the sources of power: elements, ``<joint>.motion``, ``<relation>.motion``.
        reference: Reference coordinates of the nodes inside beams, which are the last places.
        lines: Places of the nodes of every segment of ``system.segments`` from start to end;
            GROUND at the ground, ON_TREE - k at body k of ``ends_q`` of ``states``.
        reason: Why ``coordinates="auto"`` took them, "" where the user did.
    """

    system: System = field(repr=False)
    places: Places
    groups: tuple[Group, ...] = field(repr=False)
    frames: Frames = field(repr=False)
    joints: Mapping[str, tuple[int, int]] = field(repr=False)
    state_visits: Recursion = field(repr=False)
    tree_joints: tuple[str, ...] = ()
    forces: Mapping[str, tuple[int, int]] = field(default_factory=dict, repr=False)
    results: tuple[tuple[str, str], ...] = ()
    powers: tuple[str, ...] = ()
    reference: Numbers = field(default_factory=lambda: np.zeros(0), repr=False, compare=False)
    lines: tuple[Integers, ...] = field(default=(), repr=False, compare=False)
    reason: str = field(default="", repr=False, compare=False)

    @cached_property
    def states(self) -> Function:
        """:attr:`state_visits` as straight-line expressions."""
        return self.state_visits.straight()

    @cached_property
    def coordinates(self) -> tuple[str, ...]:
        """Names of q: those of the relative formulation for joints; ``<body>.px`` of nodes."""
        return self._entries("coordinates", "")

    @cached_property
    def speeds(self) -> tuple[str, ...]:
        """Names of u."""
        return self._entries("speeds", ".u")

    @cached_property
    def multipliers(self) -> tuple[str, ...]:
        """Names of lam: rows of positions of all members, group by group, then the others."""
        return tuple(
            f"{member}.{row}" if row else member
            for positions in (True, False)
            for group in self.groups
            for member in group.members
            for row, _ in (
                group.kind.rows[: group.kind.mp] if positions else group.kind.rows[group.kind.mp :]
            )
        )

    @property
    def inner(self) -> Numbers:
        """Coordinates of the nodes inside of beams in the reference configuration (n, nq)."""
        inside = self.reference.size and self.places.kinds[self.places.kind[-1]].nq
        return self.reference.reshape(-1, inside or POSE)

    @cached_property
    def mp(self) -> int:
        """Number of rows of positions; they are the first."""
        return sum(len(group) * group.kind.mp for group in self.groups)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of p."""
        return tuple(parameter.name for parameter in self.system.parameters)

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of r."""
        return tuple(entry.name for entry in self.system.inputs)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the outputs."""
        return tuple(name for name, _ in self.results)

    @property
    def kinds(self) -> Kinds:
        """The kinds of elements, once each: by number, or some of them by name."""
        return Kinds({group.kind.name: group.kind for group in self.groups}.values())

    def function(self, kind: str, name: str) -> Function:
        """A function of a kind of element as expressions.

        Args:
            kind: Such as ``"revolute"``; see :attr:`kinds`.
            name: Such as ``"balance"``.

        Raises:
            DerivationError: there is no such kind, or it has no such function.
        """
        kinds_by_name = {kind_record.name: kind_record for kind_record in self.kinds}
        if kind not in kinds_by_name:
            listed = near(kind, kinds_by_name).replace(" Known:", " Kinds:")
            raise DerivationError(f"kind of element '{kind}' does not exist.{listed}")
        functions = kinds_by_name[kind].functions
        if name not in functions:
            raise DerivationError(
                f"elements of kind '{kind}' have no function '{name}'.{near(name, functions)}"
            )
        return functions[name]

    @cached_property
    def operations(self) -> dict[str, Counts]:
        """Operators of the balance and its tangent by C name, for one member at every call."""
        return {
            kind.c_name(name): Counts(kind.functions[name])
            for kind in self.kinds
            for name in ("balance", "balance_tangent")
            if name in kind.functions
        }

    def __str__(self) -> str:
        return overview(self)

    def __repr__(self) -> str:
        counted = f"{len(self.places)} places, {self.places.nq} coordinates"
        return f"FiniteElementEquations('{self.system.name}': {counted})"

    @property
    def sources(self) -> tuple[str, ...]:
        """Literature behind the formulation and the elements."""
        source = " ".join((__doc__ or "").split("Source:")[-1].split())
        texts = (kind.source for kind in self.kinds)
        return tuple(dict.fromkeys(text for text in (source, *texts) if text))

    def _entries(self, letter: str, mark: str) -> tuple[str, ...]:
        """Names of the entries of all places, in order."""
        parts = [getattr(kind, letter) for kind in self.places.kinds]
        return tuple(
            f"{name}{mark}.{part}" if part else f"{name}{mark}"
            for name, kind in zip(self.places.names, self.places.kind, strict=True)
            for part in parts[kind]
        )
