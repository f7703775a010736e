"""Derivatives against differences in 40 digits, closed form, and each other, over the zoo."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from laws.cases import bound, derived, states, values
from mechanisms import ZOO
from table import each

SEED = 11
DIGITS, STEP = 40, "1e-13"
# central differences of this step leave STEP^2 = 1e-26 of third derivatives; the rest is ours
FORCES = ("q", "u", "r", "p", "t")


def block(equations: Any, wrt: str, rng: np.random.Generator) -> Any:
    """A random direction of a block; of q: along the speeds."""
    size = equations.system.nu if wrt == "q" else len(equations.blocks[wrt])
    return rng.uniform(-1, 1, size)


def exact(equations: Any, function: str, of: str | None, blocks: dict[str, Any]) -> list[Any]:
    found = equations.function(function, of)
    results = evaluate(found, blocks, "mp", DIGITS)
    return [x for o in found.outputs for x in results[o.name]]


def moved(equations: Any, blocks: dict[str, Any], wrt: str, by: list[Any]) -> dict[str, Any]:
    """The blocks with one of them moved."""
    if wrt == "q":
        place = exact(equations, "integrate", None, blocks | {"du": by})
        return blocks | {"q": place}
    return blocks | {wrt: [a + b for a, b in zip(blocks[wrt], by, strict=True)]}


def difference(
    equations: Any, function: str, of: str | None, blocks: dict[str, Any], wrt: str, along: Any
) -> np.ndarray:
    """Change of all results along a direction, to 26 digits."""
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(STEP)
        sides = [
            exact(equations, function, of, moved(equations, blocks, wrt, [s * step * x for x in a]))
            for s, a in ((1, along), (-1, along))
        ]
        return np.array([float((a - b) / (2 * step)) for a, b in zip(*sides, strict=True)])


def judge(
    equations: Any, function: str, wrt: tuple[str, ...], state: Any, of: str | None = None
) -> None:
    """Every block along a random direction; errors by the largest change of any of them."""
    rng = np.random.default_rng(SEED)
    q, u = state
    nu = equations.system.nu
    udot, tau = rng.uniform(-1, 1, (2, nu))
    wrench = rng.uniform(-1, 1, len(equations.blocks["wrench"]))
    given = values(equations, q=q, u=u, udot=udot, tau=tau, wrench=wrench)
    blocks = {name: [float(x) for x in row] for name, row in given.items()}
    computed = evaluate(equations.derivative(function, wrt, of), blocks)
    mass = evaluate(equations.function("mass_matrix"), blocks)["M"]
    allowed = 10 * bound(np.array(mass, dtype=float).reshape(1, nu, nu))[0] + 1e-12
    pairs = {}
    for name in wrt:
        along = block(equations, name, rng)
        expected = difference(equations, function, of, blocks, name, along)
        columns = np.array(computed[f"d_{name}"], dtype=float)
        columns = columns.reshape(len(expected), len(along) if len(along) else 0)
        size = np.abs(columns).max(initial=0.0)
        pairs[name] = (columns @ along, expected, max(size, np.abs(expected).max(initial=0.0)))
    largest = max(size for _, _, size in pairs.values())
    for name, (ours, theirs, _) in pairs.items():
        error = np.abs(ours - theirs).max(initial=0.0)
        assert error <= allowed * max(largest, 1.0), f"{function} by {name}: {error:.1e}"


@each("name", ZOO)
def test_inverse_dynamics(name: str) -> None:
    q, u = states(name)
    judge(derived(name), "inverse_dynamics", (*FORCES, "udot"), (q[-1], u[-1]))


@each("name", ZOO)
def test_forward_dynamics(name: str) -> None:
    q, u = states(name)
    judge(derived(name), "forward_dynamics", (*FORCES, "tau"), (q[-1], u[-1]))


JOINTS = {
    "cylindrical": cd.Cylindrical("x"),
    "screw": cd.Screw((1, 2, 3), pitch=0.2),
    "planar": cd.Planar("y"),
    "free": cd.Free(),
    "universal": cd.Universal("x", "z"),
    "spherical": cd.Spherical("XYZ"),
}


@each("function", ["inverse_dynamics", "forward_dynamics"])
@each("kind", JOINTS)
def test_joints_that_are_carried(kind: str, function: str) -> None:
    # below two skew axes, so that all velocity products are there
    scene = cd.Scene("carried", gravity=(0, 0, -9.81))
    inner = scene.ground
    for i, joint in enumerate((cd.Revolute("x"), cd.Revolute("y"), JOINTS[kind])):
        body = scene.body(f"b{i}", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.25))
        scene.joint(f"j{i}", joint, inner.at(0.3, 0.1, 0.2), body)
        inner = body
    equations, rng = cd.derive(scene), np.random.default_rng(SEED)
    q = rng.uniform(0.2, 0.8, equations.system.nq)
    if kind == "free":
        q[2:6] /= np.linalg.norm(q[2:6])
    judge(equations, function, ("q", "u"), (q, rng.uniform(-2, 2, equations.system.nu)))


@each("name", ["crane", "driven", "springs", "satellite", "free_mrp", "gripper"])
@each("function", ["rhs", "outputs", "power", "energy", "bias", "qdot"])
def test_every_other_function(name: str, function: str) -> None:
    q, u = states(name)
    judge(derived(name), function, ("q", "u", "r", "p", "t"), (q[0], u[0]))


@pytest.mark.parametrize("method", ["kane", "newton_euler", "composite", "articulated"])
def test_every_formalism(method: str) -> None:
    q, u = states("branched")
    judge(derived("branched", method), "forward_dynamics", ("q", "u", "p", "tau"), (q[0], u[0]))


def test_frames_and_joints() -> None:
    e = derived("satellite")
    q, u = states("satellite")
    frame, joint = e.system.frames[-1].name, e.system.joints[-1].name
    judge(e, "pose", ("q", "p"), (q[0], u[0]), frame)
    judge(e, "velocity", ("q", "u"), (q[0], u[0]), frame)
    judge(e, "acceleration", ("q", "u", "udot"), (q[0], u[0]), frame)
    judge(e, "reaction", ("q", "u", "tau"), (q[0], u[0]), joint)


def test_chosen_speeds() -> None:
    scene = ZOO["double_pendulum"].build()
    first, second = (joint.name for joint in cd.derive(scene).system.joints)
    speeds = {
        "whole": sp.cos(scene.q(first)) * scene.u(first) + scene.u(second),
        "part": 2 * scene.u(second),
    }
    e = cd.derive(scene, speeds=speeds)
    rng = np.random.default_rng(SEED)
    q, u = rng.uniform(-1, 1, (2, 2))
    # integrate moves along the joint speeds: the columns are N du, and N is read from qdot
    blocks = values(e, q=q, u=u, udot=rng.uniform(-1, 1, 2))
    blocks = {name: [float(x) for x in row] for name, row in blocks.items()}
    given = evaluate(e.derivative("qdot", ("u",)), blocks)["d_u"]
    n, along = np.array(given).reshape(2, 2), rng.uniform(-1, 1, 2)
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(STEP)
        sides = [
            exact(e, "inverse_dynamics", None, blocks | {"q": list(q + s * step * (n @ along))})
            for s in (1, -1)
        ]
        expected = [float((a - b) / (2 * step)) for a, b in zip(*sides, strict=True)]
    ours = np.array(evaluate(e.derivative("inverse_dynamics", ("q",)), blocks)["d_q"])
    np.testing.assert_allclose(ours.reshape(2, 2) @ along, expected, rtol=1e-12, atol=1e-13)


def test_pendulum_in_closed_form() -> None:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    m, length, d = (scene.parameter(n, v) for n, v in (("m", 2.0), ("length", 0.7), ("d", 0.3)))
    bob = scene.body("bob", mass=m, com=(0, 0, -length))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bob)
    damper = cd.JointForce("hinge", -d * scene.u("hinge"))
    scene.force("damper", damper)
    e = cd.derive(scene)
    q, u, tau = 0.4, 1.1, 0.6
    blocks = values(e, q=[q], u=[u], tau=[tau])
    found = evaluate(
        e.derivative("forward_dynamics", ("q", "u", "tau", "m", "length", "d")), blocks
    )
    inertia, weight = 2.0 * 0.7**2, 2.0 * 9.81 * 0.7
    udot = (tau - 0.3 * u - weight * np.sin(q)) / inertia
    expected = {
        "q": -weight * np.cos(q) / inertia,
        "u": -0.3 / inertia,
        "tau": 1 / inertia,
        "m": (-9.81 * 0.7 * np.sin(q) - 0.7**2 * udot) / inertia,
        "length": (-2.0 * 9.81 * np.sin(q) - 2 * 2.0 * 0.7 * udot) / inertia,
        "d": -u / inertia,
    }
    for name, value in expected.items():
        assert found[f"d_{name}"] == pytest.approx([value], rel=1e-14), name


@pytest.mark.parametrize("name", ["branched", "satellite", "spherical_ZYX", "gripper", "crane"])
def test_one_follows_from_the_other(name: str) -> None:
    """d udot = -M^-1 d tau at the udot of the solution, d udot/d tau = M^-1, d tau/d udot = M."""
    e = derived(name)
    q, u = (x[0] for x in states(name))
    nu = e.system.nu
    tau = np.random.default_rng(SEED).uniform(-1, 1, nu)
    blocks = values(e, q=q, u=u, tau=tau)
    blocks["udot"] = evaluate(e.function("forward_dynamics"), blocks)["udot"]
    forward = evaluate(e.derivative("forward_dynamics", ("q", "u", "tau")), blocks)
    inverse = evaluate(e.derivative("inverse_dynamics", ("q", "u", "udot")), blocks)
    given = {"forward": forward, "inverse": inverse}
    found = {
        key: {name: np.array(x).reshape(nu, nu) for name, x in part.items()}
        for key, part in given.items()
    }
    mass = np.array(evaluate(e.function("mass_matrix"), blocks)["M"]).reshape(nu, nu)
    allowed = 10 * bound(mass[None])[0]
    np.testing.assert_allclose(found["inverse"]["d_udot"], mass, rtol=1e-14, atol=1e-14)
    np.testing.assert_allclose(found["forward"]["d_tau"] @ mass, np.eye(nu), atol=allowed)
    for wrt in ("d_q", "d_u"):
        size = np.abs(found["inverse"][wrt]).max()
        product = mass @ found["forward"][wrt]
        np.testing.assert_allclose(product, -found["inverse"][wrt], atol=allowed * max(size, 1.0))


def test_branches_do_not_reach_each_other() -> None:
    """d tau_i / dq_j is structurally 0 unless one of both joints carries the other."""
    e = derived("branched")
    function = e.derivative("inverse_dynamics", ("q", "u"))
    nu, parents = e.system.nu, [b.parent for b in e.system.bodies]

    def carries(i: int) -> set[int]:
        return {i} | (carries(parents[i]) if parents[i] >= 0 else set())

    owner = [i for i, j in enumerate(e.system.joints) for _ in j.element.speeds if j.u >= 0]
    for output in function.outputs:
        for row in range(nu):
            for column in range(nu):
                a, b = owner[row], owner[column]
                if a not in carries(b) and b not in carries(a):
                    assert output.nodes[row * nu + column] == 0


def test_requests_that_make_no_sense() -> None:
    e = derived("double_pendulum")
    with pytest.raises(DerivationError, match="no derivative"):
        e.function("derivative", "forward_dynamics")
    with pytest.raises(DerivationError, match="forward_dynamics"):
        e.derivative("forward_dynamic")
    with pytest.raises(DerivationError, match="'integrate' does not exist"):
        e.derivative("integrate", ("q",))
    with pytest.raises(DerivationError, match=r"upper\.mass"):
        e.derivative("bias", ("upper.mas",))
    with pytest.raises(DerivationError, match="needs a frame"):
        e.derivative("pose", ("q",))
    with pytest.raises(DerivationError, match="takes no frame"):
        e.derivative("bias", ("q",), of="elbow")
