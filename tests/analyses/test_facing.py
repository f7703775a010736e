"""Hinges that close a loop are not assembled with their axis turned round."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.mechanisms.mechanism import Mechanism
from cardan.analyses.mechanisms.position_solver import PositionSolver
from cardan.analyses.mechanisms.searches import search

AXIS = np.array([0.3, 1.0, 0.2])


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    """A crank, a coupler on a ball and a Hooke joint, and a rocker whose bearing is cut."""
    scene = cd.Scene("spatial", gravity=(0, 0, -9.81))
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, inertia=(0.1, 0.1, 0.1))
        for name in ("crank", "coupler", "rocker")
    )
    scene.joint("motor", cd.Revolute("z"), scene.ground, crank)
    scene.joint("ball", cd.Spherical(), crank.at(0.3, 0, 0), coupler)
    scene.joint("hooke", cd.Universal("x", "y"), coupler.at(0.9, 0, 0), rocker)
    bearing = cd.Revolute(tuple(AXIS))
    scene.joint("bearing", bearing, rocker.at(0, 0, 0.5), scene.ground.at(1, 0.1, 0.45), cut=True)
    return cd.compile(scene)


def cosine(model: cd.CompiledModel, q: np.ndarray) -> float:
    """Between the axis in the rocker and in the ground."""
    rocker = model.pose("rocker", q)[:3, :3]
    return float(AXIS @ rocker @ AXIS / (AXIS @ AXIS))


def turned_round(model: cd.CompiledModel) -> np.ndarray:
    """A position that only the closing conditions take for one."""
    m, rng = Mechanism(model), np.random.default_rng(2)
    for _ in range(40):
        q, _ = model.split(model.random_state(rng))
        end = PositionSolver(m).solve(q)
        if end.closed and cosine(model, end.q) < 0:
            return end.q
    raise AssertionError("no such position was found")


def test_turned_positions_are_told_apart(model: cd.CompiledModel) -> None:
    q = turned_round(model)
    assert np.abs(model.constraints(q)).max() < 1e-12
    np.testing.assert_allclose(model.assembly_signs(q), [-1.0], atol=1e-12)
    assert Mechanism(model).reversed_axis(q) == "bearing"
    good = model.assemble().q
    np.testing.assert_allclose(model.assembly_signs(good), [1.0], atol=1e-12)
    assert Mechanism(model).reversed_axis(good) == ""


def test_searches_do_not_end_there(model: cd.CompiledModel) -> None:
    start, _ = model.split(model.initial())
    found = search(Mechanism(model), [], start, 24, 0)
    met = [one.q for one in found if one.met]
    assert len(met) >= 4
    assert min(cosine(model, q) for q in met) == pytest.approx(1, abs=1e-11)
    assert any(one.reversed_axis == "bearing" and not one.met for one in found)


def test_a_start_that_is_turned_round_is_refused(model: cd.CompiledModel) -> None:
    q = turned_round(model)
    with pytest.raises(cd.ModelError, match=r"joint 'bearing' closes .* an axis turned round"):
        model.simulate(0.1, q=q)
    everything = dict(zip(model.coordinates, q.tolist(), strict=True))
    with pytest.raises(cd.ModelError, match=r"is out of reach|are inconsistent"):
        model.assemble(everything, starts=2)
