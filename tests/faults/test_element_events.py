"""Faults of events of elements in finite-element coordinates."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_events import LOWER, cantilever

LYING = -1.0


def blocked(stops: int) -> cd.CompiledModel:
    """A mass on a rail on another, which a second joint holds at the ground; stops on the rails."""
    scene = cd.Scene("blocked", gravity=(0, 0, -9.81))
    below = scene.ground
    for k, name in enumerate(("one", "two")):
        block = scene.body(name, mass=1.0 + k, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.3))
        scene.joint(f"{name} rail", cd.Prismatic((0.48, 0.6, 0.64)), below.at(k, 0.3, 0.1), block)
        if k == 0:
            hinge = cd.Revolute((0.36, 0.8, -0.48))
            scene.joint("hinge", hinge, scene.ground, block.at(0.1, 0.2, 0.3))
        if k >= 2 - stops:
            stop = cd.Stop(f"{name} rail", lower=0.0, restitution=0.5)
            scene.force(f"{name} stop", stop)
        below = block
    return cd.compile(scene, coordinates="absolute")


@pytest.mark.parametrize("rate", [-1e-3, 1e-3])
@pytest.mark.parametrize("mode", [0.0, LYING])
def test_a_stop_that_nothing_can_move_takes_nothing_from_others(rate: float, mode: float) -> None:
    """Its impulse was a speed over the rounding of what answers it, beside those of others."""
    changes = []
    for model in (blocked(1), blocked(2)):
        q, u = model._layout.start("q"), np.zeros(model.nu)
        u[model.speeds.index("two rail.u")] = -1.0
        at = [model.speeds.index(f"two.u.p{x}") for x in "xyz"]
        u[at] = -np.array([0.48, 0.6, 0.64])
        # a rate that constraints do not allow, as roundings and tolerances leave them
        u[model.speeds.index("one rail.u")] = rate
        fired = np.array([float(name.endswith(".lower")) for name in model.event_names])
        s = [mode * (row.name == "one stop") for row in model.manifest.s]
        changes.append(model.transition(q, u, fired, s=s)[: model.nu] - u)
    two = model.speeds.index("two rail.u")
    assert changes[0][two] == pytest.approx(1.5, abs=1e-9)
    assert changes[1] == pytest.approx(changes[0], abs=1e-9)


def test_accelerations_are_solved_for_only_where_a_value_reads_them() -> None:
    """Every value of every event cost a factorization, in all modes."""
    model = cd.compile(cantilever(2, lower=LOWER))
    q, u = model._layout.start("q"), np.zeros(model.nu)
    model.events(q, u, s=[0.0])
    mesh = model._source.results(model).mesh
    marks = []
    for mode in (0.0, LYING):
        at = model._source.results(model).state({"q": q, "u": u, "s": np.array([mode])})
        (values,) = mesh.results("signs", at)
        marks.append(values[0, -1])
    assert marks == [0.0, 1.0]
    # a value of a mode that reads them is that of the solution
    lam = model.multipliers(q, u, s=[LYING])
    row = list(model.multipliers_of).index("stop.stop")
    assert model.events(q, u, s=[LYING])[-1] == pytest.approx(lam[row])


def test_closed_states_are_given_back_as_they_are() -> None:
    """A step of a projection was solved for where nothing was open."""
    model = cd.compile(cantilever(2, lower=LOWER))
    q, u = model._layout.start("q"), np.zeros(model.nu)
    closed = model.close_position(q)[: model.nq]
    again = model.close_position(closed)
    if np.abs(again[model.nq :]).max(initial=0) <= 1e-15:
        np.testing.assert_array_equal(again[: model.nq], closed)
    np.testing.assert_array_equal(model.close_velocity(closed, u)[: model.nu], u)


def test_steps_too_long_for_a_beam_at_a_stop_name_their_cure() -> None:
    """The message spoke of settle= alone, which is no cure where steps miss the vibration."""
    model = cd.compile(cantilever(8, lower=LOWER, restitution=0.0))
    method = cd.GeneralizedAlpha(0.8)
    with pytest.warns(cd.SolveWarning, match="ever again.*take step= shorter"):
        coarse = model.simulate(0.12, method=method, step=1e-4)
    assert coarse.status == "chatter"
    assert model.simulate(0.12, method=method, step=2e-5).success
