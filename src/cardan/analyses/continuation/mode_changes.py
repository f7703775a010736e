"""Corners of a path, where a stop, a latch or dry friction changes its mode.

Within a mode the path is smooth. Where a sign function of a mode falls through 0 the element does
what it does in a run, without speeds, and the path goes on in the direction that the new mode
allows: under a stop that is reached, the load may have to turn back.

Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 5.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...arrays import Array, Booleans
from ...errors import SolveError
from ..statics.settling import fired_at, forbidden, signs_of_modes
from .equilibria import EquilibriumFamily, Loaded
from .follow import Place, Step, place
from .special_points import EVENT, Corner, Special

BISECTED = 60
ASIDE = 1e-4  # length of the step that tells which direction a mode allows


def corner_within(
    family: EquilibriumFamily, names: Sequence[str], step: Step, number: int
) -> Corner | None:
    """The first change of a mode within a step; None where there is none.

    Args:
        family, names, step: Of what, with the names of its events.
        number: Of the place from which the step goes.
    """
    problem = family.problem
    if not names:
        return None
    passed = _forbidden(family, step.before, step.after)
    if not passed.any():
        return None
    low, high = 0.0, 1.0
    for _ in range(BISECTED):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        there = _negative(family, step.before, step.at(family, middle)) & passed
        low, high = (low, middle) if there.any() else (middle, high)
    fired = _negative(family, step.before, step.at(family, high)) & passed
    at: Loaded = step.at(family, low).point
    behind = replace(at, point=fired_at(problem, at.point, fired))
    label = " and ".join(names[int(k)] for k in np.flatnonzero(fired))
    onward = _onward(family, behind, step.before.tangent)
    special = Special(EVENT, label, place(family, at, step.before.tangent), number, low)
    return Corner(special, onward)


def _forbidden(family: EquilibriumFamily, before: Place, after: Place) -> Booleans:
    return forbidden(family.problem, before.point.point, after.point.point)


def _negative(family: EquilibriumFamily, before: Place, at: Place) -> Booleans:
    """Mask of the sign functions below 0 on the way from one place to another."""
    system = family.problem.system
    way = system.difference(before.point.point.at.q, at.point.point.at.q)
    return np.asarray(signs_of_modes(family.problem, at.point.point, way) < 0)


def _onward(family: EquilibriumFamily, behind: Loaded, tangent: Array) -> Place | None:
    """The place behind a change of modes in the direction that they allow; None without any."""
    try:
        forward = place(family, behind, tangent)
    except SolveError:
        return None
    for sign in (1.0, -1.0):
        direction = sign * forward.tangent
        near = family.moved(behind, ASIDE * direction)
        if not forbidden(family.problem, behind.point, near.point).any():
            return place(family, behind, direction)
    return None
