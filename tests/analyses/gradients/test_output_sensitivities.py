"""What outputs, energies, forces and functions of a motion change by."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.gradients.test_elements import HOW, PARAMETERS, SPAN, START, richardson
from cardan.errors import ArgumentError, DerivationError, ModelError
from laws.absolute_scenes import rubber
from table import each

# of differences to eighth order
WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
KNOTS = np.linspace(0.0, 1.0, 5)
TORQUES = np.array([1.0, 0.5, -0.5, 0.2, 0.4])
# steps of one length: what a run computes is smooth
STEPS: dict[str, Any] = {"method": "RK4", "step": 2e-3}


def arm() -> cd.CompiledModel:
    """Two links, a motor and a spring; an output depends on a parameter and an input itself."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    m, length = scene.parameter("m", 1.0), scene.parameter("length", 0.6)
    inertia = cd.inertia.rod(m, length, axis="z")
    upper = scene.body("upper", mass=m, com=(0, 0, -length / 2), inertia=inertia)
    hand = scene.body("hand", mass=0.5, com=(0, 0, -0.2), inertia=(0.01, 0.01, 0.002))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -length), hand)
    tau = scene.input("tau", unit="N*m")
    scene.force("motor", cd.JointForce("elbow", tau))
    anchor = scene.ground.at(0.5, 0, 0)
    scene.force("spring", cd.SpringDamper(anchor, hand, stiffness=20.0, damping=0.3 * m))
    scene.output("reach", hand.at(0, 0, -0.4).position()[0] * length + 0.1 * m * tau)
    return cd.compile(scene)


def run(model: cd.CompiledModel, name: str = "", by: float = 0.0, **more: Any) -> cd.Trajectory:
    """The motion with one thing changed."""
    torques, start = TORQUES.copy(), {"shoulder": 0.3, "elbow": 0.4}
    if name.startswith("tau"):
        torques[int(name.removeprefix("tau"))] += by
    if name == "q0.shoulder":
        start["shoulder"] += by
    parameters = {name: model.parameters[name] + by} if name in model.parameters else None
    inputs = {"tau": (KNOTS, torques)}
    return model.simulate(1.0, q=start, inputs=inputs, parameters=parameters, **STEPS, **more)


HISTORIES = (
    *("reach", "elbow", "shoulder.u", "tau", "energy", "kinetic energy", "potential energy"),
    *("spring.force", "motor.force", "elbow.force", "shoulder.moment.y"),
)
UNKNOWNS = ("m", "length", "q0.shoulder", "tau")


def test_histories() -> None:
    """By parameters, a start and values of an input, at the end: differences of eighth order."""
    model = arm()
    motion = run(model, sensitivity=UNKNOWNS)
    changes = {what: motion.sensitivity.of(what) for what in HISTORIES}
    for what in HISTORIES:
        for unknown in UNKNOWNS[:3]:
            assert changes[what][unknown].shape == motion[what].shape
        assert changes[what]["tau"].shape == (*motion[what].shape, len(KNOTS))
    for unknown in ("m", "length", "q0.shoulder", "tau1", "tau4"):
        column = int(unknown[3:]) if unknown.startswith("tau") else None
        expected = dict.fromkeys(HISTORIES, 0.0)
        for k, weight in enumerate(WEIGHTS, 1):
            ahead, behind = (run(model, unknown, side * k * 1e-3) for side in (1, -1))
            for what in HISTORIES:
                change = weight * (ahead[what][-1] - behind[what][-1]) / 1e-3
                expected[what] = expected[what] + change
        for what in HISTORIES:
            found = changes[what]["tau" if column is not None else unknown][-1]
            found = found if column is None else found[..., column]
            np.testing.assert_allclose(
                found, expected[what], rtol=1e-9, atol=1e-9, err_msg=f"{what} by {unknown}"
            )


def test_functions_and_formulas() -> None:
    """A formula is worth what its names are, and a frame what an output at it is."""
    motion = run(arm(), sensitivity=("m", "x0"))
    of = motion.sensitivity.of
    reach, m, tau = motion["reach"], 1.0, motion["tau"]
    square = of("m*(reach - 0.2)^2 + tau")
    np.testing.assert_allclose(
        square["m"], (reach - 0.2) ** 2 + 2 * m * (reach - 0.2) * of("reach")["m"], rtol=1e-12
    )
    poses, length = of(("pose", "hand")), 0.6
    arm_of_tip = poses["m"][:, 0, 3] - 0.4 * poses["m"][:, 0, 2]
    np.testing.assert_allclose(arm_of_tip * length + 0.1 * tau, of("reach")["m"], atol=1e-12)
    assert poses["x0"].shape == (len(motion), 4, 4, 4)
    assert of("com")["m"].shape == (len(motion), 3)
    # between the rows
    times = np.array([0.0, 0.123, 1.0])
    at = of("reach", times)["x0"]
    np.testing.assert_allclose(at[[0, 2]], of("reach")["x0"][[0, -1]], rtol=1e-12, atol=1e-15)
    states = motion.sensitivity.at(times)["x0"]
    np.testing.assert_array_equal(of("elbow.u", times)["x0"], states[:, 3])


