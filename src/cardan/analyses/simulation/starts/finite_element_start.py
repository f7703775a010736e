"""Start of a run of elements in tables: assemble the joints; nodes and beams follow.

Loops that joints alone do not close are closed by all nodes: beams bend then, and what is named is
held all the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from ....arrays import Array
from ....errors import ModelError
from ....processes import collector_paused
from ....runtime.models.constraint_projection import size_of
from ....runtime.models.finite_elements import table_loading
from ....runtime.models.finite_elements.assembled import Assembled
from ....runtime.models.loaded_model import LoadedModel
from ....schema.rows import among
from ...mechanisms.branches import refuse_singular
from ...mechanisms.consistent_rates import speeds
from ...mechanisms.nearest_position import NEARLY, assembled
from ...mechanisms.nodal_mechanism import NodalMechanism
from ...mechanisms.position_solver import missed
from ...mechanisms.targets import read
from ..settings import start_key
from .strain_limits import warn_of_strain

MOST = 60
CLOSED, GOOD = 1e-12, 1e-9  # gaps against the size of the scene: sought, and good enough


@collector_paused()
def meshed_start(model: LoadedModel, x: Array, q: object, u: object, t: float, r: Array) -> Array:
    """A state (nx,) whose constraints hold, named coordinates and speeds kept as they are.

    Args:
        model: In absolute coordinates.
        x: The start as it was named, with defaults.
        q, u: As the user gave them.
        t, r: Time and inputs.

    Raises:
        ModelError: no state near it fulfills the constraints.

    Warns:
        SolveWarning: beams are strained beyond what materials bear.
    """
    key = start_key(x, q, u, t, r)
    solved: tuple[bytes, Array] | None = model._derived.get(meshed_start)
    if solved and solved[0] == key:
        return solved[1].copy()
    start = _Start(model, x, q, u, t, r)
    place, by_joints = start.place()
    speed = start.speed(place, by_joints)
    state = np.concatenate([place, speed, start.internal])
    # what is warned of is warned of each time, in searches too
    if not warn_of_strain(model, state) and not start.searched:
        model._derived[meshed_start] = key, state.copy()
    return state


def next_start(model: LoadedModel, x: Array, t: float, r: Array) -> Array:
    """A state (nx,) whose constraints hold next to one where they may be open; nothing is held.

    Raises:
        ModelError: no state near it fulfills the constraints.
    """
    q, u, z = model.parts_of(x)
    start, free = _Start(model, x, q, u, t, r), np.zeros(model.nu)
    place = start.by_nodes(q.copy(), free)
    return np.concatenate([place, start.closed("close_velocity", place, u, free)[: model.nu], z])


def start_of_search(
    model: LoadedModel, x: Array, q: object, locked: Mapping[str, object], t: float, r: Array
) -> Array:
    """A state (nx,) at which a search for rest begins.

    Args:
        model, x, t, r: As :func:`meshed_start` takes them.
        q: Where the search is to begin, as the user gave it; a whole block stays what it is but
            for what constraints change.
        locked: Coordinates that are held.

    Raises:
        ModelError: no state near it fulfills the constraints.
    """
    names = {**q, **locked} if isinstance(q, Mapping) else locked
    start = _Start(model, x, names, None, t, r)
    place = None
    if q is None or isinstance(q, Mapping):
        with suppress(ModelError):
            place = start.place()[0]
    if place is None:
        place = start.by_nodes(start.q0, _locked_speeds(model, locked, "q"))
    return np.concatenate([place, start.u0, start.internal])


class _Start:
    """A start from named values.

    Args: as :func:`meshed_start` takes them.
    """

    def __init__(
        self, model: LoadedModel, x: Array, q: object, u: object, t: float, r: Array
    ) -> None:
        self.model, self.searched = model, False
        self.q0, self.u0, self.internal = (part.copy() for part in model.parts_of(x))
        self.arguments = {"t": t, "r": r, "z": self.internal}
        self.q, self.u = _named(model, q, "q"), _named(model, u, "u")
        node_entries = [
            *_free_node_entries(model, self.q, "q"),
            *_free_node_entries(model, self.u, "u"),
        ]
        self.m = NodalMechanism(model, t, r, node_entries, self.q0)
        self.scale = max(size_of(model), float(np.abs(self.q0).max(initial=0.0)), 1e-9)

    # positions

    def place(self) -> tuple[Array, bool]:
        """Coordinates, and whether nodes are where the joints carry them."""
        if self.q is None:
            return self._near(self.q0), False
        begin = self.m.carry(self.q0)
        names = self._moving(self.q, "q")
        self.m.nodes_named = self._names_nodes(names)
        if self._gap(begin) <= CLOSED * self.scale and not self._missed(names, begin):
            return begin, True
        self.searched = True
        with suppress(ModelError):
            if undeformed := self._undeformed("q"):
                goals = read(self.m, {**undeformed, **names})
                return self.m.carry(assembled(self.m, goals, begin).q), True
        goals = read(self.m, names)
        try:
            return self.m.carry(assembled(self.m, goals, begin).q), True
        except ModelError as problem:
            if not table_loading.tables_of(self.model).beams:
                raise
            return self._bent(names, begin, problem)

    def _bent(
        self, names: Mapping[str, object], begin: Array, problem: ModelError
    ) -> tuple[Array, bool]:
        """Same as :meth:`place` where beams cannot stay as they are."""
        if self.m.linked and self.m.links:
            unlinked = self.m.unlinked()
            try:
                return unlinked.carry(assembled(unlinked, read(unlinked, names), begin).q), True
            except ModelError:
                pass
        locked = _locked_speeds(self.model, self.q, "q")
        try:
            position = self.by_nodes(begin, locked)
        except ModelError:
            raise problem from None
        off = missed(self.m, read(self.m, names), position)
        if np.abs(off).max(initial=0.0) > GOOD:
            # what is named cannot be held, and is not replaced
            raise problem
        return self.m.nearest(position, begin), False

    def _missed(self, names: Mapping[str, object], q: Array) -> bool:
        """True when something named or a beam is missed, or an axis is turned round."""
        m = self.m
        open_by = np.abs(missed(m, read(m, names), q)).max(initial=0.0)
        # where all joints are named, nothing could move that a beam be strained less
        if not _locked_speeds(self.model, names, "q")[m.lead].all():
            open_by = np.abs(m.residuals(q)).max(initial=open_by)
        return bool(open_by > GOOD) or bool(m.reversed_axis(q))

    def _near(self, q: Array) -> Array:
        """Coordinates that were all given, closed to the last digits."""
        gaps = self._gaps(q)
        worst = int(np.abs(gaps).argmax()) if len(gaps) else 0
        if len(gaps) and abs(gaps[worst]) > NEARLY * self.scale:
            row = self.model.manifest.multipliers[worst]
            raise ModelError(
                f"q: all coordinates are given, and '{row.name}' stays open by "
                f"{abs(gaps[worst]):.3g}. Name only those that are to be held: the others follow"
            )
        return self.by_nodes(q, np.zeros(self.model.nu))

    def _gaps(self, q: Array) -> Array:
        gaps: Array = self.model._evaluate(
            ("constraints", None), (self.arguments["t"], q, self.arguments["r"]), None, None
        )
        return gaps

    def _gap(self, q: Array) -> float:
        return float(np.abs(self._gaps(q)).max(initial=0.0))

    def by_nodes(self, q: Array, locked: Array) -> Array:
        """Newton's steps of all coordinates but those held along a speed.

        Raises:
            ModelError: some constraint stays open.
        """
        place, speed, gap = q.copy(), np.zeros(self.model.nu), np.inf
        positions = sum(row.level == "position" for row in self.model.manifest.multipliers)
        if not positions:
            return place
        for _ in range(MOST):
            step = self.closed("close_position", place, speed, locked)
            last, gap = gap, float(np.abs(step[len(q) :]).max(initial=0.0))
            good = gap <= GOOD * self.scale and gap >= 0.5 * last
            if gap <= CLOSED * self.scale or good:
                return place
            place = step[: len(q)]
            _normalize(self.model, place)
        raise ModelError(_open(self.model, step[len(q) :]))

    # speeds

    def speed(self, q: Array, by_joints: bool) -> Array:
        """Speeds of everything at a position.

        Raises:
            ModelError: inconsistent speeds.
        """
        if self.u is None:
            return self._near_speeds(q)
        names = self._moving(self.u, "u")
        if by_joints:
            m, near = self.m.unlinked(), self.u0
            if m.closing.rows:
                refuse_singular(m, q)
            if undeformed := self._undeformed("u"):
                with suppress(ModelError):
                    near = m.state(q, speeds(m, q, {**undeformed, **names}, near))[1]
            if self.m.links:
                # beams move as they are, if what is named lets them
                with suppress(ModelError):
                    near = speeds(self.m, q, names, self.u0)
            try:
                # else they take up what the speeds of their ends differ by
                solved = m.state(q, speeds(m, q, names, near))[1]
                # nodes that beams alone hold have the speeds that were named
                entries = [
                    self.model.speeds.index(n) for n in _free_node_entries(self.model, self.u, "u")
                ]
                solved[entries] = self.u0[entries]
                return solved
            except ModelError:
                if not table_loading.tables_of(self.model).beams:
                    raise
        u = self.m.state(q, self.u0)[1] if by_joints else self.u0
        locked = _locked_speeds(self.model, self.u, "u")
        solved = self.closed("close_velocity", q, u, locked)[: self.model.nu]
        off = np.abs(solved - u)[locked != 0].max(initial=0.0)
        if off > GOOD * max(1.0, float(np.abs(u).max(initial=0.0))):
            raise ModelError(
                f"speeds of {', '.join(f'{name!r}' for name in self.u)} are inconsistent. "
                "Leave one of them out"
            )
        self._check_rates(q, solved, ", ".join(f"'{name}'" for name in self.u) or "all joints")
        return solved

    def _near_speeds(self, q: Array) -> Array:
        """Speeds that were all given, made consistent to the last digits."""
        u = self.u0
        rates, size = self._rates(q, u), max(1.0, float(np.abs(u).max(initial=0.0)))
        worst = int(np.abs(rates).argmax()) if len(rates) else 0
        if len(rates) and abs(rates[worst]) > NEARLY * self.scale * size:
            row = self.model.manifest.multipliers[worst]
            raise ModelError(
                f"u: all speeds are given, and joint '{row.joint}' would come apart at "
                f"{abs(rates[worst]):.3g} in '{row.name}'. Name only those that are to be held: "
                "the others follow"
            )
        return self.closed("close_velocity", q, u, np.zeros(self.model.nu))[: self.model.nu]

    def _rates(self, q: Array, u: Array) -> Array:
        rates: Array = self.model._evaluate(
            ("constraint_rates", None), (self.arguments["t"], q, u, self.arguments["r"]), None, None
        )
        return rates

    def _check_rates(self, q: Array, u: Array, said: str) -> None:
        """Refuse speeds that constraints do not allow."""
        rates = self._rates(q, u)
        worst = int(np.abs(rates).argmax()) if len(rates) else 0
        size = self.scale * max(1.0, float(np.abs(u).max(initial=0.0)))
        if len(rates) and abs(rates[worst]) > GOOD * size:
            row = self.model.manifest.multipliers[worst]
            raise ModelError(
                f"speeds of {said} are inconsistent: joint '{row.joint}' would come apart "
                f"at {abs(rates[worst]):.3g} in '{row.name}'. Leave one of them out"
            )

    # names

    def _moving(self, named: Mapping[str, object], letter: str) -> dict[str, object]:
        """Values of names but those of nodes that beams alone hold, which stay where they are."""
        if not named:
            return {}
        staying = {*_free_node_entries(self.model, named, letter)}
        names = self.model.coordinates if letter == "q" else self.model.speeds
        places = self.model._layout.slots[letter]
        return {k: v for k, v in named.items() if staying.isdisjoint(names[places[k]])}

    def _undeformed(self, letter: str) -> dict[str, object]:
        """Coordinates or speeds of superelements without deformation.

        They are there before anything is deformed, which closed loops may ask for.
        """
        entries = self.model.coordinates if letter == "q" else self.model.speeds
        joints = among(self.model.manifest.joints, "kind", ("elastic", "modal"))
        slots = (one.slot(letter) for one in joints)
        return {entries[k]: 0.0 for first, count in slots for k in range(first, first + count)}

    def _names_nodes(self, names: Mapping[str, object]) -> bool:
        """True when a name belongs to a node that joints carry."""
        if not names:
            return False
        places, led = self.model._layout.slots["q"], set(self.m.led.tolist())
        return any(places[name].start not in led for name in names)

    def closed(self, name: str, q: Array, u: Array, locked: Array) -> Array:
        source = self.model._source
        assert isinstance(source, Assembled)
        return source.results(self.model).closed(name, q, u, locked, self.arguments)


def _named(model: LoadedModel, values: object, letter: str) -> Mapping[str, Any] | None:
    """The named values; None where every entry is given."""
    if values is not None and not isinstance(values, Mapping):
        return None
    size = {"q": model.nq, "u": model.nu}[letter]
    if not values and size:
        return {}
    places = model._layout.slots[letter]
    named_entries = {k for name in values or {} for k in range(*places[name].indices(size))}
    return None if len(named_entries) == size else values or {}


def _free_node_entries(
    model: LoadedModel, named: Mapping[str, object] | None, letter: str
) -> list[str]:
    """Entries of names that belong to nodes which beams alone hold: they stay where they are."""
    if not named:
        return []
    tables, manifest = table_loading.tables_of(model), model.manifest
    inside = sum(len(line) - 2 for line in tables.beams)
    free = {*manifest.elements.beam_nodes, *range(len(tables.kind) - inside, len(tables.kind))}
    starts = tables.q if letter == "q" else tables.u
    node_entries = {k for place in free for k in range(starts[place], starts[place + 1])}
    places = model._layout.slots[letter]
    names = model.coordinates if letter == "q" else model.speeds
    named_entries = {k for name in named for k in range(places[name].start, places[name].stop)}
    return [names[k] for k in sorted(node_entries & named_entries)]


def _locked_speeds(model: LoadedModel, named: object, letter: str) -> Array:
    """1 for the speeds (nu,) along which nothing may change."""
    locked = np.zeros(model.nu)
    if not isinstance(named, Mapping) or not named:
        return locked
    places = model._layout.slots[letter]
    sizes = {"q": model.nq, "u": model.nu}[letter]
    named_entries = {k for name in named for k in range(*places[name].indices(sizes))}
    for joint in model.manifest.joints:
        (start, count), (first, speeds) = joint.slot("q"), joint.slot("u")
        if letter == "u":
            locked[[k for k in range(first, first + speeds) if k in named_entries]] = 1.0
        elif named_entries & set(range(start, start + count)):
            same_layout = count == speeds
            locked[
                [first + k for k in range(speeds) if not same_layout or start + k in named_entries]
            ] = 1.0
    return locked


def _normalize(model: LoadedModel, q: Array) -> None:
    entries = np.array(model.manifest.quaternions, dtype=np.intp)[:, None] + np.arange(4)
    q[entries] /= np.linalg.norm(q[entries], axis=1)[:, None]


def _open(model: LoadedModel, gaps: Array) -> str:
    """Message about constraints that cannot be closed."""
    k = int(np.argmax(np.abs(gaps)))
    row = model.manifest.multipliers[k]
    return (
        f"the start cannot be assembled: '{row.name}' stays open by {abs(gaps[k]):.3g}. "
        f"Name other coordinates of the loop of joint '{row.joint}', or fewer"
    )
