"""Events in finite-element coordinates: as in joint coordinates, scene by scene."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.event_scenes import SCENES, Start
from laws.test_absolute import carried

FINE = {"rtol": 1e-10, "atol": 1e-11, "method": "DOP853"}
SPAN = 2.0
# states are those of a motion, to the projection onto the constraints
CLOSE = 1e-8


@functools.cache
def both(name: str) -> tuple[cd.CompiledModel, cd.CompiledModel, Start]:
    """A scene in finite-element and in joint coordinates, and where a run starts."""
    scene, start = SCENES[name]()
    return cd.compile(scene, coordinates="absolute"), cd.compile(SCENES[name]()[0]), start


@functools.cache
def motion_of(name: str) -> Any:
    """The motion in joint coordinates."""
    _, other, start = both(name)
    return other.simulate(SPAN, q=start, **FINE)


def moments(name: str, count: int = 4) -> list[dict[str, Any]]:
    """States along the motion, with modes drawn."""
    _, other, _ = both(name)
    motion, rng, states = motion_of(name), np.random.default_rng(2), []
    for k in np.linspace(1, len(motion.t) - 1, count).astype(int):
        q, u, z = other.parts_of(motion.x[k])
        # not where something begins or ends
        u = 1.05 * u
        s = [
            float(rng.choice([int(v) for v in row.labels])) if row.labels else motion.s[k][i]
            for i, row in enumerate(other.manifest.s)
        ]
        states += [{"q": q, "u": u, "z": z, "t": motion.t[k], "s": x} for x in (motion.s[k], s)]
    return states


@pytest.mark.parametrize("name", SCENES)
def test_signs(name: str) -> None:
    model, other, _ = both(name)
    assert model.event_names == other.event_names
    if not model.event_names:
        return
    for at in moments(name):
        nodes, speeds = carried(model, other, at["q"], at["u"])
        mine = model.events(**{**at, "q": nodes, "u": speeds})
        theirs = other.events(**at)
        assert mine == pytest.approx(theirs, abs=CLOSE * (1 + np.abs(theirs).max(initial=0)))


@pytest.mark.parametrize("name", SCENES)
def test_transitions(name: str) -> None:
    model, other, _ = both(name)
    if not model.event_names:
        return
    at_speeds = [model.speeds.index(speed) for speed in other.speeds if speed in model.speeds]
    picked = [k for k, speed in enumerate(other.speeds) if speed in model.speeds]
    for at in moments(name):
        nodes, speeds = carried(model, other, at["q"], at["u"])
        here = {**at, "q": nodes, "u": speeds}
        possible = other.events(**at) != 1.0
        possible |= [row.kind == "tick" for row in other.manifest.events]
        for fired in np.eye(len(model.event_names))[possible]:
            mine, theirs = (
                model.transition(**here, events=fired),
                other.transition(**at, events=fired),
            )
            tol = CLOSE * (1 + np.abs(theirs).max(initial=0))
            assert mine[: model.nu][at_speeds] == pytest.approx(theirs[: other.nu][picked], abs=tol)
            assert mine[model.nu :] == pytest.approx(theirs[other.nu :], abs=tol)


@pytest.mark.parametrize("name", SCENES)
def test_motions(name: str) -> None:
    model, other, start = both(name)
    theirs, mine = motion_of(name), model.simulate(SPAN, q=start, **FINE)
    assert theirs.t[-1] == mine.t[-1] == SPAN
    assert [event.name for event in mine.events] == [event.name for event in theirs.events]
    times = [event.t for event in theirs.events]
    assert [event.t for event in mine.events] == pytest.approx(times, abs=1e-6)
    for place in (p for p in other.coordinates if p in model.coordinates):
        assert mine[place][-1] == pytest.approx(theirs[place][-1], abs=1e-6)


@pytest.mark.parametrize("method", [cd.GeneralizedAlpha(0.8), cd.GeneralizedAlpha(0.5), "HHT"])
@pytest.mark.parametrize("name", ["controlled", "sampled"])
def test_internal_states_have_the_order_of_the_method(name: str, method: Any) -> None:
    model, other, start = both(name)
    theirs, errors = motion_of(name), []
    for step in (4e-3, 2e-3):
        mine = model.simulate(SPAN, q=start, method=method, step=step)
        places = [abs(mine[place][-1] - theirs[place][-1]) for place in other.coordinates]
        last = theirs.x[-1][other.nq + other.nu :]
        errors.append((max(places), np.abs(mine.x[-1][model.nq + model.nu :] - last).max()))
    assert max(errors[1]) < 5e-5
    assert all(3 < a / b < 5 for a, b in zip(*errors, strict=True))


@pytest.mark.parametrize("name", [name for name in SCENES if name not in ("controlled", "sampled")])
def test_motions_by_generalized_alpha(name: str) -> None:
    model, _, start = both(name)
    theirs = motion_of(name)
    mine = model.simulate(SPAN, q=start, method=cd.GeneralizedAlpha(0.8), step=1e-3)
    assert [event.name for event in mine.events] == [event.name for event in theirs.events]
    times = [event.t for event in theirs.events]
    # a stiff contact takes an eighth of a step for its first part
    limit = 3e-3 if name == "bouncing" else 2e-5
    assert [event.t for event in mine.events] == pytest.approx(times, abs=limit)
