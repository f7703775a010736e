"""Closed systems for other programs: frames held together, bodies split where that is needed."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import cardan as cd
from cardan.peers.circuits import Circuits, circuits
from cardan.peers.comparison import OURS, compare, drawn, pushed, taking_part
from cardan.peers.contest import relative
from cardan.runtime.verification.newton_euler import mass_matrix
from mechanisms.closed import CLOSED, Closed, four_bar

FORWARD = "forward_dynamics"


def found(scene: cd.Scene) -> tuple[cd.CompiledModel, Circuits]:
    model = cd.compile(scene)
    closed = circuits(model)
    assert isinstance(closed, Circuits), closed
    return model, closed


@pytest.mark.parametrize("mechanism", CLOSED.values(), ids=repr)
def test_parts_of_bodies_add_up(mechanism: Closed) -> None:
    model, closed = found(mechanism.build())
    own = drawn(model, 5)
    states = closed.states(own)
    whole = mass_matrix(closed.scene, states.q)
    # at speeds that keep the parts together the kinetic energy is that of the whole bodies
    energy = np.einsum("ni,nij,nj->n", states.u, whole, states.u) / 2
    np.testing.assert_allclose(energy, model.energy(own.q, own.u)[0], rtol=1e-9)
    assert states.third.shape == states.u.shape


@pytest.mark.parametrize("mechanism", CLOSED.values(), ids=repr)
def test_pinocchio_agrees_in_c(mechanism: Closed) -> None:
    model = cd.compile(mechanism.build())
    contenders, absent = taking_part(model, ("pinocchio",))
    if absent:
        pytest.skip(absent["pinocchio"])
    states = drawn(model, 20)
    theirs = contenders["pinocchio"].results(FORWARD, pushed(model, FORWARD, states))
    ours = model.forward_dynamics(states.q, states.u, tau=states.third)
    assert relative(theirs, ours) <= 1e-9


def test_what_is_held() -> None:
    kinds = {name: found(CLOSED[name].build())[1] for name in ("four_bar", "bricard", "stewart")}
    # planar loops close by points, a spatial hinge by a split body, ball joints by points
    assert [
        (held.aligned, len(kinds["four_bar"].seats)) for held in kinds["four_bar"].connections
    ] == [(False, 0)]
    assert [held.aligned for held in kinds["bricard"].connections] == [True]
    assert len(kinds["bricard"].seats) == 1
    assert [held.aligned for held in kinds["stewart"].connections] == [False] * 5


def test_relations_that_are_no_joints_are_refused_by_name() -> None:
    scene = four_bar()
    scene.constraint("law", scene.u("A") - scene.u("D") / 3)
    assert circuits(cd.compile(scene)) == "'law' is not a closing condition of a joint"


def test_trees_alone_are_not_compared_with_circuits() -> None:
    model = cd.compile(four_bar())
    absent = taking_part(model, ("casadi", "pydy"))[1]
    assert set(absent) == {"casadi", "pydy"}
    row = compare(model, ("forward_dynamics",), (), rounds=1).row("forward_dynamics", OURS)
    assert row is not None
    assert row.error is not None
    assert row.error < 1e-12


def test_mujoco_holds_points_nearly() -> None:
    """Its constraints give way by 1e-4 of the force, and it neglects that their rows turn."""
    pytest.importorskip("mujoco", reason="MuJoCo is not installed: pip install mujoco")
    scene = four_bar()
    scene.joints["C"] = dataclasses.replace(scene.joints["C"], kind=cd.Spherical(), cut=True)
    model = cd.compile(scene)
    drawn_states = drawn(model, 8)
    states = dataclasses.replace(drawn_states, u=0 * drawn_states.u)
    contender = taking_part(model, ("mujoco",))[0]["mujoco"]
    ours = model.forward_dynamics(states.q, states.u, tau=states.third)
    theirs = contender.results("forward_dynamics", states)
    assert 1e-9 < np.abs(theirs - ours).max() / np.abs(ours).max() < 1e-2


def test_drawn_states_are_on_the_constraints() -> None:
    model = cd.compile(CLOSED["delta"].build())
    states = drawn(model, 20)
    assert np.abs(model.constraints(states.q)).max() < 1e-12
    assert np.abs(model.constraint_rates(states.q, states.u)).max() < 1e-12
    assert np.ptp(states.q, axis=0).max() > 0.05
