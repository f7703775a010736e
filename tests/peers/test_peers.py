"""Other programs on our mechanisms: every one that is here gives our numbers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import cardan as cd
from cardan.peers import PEERS, peer
from cardan.peers.comparison import OURS, compare, drawn, pushed, taking_part
from cardan.peers.contest import contest, relative
from cardan.peers.coordinates import Convention, after_each_other, coordinates, refusal
from cardan.peers.peer import FUNCTIONS, Contender, installed
from cardan.peers.tree import central, depth_first
from cardan.runtime.verification.flat_scene import scene_of
from mechanisms import ZOO
from table import each

EPS = float(np.finfo(float).eps)
NEEDED = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "applied_forces", "integrate")
# trees of the joints that others know too
SHARED = ("branched", "satellite", "double_pendulum")


def compiled(name: str) -> cd.CompiledModel:
    return cd.compile(ZOO[name].build(), functions=NEEDED)


@pytest.mark.parametrize("mechanism", SHARED)
@pytest.mark.parametrize("name", PEERS)
def test_peers_agree(name: str, mechanism: str) -> None:
    found = peer(name)
    model = compiled(mechanism)
    contenders, absent = taking_part(model, (name,))
    if absent:
        pytest.skip(f"{found.name}: {absent[name]}")
    contender = contenders[name]
    states = drawn(model, 10)
    allowed = 100 * EPS * np.linalg.cond(model.mass_matrix(states.q)).max()
    ours = {
        "forward_dynamics": model.forward_dynamics(states.q, states.u, tau=states.third),
        "inverse_dynamics": model.inverse_dynamics(states.q, states.u, states.third),
        "mass_matrix": model.mass_matrix(states.q),
    }
    for function in set(ours) & set(contender.functions):
        theirs = contender.results(function, pushed(model, function, states))
        if function == "inverse_dynamics":
            theirs = theirs - model.applied_forces(states.q, states.u)
        assert relative(theirs, ours[function]) <= allowed, function


@pytest.mark.parametrize("mechanism", ["branched", "double_pendulum"])
@pytest.mark.parametrize("name", PEERS)
def test_peers_agree_on_derivatives(name: str, mechanism: str) -> None:
    model = cd.compile(ZOO[mechanism].build())
    contenders, absent = taking_part(model, (name,))
    if absent or "derivatives" not in contenders[name].functions:
        pytest.skip(f"{peer(name).name}: {absent.get(name, 'no derivatives')}")
    states = drawn(model, 10)
    given = pushed(model, "derivatives", states)
    slopes = model.derivative("forward_dynamics", wrt=("q", "u"))
    rows = zip(given.q, given.u, given.third, strict=True)
    ours = np.stack([slopes(q, u, tau=force) for q, u, force in rows])
    theirs = contenders[name].results("derivatives", given)
    condition = np.linalg.cond(model.mass_matrix(states.q)).max()
    # MuJoCo takes differences of first order over 1e-6
    allowed = 1e-4 if name == "mujoco" else 1000 * EPS * condition
    assert relative(theirs, ours) <= allowed


@each("how", [Convention(*row) for row in np.ndindex(2, 2, 2, 2)])
def test_coordinates_of_others_and_back(how: Convention) -> None:
    model = compiled("satellite")
    scene = scene_of(model)
    place = coordinates(scene, how, after_each_other(scene, depth_first(scene)))
    s = drawn(model, 5)
    theirs = place.speeds(s.q, s.u)
    np.testing.assert_allclose(place.back(s.q, theirs), s.u, atol=10 * EPS)
    rates = place.accelerations(s.q, s.u, s.third)
    np.testing.assert_allclose(place.accelerations_back(s.q, s.u, rates), s.third, atol=10 * EPS)
    # power is the same whoever writes it
    power = np.sum(place.speeds(s.q, s.third) * theirs, axis=1)
    np.testing.assert_allclose(power, np.sum(s.third * s.u, axis=1), atol=100 * EPS)
    m = place.matrix_back(s.q, np.broadcast_to(np.eye(model.nu), (5, model.nu, model.nu)))
    np.testing.assert_allclose(m, np.broadcast_to(np.eye(model.nu), m.shape), atol=10 * EPS)


def test_speeds_of_others_change_as_their_accelerations_say() -> None:
    model = compiled("satellite")
    scene = scene_of(model)
    how = Convention(True, True, True, body_axes=True)
    place = coordinates(scene, how, after_each_other(scene, depth_first(scene)))
    s, step = drawn(model, 5), 1e-6
    ends = []
    for sign in (1, -1):
        q = model.integrate(s.q, sign * step * s.u)
        ends.append(place.speeds(q, s.u + sign * step * s.third))
    rate = (ends[0] - ends[1]) / (2 * step)
    # a central difference: step^2, and rounding over step
    np.testing.assert_allclose(place.accelerations(s.q, s.u, s.third), rate, atol=1e-8)


def test_central_inertia_is_what_was_written() -> None:
    scene = cd.Scene("one")
    body = scene.body("body", mass=2.0, com=(0.1, 0.2, 0.3), inertia=(0.3, 0.4, 0.5))
    scene.joint("hinge", cd.Revolute("z"), scene.ground, body)
    com, inertia = central(scene_of(cd.compile(scene)))
    np.testing.assert_allclose(com, [[0.1, 0.2, 0.3]], rtol=10 * EPS)
    np.testing.assert_allclose(inertia, [np.diag([0.3, 0.4, 0.5])], atol=10 * EPS)


def test_what_nobody_else_knows_is_refused_by_name() -> None:
    scene, joints = scene_of(compiled("double_pendulum")), ("shoulder", "elbow")
    assert refusal(scene, joints) == ""
    changed = replace(scene, kinds=("screw", "revolute"))
    assert refusal(changed, joints) == "joint 'shoulder' is screw"
    assert refusal(replace(scene, leaders=(-1, 0)), joints) == "joint 'elbow' is coupled"
    assert all(peer(name).refusal(changed, joints) for name in PEERS)


def test_everybody_has_a_turn_in_every_round() -> None:
    turns: list[str] = []

    def run(name: str, seconds: list[float]):
        def once(repeats: int) -> float:
            turns.append(name)
            return seconds[len([t for t in turns if t == name]) % len(seconds)]

        return once

    times = contest({"a": run("a", [3.0, 1.0, 2.0]), "b": run("b", [5.0])}, rounds=3)
    assert turns[-6:] == ["a", "b"] * 3
    assert (times["a"].least, times["a"].median) == (1.0, 2.0)
    assert (times["b"].least, times["b"].median) == (5.0, 5.0)


def test_comparison_names_everybody() -> None:
    found = compare(compiled("branched"), ("forward_dynamics",), ("mujoco", "pydy"), rounds=1)
    programs = {row.program for row in found.rows}
    assert programs | set(found.absent) >= {OURS, "mujoco", "pydy"}
    row = found.row("forward_dynamics", OURS)
    assert row is not None
    assert row.error <= 100 * EPS * found.condition
    assert 0 < row.time.least <= row.time.median


def test_functions_are_known_to_everybody() -> None:
    model = compiled("double_pendulum")
    contenders, _ = taking_part(model, ("casadi", "mujoco"))
    for contender in contenders.values():
        assert isinstance(contender, Contender)
        assert set(contender.functions) <= set(FUNCTIONS)


def test_a_peer_that_is_not_here_says_how_to_get_it() -> None:
    assert installed("no_such_module", "thing") == "not installed: pip install thing"
    assert installed("numpy", "numpy") == ""


def test_a_peer_without_the_functions_asked_for_is_named() -> None:
    found = compare(compiled("branched"), ("mass_matrix",), ("casadi", "drake", "pydy"), rounds=1)
    expected = {"drake": "derivatives", "pydy": "forward_dynamics"}
    for name, function in expected.items():
        if not peer(name).missing():
            assert found.absent[name] == f"it is compared in {function}"
