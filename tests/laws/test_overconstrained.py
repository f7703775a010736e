"""Mechanisms with more constraints than they need move as their closed forms say."""

from __future__ import annotations

import itertools
from functools import cache, partial
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import cardan as cd
from mechanisms.overconstrained import (
    BENNETT,
    FIVE,
    bennett,
    bennett_angles,
    closure,
    five_angles,
    five_revolutes,
)
from table import each

KINDS = ("relative", "absolute")
TIGHT = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
WAYS = list(itertools.product(("ground first", "door first"), repeat=2))
GRAVITY = (1.0, -2.0, -9.81)  # with a part across the hinges: the door swings


def door(*ways: str) -> cd.Scene:
    """A door on one coaxial hinge for each way in which one is declared."""
    scene = cd.Scene("door", gravity=GRAVITY)
    leaf = scene.body("door", mass=2.0, com=(0.4, 0, 0), inertia=(0.1, 0.1, 0.15))
    for k, way in enumerate(ways):
        ends = scene.ground.at(0, 0, k), leaf.at(0, 0, k)
        scene.joint(f"h{k}", cd.Revolute("z"), *(ends if way == "ground first" else ends[::-1]))
    return scene


def swing(t: float, x: np.ndarray) -> list[float]:
    """Of a door on one hinge: its moment of inertia is 0.15 + 2 0.4^2."""
    pull = GRAVITY[1] * np.cos(x[0]) - GRAVITY[0] * np.sin(x[0])
    return [x[1], 2.0 * 0.4 * pull / (0.15 + 2.0 * 0.4**2)]


@each("coordinates", KINDS)
@each("ways", WAYS)
def test_a_door_on_two_hinges_moves_as_on_one(ways: tuple[str, str], coordinates: str) -> None:
    """Whichever side either hinge is declared from; angles count from its first side."""
    times = np.linspace(0.0, 1.0, 21)
    exact = solve_ivp(swing, (0, 1), [0.3, 1.0], "DOP853", times, rtol=1e-13, atol=1e-15).y
    sign = 1.0 if ways[0] == "ground first" else -1.0
    start = {"q": {"h0": 0.3 * sign}, "u": {"h0": sign}}
    found = []
    for some in (ways[:1], ways):
        model = cd.compile(cd.derive(door(*some), coordinates=coordinates))
        motion = model.simulate(times, **start, **TIGHT, check=True)
        assert motion.success
        found.append(sign * np.array([motion["h0"], motion["h0.u"]]))
    errors = [float(np.abs(x - exact).max()) for x in found]
    print(ways, coordinates, "one hinge, two hinges:", *(f"{error:.1e}" for error in errors))
    assert max(errors) < 1e-9


LINKAGES = {
    "bennett": (BENNETT, bennett, bennett_angles),
    **{
        name: (FIVE[name], partial(five_revolutes, name), partial(five_angles, name))
        for name in FIVE
    },
}
TURNS = np.linspace(0.0, 2.0, 201)


@cache
def linkage(name: str, coordinates: str, treatment: str = "auto") -> cd.CompiledModel:
    scene = LINKAGES[name][1]()
    return cd.compile(cd.derive(scene, coordinates=coordinates, constraints=treatment))


def turned(
    name: str, coordinates: str, times: Any = TURNS, treatment: str = "auto", **how: Any
) -> cd.Trajectory:
    """A run of a linkage from 0.4 rad with 8 rad/s."""
    model = linkage(name, coordinates, treatment)
    start = {j: x for j, x in LINKAGES[name][2](0.4).items() if j in model.coordinates}
    return model.simulate(times, q=start, u={"j0": 8.0}, **how)


def apart(name: str, motion: cd.Trajectory) -> float:
    """The largest angle between a joint and its closed form, of the first joint of the motion."""
    exact = [LINKAGES[name][2](x) for x in motion["j0"]]
    errors = [
        motion[joint] - [angles[joint] for angles in exact]
        for joint in exact[0]
        if joint in motion.model.coordinates
    ]
    return float(np.abs(np.angle(np.exp(1j * np.array(errors)))).max())


@cache
def reference(name: str) -> np.ndarray:
    """The angle of the first joint, which energy alone tells beside the closed form."""
    return np.asarray(turned(name, "relative", **TIGHT)["j0"])


@pytest.mark.parametrize("name", LINKAGES)
def test_closed_forms_close_their_linkages(name: str) -> None:
    sides, _, angles = LINKAGES[name]
    gaps = [np.abs(closure(sides, angles(x).values())).max() for x in np.linspace(-10, 10, 201)]
    assert max(gaps) < 1e-14


