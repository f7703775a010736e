"""Visits of all bodies of a large tree from those of its representatives.

A visit reads and writes entries of its body, of the body's parent, of bodies that stand for
themselves, and of nothing else. In the visit of another body of the kind, the entries of that body
and of its parent take their places.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ...ir.function import Function
from ...ir.recursion import STORE, Visit
from ...ir.strided_visits import Layout, VisitRows
from .representatives import Ints, Representatives

# blocks whose entries belong to coordinates and to speeds
BY_SLOT = {"q": "q", "qdot": "q", "u": "u", "udot": "u", "tau": "u"}


class _Foreign(Exception):
    """A visit reads or writes an entry of a body that it may not know of."""


class Results(NamedTuple):
    """Entries of the results that belong to bodies.

    Attributes:
        start: First entry of an output among all results.
        first: Of every body its first entry within the output, None where none is a body's.
    """

    start: int
    first: Ints | None


class Unfolding:
    """Puts the entries of all bodies in the places of those of their representatives.

    Args:
        few: The small tree.
        function: What is computed.
        firsts: Of every output, the first entry of every body in it, None where none is a body's.
        size: Entries of the store of one body.
    """

    def __init__(
        self, few: Representatives, function: Function, firsts: Sequence[Ints | None], size: int
    ) -> None:
        self.few, self.size = few, size
        self.results, start = list[Results](), 0
        for output, first in zip(function.outputs, firsts, strict=True):
            self.results.append(Results(start, first))
            start += output.size
        alone = {few.numbers[k] for k, single in enumerate(few.alone) if single}
        self.alone = alone
        self._body_by_slot = {letter: _slots(few, letter) for letter in ("q", "u")}

    def rows(self, visits: Iterable[tuple[int, Visit]]) -> VisitRows | None:
        """Visits of all bodies from (body of the small tree, visit) of its bodies, by body.

        None where a visit reads or writes entries of other bodies than it may.
        """
        parts = []
        try:
            for body, visit in visits:
                members = self.few.members[body]
                if len(members):
                    parts.append((members, visit.step, *self._of_all(body, visit)))
        except _Foreign:
            return None
        return VisitRows.joined(parts)

    def _of_all(self, body: int, visit: Visit) -> tuple[Layout, Ints]:
        """The entries of a visit, a row for every body of the kind."""
        layout = Layout.of(visit)
        columns = [
            column
            for block, places in visit.reads.items()
            for column in (
                (self._stored(body, k) if block == STORE else self._read(body, block, k))
                for k in places
            )
        ]
        columns += [self._stored(body, k) for k in visit.stores]
        columns += [self._result(body, k) for k in visit.outs]
        rows = np.empty((len(self.few.members[body]), len(columns)), dtype=np.int64)
        for n, column in enumerate(columns):
            rows[:, n] = column
        return layout, rows

    def _stored(self, body: int, place: int) -> Ints | int:
        """A place in the store, [body][field]."""
        few, members = self.few, self.few.members[body]
        owner, field = divmod(place, self.size)
        if owner == few.numbers[body]:
            return members * self.size + field
        if few.parent >= 0 and owner == few.numbers[few.parent]:
            # bodies next to the ground have no parent
            if few.system.bodies[body].parent != few.parent:
                raise _Foreign
            parents: Ints = few.parents[members]
            return parents * self.size + field
        if owner in self.alone:
            return place
        raise _Foreign

    def _read(self, body: int, block: str, k: int) -> Ints | int:
        """An entry of a block."""
        few, number, members = self.few, self.few.numbers[body], self.few.members[body]
        if few.alone[body] or block == "t" or (block, k) in few.shared:
            return k
        if block in BY_SLOT:
            letter = BY_SLOT[block]
            first, owner = few.slots[letter], self._body_by_slot[letter].get(k)
            if owner == number:
                return np.asarray(first[members] + (k - first[number]))
            if owner in self.alone:
                return k
        elif few.owners.get((block, k)) == number:
            n = few.entries[number].index((block, k))
            return np.array([_entry(few, member, n) for member in members], dtype=np.int64)
        raise _Foreign

    def _result(self, body: int, k: int) -> Ints | int:
        """An entry of the results."""
        members, number = self.few.members[body], self.few.numbers[body]
        result = max((r for r in self.results if r.start <= k), key=lambda r: r.start)
        if result.first is None:
            if not self.few.alone[body]:
                raise _Foreign
            return k
        within = k - result.start - result.first[number]
        return np.asarray(result.start + result.first[members] + within)


def _entry(few: Representatives, member: int, n: int) -> int:
    entry = few.entries[member][n]
    assert entry is not None
    return entry[1]


def _slots(few: Representatives, letter: str) -> dict[int, int]:
    """Slot of a body of the small tree -> that body."""
    slots: dict[int, int] = {}
    for number, joint in zip(few.numbers, few.system.joints, strict=True):
        first = getattr(joint, letter)
        parts = joint.element.coordinates if letter == "q" else joint.element.speeds
        if first >= 0:
            slots.update(dict.fromkeys(range(first, first + len(parts)), number))
    return slots
