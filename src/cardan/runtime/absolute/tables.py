"""The elements of a model as tables: what stands in its folder besides functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.intp]


@dataclass(frozen=True)
class PlaceKind:
    """What a place holds.

    Attributes:
        name: "node", "line<k>" or that of a joint.
        nq, nu: Numbers of coordinates and speeds.
        quaternion: Index of the scalar part of a unit quaternion in its q, None without one.
        functions: C name of ``move`` and ``qdot`` where speeds are not rates.
    """

    name: str
    nq: int
    nu: int
    quaternion: int | None = None
    functions: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Kind:
    """What elements share.

    Attributes:
        name: C identifier.
        nq, nu, nz, ns: Local sizes.
        m, mp: Rows of constraints, and those of them of positions, which come first.
        functions: Name -> C name.
        parts: Matrices of the tangent -> where they begin in it.
        outputs: Name -> number of results of functions.
    """

    name: str
    nq: int
    nu: int
    m: int
    mp: int
    nz: int = 0
    ns: int = 0
    functions: Mapping[str, str] = field(default_factory=dict)
    parts: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class Table:
    """The elements of a kind.

    Attributes:
        kind: What they share.
        place: (n, places) which places each couples.
        first: (n,) first of its rows, numbered group by group as they come.
        common: Name of the saved Function p -> data, "" without.
        own: (n, k) data that are numbers.
        members: Their names.
        z, s: (n, nz), (n, ns) which internal states and modes of the scene are theirs.
        outputs, powers: (n, k) entries of the scene's to which they contribute.
    """

    kind: Kind
    place: Integers
    common: str = ""
    own: Array | None = None
    members: Sequence[str] = ()
    z: Integers | None = None
    s: Integers | None = None
    outputs: Integers | None = None
    powers: Integers | None = None

    def __len__(self) -> int:
        return len(self.place)


@dataclass(frozen=True)
class Tables:
    """All places and elements of a model.

    Attributes:
        kinds: Of places.
        kind: (places,) index of the kind of every place.
        groups: The elements.
        nr, nz, ns: Inputs, internal states and modes of the scene.
        beams: Places of the nodes of every segment of a beam; -1 for the ground.
        stations: Their arc lengths from the start of the beam [m].
    """

    kinds: tuple[PlaceKind, ...]
    kind: Integers
    groups: tuple[Table, ...]
    nr: int
    nz: int = 0
    ns: int = 0
    beams: tuple[Integers, ...] = ()
    stations: tuple[Array, ...] = ()

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
        """Of every group (n, 2): first row of positions, first of the others behind those."""
        found, position, other = [], 0, self.mp
        for group in self.groups:
            kind, each = group.kind, np.arange(len(group), dtype=np.intp)
            rest = kind.m - kind.mp
            pairs = np.stack([position + kind.mp * each, other + rest * each], axis=1)
            found.append(np.ascontiguousarray(pairs))
            position, other = position + kind.mp * len(group), other + rest * len(group)
        return tuple(found)

    def places_of(self, group: Table) -> Integers:
        """(n, nq) global coordinate of every local one."""
        return _spread(self.q, group.place)

    def columns(self, group: Table) -> Integers:
        """(n, nu) global speed of every local one."""
        return _spread(self.u, group.place)

    def lines(self, number: int) -> Integers:
        """(n, m) global row of every local one."""
        kind, rows = self.groups[number].kind, self.rows[number]
        own = [rows[:, :1] + np.arange(kind.mp), rows[:, 1:] + np.arange(kind.m - kind.mp)]
        return np.concatenate(own, axis=1)


def _spread(starts: Integers, place: Integers) -> Integers:
    """(n, k) all numbers of the places (n, places) of elements of one kind."""
    if not place.size:
        return np.zeros((len(place), 0), dtype=np.intp)
    sizes = starts[place[0] + 1] - starts[place[0]]
    parts = [starts[place[:, k], None] + np.arange(sizes[k]) for k in range(place.shape[1])]
    return np.concatenate(parts, axis=1)
