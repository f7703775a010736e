"""Reactions that redundant constraints leave open are those of least norm.

Against the least squares of Newton's and Euler's equations of the body, with moments over the
largest distance between two of the joints.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np
import pytest

import cardan as cd

G = 9.81
HINGES = np.array([[0.0, 0.0, 0.2], [0.0, 0.0, 1.8]])
LEGS = np.array([[0.5, 0.3, 0.0], [-0.5, 0.3, 0.0], [-0.5, -0.3, 0.0], [0.5, -0.3, 0.0]])
MOMENTS_ACROSS, FORCES, UP = [0, 1], [3, 4, 5], [5]


def door(scene: cd.Scene, swapped: bool = False) -> None:
    """A door on two hinges."""
    body = scene.body("door", mass=20.0, com=(0.4, 0, 1.0), inertia=(8, 10, 3))
    for name, place, more in zip(("low", "high"), HINGES, ({}, {"cut": True}), strict=True):
        frames = scene.ground.at(*place), body.at(*place)
        scene.joint(name, cd.Revolute("z"), *(frames[::-1] if swapped else frames), **more)


def table(scene: cd.Scene) -> None:
    """A table that slides on four legs."""
    top = scene.body("top", mass=12.0, com=(0.1, 0.05, 0.7), inertia=(1, 1, 2))
    for k, place in enumerate(LEGS):
        feet = scene.ground.at(*place), top.at(*place)
        scene.joint(f"leg{k}", cd.Planar("z"), *feet, **({"cut": True} if k else {}))


def beside(scene: cd.Scene) -> None:
    """A beam that has nothing to do with the rest."""
    section, steel = cd.section.tube(0.05, 0.04), cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", scene.ground.at(0, 3, 0), (1.0, 3.0, 0), section, steel, elements=1)


def least(places: np.ndarray, components: list[int], total: np.ndarray) -> np.ndarray:
    """Wrenches (k, 6) at places that add up to one about the origin."""
    between = np.linalg.norm(places[:, None] - places[None], axis=-1).max()
    columns, units = [], []
    for place in places:
        for component in components:
            unit = np.zeros(6)
            unit[component] = between if component < 3 else 1.0
            columns.append(np.r_[unit[:3] + np.cross(place, unit[3:]), unit[3:]])
            units.append(unit[component])
    shares = np.linalg.pinv(np.array(columns).T) @ total * units
    wrenches = np.zeros((len(places), 6))
    wrenches[:, components] = shares.reshape(len(places), -1)
    return wrenches


def wrench(mass: float, com: np.ndarray, acceleration: np.ndarray) -> np.ndarray:
    """Moment about the origin and force that a body needs whose axis of inertia it turns about."""
    force = mass * (acceleration + np.array([0, 0, G]))
    return np.r_[np.cross(com, force), force]


def compiled(build: Callable[[cd.Scene], None], kind: str) -> cd.CompiledModel:
    """A scene in joint coordinates, in absolute ones, or beside a beam."""
    scene = cd.Scene("redundant", gravity=(0, 0, -G))
    build(scene)
    if kind == "elements":
        beside(scene)
        return cd.compile(scene)
    return cd.compile(scene, coordinates=kind)


KINDS = pytest.mark.parametrize("kind", ["relative", "absolute", "elements"])


@KINDS
@pytest.mark.parametrize("swapped", [False, True])
def test_a_door_on_two_hinges(kind: str, swapped: bool) -> None:
    model = compiled(lambda scene: door(scene, swapped), kind)
    motion = model.simulate(1e-3, u={"low": 2.0}, rtol=1e-8)
    expected = least(
        HINGES,
        MOMENTS_ACROSS + FORCES,
        wrench(20.0, np.array([0.4, 0, 1.0]), np.array([-4 * 0.4, 0, 0])),
    )
    # on the bodies that were declared as children, which is the ground where they are swapped
    sign = -1.0 if swapped else 1.0
    with pytest.warns(cd.SolveWarning, match="least norm"):
        low = motion.reaction("low")[0]
    assert sign * low == pytest.approx(expected[0], abs=1e-6)
    assert sign * motion.reaction("high")[0] == pytest.approx(expected[1], abs=1e-6)
    # each of them bears half of the weight
    assert motion["high.force.z"][0] == pytest.approx(sign * 10.0 * G, abs=1e-6)
    assert model.redundancy().redundant == 5


@KINDS
def test_a_table_on_four_legs(kind: str) -> None:
    model = compiled(table, kind)
    motion = model.simulate(1e-3)
    expected = least(
        LEGS, MOMENTS_ACROSS + UP, wrench(12.0, np.array([0.1, 0.05, 0.7]), np.zeros(3))
    )
    with pytest.warns(cd.SolveWarning, match="least norm"):
        reactions = [motion.reaction(f"leg{k}")[-1] for k in range(4)]
    assert np.array(reactions) == pytest.approx(expected, abs=1e-6)
    assert sum(reactions)[5] == pytest.approx(12.0 * G)


def parallelogram(scene: cd.Scene) -> None:
    """Two cranks and a rod on balls between them: nothing is redundant, unless all lie in line."""
    crank, rod, rocker = (
        scene.body(name, mass=1.0, com=(x / 2, 0, 0), inertia=(0.1, 0.3, 0.3))
        for name, x in (("crank", 1.0), ("rod", 2.0), ("rocker", 1.0))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Spherical(), crank.at(1, 0, 0), rod)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(2, 0, 0), rocker)
    scene.joint("C", cd.Spherical(), rod.at(2, 0, 0), rocker.at(1, 0, 0), cut=True)
    scene.force("push", cd.Force(crank, (8, 0, 0)))


@KINDS
def test_a_state_where_constraints_lose_rank_comes_later(kind: str) -> None:
    """In line a force P along the crank takes two ways: with A + P = B = C = D the sum of squares
    is least for B = P/4."""
    model = compiled(parallelogram, kind)
    still = np.zeros(model.nu)
    regular = model.simulate(1e-4, q={"A": 0.7, "D": 0.7}, u={"A": 0.0}).q[0]
    line = model.simulate(1e-9, u=still).q[0]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for joint in "ABCD":
            model.reaction(joint, regular, still)
    with pytest.warns(cd.SolveWarning, match="at state 1, where constraints lose rank") as said:
        found = [model.reaction(joint, np.array([regular, line]), still)[1, 3] for joint in "ABCD"]
    assert len(said) == 1
    # the rod pushes the rocker along x, which the ground holds
    assert found == pytest.approx([-6.0, 2.0, 2.0, -2.0], abs=1e-9)


@KINDS
def test_many_speeds_at_one_position(kind: str) -> None:
    """Every row is of least norm, where only speeds or times have leading axes too."""
    model = compiled(door, kind)
    q, u = model.split(model.simulate(1e-3, u={"low": 1.0}).x[0])
    speeds = np.arange(3.0)[:, None] * u
    with pytest.warns(cd.SolveWarning, match="least norm"):
        found = model.reaction("low", q, speeds)
    for row, omega in zip(found, range(3), strict=True):
        total = wrench(20.0, np.array([0.4, 0, 1.0]), np.array([-(omega**2) * 0.4, 0, 0]))
        assert row == pytest.approx(least(HINGES, MOMENTS_ACROSS + FORCES, total)[0], abs=1e-6)
    assert model.reaction("low", q, u, t=[0.0, 1.0]) == pytest.approx(found[[1, 1]], abs=1e-9)
    with pytest.raises(cd.ArgumentError, match="leading axes do not broadcast together"):
        model.reaction("low", q, speeds, t=[0.0, 1.0])
    # there are no inputs
    assert model.reaction("low", q, u, r=[]) == pytest.approx(found[1], abs=1e-9)


@pytest.mark.parametrize("together", [False, True])
def test_parameters_of_a_call(together: bool) -> None:
    """Hinges at a distance that the call gives."""
    scene = cd.Scene("redundant", gravity=(0, 0, -G))
    high = scene.parameter("high", 1.8, unit="m")
    body = scene.body("door", mass=20.0, com=(0.4, 0, 1.0), inertia=(8, 10, 3))
    scene.joint("low", cd.Revolute("z"), scene.ground.at(*HINGES[0]), body.at(*HINGES[0]))
    ends = scene.ground.at(0, 0, high), body.at(0, 0, high)
    scene.joint("high", cd.Revolute("z"), *ends, cut=True)
    model, heights = cd.compile(scene), np.array([1.0, 3.0])
    values = [heights] if together else list(heights)
    with pytest.warns(cd.SolveWarning, match="least norm"):
        found = [model.reaction("low", [0.0], [0.0], parameters={"high": x}) for x in values]
    for row, height in zip(np.reshape(found, (-1, 6)), heights, strict=True):
        places = np.array([HINGES[0], [0, 0, height]])
        total = wrench(20.0, np.array([0.4, 0, 1.0]), np.zeros(3))
        expected = least(places, MOMENTS_ACROSS + FORCES, total)[0]
        assert row == pytest.approx(expected, abs=1e-6)
