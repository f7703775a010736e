"""Forces along motions: inverse dynamics by name, of runs, splines and mechanisms with loops."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import cardan as cd
from cardan.errors import ArgumentError, SolveError
from mechanisms import ZOO
from mechanisms.closed_planar import four_bar, four_bar_angles

ARM = Path(__file__).parents[2] / "examples" / "arm.urdf"


def test_a_given_motion_takes_the_forces_of_inverse_dynamics(tmp_path: Path) -> None:
    model = cd.compile(cd.load(ARM))
    t = np.linspace(0, 2, 401)
    wave = np.sin(np.outer(t, [1.0, 2.0, 3.0]))
    found = model.torques({"t": t, "q": wave})
    rates = np.cos(np.outer(t, [1.0, 2.0, 3.0])) * [1.0, 2.0, 3.0]
    hard = -wave * [1.0, 4.0, 9.0]
    want = model.inverse_dynamics(wave, rates, hard)
    # a quintic spline through samples every 5 ms
    assert np.abs(found.forces - want).max() < 1e-6
    assert np.array_equal(found["elbow"], found.tau[:, 2])
    assert np.array_equal(found.power, found.forces * found.u)
    # what the motors gave is in the energy or went to the dampers
    energy = model.energy(found.q, found.u).total
    lost = np.trapezoid(model.power(found.q, found.u).sum(axis=-1), found.t)
    assert found.work.sum() == pytest.approx(energy[-1] - energy[0] - lost, rel=1e-4)
    assert "elbow.u" in repr(found)
    assert "N m" in repr(found)
    # the table is data again
    path = found.save(tmp_path / "run.csv")
    again = model.torques(path)
    assert np.array_equal(again.forces, found.forces)
    # names, functions and tables in place of arrays
    named = {
        "t": t,
        "waist": CubicSpline(t, wave[:, 0]),
        "shoulder": wave[:, 1],
        "elbow": cd.table(t, wave[:, 2], kind="cubic"),
    }
    assert np.abs(model.torques(named).forces - want).max() < 1e-3
    with pytest.raises(ArgumentError, match="'elbo' is not an actuator here"):
        found["elbo"]
    with pytest.raises(SolveError, match="cannot make this motion"):
        model.torques({"t": t, "q": wave}, actuators=["elbow"])


def test_a_run_takes_none_of_its_own_and_some_of_a_heavier_robot() -> None:
    scene = ZOO["double_pendulum"].build()
    model = cd.compile(scene)
    run = model.simulate(2.0, q={"shoulder": 1.0}, rtol=1e-10, atol=1e-12)
    assert np.abs(run.torques().forces).max() < 1e-12 * 10
    heavy = model.with_parameters({"lower.mass": 0.8})
    found = heavy.torques(run)
    udot = model.forward_dynamics(run.q, run.u)
    assert np.allclose(found.forces, heavy.inverse_dynamics(run.q, run.u, udot), atol=1e-12)
    assert found.peak.max() > 0.1


def test_without_the_motor_of_the_model() -> None:
    scene = cd.Scene("wheel", gravity=(0, 0, 0))
    disk = scene.body("disk", mass=1, inertia=(0.1, 0.1, 0.2))
    scene.joint("axle", cd.Revolute("z"), scene.ground, disk)
    scene.force("motor", cd.JointForce("axle", scene.input("torque", default=0.6)))
    run = cd.compile(scene).simulate(1.0)
    assert np.abs(run.torques().forces).max() < 1e-14
    without = run.torques(inputs={"torque": 0})
    assert np.allclose(without["axle"], 0.6, rtol=1e-14)
    with pytest.raises(ArgumentError, match="no input 'torqe'"):
        run.torques(inputs={"torqe": 0})


def test_quaternions_have_speeds() -> None:
    """Positions of a free body alone: speeds solve qdot = N u, and nothing but gravity acts."""
    model = cd.compile(ZOO["satellite"].build())
    run = model.simulate(np.linspace(0, 1, 401), **_start("satellite"), rtol=1e-11, atol=1e-12)
    found = model.torques({"t": run.t, "q": run.q})
    assert np.abs(found.u - run.u).max() < 1e-7
    assert np.abs(found.forces).max() < 1e-3


def _start(name: str) -> dict[str, dict[str, object]]:
    state = ZOO[name].states[0]
    return {"q": dict(state.q), "u": dict(state.u)}


def test_circuits_by_chosen_actuators() -> None:
    model = cd.compile(four_bar())
    start = {name: angle for name, angle in four_bar_angles(0.3).items() if name != "C"}
    sweep = model.sweep("A", np.linspace(0.3, 2.0, 40), rate=4.0, start=start)
    motion = {"t": np.linspace(0, 1.7 / 4, 40), "q": sweep.q, "u": sweep.u, "udot": sweep.udot}
    crank = model.torques(motion, actuators=["A"])
    assert crank.unique
    assert np.array_equal(crank["A"], model.actuation(sweep.q, sweep.u, sweep.udot, ["A"])["A"])
    # the power of the crank is what the energy gains
    energy = model.energy(sweep.q, sweep.u).total
    assert crank.work[0] == pytest.approx(energy[-1] - energy[0], rel=1e-3)
    every = model.torques(motion)
    assert not every.unique
    assert np.linalg.norm(every.forces) < np.linalg.norm(crank.forces)
    assert "least norm" in repr(every)


def test_names_with_dots_and_a_u_are_found() -> None:
    scene = cd.Scene("leg", gravity=(0, 0, -9.81))
    thigh = scene.body("thigh", mass=1, com=(0, 0, -0.5))
    foot = scene.body("foot", mass=1, com=(0, 0, -0.1), inertia=(0.1, 0.1, 0.1))
    scene.joint("leg.upper", cd.Revolute("y"), scene.ground, thigh)
    scene.joint("leg.under", cd.Spherical(), thigh.at(0, 0, -1), foot)
    equations = cd.derive(scene)
    model = cd.compile(equations)
    found = model.torques(model.simulate(0.1, q={"leg.upper": 0.3}))
    assert found["leg.upper"] is not None
    assert found["leg.under.x"].shape == found.t.shape
    named = ("leg.upper", *(f"along leg.under.u.{x}" for x in "xyz"))
    linear = model.linearize()
    assert linear.along == named
    assert linear.states == equations.linearize().states
    assert "legpper" not in equations._repr_latex_()
