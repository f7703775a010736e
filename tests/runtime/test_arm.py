"""A small arm through the whole compiler: frames, wrenches, reactions, parameters, saving."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import cardan as cd
from cardan.api.saved_model import load
from cardan.errors import BuildError, DerivationError, ModelError

pytestmark = pytest.mark.usefixtures("cache_directory")

EPS = np.finfo(float).eps
GRAVITY = np.array([0.0, 0.0, -9.81])
MASSES = {"upper": 2.0, "lower": 1.5, "tool": 0.5}


@pytest.fixture(scope="module")
def equations():
    scene = cd.Scene("arm", gravity=tuple(GRAVITY))
    bodies = {
        name: scene.body(name, mass=mass, com=(0.1, 0.02, -0.2), inertia=(0.02, 0.03, 0.01))
        for name, mass in MASSES.items()
    }
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, bodies["upper"])
    scene.joint("elbow", cd.Spherical(), bodies["upper"].at(0, 0.1, -0.4), bodies["lower"])
    scene.joint("slide", cd.Prismatic("x"), bodies["lower"].at(0.05, 0, -0.3), bodies["tool"])
    for name, body in bodies.items():
        body.at(0.1, 0.02, -0.2, name=f"{name}_com")
    bodies["tool"].at(0.3, -0.1, 0.2, name="tip")
    return cd.derive(scene)


@pytest.fixture
def arm(equations):
    return cd.compile(equations)


@pytest.fixture
def state(arm):
    return arm.split(arm.random_state(3))


def test_verified_when_built(arm):
    result = arm.verify()
    arm.prepare("rhs", "forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "qdot")
    result = arm.verify()
    assert {"rhs", "forward_dynamics", "mass_matrix", "qdot"} <= set(result.checked)
    assert result.worst < 100 * EPS


def test_wrenches_are_jacobian_times_wrench(arm, state):
    q, u = state
    w = np.array([0.3, -1.0, 0.5, 4.0, -2.0, 7.0])
    tau = arm.frame_jacobian("tip", q).T @ w
    pushed = arm.forward_dynamics(q, u, wrenches={"tip": w})
    assert np.allclose(pushed, arm.forward_dynamics(q, u, tau=tau), rtol=1e-12)
    rest = arm.inverse_dynamics(q, u, pushed, wrenches={"tip": w})
    assert np.abs(rest).max() < 1e-12 * np.abs(arm.inverse_dynamics(q, u, pushed)).max()
    assert np.allclose(arm.rhs(0.0, np.r_[q, u], wrenches={"tip": w})[-arm.nu :], pushed)


@pytest.mark.parametrize("frame", ["tip", "lower", "upper_com"])
def test_reaction_carries_everything_outboard(arm, state, frame):
    # Newton for the whole arm: base reaction + weight + wrench = sum of m a at the centers of mass
    q, u = state
    w = np.array([0.3, -1.0, 0.5, 4.0, -2.0, 7.0])
    tau = np.linspace(-1, 1, arm.nu)
    udot = arm.forward_dynamics(q, u, tau=tau, wrenches={frame: w})
    reaction = arm.reaction("shoulder", q, u, tau=tau, wrenches={frame: w})
    accelerations = {n: arm.acceleration(f"{n}_com", q, u, udot)[3:] for n in MASSES}
    needed = sum(m * (accelerations[n] - GRAVITY) for n, m in MASSES.items())
    base = arm.pose("upper", q)[:3, :3] @ reaction[3:]
    assert np.allclose(base + w[3:], needed, rtol=0, atol=1e-12 * np.abs(needed).max())
    # and along its free axis the joint carries what was applied there
    assert abs(reaction[1] - tau[0]) < 1e-11


def test_batch_of_wrenches(arm, state):
    q, u = state
    w = np.random.default_rng(1).uniform(-1, 1, (4, 6))
    many = arm.reaction("elbow", q, u, wrenches={"tip": w, "upper": w[0]})
    for k in range(4):
        one = arm.reaction("elbow", q, u, wrenches={"tip": w[k], "upper": w[0]})
        assert np.allclose(many[k], one, rtol=1e-13)


def test_velocities_in_either_axes(arm, state):
    q, u = state
    R = arm.pose("tip", q)[:3, :3]
    ground, own = (arm.velocity("tip", q, u, in_=axes) for axes in ("ground", "frame"))
    assert np.allclose(own, np.r_[R.T @ ground[:3], R.T @ ground[3:]], rtol=1e-13)
    assert np.allclose(arm.frame_jacobian("tip", q) @ u, ground, rtol=1e-13)
    several = arm.acceleration("tip", np.stack([q, q]), u, np.ones(arm.nu), in_="frame")
    assert several.shape == (2, 6)
    with pytest.raises(ValueError, match="in_ must be"):
        arm.velocity("tip", q, u, in_="body")


def test_parameters_of_the_scene(arm, state):
    q, _ = state
    heavy = arm.with_parameters({"tool.mass": 5.0})
    assert heavy.mass_matrix(q)[-1, -1] == pytest.approx(5.0, rel=1e-14)
    assert arm.mass_matrix(q)[-1, -1] == pytest.approx(0.5, rel=1e-14)
    sweep = arm.mass_matrix(q, parameters={"tool.mass": [1.0, 2.0, 3.0]})
    assert np.allclose(sweep[:, -1, -1], [1, 2, 3], rtol=1e-14)
    with pytest.raises(ModelError, match=r"'tool\.mas' does not exist.*Did you mean 'tool\.mass'"):
        arm.with_parameters({"tool.mas": 1.0})
    assert heavy.verify().worst < 100 * EPS


def test_function_that_was_not_asked_for(equations):
    model = cd.compile(equations, functions=["rhs"])
    with pytest.raises((ModelError, DerivationError), match="functions="):
        model.mass_matrix(np.zeros(model.nq))


def test_exported_model_runs_alone(equations, tmp_path, state, arm):
    equations.export(tmp_path / "out", ("forward_dynamics", "mass_matrix"))
    model = load(tmp_path / "out")
    q, u = state
    assert np.array_equal(model.forward_dynamics(q, u), arm.forward_dynamics(q, u))
    with pytest.raises(ModelError, match=r"compiled without 'rhs'.*functions="):
        model.rhs(0.0, np.r_[q, u])


def test_names_with_one_spelling_in_c_keep_their_frames(tmp_path):
    """A saved model finds by name what the writer told apart by numbers."""
    scene = cd.Scene("twins")
    b = scene.body("b", mass=1, com=(1, 0, 0))
    scene.joint("j", cd.Revolute("z"), scene.ground, b)
    places = {"a b": 1.0, "a_b": 2.0}
    for name, x in places.items():
        b.at(x, 0, 0, name=name)
    frames = tuple(("pose", name) for name in places)
    cd.derive(scene).export(tmp_path / "out", frames)
    model = load(tmp_path / "out")
    assert {name: model.pose(name, [0.0])[0, 3] for name in places} == places


def test_a_pickle_holds_what_was_not_used_yet():
    """All that takes no frame or joint, as far as it exists: a massless tip has no udot."""
    scene = cd.Scene("fresh")
    b = scene.body("b", mass=1, com=(1, 0, 0))
    scene.joint("j", cd.Revolute("y"), scene.ground, b)
    model = pickle.loads(pickle.dumps(cd.compile(scene)))
    assert model.forward_dynamics([0.0], [0.0])[0] == pytest.approx(9.81, rel=1e-15)
    scene.joint("tip", cd.Revolute("z"), b.at(1, 0, 0), scene.body("tip"))
    model = pickle.loads(pickle.dumps(cd.compile(scene)))
    assert model.mass_matrix([0.0, 0.0])[0, 0] == pytest.approx(1.0, rel=1e-15)
    with pytest.raises(ModelError, match="compiled without 'forward_dynamics'"):
        model.forward_dynamics([0.0, 0.0], [0.0, 0.0])


def test_verification_moves_the_inputs(tmp_path, cache_directory, monkeypatch):
    """A derivation that loses the acceleration of an input is found when it is built."""
    scene = cd.Scene("shaker", gravity=(0, 0, 0))
    turn = scene.input("turn")
    table, arm = scene.body("table"), scene.body("arm", mass=2, com=(0.3, 0.2, 0.1))
    scene.joint("axle", cd.Revolute("z"), scene.ground, table, prescribed=2 * turn)
    scene.joint("pin", cd.Revolute((0, 1, 1)), table.at(1, 0, 0), arm)
    right = cd.compile(scene, directory=tmp_path / "right", method="kane")
    right.prepare("forward_dynamics")
    assert right.verify().checked == ("forward_dynamics",)
    monkeypatch.setattr(
        "cardan.equations.kinematics.kinematics.input_rates", lambda graph, inputs: {}
    )
    wrong = cd.compile(scene, directory=tmp_path / "wrong", method="kane")
    with pytest.raises(BuildError, match="forward_dynamics differs from an independent"):
        wrong.forward_dynamics([0.0], [0.0])
