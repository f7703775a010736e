"""Driven mechanisms: against closed forms, along one branch, up to where they cannot follow."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_planar import (
    FOUR_BAR,
    four_bar,
    four_bar_angles,
    parallelogram,
    slider_crank,
    slider_crank_coordinates,
)


@pytest.fixture(scope="module")
def bars() -> cd.CompiledModel:
    return cd.compile(four_bar())


@pytest.fixture(scope="module")
def crank() -> cd.CompiledModel:
    return cd.compile(slider_crank())


def test_whole_turns_stay_on_their_branch(bars: cd.CompiledModel) -> None:
    angles = np.linspace(0, 4 * math.pi, 145)
    for side, sign in ((1, "+"), (-1, "-")):
        found = bars.sweep("A", angles, branch={"D": sign})
        assert found.success
        np.testing.assert_array_equal(found["A"], angles)
        expected = [four_bar_angles(angle, side) for angle in angles]
        for name in "BD":
            away = found[name] - [angles[name] for angles in expected]
            np.testing.assert_allclose(np.remainder(away + 1, 2 * math.pi), 1, rtol=0, atol=1e-12)
            # no jumps: a continuous curve
            assert np.abs(np.diff(found[name])).max() < 0.3
        np.testing.assert_allclose(found["A.u"], 1)


def test_rates_are_derivatives(crank: cd.CompiledModel) -> None:
    theta, rate, acceleration = np.linspace(0.1, 6, 31), 3.0, -2.0
    start = slider_crank_coordinates(0.1)
    start.pop("C")
    found = crank.sweep("A", theta, rate=rate, acceleration=acceleration, start=start)
    sine = -0.1 * np.sin(theta) / 0.3
    place = 0.1 * np.cos(theta) + 0.3 * np.sqrt(1 - sine**2)
    np.testing.assert_allclose(found["guide"], place, rtol=0, atol=1e-14)
    h = 1e-4

    def guide(angle: np.ndarray) -> np.ndarray:
        return 0.1 * np.cos(angle) + np.sqrt(0.09 - 0.01 * np.sin(angle) ** 2)

    slope = (guide(theta + h) - guide(theta - h)) / (2 * h)
    bend = (guide(theta + h) + guide(theta - h) - 2 * guide(theta)) / h**2
    np.testing.assert_allclose(found["guide.u"], slope * rate, rtol=0, atol=1e-8)
    expected = bend * rate**2 + slope * acceleration
    # the second difference is right to eps / h^2
    np.testing.assert_allclose(found["guide.udot"], expected, rtol=0, atol=1e-6)


def test_a_dead_point_stops_with_its_place(crank: cd.CompiledModel) -> None:
    values = np.linspace(0.305, 0.455, 16)
    start = {"A": 1.0, "B": -1.3, "guide": 0.305}
    said = r"stops at 'guide' = 0\.4 \(of 0\.405\): a dead point, 'guide' cannot go further"
    with pytest.warns(cd.SolveWarning, match=said):
        found = crank.sweep("guide", values, start=start)
    assert found.status == "singular"
    assert found.values[-1] == pytest.approx(0.395)
    assert len(found) == 10
    with pytest.raises(cd.SolveError, match="dead point"):
        crank.sweep("guide", values, start=start, check=True)


def test_branches_that_meet_stop_the_sweep() -> None:
    model = cd.compile(parallelogram(1))
    start = {"A0": 1.0, "A1": 1.0, "B0": -1.0}
    start = {name: value for name, value in start.items() if name in model.coordinates}
    with pytest.warns(cd.SolveWarning, match="branches of the mechanism meet"):
        found = model.sweep("A0", np.linspace(1, -1, 21), start=start)
    # up to there the cranks are parallel
    np.testing.assert_allclose(found["A1"], found["A0"], rtol=0, atol=1e-9)
    assert 0 <= found.values[-1] <= 0.1 + 1e-12


def test_several_drivers_go_together() -> None:
    """Deployment: two hinges of an open chain, one turning half as fast as the other."""
    scene = cd.Scene("panels", gravity=(0, 0, 0))
    a = scene.body("a", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    b = scene.body("b", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    scene.joint("root", cd.Revolute("z"), scene.ground, a)
    scene.joint("hinge", cd.Revolute("z"), a.at(1, 0, 0), b)
    model = cd.compile(scene)
    angles = np.linspace(0, 1, 11)
    found = model.sweep({"root": angles, "hinge": -2 * angles}, rate=0.5)
    np.testing.assert_allclose(found["hinge"], -2 * found["root"], rtol=0, atol=1e-15)
    np.testing.assert_allclose(found["hinge.u"], -1.0)
    tip = found.pose("b")[:, :3, 3]
    np.testing.assert_allclose(tip[:, 1], np.sin(angles), rtol=0, atol=1e-14)


def test_an_input_drives() -> None:
    model = cd.compile(input_four_bar())
    angles = np.linspace(0.5, 3.0, 11)
    found = model.sweep("angle", angles, rate=4.0, branch={"D": "+"})
    expected = [four_bar_angles(angle)["D"] for angle in angles]
    np.testing.assert_allclose(found["D"], expected, rtol=0, atol=1e-12)
    by_crank = cd.compile(four_bar()).sweep("A", angles, rate=4.0, branch={"D": "+"})
    np.testing.assert_allclose(found["D.u"], by_crank["D.u"], rtol=0, atol=1e-11)
    np.testing.assert_allclose(found["D.udot"], by_crank["D.udot"], rtol=0, atol=1e-9)


def input_four_bar() -> cd.Scene:
    """The four-bar with its crank moved by an input."""
    scene = cd.Scene("input", gravity=(0, 0, 0))
    links = []
    for name in ("crank", "coupler", "rocker"):
        length = FOUR_BAR[name]
        inertia = cd.inertia.box(length, length, 0.02, 0.01)
        links.append(scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=inertia))
    a, b, c = links
    turn, ground = cd.Revolute("z"), scene.ground
    scene.joint("A", turn, ground, a, prescribed=scene.input("angle"))
    scene.joint("B", turn, a.at(FOUR_BAR["crank"], 0, 0), b)
    scene.joint("D", turn, ground.at(FOUR_BAR["ground"], 0, 0), c)
    scene.joint("C", turn, b.at(FOUR_BAR["coupler"], 0, 0), c.at(FOUR_BAR["rocker"], 0, 0))
    return scene


def test_pictures_and_words(bars: cd.CompiledModel, tmp_path: Path) -> None:
    found = bars.sweep("A", np.linspace(0, 6, 13), branch={"D": "+"})
    assert "0 to 6: reached all values" in repr(found)
    assert "smallest singular value of the driven constraints" in repr(found)
    figure = found.plot(tmp_path / "sweep.png", names=["D", "D.u"])
    assert (tmp_path / "sweep.png").stat().st_size > 1000
    assert len(figure.axes) == 2


def test_mistakes(bars: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match="no coordinate 'E'"):
        bars.sweep("E", [0.0, 1.0])
    with pytest.raises(cd.ArgumentError, match="driver= is a coordinate and values= its values"):
        bars.sweep("A")
    with pytest.raises(cd.ArgumentError, match=r"not \(n,\)"):
        bars.sweep("A", 1.0)
    with pytest.raises(cd.SolveError, match="must be finite"):
        bars.sweep("A", [0.0, math.nan])
    with pytest.raises(cd.ArgumentError, match="same number of values"):
        bars.sweep({"A": [0.0, 1.0], "D": [1.0]})
    with pytest.raises(cd.ModelError, match="no such history"):
        bars.sweep("A", [0.0, 0.1])["Q"]
    free = cd.compile(two_hinges())
    with pytest.raises(cd.ModelError, match="2 degrees of freedom, 'root' drives 1: give"):
        free.sweep("root", [0.0, 1.0])
    held = free.sweep("root", [0.0, 1.0], locked={"hinge": 0.3})
    np.testing.assert_array_equal(held["hinge"], 0.3)
    for given, said in (
        ("hing", r"values they keep, such as \{'root': 0.2\}.* Did you mean 'hinge'"),
        ("hinge", r"values they keep, such as \{'hinge': 0.2\}"),
        (["hinge"], "values they keep"),
        (3, "locked=3: give coordinates or frames"),
    ):
        with pytest.raises(cd.ModelError, match=said):
            free.sweep("root", [0.0, 1.0], locked=given)
        with pytest.raises(cd.ModelError, match=said):
            free.singular_positions("root", (0.0, 1.0), locked=given)


def two_hinges() -> cd.Scene:
    """An open chain of two links."""
    scene = cd.Scene("two_hinges", gravity=(0, 0, 0))
    a = scene.body("a", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    b = scene.body("b", mass=1.0, com=(0.5, 0, 0), inertia=(0.01, 0.1, 0.1))
    scene.joint("root", cd.Revolute("z"), scene.ground, a)
    scene.joint("hinge", cd.Revolute("z"), a.at(1, 0, 0), b)
    return scene
