"""Faults of runs in time, each by its number."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import cardan as cd
from analyses.interpreted import without_compiler
from cardan.runtime.sparse.pattern import pattern
from cardan.runtime.sparse.stages import stages
from table import each


def satellite(torque: float = 0.05, **beam: str) -> cd.Scene:
    """A free hub with a motor wheel and an elastic panel."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=50.0, inertia=(5, 5, 5))
    scene.joint("free", cd.Free(), scene.ground, hub)
    scene.force("wheel", cd.Rotor(hub, axis="z", inertia=0.1, torque=torque))
    section, material = cd.section.rectangle(0.5, 0.005), cd.material(E=7e10, nu=0.3, rho=2700)
    scene.beam("panel", hub.at(0.5, 0, 0), (2.5, 0, 0), section, material, elements=4, **beam)
    return scene


def test_b1_a_free_hub_with_a_motor_wheel_and_a_panel_runs_with_defaults() -> None:
    """The wheel, which its carrier weighs for, was eliminated before the rows that hold it."""
    model = cd.compile(satellite())
    motion = model.simulate(1.0)
    assert motion.status == "finished", motion.message
    momentum = model.momentum(motion.q, motion.u)
    exchanged = 0.05 * 1.0  # torque of the motor times the time
    assert np.abs(momentum[:, :3]).max() <= 100 * 1e-6 * exchanged


def test_b1_energy_momentum_keeps_the_momenta_of_hub_wheel_and_panel() -> None:
    """What the method promises, with a wheel that turns freely."""
    scene = satellite(torque=0.0, inertia="lumped")
    with pytest.raises(cd.ModelError, match="coordinates='absolute'"):
        cd.compile(scene).simulate(0.3, method="EnergyMomentum", step=1e-3)
    model = cd.compile(scene, coordinates="absolute")
    begin = {"wheel.rotor": 5.0, "free": (0.1, 0.2, 0.1, 0, 0, 0)}
    motion = model.simulate(0.3, u=begin, method="EnergyMomentum", step=1e-3)
    assert motion.success, motion.message
    momentum = model.momentum(motion.q, motion.u)
    assert np.abs(momentum - momentum[0]).max() <= 1e-9 * np.abs(momentum).max()


def test_b1_a_bicycle_on_nodes_runs_at_tight_tolerances() -> None:
    """The same order of elimination: rows of the rear hub went with the heavier frame."""
    scene = cd.examples["bicycle"]
    model = cd.compile(scene, coordinates="absolute")
    for rtol in (1e-6, 1e-8, 1e-9):
        settings = scene.settings | {"t": 0.5, "rtol": rtol, "method": "GeneralizedAlpha"}
        motion = model.simulate(**settings)
        assert motion.status == "finished", motion.message
        # nothing is tried again: the equations of every step were solved
        assert motion.statistics["rejections"] <= 1


@pytest.mark.parametrize("parent", [0, 1])
def test_b1_rows_of_a_joint_go_with_its_child_where_the_tree_floats(parent: int) -> None:
    """Either of two bodies could go with the rows between them: the root can stand alone."""
    child = 1 - parent
    rows = pattern([6, 6, 6], [[[parent, child, 2]]], multiplier=[False, False, True])
    order = stages(rows)
    assert order[2] == order[child]
    assert order[2] != order[parent]


def test_b1_a_node_that_a_chain_of_exchanges_frees_is_held_too() -> None:
    """Rows 3 hold 0 or 1, rows 4 hold 1 or 2, rows 5 the ground's child 2: all three are held."""
    cliques = [[[1, 0, 3]], [[2, 1, 4]], [[0, 2, 5]]]
    rows = pattern([6] * 6, cliques, multiplier=[False] * 3 + [True] * 3)
    order = stages(rows)
    assert sorted(order[3:]) == sorted(order[:3])


def four_bar() -> cd.CompiledModel:
    """A crank, a coupler and a rocker between two points of the ground, under gravity."""
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    links = []
    for name, length in {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}.items():
        rod = cd.inertia.rod(length, length, axis="x")
        links.append(scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=rod))
    crank, coupler, rocker = links
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0))
    return cd.compile(scene)


def test_a18_atol_follows_rtol() -> None:
    """With atol 1e-9 whatever rtol, tighter ones than that changed nothing."""
    model = four_bar()
    begin = {"q": {"A": 0.5}, "u": {"A": 12.0}}
    right = model.simulate(0.5, **begin, rtol=1e-13)["A"][-1]
    errors = []
    for rtol in (1e-9, 1e-11):
        motion = model.simulate(0.5, **begin, method="GeneralizedAlpha", rtol=rtol)
        errors.append(abs(motion["A"][-1] - right))
    print(errors)
    # of order 2: the error follows rtol to the power 2/3, which is 20 here
    assert errors[1] < errors[0] / 5
    assert model.simulate(0.01, **begin).solver_info.settings == "rtol 1e-06, atol 1e-09"
    assert model.simulate(0.01, **begin, rtol=1e-3).solver_info.settings == "rtol 0.001, atol 1e-09"


