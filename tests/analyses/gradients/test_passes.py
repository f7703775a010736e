"""Gradients of motions over places where branches of a mechanism meet."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from cardan.errors import SolveError
from table import each

REFERENCES = Path(__file__).parents[2] / "references"
TIGHT = {"rtol": 1e-12, "atol": 1e-13}


def windows_scene() -> cd.Scene:
    """Three parallel cranks with two couplers: the IFToMM four-bars, one degree of freedom."""
    scene = cd.Scene("windows", gravity=(0, -9.81, 0))
    inertia = cd.inertia.rod(1.0, 1.0, axis="x")
    cranks = [scene.body(f"crank{k}", mass=1.0, com=(0.5, 0, 0), inertia=inertia) for k in range(3)]
    for k, crank in enumerate(cranks):
        scene.joint(f"A{k}", cd.Revolute("z"), scene.ground.at(k, 0, 0), crank)
    for k in range(2):
        coupler = scene.body(f"coupler{k}", mass=1.0, com=(0.5, 0, 0), inertia=inertia)
        scene.joint(f"B{k}", cd.Revolute("z"), cranks[k].at(1, 0, 0), coupler)
        scene.joint(f"C{k}", cd.Revolute("z"), coupler.at(1, 0, 0), cranks[k + 1].at(1, 0, 0))
    end = cranks[0].at(1, 0, 0).position()
    scene.output("x", end[0])
    scene.output("y", end[1])
    return scene


def windows() -> cd.CompiledModel:
    return cd.compile(windows_scene())


H = np.pi / 2
UP = {"q": {"A0": H, "A1": H, "A2": H, "B0": -H, "B1": -H}, "u": {"A0": -1.0}}


@each("method", ["DOP853", "RK45", "RK4", "Radau"])
def test_cranks_lie_down(method: str) -> None:
    """Links of the mechanism all lie on one line at t = 0.7 s, where it could fold."""
    known = json.loads((REFERENCES / "sens_fourbar_N2.json").read_text("utf-8"))["reference"]
    model, names = windows(), ("u0.A0", "gravity.y")
    how = {"step": 1e-3} if method == "RK4" else TIGHT
    motion = model.simulate(1.0, method=method, sensitivity=names, **UP, **how)
    assert motion.solver_info.statistics["passed"] == 1
    tolerance = 1e-9 if method != "RK4" else 1e-7
    for entry, output in enumerate("xy"):
        found = model.gradient(1.0, cd.cost(final=output), wrt=names, method=method, **UP, **how)
        expected = known["d_B0"][entry] * np.array([1, -1])
        slopes = [found.slope[name] for name in names]
        np.testing.assert_allclose(slopes, expected, atol=tolerance)
        assert found.value == pytest.approx(known["B0"][entry], abs=tolerance)
    for column, name in enumerate(names):
        expected = np.array(known["d_phi_phidot"])[:, column] * [1, -1][column]
        ours = motion.sensitivity[name][-1, [0, model.nq]]
        np.testing.assert_allclose(ours, expected, atol=tolerance)
        backward = model.gradient(1.0, cd.cost(final="A0"), wrt=name, method=method, **UP, **how)
        assert backward.slope[name] == pytest.approx(ours[0], rel=1e-12, abs=1e-12)


def test_running_costs_and_times_within() -> None:
    """Against the motion of one coordinate; sensitivities at times beside the place too."""
    times, k = np.linspace(0, 1.0, 41), (1.5 + 2) / (1 + 2)

    def rates(_: float, y: np.ndarray) -> list[float]:
        phi, w, a, b = y[:4]
        return [w, -k * 9.81 * np.cos(phi), b, k * 9.81 * np.sin(phi) * a, 2 * phi * a]

    exact = solve_ivp(rates, (0, 1), [H, -1, 0, 1, 0], t_eval=times, rtol=1e-13, atol=1e-14).y
    model = windows()
    found = model.gradient(1.0, cd.cost(running="A0^2"), wrt="u0.A0", **UP, **TIGHT)
    assert found.slope["u0.A0"] == pytest.approx(exact[4, -1], abs=1e-9)
    motion = model.simulate(1.0, sensitivity="u0.A0", **UP, **TIGHT)
    ours = motion.sensitivity.at(times)["u0.A0"]
    np.testing.assert_allclose(ours[:, 0], exact[2], atol=1e-7)
    np.testing.assert_allclose(ours[:, model.nq], exact[3], atol=1e-6)


@each("level", [0.3, 0.03, -0.2])
def test_runs_that_end_beside_the_place(level: float) -> None:
    """An end within the step over the place has no derivative; another one has the right one."""
    model, k = windows(), (1.5 + 2) / (1 + 2)

    def rates(_: float, y: np.ndarray) -> list[float]:
        return [y[1], -k * 9.81 * np.cos(y[0])]

    def time(speed: float) -> float:
        found = solve_ivp(
            rates, (0, 1), [H, speed], rtol=1e-13, atol=1e-14,
            events=lambda t, y: y[0] - level, method="DOP853",
        )  # fmt: skip
        return float(found.t_events[0][0])

    ends = {"events": {"level": ("A0", level)}, **UP, **TIGHT}
    if level == 0.03:
        with pytest.raises(SolveError, match="where branches meet, and an event lies in it"):
            model.gradient(1.0, cd.cost(final="t"), wrt="u0.A0", **ends)
        return
    found = model.gradient(1.0, cd.cost(final="t"), wrt="u0.A0", **ends)
    expected = (time(-0.999) - time(-1.001)) / 2e-3
    assert found.slope["u0.A0"] == pytest.approx(expected, rel=1e-5)
