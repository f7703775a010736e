"""Where a run of a closed system starts: what is named is held, the rest is assembled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ModelError
from ..runtime.compiled import CompiledModel
from ..runtime.initial import entries
from .assemble import STARTS, choose, outside
from .consistent import speeds
from .mechanism import Mechanism
from .meeting import Found
from .meshed_start import meshed_start
from .redundancy import rank_of
from .rounded import rounded, slack
from .searches import search, search_from
from .settings import Start
from .targets import Target, read
from .unassembled import explain, turned_round

Array = NDArray[np.float64]
BESIDE = 1e-3  # of the size, and radians
NAMED = "Name fewer coordinates at the start: circuits determine the others"
NEARLY = 1e-4  # residuals without units of values that were meant to fit, and are rounded


def closed_start(model: CompiledModel, begin: Start, q: Any, u: Any, t: float, r: Array) -> Start:
    """A start at which circuits are closed.

    Args:
        model: The compiled model; trees start where they are told to.
        begin: The start as it was named, with defaults.
        q, u: As the user gave them; anything but names is a whole block.
        t, r: Time and inputs.

    Raises:
        ModelError: circuits that cannot be assembled with what is named.
    """
    manifest = model.manifest
    always = [row for row in manifest.get("multipliers", ()) if not row.get("switched")]
    if not always or "constraints" not in manifest["available"]:
        # the run itself projects what it is given; what modes hold is not held before it begins
        return begin
    if "mesh" in manifest:
        return replace(begin, x=meshed_start(model, begin.x, q, u, t, r))
    m = Mechanism(model, t, r)
    place, speed, internal = model.parts_of(begin.x)
    place = _positions(m, place, _named("q", model, q))
    m.slack = m.slack or slack(m, place)
    speed = _speeds(m, place, speed, _named("u", model, u))
    return replace(begin, x=np.concatenate([place, speed, internal]), slack=m.slack)


def _named(letter: str, model: CompiledModel, given: Any) -> Mapping[str, Any] | None:
    """What was named; None where every entry was given."""
    if given is not None and not isinstance(given, Mapping):
        return None
    places = entries(model.manifest, letter)
    rows = model.coordinates if letter == "q" else model.speeds
    known = {k for name in given or {} for k in range(*places[name].indices(len(rows)))}
    return None if len(known) == len(rows) else given or {}


def _positions(m: Mechanism, q: Array, named: Mapping[str, Any] | None) -> Array:
    """Assembled coordinates."""
    open_by = float(np.abs(m.residuals(q)).max(initial=0.0))
    if named is None and open_by <= NEARLY:
        end = search_from(m, [], q)
        if end.turned:
            raise ModelError(turned_round(end.turned))
        if end.met:
            return end.q
    every = dict(zip(m.model.coordinates, q.tolist(), strict=True))
    goals = read(m, every if named is None else named)
    return _assembled(m, goals, q).q


def _assembled(m: Mechanism, goals: list[Target], q: Array) -> Found:
    """The position next to a start; other starts are tried where that does not close."""
    first = search_from(m, goals, q)
    if first.met and not outside(m, first.q):
        return first
    found = search(m, goals, q, STARTS, 0)
    met = [one for one in found if one.met]
    if not met:
        # numbers that fit but for their last digits
        wished = [replace(goal, weight=1.0) for goal in goals]
        nearest = search_from(m, wished, q)
        if nearest.met and nearest.cost <= NEARLY**2:
            return nearest
        found = rounded(m, goals, q, STARTS, 0)
        met = [one for one in found if one.met]
    if not met:
        explain(m, goals, found, lambda n, some: search(n, some, q, 6, 0), NAMED)
    return choose(m, met, [], q)


def _speeds(m: Mechanism, q: Array, u: Array, named: Mapping[str, Any] | None) -> Array:
    """Speeds that circuits allow."""
    if named is not None:
        _refuse_singular(m, q)
        return speeds(m, q, named, u)
    rates = m.rates(q, u)
    worst = int(np.abs(rates).argmax())
    if abs(rates[worst]) <= NEARLY * max(1.0, float(np.abs(u / m.columns).max(initial=0.0))):
        return speeds(m, q, {}, u)
    row = m.closing.rows[worst]
    raise ModelError(
        f"u: all speeds are given, and joint '{row['joint']}' would come apart at "
        f"{abs(rates[worst]) * m.rows[worst]:.3g} in '{row['name']}'. Name only those that are to "
        "be held: the others follow"
    )


def _refuse_singular(m: Mechanism, q: Array) -> None:
    """Refuse a start at which branches meet, unless all speeds say which one is meant.

    Raises:
        ModelError: constraints are fewer here than at a position beside it.
    """
    G = m.jacobian(q)
    U, s, _ = np.linalg.svd(G)
    rank = rank_of(s)
    if rank == len(G):
        return
    aside = np.random.default_rng(0).uniform(-BESIDE, BESIDE, m.model.nu)
    beside = search_from(m, [], m.advance(q, aside)).q
    usual = rank_of(np.linalg.svd(m.jacobian(beside), compute_uv=False))
    if usual <= rank:
        return
    # what is lost here, and not what is redundant everywhere
    weakest = int(np.abs(U[:, rank:]).max(axis=1).argmax())
    raise ModelError(
        f"the start is a singular position: {rank} of {usual} independent constraints hold there, "
        f"branches of the motion meet at joint '{m.closing.rows[weakest]['joint']}'. Give all "
        "speeds, u=: they say which branch is meant; or start beside it"
    )
