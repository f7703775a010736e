"""Weights times derivatives, changes along directions, and Hessians, over the zoo.

The gradient and the change along a direction against differences in 40 digits, the Hessian against
such differences of the gradient; all of them against the derivative itself.
"""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

import cardan as cd
from cardan.equations.functions.blocks import defaults
from cardan.errors import DerivationError
from cardan.ir.interpreter import evaluate
from cardan.schema.request import Request
from equations.test_derivatives import DIGITS, STEP, exact, moved
from laws import event_scenes
from laws.cases import bound, derived, states, values
from laws.circuits import compiled, scene_of, start
from mechanisms import ZOO
from table import each

SEED = 17
FORCES = ("q", "u", "r", "p", "t")


def blocks_at(equations: Any, q: Any, u: Any) -> dict[str, list[float]]:
    rng = np.random.default_rng(SEED)
    nu = equations.system.nu
    udot, tau = rng.uniform(-1, 1, (2, nu))
    wrench = rng.uniform(-1, 1, len(equations.blocks["wrench"]))
    given = values(equations, q=q, u=u, udot=udot, tau=tau, wrench=wrench)
    given |= {name: block for name, block in defaults(equations.system).items() if name in "zs"}
    given["e"] = np.ones(len(equations.blocks["e"]))
    return {name: [float(x) for x in row] for name, row in given.items()}


def flat(results: Any) -> np.ndarray:
    return np.concatenate([np.ravel(np.array(x, dtype=float)) for x in results.values()] or [[]])


def product(equations: Any, kind: str, request: str, blocks: Any, v: Any) -> np.ndarray:
    return flat(evaluate(equations.function(kind, request), {**blocks, "v": list(v)}))


def sizes(equations: Any, wrt: tuple[str, ...]) -> list[int]:
    nu = equations.system.nu
    known = {"q": nu, "coordinates": len(equations.blocks["q"]), "t": 1}
    return [known.get(name, len(equations.blocks.get(name, ()))) or 1 for name in wrt]


def judge(
    equations: Any, function: str, wrt: tuple[str, ...], state: Any, of: str | None = None
) -> None:
    """All three against the matrix of the derivative, and the Hessian against differences."""
    wrt = tuple(name for name in wrt if name == "t" or len(equations.blocks[name]))
    rng, request = np.random.default_rng(SEED), str(Request(function, of, wrt))
    blocks = blocks_at(equations, *state)
    counts = sizes(equations, wrt)
    columns = evaluate(equations.derivative(function, wrt, of), blocks)
    matrix = np.hstack(
        [
            np.array(x, dtype=float).reshape(-1, count)
            for x, count in zip(columns.values(), counts, strict=True)
        ]
    )
    allowed = 100 * allowance(equations, blocks)
    weights, way = rng.uniform(-1, 1, len(matrix)), rng.uniform(-1, 1, matrix.shape[1])
    scale = max(1.0, np.abs(matrix).max(initial=0.0))
    gradient = product(equations, "vjp", request, blocks, weights)
    assert np.abs(gradient - weights @ matrix).max(initial=0.0) <= allowed * scale
    change = product(equations, "jvp", request, blocks, way)
    assert np.abs(change - matrix @ way).max(initial=0.0) <= allowed * scale
    hessian = product(equations, "hessian", request, blocks, weights)
    hessian = hessian.reshape(matrix.shape[1], matrix.shape[1])
    np.testing.assert_array_equal(hessian, hessian.T)
    judge_hessian(equations, request, wrt, blocks, weights, hessian, allowed)


def allowance(equations: Any, blocks: Any) -> float:
    mass = np.array(evaluate(equations.function("mass_matrix"), blocks)["M"], dtype=float)
    nu = equations.system.nu
    return float(bound(mass.reshape(1, nu, nu))[0]) + 1e-13


