"""The Jacobian of the right-hand side against differences in 40 digits, over the zoo."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.ir.interpreter import evaluate
from laws import circuits
from laws.cases import bound, derived, states, values
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from table import each

SEED = 3
DIGITS, STEP = 40, "1e-13"
Array = np.ndarray


def quaternions(equations: Any) -> list[int]:
    """First slot in q of every unit quaternion."""
    found = [(j.q, j.element.quaternion) for j in equations.system.joints if j.q >= 0]
    return [first + own for first, own in found if own is not None]


def difference(equations: Any, blocks: dict[str, Any], along: dict[str, Array]) -> Array:
    """Change of rhs along a direction of its arguments, quaternions kept at length 1."""
    rhs, sides = equations.function("rhs"), []
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(STEP)
        for sign in (1, -1):
            moved = dict(blocks)
            for name, change in along.items():
                pairs = zip(blocks[name], change, strict=True)
                moved[name] = [mpmath.mpf(a) + sign * step * mpmath.mpf(b) for a, b in pairs]
            for first in quaternions(equations):
                own = moved["q"][first : first + 4]
                size = mpmath.sqrt(sum(x * x for x in own))
                moved["q"][first : first + 4] = [x / size for x in own]
            results = evaluate(rhs, moved, "mp", DIGITS)
            sides.append([x for o in rhs.outputs for x in results[o.name]])
        return np.array([float((a - b) / (2 * step)) for a, b in zip(*sides, strict=True)])


def judge(equations: Any, q: Array, u: Array, allowed: float, **more: Any) -> None:
    """Along a random direction of everything, and along the quaternions themselves."""
    rng = np.random.default_rng(SEED)
    given = {"z": []} | values(equations, q=q, u=u, **more)
    blocks = {name: [float(x) for x in row] for name, row in given.items()}
    along = {name: rng.uniform(-1, 1, len(blocks[name])) for name in ("q", "u", "z", "t", "r")}
    nq, n = len(q), len(q) + len(u) + len(blocks["z"])
    found = evaluate(equations.function("rhs_jacobian"), blocks)
    by_x = np.array(found["d_x"], dtype=float).reshape(n, n)
    by_r = np.array(found.get("d_r", []), dtype=float).reshape(n, -1)
    ours = by_x @ np.concatenate([along["q"], along["u"], along["z"]]) + by_r @ along["r"]
    ours += np.array(found["d_t"], dtype=float) * along["t"]
    theirs = difference(equations, blocks, along)
    size = max(1.0, np.abs(by_x).max(initial=0.0), np.abs(by_r).max(initial=0.0))
    assert np.abs(ours - theirs).max(initial=0.0) <= allowed * size
    for first in quaternions(equations):
        place = slice(first, first + 4)
        assert np.abs(by_x[:, :nq][:, place] @ q[place]).max() <= allowed * size


@each("name", ZOO)
def test_trees(name: str) -> None:
    equations, (q, u) = derived(name), states(name)
    blocks = values(equations, q=q[-1], u=u[-1])
    mass = evaluate(equations.function("mass_matrix"), blocks)["M"]
    nu = equations.system.nu
    # what a solve with M loses, for every entry that is summed
    judge(equations, q[-1], u[-1], 10 * bound(np.array(mass, float).reshape(1, nu, nu))[0] + 1e-12)


@pytest.mark.parametrize("name", CLOSED)
def test_circuits(name: str) -> None:
    model = circuits.compiled(name)
    q, u = circuits.start(model, name, circuits.PLACES[0])
    # loops are regular here: a few digits for the two solves
    judge(cd.derive(circuits.scene_of(name)), q, u, 1e-10)


# a penalty multiplies what rounding leaves of the residuals
TREATMENTS = {"elimination": 1e-10, "null_space": 1e-10, "baumgarte": 1e-10, "penalty": 1e-6}


@pytest.mark.parametrize("treatment", TREATMENTS)
def test_other_ways_to_treat_constraints(treatment: str) -> None:
    name = "four_bar"
    q, u = circuits.start(circuits.compiled(name), name, circuits.PLACES[1])
    judge(cd.derive(circuits.scene_of(name), constraints=treatment), q, u, TREATMENTS[treatment])


@pytest.mark.parametrize("method", ["kane", "newton_euler", "composite", "articulated"])
def test_every_formalism(method: str) -> None:
    q, u = states("satellite")
    judge(derived("satellite", method), q[-1], u[-1], 1e-10)


@pytest.mark.parametrize("mode", [0, 1, -1, 2])
def test_internal_states_and_modes(mode: int) -> None:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    wanted = scene.input("wanted", default=0.3)
    upper = scene.body("upper", mass=2.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    lower = scene.body("lower", mass=1.0, com=(0, 0, -0.4), inertia=(0.1, 0.1, 0.1))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    total = sp.Symbol("total")
    behind = wanted * sp.sin(cd.t) - scene.q("shoulder")
    law = 5 * behind + 3 * total - scene.u("shoulder")
    scene.force("control", cd.Controller("shoulder", (total,), (behind - total**2 / 9,), law))
    scene.force("motor", cd.Actuator("elbow", command=-2 * scene.q("elbow"), lag=0.05))
    scene.force("rub", cd.Friction("elbow", 0.7, static=0.9, stribeck=0.1, viscous=0.2))
    equations = cd.derive(scene)
    assert (equations.system.nz, equations.system.ns) == (2, 1)
    # undecided, sliding either way, sticking: then the elbow is held by a condition
    q, u = np.array([0.4, -0.7]), np.array([1.2, 0.0 if mode == 2 else 0.6])
    judge(equations, q, u, 1e-11, z=[0.2, -0.5], s=[float(mode)])


def test_compiled() -> None:
    scene = cd.Scene("driven", gravity=(0, 0, -9.81))
    pull, arm = scene.input("pull"), scene.body("arm", mass=2.0, com=(0, 0, -0.5))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    scene.force("push", cd.JointForce("hinge", 3 * cd.t * pull - 0.2 * scene.u("hinge")))
    model = cd.compile(scene)
    x = np.array([[0.3, -1.2], [0.5, 0.1]])
    by_x, by_t, by_r = model.rhs_jacobian(0.7, x, [2.0])
    # m l^2 udot = -m g l sin q + 3 t r - 0.2 u with m l^2 = 0.5
    expected = np.zeros((2, 2, 2))
    expected[:, 0, 1] = 1
    expected[:, 1, 0] = -9.81 / 0.5 * np.cos(x[:, 0])
    expected[:, 1, 1] = -0.4
    np.testing.assert_allclose(by_x, expected, rtol=0, atol=1e-13)
    np.testing.assert_allclose(by_t, [[0, 12], [0, 12]], rtol=0, atol=1e-13)
    np.testing.assert_allclose(by_r, [[[0], [4.2]], [[0], [4.2]]], rtol=0, atol=1e-13)
    assert set(model.source) >= {"rhs_jacobian"}