@pytest.mark.parametrize(
    ("coordinates", "method"),
    [("relative", "DOP853"), ("relative", "Radau"), ("absolute", "DOP853")],
)
def test_bennett_turns_as_its_closed_form(coordinates: str, method: str) -> None:
    motion = turned("bennett", coordinates, method=method, rtol=1e-11, atol=1e-13, check=True)
    off = float(np.abs(motion["j0"] - reference("bennett")).max())
    error, turns = apart("bennett", motion), motion["j0"].max() / (2 * np.pi)
    print(f"{coordinates} {method}: {turns:.2f} turns, {error:.1e} of the form, {off:.1e} in time")
    assert motion.success
    assert turns > 1
    assert error < 1e-9
    assert off < 1e-9


@pytest.mark.parametrize("coordinates", KINDS)
def test_bennett_by_generalized_alpha(coordinates: str) -> None:
    times, how = TURNS[:101], {"rtol": 1e-11, "atol": 1e-13}
    motion = turned("bennett", coordinates, times, method="GeneralizedAlpha", **how)
    assert motion.success
    off = float(np.abs(motion["j0"] - reference("bennett")[:101]).max())
    print(f"{coordinates}: {apart('bennett', motion):.1e} of the closed form, {off:.1e} in time")
    assert apart("bennett", motion) < 1e-9
    assert off < 1e-6


@pytest.mark.parametrize("coordinates", KINDS)
def test_generalized_alpha_is_of_order_2(coordinates: str) -> None:
    """Also at steps so long that some begin anew, far from where rows are redundant."""
    times, steps, off = TURNS[:101], (5e-3, 4e-3, 2e-3, 1e-3), []
    for step in steps:
        method = cd.GeneralizedAlpha(0.8)
        motion = turned("bennett", coordinates, times, method=method, step=step)
        assert motion.success
        off.append(float(np.abs(motion["j0"] - reference("bennett")[:101]).max()))
    slopes = np.diff(np.log(off)) / np.diff(np.log(steps))
    print(coordinates, "errors", *(f"{x:.2e}" for x in off), "slopes", slopes)
    np.testing.assert_allclose(slopes, 2.0, atol=0.05)


# of methods at a step of 1e-3: errors in time of order 2 and 4, by the reference ten times smaller
AT_STEPS = {"EnergyMidpoint": 2e-5, "RK4": 1e-5}


@pytest.mark.parametrize("treatment", ["multipliers", "null_space", "elimination", "baumgarte"])
def test_treatments_of_bennett(treatment: str) -> None:
    times, exact = TURNS[:101], reference("bennett")[:101]
    for method in ("DOP853", *AT_STEPS):
        how = {"step": 1e-3} if method in AT_STEPS else {"rtol": 1e-11, "atol": 1e-13}
        motion = turned("bennett", "relative", times, treatment, method=method, **how)
        off, drift = (
            float(np.abs(x).max()) for x in (motion["j0"] - exact, motion.energy_residual)
        )
        error = apart("bennett", motion)
        print(f"{treatment} {method}: {error:.1e} of the form, {off:.1e} in time, {drift:.1e} J")
        assert motion.success
        assert error < 1e-9
        assert off < AT_STEPS.get(method, 1e-9)
        assert method != "EnergyMidpoint" or drift < 1e-12 * motion.energy.kinetic.max()


@pytest.mark.parametrize(("name", "coordinates"), list(itertools.product(FIVE, KINDS)))
def test_linkages_of_five_turn_as_their_closed_forms(name: str, coordinates: str) -> None:
    motion = turned(name, coordinates, method="DOP853", rtol=1e-11, atol=1e-13)
    error, ends = apart(name, motion), (motion["j0"].min(), motion["j0"].max())
    print(f"{name} {coordinates}: j0 in {ends}, {error:.1e} of the closed form")
    assert motion.success
    assert ends[1] - ends[0] > 4
    assert error < 1e-9


@each("rtol", [1e-4, 1e-8, 1e-11])
@each("name", LINKAGES)
def test_redundant_rows_cost_no_steps(name: str, rtol: float) -> None:
    """Stages of steps are open, and rows follow from others where they are closed: 2000 steps, or
    another motion, where 40 do it, unless rank is told by what gaps explain."""
    motion = turned(name, "absolute", method="DOP853", rtol=rtol, atol=rtol / 100)
    steps = motion.solver_info.statistics["steps"]
    off = float(np.abs(motion["j0"] - reference(name)).max())
    print(f"{name} {rtol:.0e}: {steps} steps, {off:.1e} in time")
    assert motion.success
    assert off < max(1e3 * rtol, 1e-9)
    assert steps < 1500 * (rtol / 1e-11) ** -0.1


@pytest.mark.parametrize(("name", "coordinates"), list(itertools.product(FIVE, KINDS)))
def test_linkages_of_five_over_part_of_a_turn(name: str, coordinates: str) -> None:
    motion = turned(name, coordinates, TURNS[:41], method="DOP853", rtol=1e-11, atol=1e-13)
    print(f"{name} {coordinates}: to {motion['j0'][-1]} rad, {apart(name, motion):.1e}")
    assert motion.success
    assert motion["j0"][-1] > 1.5
    assert apart(name, motion) < 1e-9