def judge_hessian(
    equations: Any,
    request: str,
    wrt: tuple[str, ...],
    blocks: Any,
    weights: Any,
    hessian: np.ndarray,
    allowed: float,
) -> None:
    """Rates of the gradient along one way, in terms of another, in both orders."""
    rng, ends = np.random.default_rng(SEED + 1), np.cumsum([0, *sizes(equations, wrt)])
    ways = rng.uniform(-1, 1, (2, len(hessian)))
    given = {**blocks, "v": list(weights)}
    slopes = []
    for along, other in (ways, ways[::-1]):
        with mpmath.workdps(DIGITS):
            step, sides = mpmath.mpf(STEP), []
            for sign in (1, -1):
                place = given
                for k, name in enumerate(wrt):
                    by = [sign * step * x for x in along[ends[k] : ends[k + 1]]]
                    place = moved(equations, place, name, by)
                sides.append(exact(equations, "vjp", request, place))
            rates = [(a - b) / (2 * step) for a, b in zip(*sides, strict=True)]
            slopes.append(float(sum(a * b for a, b in zip(rates, other, strict=True))))
    expected = sum(slopes) / 2
    scale = max(1.0, np.abs(hessian).max(initial=0.0))
    assert ways[0] @ hessian @ ways[1] == pytest.approx(expected, abs=10 * allowed * scale)


@each("name", ZOO)
def test_forward_dynamics(name: str) -> None:
    q, u = states(name)
    judge(derived(name), "forward_dynamics", (*FORCES, "tau"), (q[-1], u[-1]))


@each("name", ZOO)
def test_inverse_dynamics(name: str) -> None:
    q, u = states(name)
    judge(derived(name), "inverse_dynamics", (*FORCES, "udot"), (q[-1], u[-1]))


@each("name", ["crane", "driven", "springs", "satellite", "free_mrp", "gripper"])
@each("function", ["rhs", "outputs", "power", "energy", "bias", "qdot", "momenta"])
def test_every_other_function(name: str, function: str) -> None:
    q, u = states(name)
    judge(derived(name), function, ("q", "u", "r", "p", "t"), (q[0], u[0]))


def test_frames_and_joints() -> None:
    e = derived("satellite")
    q, u = states("satellite")
    frame, joint = e.system.frames[-1].name, e.system.joints[-1].name
    judge(e, "pose", ("q", "p"), (q[0], u[0]), frame)
    judge(e, "acceleration", ("q", "u", "udot"), (q[0], u[0]), frame)
    judge(e, "reaction", ("q", "u", "tau"), (q[0], u[0]), joint)


@each("name", ["four_bar", "slider_crank", "andrews", "parallelogram", "stewart"])
@each("function", ["forward_dynamics", "multipliers", "rhs", "constraint_jacobian"])
def test_loops(name: str, function: str) -> None:
    equations = cd.derive(scene_of(name))
    q, u = start(compiled(name), name, 0.3)
    tau = ("tau",) if function in ("forward_dynamics", "multipliers") else ()
    speeds = () if function == "constraint_jacobian" else ("u",)
    judge(equations, function, ("q", *speeds, "p", *tau), (q, u))


def test_reaction_of_a_loop() -> None:
    equations = cd.derive(scene_of("four_bar"))
    q, u = start(compiled("four_bar"), "four_bar", 0.3)
    judge(equations, "reaction", ("q", "u", "tau", "p"), (q, u), equations.system.joints[0].name)


def test_massless_link_of_a_loop() -> None:
    # constraints are added to M: accelerations are differentiated through their solution
    scene = cd.Scene("linkage", gravity=(0, -9.81, 0))
    crank = scene.body("crank", mass=0)
    coupler, rocker = (
        scene.body(name, mass=1.0, com=(length / 2, 0, 0), inertia=cd.inertia.rod(1.0, length))
        for name, length in (("coupler", 0.8), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=0.8)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler, cut=True)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), rocker.at(0.6, 0, 0), coupler.at(0.8, 0, 0))
    model = cd.compile(scene)
    q, u = model.split(model.initial(q={"A": 0.8}, u={"A": 1.3}))
    equations = cd.derive(scene)
    assert np.min(np.diagonal(model.mass_matrix(q))) == 0
    judge(equations, "forward_dynamics", ("q", "u", "tau"), (q, u))


