"""Linear models derived from the start against the differentiated nonlinear equations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.linearized import differentiated, from_start
from cardan.equations.linearized.all_coordinates import DYNAMIC
from cardan.equations.linearized.reference import Reference
from laws.cases import slots
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

SEED = 4
TREES = [name for name in ZOO if name not in ("backwards_guided",)]


def reference(equations: Any, q: dict[str, Any], u: dict[str, Any]) -> Reference:
    """A motion that accelerates, with internal states away from 0."""
    rng, entries = np.random.default_rng(SEED), equations.blocks
    udot: Any = "free"
    if not equations.system.closed:
        udot = dict(zip(entries["udot"].entries, rng.normal(size=len(entries["u"])), strict=True))
    z = dict(zip(entries["z"].entries, rng.uniform(0.1, 0.5, len(entries["z"])), strict=True))
    return Reference(
        equations, q=q, u=u, udot=udot, z=z, r={}, s={}, t=0.3, values={}, independent=None
    )


def judge(equations: Any, q: dict[str, Any], u: dict[str, Any]) -> None:
    """Every matrix of all increments, entry by entry."""
    one, other = reference(equations, q, u), reference(equations, q, u)
    ours, theirs = from_start.full_matrices(one), differentiated.full_matrices(other)
    for name in (*DYNAMIC, "by_z", "by_r"):
        found = one.number(getattr(ours, name))
        expected = other.number(getattr(theirs, name))
        size = max(1.0, float(np.abs(expected).max(initial=0.0)))
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * size, err_msg=name)


def moving(equations: Any, q: dict[str, Any]) -> dict[str, float]:
    """Random speeds that the constraints allow."""
    at = Reference(
        equations, q=q, u={}, udot={}, z={}, r={}, s={}, t=0.3, values={}, independent=None
    )
    u = at.number(at.W) @ np.random.default_rng(SEED).normal(size=len(at.w))
    return dict(zip(equations.speeds, u.tolist(), strict=True))


@pytest.mark.parametrize("name", some(TREES, 3))
def test_trees(name: str) -> None:
    equations = cd.derive(ZOO[name].build(), method="composite")
    q, u = slots(equations.system, ZOO[name].states[0])
    if not u.any():
        u = np.random.default_rng(SEED).uniform(0.2, 0.7, len(u))
    judge(
        equations,
        dict(zip(equations.coordinates, q.tolist(), strict=True)),
        dict(zip(equations.speeds, u.tolist(), strict=True)),
    )


@pytest.mark.parametrize("name", some(CLOSED, 3))
def test_circuits(name: str) -> None:
    equations = cd.derive(CLOSED[name].build())
    joints = {joint.name for joint in equations.system.joints if joint.q >= 0}
    q, _ = slots(equations.system, CLOSED[name].state(0.1, 1.0, joints))
    place = dict(zip(equations.coordinates, q.tolist(), strict=True))
    judge(equations, place, moving(equations, place))


@pytest.mark.parametrize("name", some(ROLLING, 2))
def test_rolling(name: str) -> None:
    equations = cd.derive(ROLLING[name]())
    place = {"rolls.lean": 0.2, "rolls.yaw": 0.4, "rolls.spin": 0.7}
    judge(equations, place, moving(equations, place))


def test_circuits_in_closed_form() -> None:
    # the joints of a dyad have shares in other speeds, which change with the position
    equations = cd.derive(CLOSED["slider_crank"].build(), constraints="closed_form")
    assert equations.system.closures
    judge(equations, {equations.coordinates[0]: 0.7}, {equations.speeds[0]: 1.3})


def test_chosen_speeds() -> None:
    scene = ZOO["double_pendulum"].build()
    first, second = (joint.name for joint in cd.derive(scene).system.joints)
    speeds = {"one": scene.u(first), "both": scene.u(first) + scene.u(second)}
    equations = cd.derive(scene, speeds=speeds)
    judge(equations, {first: 0.4, second: 0.9}, {"one": 0.7, "both": -0.3})