def test_adjoint_gradients_agree() -> None:
    """Backward, with the output as a cost at the end."""
    model = arm()
    given = {"q": {"shoulder": 0.3}, "inputs": {"tau": (KNOTS, TORQUES)}, **STEPS}
    slope = model.gradient(1.0, cd.cost(final="reach"), wrt=("p", "x0", "tau"), **given).slope
    motion = model.simulate(1.0, sensitivity=("p", "x0", "tau"), **given)
    for name, changes in motion.sensitivity.of("reach").items():
        np.testing.assert_allclose(changes[-1], slope[name], rtol=1e-11, atol=1e-12)


def servo() -> cd.CompiledModel:
    """A cart that a sampled controller drives; its force holds between samples."""
    scene = cd.Scene("servo")
    cart = scene.body("cart", mass=2.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
    gain, total = scene.parameter("gain", 30.0), sp.Symbol("total")
    off = scene.q("x") - 0.5
    force = -gain * off - 8.0 * scene.u("x") - 5.0 * total
    pid = cd.Controller("x", states=[total], changes=[total + 0.02 * off], force=force, sample=0.02)
    scene.force("pid", pid)
    return cd.compile(scene)


def test_what_a_sampled_controller_holds_changes_too() -> None:
    """Its force between samples depends on nothing but modes, and these on the gain."""
    model = servo()
    motion = model.simulate(0.55, q={"x": 0.1}, rtol=1e-12, sensitivity="gain")
    times = np.array([0.0, 0.013, 0.25, 0.55])
    found = motion.sensitivity.of("pid.force", times[1:])["gain"]

    def force(by: float) -> Any:
        how = {"q": {"x": 0.1}, "rtol": 1e-12, "parameters": {"gain": 30.0 + by}}
        return model.simulate(times, **how)["pid.force"][1:]

    total = sum(w * (force(k * 0.05) - force(-k * 0.05)) for k, w in enumerate(WEIGHTS, 1))
    assert np.abs(found).min() > 1e-3
    np.testing.assert_allclose(found, total / 0.05, rtol=1e-9)


@each("coordinates", ["auto", "absolute"])
def test_beams(coordinates: str) -> None:
    model = cd.compile(rubber(), coordinates=coordinates)
    names = tuple(name for name in PARAMETERS if name in ("E", "m", "gravity.z"))

    def motion(name: str = "", by: float = 0.0, **more: Any) -> cd.Trajectory:
        parameters = {name: model.parameters[name] * (1 + by)} if name else None
        given = {"inputs": {"torque": 0.1}, "parameters": parameters, **START, **HOW}
        return model.simulate(SPAN, **given, **more)

    along = motion(sensitivity=names).sensitivity
    for what in ("z", "energy"):
        changes = along.of(what)
        for name in names:

            def value(by: float, name: str = name, what: str = what) -> float:
                return float(motion(name, by)[what][-1])

            expected = richardson(value, 1e-3) / model.parameters[name]
            # differences have the rounding of runs, 1e-15 of positions of 1 m, over 1e-3
            close = pytest.approx(expected, rel=1e-6, abs=1e-11)
            assert changes[name][-1] == close, (what, name)


def test_what_has_no_sensitivity_is_said() -> None:
    of = run(arm(), sensitivity="m").sensitivity.of
    with pytest.raises(DerivationError, match=r"'rech' is not known here.*Did you mean 'reach'"):
        of("rech")
    with pytest.raises(ModelError, match=r"frame 'hnd' does not exist.*Did you mean 'hand'"):
        of(("pose", "hnd"))
    with pytest.raises(ModelError, match=r"no function 'pos'.*Did you mean 'pose'"):
        of(("pos", "hand"))
    with pytest.raises(ArgumentError, match=r"acceleration is a function of udot"):
        of(("acceleration", "hand"))
    with pytest.raises(ArgumentError, match=r"give a name of the motion"):
        of(("pose",))


def test_everything_differentiated_has_one_tolerance() -> None:
    """A gradient, a motion and an ensemble with sensitivities take the same steps."""
    model, q = arm(), {"shoulder": 0.3}
    motion = model.simulate(1.0, q=q, sensitivity="m")
    back = model.gradient(1.0, cd.cost(final="reach"), wrt="m", q=q)
    runs = model.ensemble(1.0, vary={"shoulder": [0.3, 0.4]}, sensitivity="m")
    assert motion.solver_info.settings == "rtol 1e-09, atol 1e-12"
    assert isinstance(back.motion, cd.Trajectory)
    np.testing.assert_array_equal(back.motion.x, motion.x)
    np.testing.assert_array_equal(runs.final[0], motion.x[-1])
    assert model.simulate(1.0, q=q).solver_info.settings == "rtol 1e-06, atol 1e-09"
    # a tolerance that is named counts
    loose = model.simulate(1.0, q=q, sensitivity="m", rtol=1e-6)
    assert loose.solver_info.settings == "rtol 1e-06, atol 1e-09"
