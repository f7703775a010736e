"""The same machine described in another order or in other frames moves the same."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.ir.interpreter import evaluate
from table import each

SEED = 13
LINKS = ("trunk", "left", "right", "hand")
PARENT = {"trunk": "ground", "left": "trunk", "right": "trunk", "hand": "right"}
AXES = {"trunk": (0, 0, 1), "left": (1, 0, 0), "right": (1, 2, 2), "hand": (0, 0.6, 0.8)}
TENSOR = np.array([[0.05, 0.004, -0.003], [0.004, 0.06, 0.002], [-0.003, 0.002, 0.04]])


def arm(order: tuple[str, ...] = LINKS, twist: dict[str, Rotation] | None = None) -> cd.Scene:
    """A branched arm; ``twist`` describes bodies in turned and shifted axes."""
    scene = cd.Scene("arm", gravity=(0.5, 1.0, -9.0))
    turned = twist or {}
    bodies, places = {"ground": scene.ground}, {}
    for name in order:
        index = LINKS.index(name)
        r = turned.get(name, Rotation.identity())
        shift = np.array([0.1, -0.2, 0.3]) if name in turned else np.zeros(3)
        # body axes = axes of the plain description turned by r, origin moved by shift
        matrix = r.as_matrix()
        com = matrix.T @ (np.array([0.1, 0.05 * index, 0.2]) - shift)
        tensor = matrix.T @ (TENSOR * (1 + index)) @ matrix
        bodies[name] = scene.body(name, mass=1.0 + index, com=tuple(com), inertia=tensor.tolist())
        places[name] = (matrix, shift)
    for name in order:
        ends = []
        for body, point in ((PARENT[name], (0.1, 0.2, 0.3)), (name, (0, 0, 0))):
            matrix, shift = places.get(body, (np.eye(3), np.zeros(3)))
            here = matrix.T @ (np.array(point) * (body != "ground") - shift)
            ends.append(bodies[body].at(*here, rotation=matrix.T.tolist()))
        scene.joint(f"{name}_joint", cd.Revolute(AXES[name]), *ends)
    return scene


def by_name(model: cd.CompiledModel, values: dict[str, float]) -> np.ndarray:
    return np.array([values[name] for name in model.coordinates])


def accelerations(scene: cd.Scene, state: dict[str, dict[str, float]]) -> dict[str, float]:
    model = cd.compile(scene, functions=("forward_dynamics",))
    udot = model.forward_dynamics(by_name(model, state["q"]), by_name(model, state["u"]))
    return dict(zip(model.coordinates, udot.tolist(), strict=True))


@pytest.fixture(scope="module")
def state() -> dict[str, dict[str, float]]:
    rng = np.random.default_rng(SEED)
    names = [f"{name}_joint" for name in LINKS]
    return {key: dict(zip(names, rng.uniform(-1, 1, 4), strict=True)) for key in "qu"}


@pytest.mark.parametrize("order", [LINKS[::-1], ("hand", "trunk", "right", "left")])
def test_order_of_description(state: dict, order: tuple[str, ...]) -> None:
    expected = accelerations(arm(), state)
    assert accelerations(arm(order), state) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("bodies", [("trunk",), ("left", "hand"), LINKS])
def test_axes_of_bodies(state: dict, bodies: tuple[str, ...]) -> None:
    expected = accelerations(arm(), state)
    rotations = Rotation.random(len(bodies), rng=np.random.default_rng(SEED))
    twist = dict(zip(bodies, rotations, strict=True))
    assert accelerations(arm(twist=twist), state) == pytest.approx(expected, rel=1e-11)


def test_units_of_parameters() -> None:
    def bob(length: float, unit: str) -> float:
        scene = cd.Scene("bob", gravity=(0, 0, -9.81))
        l = scene.parameter("l", length, unit=unit)
        body = scene.body("bob", mass=1.0, com=(0, 0, -l))
        scene.joint("pivot", cd.Revolute("y"), scene.ground, body)
        return float(cd.compile(scene).forward_dynamics([0.5], [0.0])[0])

    assert bob(0.4, "m") == pytest.approx(bob(400, "mm"), rel=1e-15)
    assert bob(0.4, "m") == pytest.approx(-9.81 / 0.4 * np.sin(0.5), rel=1e-15)


def crane(place: tuple[float, float, float], kind: cd.Joint) -> cd.Scene:
    """Three bodies somewhere, the first on a joint of some kind."""
    scene, rng = cd.Scene("crane", gravity=(0.5, 1.0, -9.0)), np.random.default_rng(SEED)
    inner = scene.ground.at(*place)
    for i, joint in enumerate((kind, cd.Revolute("y"), cd.Revolute("x"))):
        com = tuple(rng.uniform(-0.3, 0.3, 3))
        body = scene.body(f"body{i}", mass=1.0 + i, com=com, inertia=(TENSOR * (1 + i)).tolist())
        scene.joint(f"joint{i}", joint, inner, body)
        inner = body.at(*rng.uniform(-0.5, 0.5, 3))
    return scene


@each("method", ["kane", "newton_euler", "composite", "articulated", "lagrange", "gibbs_appell"])
@each("kind", [*(cd.Revolute(axis) for axis in "xyz"), cd.Prismatic("x"), cd.Universal("x", "y")])
def test_place_of_the_scene(kind: cd.Joint, method: str) -> None:
    """Vehicles and cranes in coordinates of a map: no inertia is told about a point far away."""
    near, far = (
        cd.derive(crane(place, kind), method=method) for place in ((0.0, 0.0, 0.0), (1e6, 2e6, 3e6))
    )
    rng = np.random.default_rng(SEED)
    for name in ("mass_matrix", "bias", "forward_dynamics", "inverse_dynamics"):
        functions = [equations.function(name) for equations in (near, far)]
        blocks = {b.name: rng.uniform(-1, 1, len(b)) for b in functions[0].inputs}
        expected, found = (
            np.ravel(next(iter(evaluate(f, blocks | {"p": parameters(e)}, "numpy").values())))
            for f, e in zip(functions, (near, far), strict=True)
        )
        scale = np.abs(expected).max()
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13 * scale)


def parameters(equations: cd.Equations) -> np.ndarray:
    return np.array([p.value for p in equations.system.parameters])
