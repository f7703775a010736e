"""Regressors: one column after the other, by the motion of a body of unit mass or inertia."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from .bodies import kinetic, weight
from .differences import BOUND, relative
from .evaluation import ELSEWHERE, Trial
from .joint_motion import Array, times
from .newton_euler import Scene, inverse_dynamics
from .rotations import cross_matrix

ENTRIES = ("mass", "x", "y", "z", "xx", "yy", "zz", "xy", "xz", "yz")
CELLS = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
CHANGED = 0.25


def _frames(trial: Trial) -> Iterator[tuple[int, Array, Array]]:
    """Number of every body with parts, and the frame of the first part in its axes."""
    manifest, numbers = trial.model.manifest, trial.scene.numbers
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


def _units(trial: Trial) -> Iterator[Scene]:
    """Scenes in which one of the ten numbers of one body is 1, in the order of the columns."""
    for i, R, p in _frames(trial):
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
            yield _of(trial.scene, i, m, s, inertia)


def regressor(trial: Trial, of: str | None) -> float | str:
    """Forces per unit of every number of bodies; what elements add, by changed coefficients."""
    value, worst = trial.call("regressor"), 0.0
    q, u, udot, motion = trial.tree
    count = 0
    for count, scene in enumerate(_units(trial), 1):
        expected = trial.along(inverse_dynamics(scene, q, u, udot, motion))
        column = value[:, :, count - 1]
        worst = max(worst, relative(column - expected, expected, np.ones_like(expected)))
    return _elements(trial, value, count, "inverse_dynamics", worst)


def _elements(trial: Trial, value: Array, first: int, name: str, worst: float) -> float | str:
    """Columns of force elements: what changed coefficients change in a function.

    Args:
        trial: The model at its states.
        value: All columns (n, k, columns) of the rows that the function gives.
        first: Column of the first coefficient.
        name: The function.
        worst: Error of the columns of bodies.

    Returns:
        The largest error; where none is too large, why columns cannot be told: a coefficient that
        is a number never changes.
    """
    model = trial.model
    if value.shape[-1] == first or worst > BOUND:
        return worst
    if not trial.knows(name, "inertial_parameters"):
        return ELSEWHERE
    values_of = dict(model.parameters)
    entries = model._function("inertial_parameters", None).outputs[0].entries[first:]
    left = {k for k, entry in enumerate(entries) if entry not in values_of}
    phi = trial.call("inertial_parameters")
    # those that are parameters, and expressions of other parameters
    changed = [entry for entry in entries if entry in values_of]
    changed += [parameter for parameter in values_of if left and parameter not in changed]
    for parameter in changed:
        new = float(values_of[parameter]) * (1 + CHANGED) + CHANGED
        other = replace(trial, model=model.with_parameters({parameter: new}), cache={})
        change = other.call("inertial_parameters") - phi
        observed = {k for k in left if change[:, first + k].any()}
        if parameter not in entries and not observed:
            continue
        if parameter not in entries and not np.array_equal(_rows(other, name), value):
            continue
        predicted = times(value, change)
        before, after = trial.call(name), other.call(name)
        if name == "power":
            before, after = before.sum(axis=-1)[:, None], after.sum(axis=-1)[:, None]
        error = relative(predicted - (after - before), after - before, predicted, before)
        worst, left = max(worst, error), left - observed
    if left and not worst > BOUND:
        names = ", ".join(f"'{entries[k]}'" for k in sorted(left)[:3])
        return f"nothing changes {names}: give numbers of elements as parameters"
    return worst


def _rows(trial: Trial, name: str) -> Array:
    """The columns that give a function."""
    if name == "power":
        return trial.call("energy_regressor")[:, 2:]
    return trial.call("regressor")


def energy_regressor(trial: Trial, of: str | None) -> float | str:
    """Energies per unit of every number of bodies; powers of elements by changed coefficients."""
    value, worst, count = trial.call("energy_regressor"), 0.0, 0
    for count, scene in enumerate(_units(trial), 1):
        one = replace(trial, scene=scene, cache={})
        expected = np.stack([kinetic(one), weight(one), np.zeros(len(value))], axis=-1)
        worst = max(
            worst, relative(value[:, :, count - 1] - expected, expected, np.ones_like(expected))
        )
    return _elements(trial, value[:, 2:], count, "power", worst)


def inertial_parameters(trial: Trial, of: str | None) -> float:
    """The ten numbers of every body about its own frame, and coefficients of their names."""
    model, numbers = trial.model, trial.scene.numbers
    value = np.asarray(model._function("inertial_parameters", None).caller(None)).reshape(-1)
    expected: list[float] = []
    for i, R, p in _frames(trial):
        m, s = float(numbers["mass"][i]), numbers["first_moment"][i]
        P, S = cross_matrix(p), cross_matrix(s)
        inertia = numbers["inertia"][i] - P.T @ S - S.T @ P
        inertia_tensor = R.T @ (inertia + m * P.T @ P) @ R
        expected += [m, *(R.T @ (s - m * p)), *(inertia_tensor[cell] for cell in CELLS.values())]
    entries = model._function("inertial_parameters", None).outputs[0].entries
    values = dict(model.parameters)
    coefficients = [
        float(values.get(name, current)) for name, current in zip(entries, value, strict=True)
    ]
    all_expected = np.array([*expected, *coefficients[len(expected) :]])
    return relative((value - all_expected)[None], all_expected[None])


JUDGES = {
    "regressor": regressor,
    "energy_regressor": energy_regressor,
    "inertial_parameters": inertial_parameters,
}
