"""Start of a run of a closed system: named values are locked, the rest is assembled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ....arguments import checked
from ....arrays import Array
from ....errors import ModelError
from ....runtime.models.loaded_model import LoadedModel
from ...mechanisms.assembly_diagnosis import reversed_axis_message
from ...mechanisms.branches import refuse_singular
from ...mechanisms.consistent_rates import speeds
from ...mechanisms.mechanism import Mechanism
from ...mechanisms.nearest_position import NEARLY, assembled
from ...mechanisms.position_solver import PositionSolver
from ...mechanisms.rounded_loops import closure_tolerance
from ...mechanisms.targets import read
from ..settings import Start, Values, start
from .closed_form import place
from .closed_form import speed as followed
from .finite_element_start import meshed_start


def closed_start(
    model: LoadedModel, begin: Start, q: object, u: object, t: float, r: Array
) -> Start:
    """A start at which loops are closed: one rule in every kind of coordinates.

    Coordinates and speeds that are named are held, or refused by name. The others are those next
    to the start: of joints first, angles in radians and lengths in sizes of the scene; nodes and
    beams go along with the joints.

    Args:
        model: The compiled model; trees start where they are told to.
        begin: The start as it was named, with defaults.
        q, u: As the user gave them; anything but names is a whole block.
        t, r: Time and inputs.

    Raises:
        ModelError: loops that cannot be assembled with what is named.
    """
    manifest = model.manifest
    if manifest.absolute:
        return replace(begin, x=meshed_start(model, begin.x, q, u, t, r))
    if model._layout.followers["q"]:
        q, u = (_independent(model, letter, block) for letter, block in (("q", q), ("u", u)))
        begin = _followed(model, begin, q, u, t, r)
    always = [row for row in manifest.multipliers if not row.switched]
    if not always or "constraints" not in manifest.available:
        # the run itself projects what it is given; what modes hold is not held before it begins
        return begin
    m = Mechanism.at(model, t, r)
    place, speed, internal = model.parts_of(begin.x)
    place = positions(m, place, named_of("q", model, q))
    m.closure_tol = m.closure_tol or closure_tolerance(m, place)
    speed = _speeds(m, place, speed, named_of("u", model, u))
    return replace(begin, x=np.concatenate([place, speed, internal]), closure_tol=m.closure_tol)


def _independent(model: LoadedModel, letter: str, values: object) -> Any:
    """The named values without joints that follow from loops."""
    if not isinstance(values, Mapping):
        return values
    places = model._layout.followers[letter]
    return {name: value for name, value in values.items() if name not in places}


def _followed(model: LoadedModel, begin: Start, q: Any, u: Any, t: float, r: Array) -> Start:
    """A start of loops in closed form, by what was named of all joints."""
    m = Mechanism(model, t, r)
    at, speed, internal = model.parts_of(begin.x)
    if q is None or isinstance(q, Mapping):
        at = place(m, at, q or {}, begin.followers.get("q", {}))
    if begin.followers.get("u"):
        places = model._layout.slots["u"]
        locked = [k for name in u or {} for k in range(*places[name].indices(model.nu))]
        speed = followed(m, at, speed, locked, begin.followers["u"])
    return replace(begin, x=np.concatenate([at, speed, internal]))


@checked
def initial(
    model: LoadedModel, q: Values | None = None, u: Values | None = None, z: Values | None = None
) -> Array:
    """The state x (nx,) in which a run with these named values starts.

    Loops are closed at t = 0 with the defaults of the inputs, as ``simulate`` closes them: what
    is named is held, the rest is next to q0 and u0 of the joints, then 0.

    Args:
        model: The compiled model.
        q, u, z: Coordinates, speeds and internal states by name.

    Raises:
        ModelError: an unknown name, or loops that cannot be closed with what is named.
        ArgumentError: the wrong number of values.
        SolveError: a value that is not finite, or a quaternion whose length is not 1.
    """
    q, u = q or {}, u or {}
    begin = start(model, None, q, u, z or {})
    return closed_start(model, begin, q, u, 0.0, model._layout.start("r")).x


def named_of(letter: str, model: LoadedModel, values: object) -> Mapping[str, Any] | None:
    """The named values; None where every entry is given."""
    if values is not None and not isinstance(values, Mapping):
        return None
    rows = model.coordinates if letter == "q" else model.speeds
    places = model._layout.slots[letter] if values else {}
    named_entries = {k for name in values or {} for k in range(*places[name].indices(len(rows)))}
    return None if len(named_entries) == len(rows) else values or {}


def positions(m: Mechanism, q: Array, named: Mapping[str, object] | None) -> Array:
    """Assembled coordinates next to a start (nq,), named ones held; None: all were given."""
    open_by = float(np.abs(m.residuals(q)).max(initial=0.0))
    if named is None and open_by <= NEARLY:
        end = PositionSolver(m).search(q)
        if end.reversed_axis:
            raise ModelError(reversed_axis_message(end.reversed_axis))
        if end.met:
            return end.q
    every = dict(zip(m.model.coordinates, q.tolist(), strict=True))
    goals = read(m, every if named is None else named)
    return assembled(m, goals, q).q


def _speeds(m: Mechanism, q: Array, u: Array, named: Mapping[str, object] | None) -> Array:
    """Speeds that loops allow."""
    if named is not None:
        refuse_singular(m, q)
        return speeds(m, q, named, u)
    rates = m.rates(q, u)
    worst = int(np.abs(rates).argmax())
    if abs(rates[worst]) <= NEARLY * max(1.0, float(np.abs(u / m.columns).max(initial=0.0))):
        return speeds(m, q, {}, u)
    row = m.closing.rows[worst]
    raise ModelError(
        f"u: all speeds are given, and joint '{row.joint}' would come apart at "
        f"{abs(rates[worst]) * m.rows[worst]:.3g} in '{row.name}'. Name only those that are to "
        "be held: the others follow"
    )