@pytest.mark.parametrize("constraints", ["null_space", "elimination", "baumgarte"])
def test_every_treatment(constraints: str) -> None:
    q, u = start(compiled("four_bar"), "four_bar", 0.3)
    equations = cd.derive(scene_of("four_bar"), constraints=constraints)
    judge(equations, "forward_dynamics", ("q", "u", "tau"), (q, u))


@pytest.mark.parametrize("method", ["kane", "lagrange", "composite", "articulated"])
def test_every_formalism(method: str) -> None:
    q, u = states("branched")
    judge(derived("branched", method), "forward_dynamics", ("q", "u", "p", "tau"), (q[0], u[0]))


@pytest.mark.parametrize("name", ["rubbing", "ball", "feet"])
@pytest.mark.parametrize("function", ["events", "transition", "rhs"])
def test_events_and_internal_states(name: str, function: str) -> None:
    scene, at = getattr(event_scenes, name)()
    equations = cd.derive(scene)
    nq, nu = len(equations.blocks["q"]), equations.system.nu
    q = np.array([at.get(name, 0.2) for name in equations.blocks["q"].entries][:nq])
    u = np.random.default_rng(SEED).uniform(-1, 1, nu)
    judge(equations, function, ("q", "u", "z", "p"), (q, u))


def test_coordinates_as_they_are_stored() -> None:
    """Quaternions count by their direction: the function behind the normalized ones."""
    scene = cd.Scene("top", gravity=(0, 0, -9.81))
    body = scene.body("top", mass=2.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.25))
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    slider = scene.body("slider", mass=0.5, inertia=(0.01, 0.02, 0.03))
    scene.joint("rod", cd.Prismatic("x"), body, slider)
    equations, rng = cd.derive(scene), np.random.default_rng(SEED)
    q = rng.uniform(0.2, 0.8, 5)
    q[:4] /= np.linalg.norm(q[:4])
    blocks = blocks_at(equations, q, rng.uniform(-1, 1, 4))
    weights, ways = rng.uniform(-1, 1, 4), rng.uniform(-1, 1, (2, 5))
    request = "forward_dynamics: coordinates"
    gradient = product(equations, "vjp", request, blocks, weights)
    hessian = product(equations, "hessian", request, blocks, weights).reshape(5, 5)

    def phi(a: Any, b: Any) -> Any:
        there = [x + a * y + b * z for x, y, z in zip(blocks["q"], *ways, strict=True)]
        size = mpmath.sqrt(sum(x * x for x in there[:4]))
        there[:4] = [x / size for x in there[:4]]
        values = exact(equations, "forward_dynamics", None, blocks | {"q": there})
        return sum(float(w) * x for w, x in zip(weights, values, strict=True))

    with mpmath.workdps(DIGITS):
        h = mpmath.mpf("1e-9")
        slope = (phi(h, 0) - phi(-h, 0)) / (2 * h)
        mixed = (phi(h, h) - phi(h, -h) - phi(-h, h) + phi(-h, -h)) / (4 * h * h)
    assert float(slope) == pytest.approx(gradient @ ways[0], rel=1e-12)
    assert float(mixed) == pytest.approx(ways[0] @ hessian @ ways[1], rel=1e-11)


def test_gradients_need_few_operations() -> None:
    """One sweep in reverse: the cost does not depend on the number of parameters."""
    equations = derived("branched")
    function = equations.operations_of("forward_dynamics").total
    request = "forward_dynamics: q u p tau"
    gradient = equations.operations_of("vjp", request).total
    assert gradient <= 4 * function
    assert equations.operations_of("derivative", request).total > 2 * gradient


def test_requests_that_make_no_sense() -> None:
    e = derived("double_pendulum")
    for kind in ("vjp", "jvp", "hessian"):
        with pytest.raises(DerivationError, match="no derivative"):
            e.function(kind, "forward_dynamics")
        with pytest.raises(DerivationError, match="'integrate' does not exist"):
            e.function(kind, "integrate: q")
