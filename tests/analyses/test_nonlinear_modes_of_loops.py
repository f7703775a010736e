"""Nonlinear modes of mechanisms with closed loops and of absolute coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipk

import cardan as cd
from cardan.errors import ModelError

G, LENGTH = 9.81, 1.0
Y = cd.Revolute("y")


def elliptic(angle: Any, frequency: float) -> Any:
    """Period of a pendulum that swings by an angle: 4 K(sin^2(angle / 2)) / frequency."""
    return 4 * ellipk(np.sin(np.abs(angle) / 2) ** 2) / frequency


def test_pendulum_of_absolute_coordinates() -> None:
    scene = cd.Scene("pendulum", gravity=(0, 0, -G))
    bob = scene.body("bob", mass=1.0, inertia=(0.1, 0.1, 0.1), com=(0, 0, -1))
    scene.joint("angle", Y, scene.ground, bob)
    model = cd.compile(scene, coordinates="absolute")
    path = model.continuation(energy=(0.0, 15.0), of="cycles", start=model.modes()[0])
    assert abs(path["angle"][-1]) > 2.0
    period = elliptic(path["angle"], np.sqrt(G / 1.1))
    np.testing.assert_allclose(path["period"], period, rtol=1e-12)
    np.testing.assert_allclose(path["energy"], G * (1 - np.cos(path["angle"])), rtol=1e-9)
    assert len(path[-1].multipliers) == 0


def parallelogram(bottom: float, **options: Any) -> cd.CompiledModel:
    """Two cranks and a bar; parallel where the ground between the cranks is as long as the bar."""
    scene = cd.Scene("parallelogram", gravity=(0, 0, -G))
    cranks = [
        scene.body(name, mass=0.5, com=(0, 0, -0.5), inertia=(0.05, 0.05, 0.05))
        for name in ("left", "right")
    ]
    bar = scene.body("bar", mass=2.0, com=(1, 0, 0), inertia=(0.3, 0.3, 0.3))
    scene.joint("left", Y, scene.ground, cranks[0])
    scene.joint("right", Y, scene.ground.at(bottom, 0, 0), cranks[1])
    scene.joint("top", Y, cranks[0].at(0, 0, -LENGTH), bar)
    scene.joint("end", Y, cranks[1].at(0, 0, -LENGTH), bar.at(2, 0, 0))
    return cd.compile(scene, **options)


@pytest.mark.parametrize(
    "options",
    [
        {"constraints": cd.constraints.Multipliers()},
        {"constraints": cd.constraints.Elimination()},
        pytest.param({"coordinates": "absolute"}, marks=pytest.mark.slow),
    ],
)
def test_parallelogram(options: Any) -> None:
    """The bar does not turn: the linkage is a pendulum."""
    model = parallelogram(2.0, **options)
    path = model.continuation(energy=(0.0, 15.0), of="cycles", start=model.modes()[0])
    inertia, pull = 2 * (0.05 + 0.5 * 0.25) + 2.0, G * (2 * 0.25 + 2.0)
    assert abs(path["left"][-1]) > 1.1
    period = elliptic(path["left"], np.sqrt(pull / inertia))
    np.testing.assert_allclose(path["period"], period, rtol=1e-11)
    np.testing.assert_allclose(path["energy"], pull * (1 - np.cos(path["left"])), rtol=1e-9)


def four_bar_by_hand(bottom: float, angle: float, other: float) -> float:
    """Period of a swing from rest at an angle of the left crank, by energy along the one freedom.

    Twice the integral of da sqrt(m(a) / (2 (E - V(a)))) up to where it turns back, next to another
    angle.
    """
    from scipy.integrate import quad
    from scipy.optimize import brentq

    def state(a: float) -> tuple[float, float, float, float]:
        """Potential, and rates of the right crank and the bar by that of the left one, and m."""
        tip = np.array([-np.sin(a), -np.cos(a)]) * LENGTH
        foot = np.array([bottom, 0.0])
        way = foot - tip
        far = float(np.hypot(*way))
        # the triangle of the bar, the right crank and the diagonal
        inner = np.arccos((far**2 + 4.0 - LENGTH**2) / (4.0 * far))
        turned = np.arctan2(way[1], way[0]) - inner
        joint = tip + 2.0 * np.array([np.cos(turned), np.sin(turned)])
        # rates: tip' + 2 turned' normal = right' times the normal of the right crank
        tip_rate = np.array([-np.cos(a), np.sin(a)]) * LENGTH
        normal = 2.0 * np.array([-np.sin(turned), np.cos(turned)])
        arm = joint - foot
        A = np.array([normal, [-arm[1], arm[0]]]).T * [1, -1]
        turn, right = np.linalg.solve(A, -tip_rate)
        center = tip + 0.5 * (joint - tip)
        center_rate = tip_rate + 0.5 * turn * normal
        inertia = (0.05 + 0.125) * (1 + right**2) + 2.0 * float(center_rate @ center_rate)
        inertia += 0.3 * turn**2
        height = 0.25 * tip[1] + 0.25 * joint[1] + 2.0 * center[1]
        return G * height, float(right), float(turn), inertia

    level = state(angle)[0]
    low = brentq(lambda a: state(a)[0] - level, other - 0.02, other + 0.02, xtol=1e-14)
    middle, half = 0.5 * (low + angle), 0.5 * abs(angle - low)

    def rate(s: float) -> float:
        """By the place middle + half sin(s): the root at both ends is taken out."""
        V, _, _, m = state(middle + half * np.sin(s))
        return float(np.sqrt(m / (2 * (level - V))) * half * np.cos(s))

    return 2 * quad(rate, -np.pi / 2, np.pi / 2, epsabs=1e-11, epsrel=1e-11, limit=200)[0]


def test_four_bar() -> None:
    """The bar turns; against the equation of its one freedom."""
    model = parallelogram(1.6)
    path = model.continuation(energy=(0.0, 6.0), of="cycles", start=model.modes()[0])
    for k in (len(path) // 2, -1):
        start = path["left"][k]
        ends = path["left.max"][k], path["left.min"][k]
        other = max(ends, key=lambda end: abs(end - start))
        assert path["period"][k] == pytest.approx(four_bar_by_hand(1.6, start, other), rel=1e-7)
    assert path["left.max"][-1] != pytest.approx(-path["left.min"][-1], rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("mode", [0, 1])
def test_double_pendulum(mode: int) -> None:
    """Absolute and joint coordinates have the same cycles and multipliers."""
    paths = []
    for coordinates in ("relative", "absolute"):
        scene = cd.Scene("double", gravity=(0, 0, -G))
        upper, lower = (
            scene.body(name, mass=mass, inertia=(0.1, 0.1, 0.1), com=(0, 0, -0.5))
            for name, mass in (("upper", 1.0), ("lower", 0.7))
        )
        scene.joint("first", Y, scene.ground, upper)
        scene.joint("second", Y, upper.at(0, 0, -1), lower)
        model = cd.compile(scene, coordinates=coordinates)
        paths.append(model.continuation(energy=(0.0, 6.0), of="cycles", start=model.modes()[mode]))
    tree, absolute = (path[-1] for path in paths)
    assert absolute.period == pytest.approx(tree.period, rel=1e-12)
    for name in ("first", "second"):
        assert absolute[name] == pytest.approx(tree[name], abs=1e-10)
    assert absolute.derivatives == tree.derivatives == "exact"
    np.testing.assert_allclose(absolute.multipliers, tree.multipliers, atol=1e-8)


def test_constraints_that_no_run_holds_are_refused() -> None:
    model = parallelogram(2.0, constraints=cd.constraints.Penalty())
    with pytest.raises(ModelError, match=r"Compile with constraints='multipliers'"):
        model.continuation(energy=(0.0, 1.0), of="cycles", start=model.modes()[0])


@pytest.mark.slow
def test_beam_between_fixed_pins() -> None:
    """It stretches as it bends: q'' + w^2 (q + q^3 / (4 r^2)) = 0 with the radius of gyration r.

    Source: S. Woinowsky-Krieger, Journal of Applied Mechanics 17 (1950), 35-36.
    """
    scene = cd.Scene("strut", gravity=(0, 0, 0))
    rubber = cd.material(E=1e6, nu=0.3, rho=1000)
    square = cd.section.rectangle(0.2, 0.2)
    bar = scene.beam("bar", (0, 0, 0), (1, 0, 0), square, rubber, elements=2)
    scene.joint("left", Y, scene.ground, bar.start)
    scene.joint("right", Y, scene.ground.at(1, 0, 0), bar.end)
    model = cd.compile(scene)
    modes = model.modes()
    path = model.continuation(energy=(0.0, 2.0), of="cycles", start=modes[0])
    bend = (np.abs(path["bar.node1.pz"]) / (2 * 0.2 / np.sqrt(12))) ** 2
    W = np.sqrt(1 + bend)
    ratio = 4 * ellipk(bend / (2 * W**2)) / W / (2 * np.pi)
    np.testing.assert_allclose(path["period"] * modes.frequencies[0], ratio, rtol=1e-3)
    assert ratio[-1] < 0.99
    straight = model.energy(modes.at.q, modes.at.u).potential
    for k in (0, -1):
        energy = model.energy(path[k].q, path[k].u)
        over = energy.kinetic + energy.potential - straight
        assert over == pytest.approx(path["energy"][k], rel=1e-9)
    # what keeps its energy has multipliers in reciprocal pairs (H. Poincare, 1892)
    assert path[-1].derivatives == "exact"
    multipliers = path[-1].multipliers
    assert np.prod(multipliers) == pytest.approx(1.0, abs=1e-8)
    np.testing.assert_allclose(np.poly(multipliers), np.poly(1 / multipliers), atol=1e-8)
