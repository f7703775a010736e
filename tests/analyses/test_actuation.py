"""Actuators of closed systems: unique forces, least norms, what cannot be done, hybrid dynamics."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import ArgumentError, SolveError
from laws.circuits import start
from mechanisms.closed import CLOSED

Array = Any
# differences that rounding makes, beside the largest entry
RIGHT = 1e-10
SLIDES = tuple(f"slide{k}" for k in range(6))


@cache
def model_of(name: str, constraints: str = "auto") -> cd.CompiledModel:
    return cd.compile(cd.derive(CLOSED[name].build(), constraints=constraints))


@cache
def five_bar() -> cd.CompiledModel:
    """Two cranks, two rods and a motor at the joint between the rods: two freedoms."""
    scene = cd.Scene("five_bar", gravity=(0, -9.81, 0))
    rods = {}
    for name in ("left", "long", "back", "right"):
        rods[name] = scene.body(name, mass=0.5, com=(0.1, 0, 0), inertia=(1e-3, 2e-3, 2e-3))
    left, long, back, right = rods.values()
    scene.joint("A", cd.Revolute("z"), scene.ground, left, q0=2.0)
    scene.joint("B", cd.Revolute("z"), left.at(0.2, 0, 0), long, q0=-1.2)
    scene.joint("E", cd.Revolute("z"), scene.ground.at(0.25, 0, 0), right, q0=1.0)
    scene.joint("D", cd.Revolute("z"), right.at(0.2, 0, 0), back, q0=1.2)
    scene.joint("C", cd.Revolute("z"), long.at(0.3, 0, 0), back.at(0.3, 0, 0), cut=True)
    return cd.compile(scene)


def moving(name: str, count: int = 1) -> tuple[cd.CompiledModel, Array, Array, Array, Array]:
    """A model with states on the constraints, forces, and accelerations under them."""
    if name == "five_bar":
        model = five_bar()
        q, u = model.split(model.assemble(u={"A": 1.0, "E": -2.0}).x)
    else:
        model = model_of(name)
        q, u = start(model, name, 0.3)
    rng = np.random.default_rng(5)
    tau = rng.uniform(-1, 1, (count, model.nu))
    return model, q, u, tau, model.forward_dynamics(q, u, tau=tau)


def close(one: Array, other: Array) -> bool:
    return bool(np.abs(one - other).max() <= RIGHT * max(1.0, np.abs(other).max()))


@pytest.mark.parametrize(
    ("name", "actuators"),
    [("four_bar", ["A"]), ("stewart", SLIDES), ("delta", None), ("five_bar", ["A", "E", "B"])],
)
def test_forward_after_inverse_is_the_motion(name, actuators):
    model, q, u, _, udot = moving(name, 3)
    found = model.actuation(q, u, udot, actuators)
    assert found.forces.shape == (3, len(found.actuators))
    assert close(model.forward_dynamics(q, u, tau=found.tau), udot)
    # the balance with all forces
    G = model.constraint_jacobian(q)
    assert close(model.inverse_dynamics(q, u, udot), found.tau + found.multipliers @ G)


def test_as_many_actuators_as_freedoms_are_unique():
    model, q, u, _, udot = moving("stewart")
    found = model.actuation(q, u, udot[0], SLIDES)
    assert found.unique
    assert found.freedoms == found.rank == 6
    assert "6 actuators, 6 freedoms" in repr(found)
    assert "forces are unique" in repr(found)
    # forces of the actuators alone are found again
    only = np.zeros(model.nu)
    only[[model.speeds.index(f"{name}.u") for name in SLIDES]] = np.arange(1.0, 7.0)
    found = model.actuation(q, u, model.forward_dynamics(q, u, tau=only), SLIDES)
    assert close(found.forces, np.arange(1.0, 7.0))
    assert found["slide3"] == pytest.approx(found.forces[found.actuators.index("slide3.u")])


def test_more_actuators_share_the_load_by_least_norm():
    model, q, u, _, udot = moving("five_bar")
    motors = ["A", "B", "E"]
    found = model.actuation(q, u, udot[0], motors)
    assert not found.unique
    assert (found.freedoms, found.rank, found.norm) == (2, 2, "minimum")
    assert "1 force without effect on the motion: those of least norm" in repr(found)
    # any other forces for the same motion are larger: two of the motors do, the third rests
    for pair in (["A", "B"], ["A", "E"], ["B", "E"]):
        alone = model.actuation(q, u, udot[0], pair)
        assert alone.unique
        assert np.linalg.norm(alone.forces) > np.linalg.norm(found.forces)
        # what differs has no effect, and is across the least one
        at = [model.speeds.index(n) for n in found.actuators]
        idle = (alone.tau - found.tau)[at]
        assert abs(idle @ found.forces) < RIGHT * (found.forces @ found.forces)


def test_weights_move_the_load():
    model, q, u, _, udot = moving("five_bar")
    even = model.actuation(q, u, udot[0], ["A", "B", "E"])
    spared = model.actuation(q, u, udot[0], ["A", "B", "E"], norm=[1.0, 1e8, 1.0])
    assert spared.norm == "weighted"
    assert "least weighted norm" in repr(spared)
    assert abs(spared["B"]) < 1e-6 * abs(even["B"])
    alone = model.actuation(q, u, udot[0], ["A", "E"])
    assert np.allclose(spared.forces[[0, 2]], alone.forces, rtol=1e-5)
    same = model.actuation(q, u, udot[0], ["A", "B", "E"], norm=np.diag([1.0, 1e8, 1.0]))
    assert close(same.forces, spared.forces)


def test_closed_forms_and_trees_have_no_multipliers():
    model = model_of("four_bar", "closed_form")
    q, u = model.split(model.initial(q={"A": 0.7}, u={"A": 3.0}))
    found = model.actuation(q, u, [2.0], ["A"])
    assert found.multipliers.shape == (0,)
    assert close(found.forces, model.inverse_dynamics(q, u, [2.0]))


def test_too_few_actuators_are_named():
    model, q, u, _, udot = moving("five_bar")
    with pytest.raises(SolveError, match=r"'five_bar': 'A.u' cannot make this motion.*together"):
        model.actuation(q, u, udot[0], ["A"])
    with pytest.raises(SolveError, match="an empty set of actuators cannot"):
        model.actuation(q, u, udot[0], [])


def test_a_change_point_is_named():
    """A parallelogram that lies flat has two freedoms, of which one crank moves one."""
    scene = cd.Scene("flat", gravity=(0, -9.81, 0))
    near, far = (scene.body(name, mass=1.0, com=(0.5, 0, 0)) for name in ("near", "far"))
    bar = scene.body("bar", mass=1.0)
    scene.joint("O", cd.Revolute("z"), scene.ground, near)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(-0.4, 0, 0), far)
    scene.joint("A", cd.Revolute("z"), near.at(1, 0, 0), bar)
    scene.joint("C", cd.Revolute("z"), far.at(1, 0, 0), bar.at(-0.4, 0, 0))
    model = cd.compile(scene)
    flat, beside = (model.assemble({"O": x, "D": x}).q for x in (0.0, 0.3))
    at_rest = np.zeros(model.nu)
    told = r"'flat': the position is singular, a change point: 1 of 2 independent .* meet at 'C'"
    with pytest.raises(SolveError, match=told):
        model.actuation(flat, at_rest, at_rest, ["O"])
    with pytest.raises(SolveError, match="the position at state 1 is singular"):
        model.actuation(np.array([beside, flat]), at_rest, at_rest, ["O"])
    # both cranks hold it there, and one does beside it, by the weights of two cranks and the bar
    found = model.actuation(flat, at_rest, at_rest, ["O", "D"])
    assert found.unique
    assert found["O"] + found["D"] == pytest.approx(9.81 * 2.0)
    alone = model.actuation(beside, at_rest, at_rest, ["O"])
    assert alone["O"] == pytest.approx(9.81 * 2.0 * np.cos(0.3))


def test_modes_say_what_actuators_carry():
    """A brake that sticks carries the weight of a pendulum, and what is asked of it is refused."""
    scene = cd.Scene("braked", gravity=(0, -9.81, 0))
    scene.joint("A", cd.Revolute("z"), scene.ground, scene.body("rod", mass=2.0, com=(0.5, 0, 0)))
    scene.force("brake", cd.Friction("A", coulomb=50.0))
    model, sticks = cd.compile(scene), {"brake": 2.0}
    free = model.actuation([0.0], [0.0], [0.0], ["A"])
    assert free["A"] == pytest.approx(9.81)
    stuck = model.actuation([0.0], [0.0], [0.0], ["A"], s=sticks)
    assert stuck["A"] == 0.0
    assert stuck.multipliers == pytest.approx([9.81])
    assert model.hybrid_dynamics([0.0], [0.0], {}, s=sticks).udot == pytest.approx([0.0])
    with pytest.raises(SolveError, match="do not allow these accelerations"):
        model.hybrid_dynamics([0.0], [0.0], {"A": 1.0}, s=sticks)


def test_motions_against_the_constraints_are_named():
    model, q, u, _, udot = moving("four_bar")
    with pytest.raises(SolveError, match=r"the constraints 'C.p.* do not allow"):
        model.actuation(q, u, udot[0] + [1.0, 0.0, 0.0], ["A"])


def test_wrong_names_and_weights_are_named():
    model, q, u, _, udot = moving("four_bar")
    with pytest.raises(ArgumentError, match="'elbow' is neither a joint with speeds nor a speed"):
        model.actuation(q, u, udot[0], ["elbow"])
    with pytest.raises(ArgumentError, match="no speed of its own here"):
        model.actuation(q, u, udot[0], ["C"])
    for norm in ([1.0, 1.0], [-1.0], "largest"):
        with pytest.raises(ArgumentError, match="norm"):
            model.actuation(q, u, udot[0], ["A"], norm=norm)
    found = model.actuation(q, u, udot[0], ["A"])
    with pytest.raises(ArgumentError, match="'B' is not an actuator here"):
        found["B"]


@pytest.mark.parametrize("name", ["four_bar", "five_bar"])
def test_hybrid_dynamics_agrees_with_a_prescribed_motion(name):
    model, q, u, tau, udot = moving(name, 2)
    free = tau.copy()
    free[:, 0] = 0.0
    found = model.hybrid_dynamics(q, u, {"A": udot[:, 0]}, tau=free)
    # the force that was left out comes back, and so does the rest of the motion
    assert close(found["A"], tau[:, 0])
    assert close(found.udot, udot)
    assert close(found.tau, tau)
    assert close(model.forward_dynamics(q, u, tau=found.tau), found.udot)


def test_hybrid_dynamics_of_a_tree_takes_whole_joints():
    scene = cd.Scene("swing")
    arm = scene.body("arm", mass=1.0, com=(0, 0, -0.3), inertia=(0.03, 0.03, 0.01))
    ball = scene.body("ball", mass=0.4, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, arm)
    scene.joint("socket", cd.Spherical(), arm.at(0, 0, -0.6), ball)
    model = cd.compile(scene)
    q, u = model.split(model.random_state(3))
    found = model.hybrid_dynamics(q, u, {"socket": [0.1, -0.2, 0.3]})
    assert close(found.udot[1:], np.array([0.1, -0.2, 0.3]))
    assert found.tau[0] == 0.0
    assert close(model.inverse_dynamics(q, u, found.udot), found.tau)
    with pytest.raises(ArgumentError, match=r"expected \(..., 3\)"):
        model.hybrid_dynamics(q, u, {"socket": 1.0})


def test_hybrid_dynamics_refuses_what_circuits_forbid():
    model, q, u, _, _ = moving("four_bar")
    with pytest.raises(SolveError, match=r"'A.u', 'D.u' together"):
        model.hybrid_dynamics(q, u, {"A": 1.0, "D": 50.0})


def test_a_linkage_without_mass_needs_no_mass_matrix() -> None:
    """A parallelogram carries the torque of a spring from one crank to the other."""
    scene = cd.Scene("parallelogram", gravity=(0, -9.81, 0))
    first, rod, other = (
        scene.body(n, mass=0.5, com=(0.1, 0, 0), inertia=(1e-3,) * 3)
        for n in ("first", "rod", "other")
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, first, q0=1.0)
    scene.joint("B", cd.Revolute("z"), first.at(0.2, 0, 0), rod, q0=-1.0)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), other, q0=1.0)
    scene.joint("C", cd.Revolute("z"), rod.at(0.3, 0, 0), other.at(0.2, 0, 0), cut=True)
    scene.force("spring", cd.JointSpring("D", stiffness=2.0))
    model = cd.compile(scene)
    q, still = model.assemble({"A": 1.0, "B": -1.0, "D": 1.0}).q, np.zeros(3)
    names = [p.name for p in model.manifest.parameters]
    bare = {n: 0.0 for n in names if n.endswith(".mass") or ".inertia" in n}
    for one, parameters in ((model, bare), (model.with_parameters(bare), None)):
        found = one.actuation(q, still, still, ["A"], parameters=parameters)
        assert found["A"] == pytest.approx(2.0 * 1.0, rel=1e-12)
    # with masses on one body only, M does not tell what the constraints allow
    some = {n: 0.0 for n in bare if not n.startswith("first")}
    with pytest.raises(SolveError, match="the mass matrix is singular at these parameters"):
        model.actuation(q, still, still, ["A"], parameters=some)