def test_a18_an_rtol_that_atol_makes_void_is_said() -> None:
    """Nothing said that atol decided alone."""
    model = four_bar()
    motion = model.simulate(0.01, q={"A": 0.5}, rtol=1e-11, atol=1e-9)
    assert "atol decides: rtol counts for entries above 1e+02 alone" in str(motion)
    assert "atol decides" not in str(model.simulate(0.01, q={"A": 0.5}, rtol=1e-11, atol=1e-11))
    stepper = model.stepper(q={"A": 0.5}, rtol=1e-11)
    stepper.step(0.01)
    found = model.ensemble(0.01, vary={"A": [0.4, 0.5]}, rtol=1e-11)
    assert found.job.how.atol == pytest.approx(1e-14)


def pushed(force: object, coordinates: str = "relative", t0: float = 1.0) -> cd.CompiledModel:
    """A mass of 2 kg on a slide, pushed by a force."""
    scene = cd.Scene("pushed", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0, inertia=(1, 1, 1))
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    if force == "input":
        force = scene.input("F")
    if force == "parameter":
        force = sympy.Piecewise((20, cd.t < scene.parameter("t0", t0)), (0, True))
    scene.force("push", cd.JointForce("x", force))
    return cd.compile(scene, coordinates=coordinates)


STEPS = {
    "before": sympy.Piecewise((20, cd.t < 1), (0, True)),
    "to": sympy.Piecewise((20, cd.t <= 1), (0, True)),
    "between": sympy.Piecewise((0, cd.t < 0.3), (20, cd.t < 1.3), (0, True)),
    "pulse": sympy.Piecewise((0, cd.t < 1), (2e4, cd.t < 1.001), (0, True)),
    "wave": sympy.Piecewise((40, sympy.sin(2 * sympy.pi * cd.t) > 0), (0, True)),
}


@each("coordinates", ["relative", "absolute"])
@each("name", STEPS)
def test_step_loads_are_exact(name: str, coordinates: str) -> None:
    """Jumps of Piecewise were sampled: a momentum of 20.010 for 20."""
    model = pushed(STEPS[name], coordinates)
    end = 1.0 if name == "wave" else 3.0
    for method in ("DOP853", "RK45", "RK4", "GeneralizedAlpha", "EnergyMidpoint", "Radau"):
        if method == "Radau" and coordinates == "absolute":
            continue
        motion = model.simulate(end, method=method)
        # 2e4 rows of rounding at most
        assert 2 * motion["x.u"][-1] == pytest.approx(20, abs=1e-10), method
    stepper = model.stepper()
    for _ in range(round(end / 0.05)):
        stepper.step(0.05)
    assert 2 * stepper.state[model.nq] == pytest.approx(20, abs=1e-10)


@each("written", ["<", "<=", ">", ">="])
@each("time", [0.7, 0.1 * 7, 0.1 * 3])
def test_a_jump_is_seen_from_its_own_side(written: str, time: float) -> None:
    """A step ended a rounding beside a time of many digits, and its derivative had both sides."""
    condition = sympy.Rel(cd.t, time, written)
    force = sympy.Piecewise((20.0, condition), (-10.0, True))
    motion = pushed(force).simulate(2.0, method="DOP853")
    sides = (20.0, -10.0) if "<" in written else (-10.0, 20.0)
    momentum = sides[0] * time + sides[1] * (2.0 - time)
    assert motion.solver_info.statistics["rejections"] == 0
    assert 2 * motion["x.u"][-1] == pytest.approx(momentum, abs=1e-13)


def test_step_loads_at_parameters_are_exact_in_every_run_of_an_ensemble() -> None:
    """The times of jumps are those of the run's own parameters."""
    model = pushed("parameter")
    times = [0.25, 0.7, 1.9]
    found = model.ensemble(2.0, vary={"t0": times})
    np.testing.assert_allclose(2 * found.final[:, 1], 20 * np.array(times), rtol=0, atol=1e-10)


