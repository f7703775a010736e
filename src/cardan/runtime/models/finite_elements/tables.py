"""The elements of a model as tables: what stands in its folder besides functions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....records import dataclass
from ....schema.finite_elements import ElementKind, PlaceKind
from .assembly_pattern import AssemblyPattern
from .node_pose import Plane, pose, speeds

Integers = NDArray[np.intp]
T = TypeVar("T")


@dataclass(frozen=True)
class Table:
    """The elements of a kind.

    Attributes:
        kind: What they share.
        place: (n, places) which places each couples.
        common: Name of the saved Function p -> data, "" without.
        attributes: (n, k) data that are numbers.
        members: Their names.
        z, s: (n, nz), (n, ns) which internal states and modes of the scene are theirs.
        outputs, powers: (n, k) entries of the scene's to which they contribute.
        reactions: (n, k) joints of trees to whose reactions they contribute.
        events: (n, ne) which events of the scene are theirs.
    """

    kind: ElementKind
    place: Integers
    common: str = ""
    attributes: Array | None = None
    members: Sequence[str] = ()
    z: Integers | None = None
    s: Integers | None = None
    outputs: Integers | None = None
    powers: Integers | None = None
    reactions: Integers | None = None
    events: Integers | None = None

    def __len__(self) -> int:
        return len(self.place)


@dataclass(frozen=True)
class Tables:
    """All places and elements of a model.

    Attributes:
        kinds: Of places.
        kind: (places,) index of the kind of every place.
        groups: The elements.
        nr, nz, ns, ne: Inputs, internal states, modes and events of the scene.
        beams: Places of the nodes of every segment of a beam; -1 for the ground.
        stations: Their arc lengths from the start of the beam [m].
        powers: Names of the sources of power.
        outputs: How many the scene has.
    """

    kinds: tuple[PlaceKind, ...]
    kind: Integers
    groups: tuple[Table, ...]
    nr: int
    nz: int = 0
    ns: int = 0
    ne: int = 0
    beams: tuple[Integers, ...] = ()
    stations: tuple[Array, ...] = ()
    powers: tuple[str, ...] = ()
    outputs: int = 0

    def once(self, make: Callable[[Tables], T]) -> T:
        """Value that follows from the tables alone, computed at the first request."""
        cached: dict[Any, T] = self.__dict__.setdefault("_made", {})
        if make not in cached:
            cached[make] = make(self)
        return cached[make]

    def _starts(self, sizes: list[int]) -> Integers:
        each = np.array(sizes, dtype=np.intp)[self.kind] if len(self.kind) else self.kind
        return np.concatenate(([0], np.cumsum(each))).astype(np.intp)

    @cached_property
    def q(self) -> Integers:
        """(places + 1,) first coordinate of every place."""
        return self._starts([kind.nq for kind in self.kinds])

    @cached_property
    def u(self) -> Integers:
        """(places + 1,) first speed of every place."""
        return self._starts([kind.nu for kind in self.kinds])

    @cached_property
    def sizes(self) -> dict[str, int]:
        """Entries of the blocks of a state."""
        speeds = {"u": self.nu, "udot": self.nu, "lam": self.m}
        return {"q": self.nq, **speeds, "z": self.nz, "s": self.ns, "r": self.nr}

    @property
    def driven(self) -> bool:
        """True when something is driven along a motion: its power is that of its multipliers."""
        return any(name.endswith(".motion") for name in self.powers)

    @property
    def nq(self) -> int:
        """Number of coordinates."""
        return int(self.q[-1])

    @property
    def nu(self) -> int:
        """Number of speeds."""
        return int(self.u[-1])

    @property
    def mp(self) -> int:
        """Rows of positions."""
        return sum(len(group) * group.kind.mp for group in self.groups)

    @property
    def m(self) -> int:
        """Rows of constraints."""
        return sum(len(group) * group.kind.m for group in self.groups)

    @cached_property
    def rows(self) -> tuple[Integers, ...]:
        """Rows of every group (n, 2): first row of positions, first of the others behind those."""
        rows, position, other = [], 0, self.mp
        for group in self.groups:
            kind, each = group.kind, np.arange(len(group), dtype=np.intp)
            velocity_rows = kind.m - kind.mp
            pairs = np.stack([position + kind.mp * each, other + velocity_rows * each], axis=1)
            rows.append(np.ascontiguousarray(pairs))
            position, other = position + kind.mp * len(group), other + velocity_rows * len(group)
        return tuple(rows)

    def places_of(self, group: Table) -> Integers:
        """(n, nq) global coordinate of every local one."""
        return _entries(self.q, group.place)

    def columns(self, group: Table) -> Integers:
        """(n, nu) global speed of every local one."""
        return _entries(self.u, group.place)

    def lines(self, number: int) -> Integers:
        """(n, m) global row of every local one."""
        kind, rows = self.groups[number].kind, self.rows[number]
        columns = [rows[:, :1] + np.arange(kind.mp), rows[:, 1:] + np.arange(kind.m - kind.mp)]
        return np.concatenate(columns, axis=1)

    def block(self, name: str, number: int) -> tuple[Integers, Integers]:
        """Global rows and columns (n, k), (n, l) of a matrix of the elements of a group.

        Args:
            name: One of K, C, M, by speeds both; R, G, L, by rows and speeds; H, by rows both.
            number: Of the group.
        """
        rows = self.lines(number) if name in "RGHL" else self.columns(self.groups[number])
        return rows, self.lines(number) if name == "H" else self.columns(self.groups[number])

    def pattern(self, name: str, numbers: tuple[int, ...]) -> AssemblyPattern:
        """Places of the entries of such a matrix of some groups; looked up once."""
        patterns = self._patterns
        if (name, numbers) not in patterns:
            shape = self.m if name in "RGHL" else self.nu, self.m if name == "H" else self.nu
            blocks = [self.block(name, number) for number in numbers]
            patterns[name, numbers] = AssemblyPattern.of(blocks, shape)
        return patterns[name, numbers]

    @cached_property
    def _patterns(self) -> dict[tuple[str, tuple[int, ...]], AssemblyPattern]:
        return {}

    @cached_property
    def rotational_speeds(self) -> Integers:
        """Speeds of nodes and joints that turn something, in body axes (n, 3)."""
        turns = np.array([k.name == "node" or bool(k.functions) for k in self.kinds], dtype=bool)
        first = self.u[:-1][turns[self.kind]] if len(self.kind) else self.u[:-1]
        return np.asarray(first[:, None] + np.arange(3))

    # nodes in space

    @cached_property
    def planes(self) -> tuple[Plane | None, ...]:
        """Plane of every kind of place in space, None for others."""
        return tuple(Plane.of(kind.plane) for kind in self.kinds)

    def plane(self, place: int) -> Plane | None:
        """Plane of a kind of place in space, None for others."""
        return self.planes[int(self.kind[place])]

    def nodes(self, flat: bool) -> Integers:
        """Places that are nodes, those of a plane or all others."""
        kinds = [k for k, x in enumerate(self.kinds) if x.node and (x.plane is not None) == flat]
        return np.flatnonzero(np.isin(self.kind, kinds))

    def pose(self, q: Array, place: int) -> Array:
        """Unit quaternion and position (7,) of a node at coordinates of the model."""
        return pose(self.plane(place), q[self.q[place] : self.q[place + 1]])

    def speeds(self, u: Array, place: int) -> Array:
        """Angular velocity in its axes and velocity in those of the ground (6,) of a node."""
        return speeds(self.plane(place), u[self.u[place] : self.u[place + 1]])

    def distances(self, q: Array, units: Array) -> Array:
        """Sizes of the coordinates that speeds change (nu,), in units; angles count 1.

        Of nodes the distance from the origin, of joints the displacement, at least 1.

        Args:
            q: Coordinates (nq,).
            units: Of every speed (nu,): a length, or 1 of angles.
        """
        distances: Array = np.ones(self.nu)
        for k, kind in enumerate(self.kinds):
            places = np.flatnonzero(self.kind == k)
            coordinates = q[self.q[places][:, None] + np.arange(kind.nq)]
            speeds = self.u[places][:, None] + np.arange(kind.nu)
            unit, first = units[speeds], kind.nq if kind.quaternion is None else kind.quaternion
            if kind.node:
                place = coordinates[:, [n for n in range(kind.nq) if not first <= n < first + 4]]
                far = np.linalg.norm(place, axis=1)[:, None] / unit
                distances[speeds] = np.where(unit == 1.0, 1.0, far)
            elif kind.nq == kind.nu:
                distances[speeds] = np.maximum(np.abs(coordinates) / unit, 1.0)
        return distances

    def poses(self, q: Array, places: Integers) -> Array:
        """Unit quaternions and positions (n, 7) of nodes at coordinates of the model."""
        poses = np.empty((len(places), 7))
        for kind, some in self._alike(places):
            poses[some] = pose(
                Plane.of(kind.plane), q[self._entries(self.q, places[some], kind.nq)]
            )
        return poses

    def put(self, x: Array, places: Integers, poses: Array, speeds: Array) -> None:
        """Write poses (n, 7) and speeds (n, 6) of nodes into a state."""
        for kind, some in self._alike(places):
            plane, here, u = Plane.of(kind.plane), poses[some], speeds[some]
            at = self._entries(self.q, places[some], kind.nq)
            x[at] = here if plane is None else plane.coordinates_of(here, x[at[:, 2]])
            at = self.nq + self._entries(self.u, places[some], kind.nu)
            x[at] = u if plane is None else u @ plane.to_space

    def _alike(self, places: Integers) -> Iterator[tuple[PlaceKind, Integers]]:
        """Kinds of places, and which of these are of that kind."""
        kind = self.kind[places]
        for k in np.unique(kind):
            yield self.kinds[k], np.flatnonzero(kind == k)

    @staticmethod
    def _entries(starts: Integers, places: Integers, size: int) -> Integers:
        return starts[places, None] + np.arange(size)


def _entries(starts: Integers, place: Integers) -> Integers:
    """(n, k) all numbers of the places (n, places) of elements of one kind."""
    if not place.size:
        return np.zeros((len(place), 0), dtype=np.intp)
    sizes = starts[place[0] + 1] - starts[place[0]]
    parts = [starts[place[:, k], None] + np.arange(sizes[k]) for k in range(place.shape[1])]
    return np.concatenate(parts, axis=1)
