"""Regressors: one column after the other, by the motion of a body of unit mass or inertia."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from .bodies import kinetic, weight
from .differences import BOUND, relative
from .evaluation import ELSEWHERE, Asked
from .joint_motion import Array, times
from .newton_euler import Scene, inverse_dynamics
from .rotations import cross_matrix

ENTRIES = ("mass", "x", "y", "z", "xx", "yy", "zz", "xy", "xz", "yz")
CELLS = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
CHANGED = 0.25


def _frames(asked: Asked) -> Iterator[tuple[int, Array, Array]]:
    """Of every body with parts its number, and the frame of the first part in its axes."""
    manifest, numbers = asked.model.manifest, asked.scene.numbers
    places = {row.name: k for k, row in enumerate(manifest.frames)}
    for i, body in enumerate(manifest.bodies):
        if body.parts:
            k = places[body.parts[0]]
            yield i, numbers["frame_rotation"][k], numbers["frame_position"][k]


def _of(scene: Scene, i: int, m: float, s: Array, inertia: Array) -> Scene:
    """The scene in which body i alone has mass, first moment and inertia about its origin."""
    numbers = dict(scene.numbers)
    for name, value in (("mass", m), ("first_moment", s), ("inertia", inertia)):
        numbers[name] = np.zeros_like(numbers[name])
        numbers[name][i] = value
    numbers["rotor"] = np.zeros(len(scene.parents))
    return replace(scene, numbers=numbers)


def _units(asked: Asked) -> Iterator[Scene]:
    """Scenes in which one of the ten numbers of one body is 1, in the order of the columns."""
    for i, R, p in _frames(asked):
        for entry in ENTRIES:
            m, s, inertia = 0.0, np.zeros(3), np.zeros((3, 3))
            if entry == "mass":
                m, s, inertia = 1.0, p, cross_matrix(p).T @ cross_matrix(p)
            elif entry in CELLS:
                one = np.zeros((3, 3))
                one[CELLS[entry]] = one[CELLS[entry][::-1]] = 1.0
                inertia = R @ one @ R.T
            else:
                s = R[:, "xyz".index(entry)]
                inertia = cross_matrix(p).T @ cross_matrix(s) + cross_matrix(s).T @ cross_matrix(p)
            yield _of(asked.scene, i, m, s, inertia)


def regressor(asked: Asked, of: str | None) -> float | str:
    """Forces per unit of every number of bodies; what elements add, by changed coefficients."""
    value, worst = asked.call("regressor"), 0.0
    q, u, udot, motion = asked.tree
    count = 0
    for count, scene in enumerate(_units(asked), 1):
        known = asked.along(inverse_dynamics(scene, q, u, udot, motion))
        column = value[:, :, count - 1]
        worst = max(worst, relative(column - known, known, np.ones_like(known)))
    return _elements(asked, value, count, "inverse_dynamics", worst)


def _elements(asked: Asked, value: Array, first: int, name: str, worst: float) -> float | str:
    """Columns of force elements: what changed coefficients change in a function.

    Args:
        asked: The model at its states.
        value: All columns (n, k, columns) of the rows that the function gives.
        first: Column of the first coefficient.
        name: The function.
        worst: Error of the columns of bodies.

    Returns:
        The largest error; where none is too large, why columns cannot be told: a coefficient that
        is a number never changes.
    """
    model = asked.model
    if value.shape[-1] == first or worst > BOUND:
        return worst
    if not asked.knows(name, "inertial_parameters"):
        return ELSEWHERE
    known = dict(model.parameters)
    entries = model._function("inertial_parameters", None).outputs[0].entries[first:]
    left = {k for k, entry in enumerate(entries) if entry not in known}
    phi = asked.call("inertial_parameters")
    # those that are parameters, and expressions of other parameters
    changed = [entry for entry in entries if entry in known]
    changed += [parameter for parameter in known if left and parameter not in changed]
    for parameter in changed:
        new = float(known[parameter]) * (1 + CHANGED) + CHANGED
        other = replace(asked, model=model.with_parameters({parameter: new}), kept={})
        change = other.call("inertial_parameters") - phi
        told = {k for k in left if change[:, first + k].any()}
        if parameter not in entries and not told:
            continue
        if parameter not in entries and not np.array_equal(_rows(other, name), value):
            continue
        found = times(value, change)
        before, after = asked.call(name), other.call(name)
        if name == "power":
            before, after = before.sum(axis=-1)[:, None], after.sum(axis=-1)[:, None]
        error = relative(found - (after - before), after - before, found, before)
        worst, left = max(worst, error), left - told
    if left and not worst > BOUND:
        names = ", ".join(f"'{entries[k]}'" for k in sorted(left)[:3])
        return f"nothing changes {names}: give numbers of elements as parameters"
    return worst


def _rows(asked: Asked, name: str) -> Array:
    """The columns that give a function."""
    if name == "power":
        return asked.call("energy_regressor")[:, 2:]
    return asked.call("regressor")


def energy_regressor(asked: Asked, of: str | None) -> float | str:
    """Energies per unit of every number of bodies; powers of elements by changed coefficients."""
    value, worst, count = asked.call("energy_regressor"), 0.0, 0
    for count, scene in enumerate(_units(asked), 1):
        one = replace(asked, scene=scene, kept={})
        known = np.stack([kinetic(one), weight(one), np.zeros(len(value))], axis=-1)
        worst = max(worst, relative(value[:, :, count - 1] - known, known, np.ones_like(known)))
    return _elements(asked, value[:, 2:], count, "power", worst)


def inertial_parameters(asked: Asked, of: str | None) -> float:
    """The ten numbers of every body about its own frame, and coefficients of their names."""
    model, numbers = asked.model, asked.scene.numbers
    value = np.asarray(model._function("inertial_parameters", None).caller(None)).reshape(-1)
    known: list[float] = []
    for i, R, p in _frames(asked):
        m, s = float(numbers["mass"][i]), numbers["first_moment"][i]
        P, S = cross_matrix(p), cross_matrix(s)
        inertia = numbers["inertia"][i] - P.T @ S - S.T @ P
        own = R.T @ (inertia + m * P.T @ P) @ R
        known += [m, *(R.T @ (s - m * p)), *(own[cell] for cell in CELLS.values())]
    entries = model._function("inertial_parameters", None).outputs[0].entries
    values = dict(model.parameters)
    rest = [float(values.get(name, found)) for name, found in zip(entries, value, strict=True)]
    whole = np.array([*known, *rest[len(known) :]])
    return relative((value - whole)[None], whole[None])


JUDGES = {
    "regressor": regressor,
    "energy_regressor": energy_regressor,
    "inertial_parameters": inertial_parameters,
}