def test_step_loads_are_exact_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same times in runs whose functions Python evaluates."""
    model = without_compiler(pushed(STEPS["between"]), monkeypatch)
    motion = model.simulate(3.0, method="DOP853")
    assert "in Python" in motion.solver_info.settings
    assert 2 * motion["x.u"][-1] == pytest.approx(20, abs=1e-10)


def test_e9_a_pulse_of_a_function_at_rest_is_seen() -> None:
    """Steps grew over it: the result was exactly 0."""
    model = pushed("input")
    inputs = {"F": lambda t, x: 6000.0 if 0.4 <= t < 0.401 else 0.0}
    for end in (1.0, 3.0):
        motion = model.simulate(end, inputs=inputs)
        assert motion["x.u"][-1] == pytest.approx(3.0, rel=1e-3)
        assert "steps up to 1/1000 of the span" in motion.solver_info.settings
    # what the caller says goes before
    assert model.simulate(1.0, inputs=inputs, max_step=0.5).statistics["steps"] < 100
    found = model.ensemble(1.0, vary={"x": [0.0, 1.0]}, inputs=inputs)
    np.testing.assert_allclose(found.final[:, 1], 3.0, rtol=1e-3)


def test_b12_tight_tolerances_on_nodes_take_a_method_of_high_order() -> None:
    """Generalized-alpha was taken whatever rtol: 124,000 steps at 1e-11 for an error of 3e-4."""
    scene = cd.Scene("slider_crank")
    crank = scene.body("crank", mass=1.0, com=(0.15, 0, 0), inertia=(0.001, 0.01, 0.01))
    rod = scene.body("rod", mass=1.0, com=(0.3, 0, 0), inertia=(0.001, 0.03, 0.03))
    slider = scene.body("slider", mass=1.0, inertia=(0.01, 0.01, 0.01))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), rod)
    scene.joint("C", cd.Revolute("z"), rod.at(0.6, 0, 0), slider)
    scene.joint("S", cd.Prismatic("x"), scene.ground, slider)
    begin = {"q": {"A": 0.3}, "u": {"A": 5.0}}
    right = cd.compile(scene).simulate(1.0, **begin, rtol=1e-12)["S"][-1]
    model = cd.compile(scene, coordinates="absolute")
    motion = model.simulate(1.0, **begin, rtol=1e-11)
    assert motion.solver_info.method == "DOP853"
    assert motion.statistics["steps"] < 500
    assert motion["S"][-1] == pytest.approx(right, abs=1e-7)
    assert model.simulate(0.1, **begin).solver_info.method == "DOP853"


def test_b12_stiff_elements_keep_the_implicit_method() -> None:
    """Beams vibrate faster than anything that is to be followed."""
    motion = cd.compile(satellite()).simulate(1.0, rtol=1e-8)
    assert motion.status == "finished"
    assert motion.solver_info.method == "Radau"


def test_at_gives_the_rows_of_a_run_with_output_times() -> None:
    """It raised even at those times."""
    times = np.array([0.0, 0.1, 0.25, 1.0])
    model = pushed(STEPS["before"])
    motion = model.simulate(times)
    np.testing.assert_array_equal(motion.at(times[::-1]), motion.x[::-1])
    np.testing.assert_array_equal(motion.at(0.25), motion.x[2])
    with pytest.raises(cd.errors.ModelError, match=r"t=0.3 s is not an output time"):
        motion.at([0.1, 0.3])
    assert motion.resample([0.25, 1.0]).x.shape == (2, model.nx)
    backward = model.simulate(times[::-1])
    np.testing.assert_array_equal(backward.at(0.1), backward.x[2])


@each("exponent", [1.0, 1.5])
@each("restitution", [0.2, 0.5, 0.9, 1.0])
def test_a_contact_has_the_restitution_that_is_asked_for(
    restitution: float, exponent: float
) -> None:
    """By 3/2 (1 - e) / v a restitution of 0.5 came out as 0.66."""
    scene = cd.Scene("ball", gravity=(0, 0, 0))
    ball = scene.body("ball", mass=1.0, inertia=(1, 1, 1))
    scene.joint("z", cd.Prismatic("z"), scene.ground, ball)
    contact = cd.Contact(
        ball, scene.ground, radius=0.1, stiffness=1e6, exponent=exponent,
        restitution=restitution, speed=2.0,
    )  # fmt: skip
    scene.force("floor", contact)
    motion = cd.compile(scene).simulate(0.2, q={"z": 0.2}, u={"z": -2.0}, rtol=1e-9)
    assert motion["z.u"][-1] == pytest.approx(2.0 * restitution, rel=1e-5)


def test_restitution_is_refused_where_it_means_nothing() -> None:
    """Alone, beside damping, and out of its range."""
    ground = cd.Scene("one").ground

    def contact(**how: float) -> cd.Contact:
        return cd.Contact(ground, ground, radius=0.1, stiffness=1e6, **how)

    for how in ({"restitution": 0.5}, {"speed": 1.0}):
        with pytest.raises(cd.errors.ModelError, match="go together"):
            contact(**how)
    with pytest.raises(cd.errors.ModelError, match="leave one out"):
        contact(restitution=0.5, speed=1.0, damping=0.1)
    refused = {
        0.0: "restitution=0.0, speed=1.0: give positive numbers",
        -1.0: "restitution=-1.0, speed=1.0: give positive numbers",
        1.5: "restitution=1.5: no impact gives energy; at most 1",
        float("nan"): "restitution is nan; give a finite number",
    }
    for bad, message in refused.items():
        with pytest.raises(cd.errors.ModelError, match=f"contact: {message}"):
            contact(restitution=bad, speed=1.0)


def test_e9_times_of_a_stepper_stay_on_their_grid() -> None:
    """They were summed: 3.0000000000000013 after 30 steps of 0.1."""
    stepper = pushed(STEPS["before"]).stepper()
    for _ in range(10_000):
        stepper.step(0.1)
    assert stepper.t == 1000.0
    saved = stepper.save()
    ahead = [(stepper.step(0.1).tolist(), stepper.t) for _ in range(20)]
    stepper.restore(saved)
    assert [(stepper.step(0.1).tolist(), stepper.t) for _ in range(20)] == ahead
    stepper.step(0.05)
    stepper.step(-0.05)
    assert stepper.t == pytest.approx(1002.0, abs=1e-12)
