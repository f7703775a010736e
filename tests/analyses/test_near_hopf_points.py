"""Hopf points next to one another, all within a step of a path."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cycle_scenes import POINT

Law = Callable[[Any], Any]
FREQUENCIES = (1.0, 1.3, 1.7)


def oscillators(*growth: Law) -> cd.CompiledModel:
    """x'' - 2 g(P) x' + w^2 x = 0 for each of the growth rates g."""
    scene = cd.Scene("oscillators", gravity=(0, 0, 0))
    P = scene.parameter("P", 0.0)
    for k, (rate, frequency) in enumerate(zip(growth, FREQUENCIES, strict=False)):
        name = f"x{k}"
        scene.joint(name, cd.Prismatic("x"), scene.ground, scene.body(f"body_{k}", **POINT))
        force = 2 * rate(P) * scene.u(name) - frequency**2 * scene.q(name)
        scene.force(f"force_{k}", cd.JointForce(name, force))
    return cd.compile(scene)


def loads(model: cd.CompiledModel) -> tuple[list[float], list[float]]:
    """Loads of the Hopf points of a path from 0 to 1, and their frequencies."""
    path = model.continuation(P=(0, 1))
    assert all(point.kind in ("Hopf point", "event") for point in path.points)
    points = [point for point in path.points if point.kind == "Hopf point"]
    assert all(point.accurate for point in points)
    return [point["P"] for point in points], [point.frequency for point in points]


@pytest.mark.parametrize("gap", [1e-1, 1e-3, 1e-5])
def test_two_begin(gap: float) -> None:
    """The count of unstable directions rises by 4 within a step."""
    where, turns = loads(oscillators(lambda P: P - 0.5, lambda P: P - 0.5 - gap))
    np.testing.assert_allclose(where, [0.5, 0.5 + gap], atol=1e-9)
    np.testing.assert_allclose(turns, FREQUENCIES[:2], rtol=1e-6)


def test_three_begin() -> None:
    laws = [lambda P, at=at: P - at for at in (0.5, 0.501, 0.5021)]
    where, turns = loads(oscillators(*laws))
    np.testing.assert_allclose(where, [0.5, 0.501, 0.5021], atol=1e-9)
    np.testing.assert_allclose(turns, FREQUENCIES, rtol=1e-6)


@pytest.mark.parametrize("half", [0.1, 0.02, 0.005])
@pytest.mark.parametrize("side", [1, -1])
def test_one_begins_and_ends(half: float, side: int) -> None:
    """An oscillation that grows, or decays, between two loads."""
    scale = 0.1
    where, _ = loads(oscillators(lambda P: side * scale * (half**2 - (P - 0.47) ** 2)))
    np.testing.assert_allclose(where, [0.47 - half, 0.47 + half], atol=1e-9)


def test_together() -> None:
    """Two that begin at one load are one point."""
    where, _ = loads(oscillators(lambda P: P - 0.5, lambda P: P - 0.5))
    np.testing.assert_allclose(where, [0.5], atol=1e-9)
