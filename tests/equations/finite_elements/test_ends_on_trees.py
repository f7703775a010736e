"""Beams that end at bodies of rigid trees: elements with the coordinates of the joints that carry
them move like those on nodes that rows of constraints hold there."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest

import cardan as cd
from cardan.equations.finite_elements.lowering import lowered
from cardan.equations.finite_elements.nodal_scene import ends_of_beams, ends_with_nodes
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.equations.functions.blocks import defaults
from cardan.ir.interpreter import evaluate
from cardan.topology import build
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_tangents import tangents_agree

RUBBER = cd.material(E=2e6, nu=0.3, rho=1100, damping=1e-3)
ROD = cd.section.general(EA=300.0, GA=120.0, EI=(4.0, 6.0), GJ=3.0, rhoA=0.8, rhoI=(2e-3, 3e-3))
AXIS = (0.6, 0.0, 0.8)


def _arm(scene: cd.Scene, kind: object) -> cd.Body:
    """A body on two joints, the second of which is of some kind."""
    upper = scene.body("upper", mass=1.2, com=(0.2, 0.01, 0), inertia=(0.02, 0.1, 0.09))
    lower = scene.body("lower", mass=0.7, com=(0.1, 0, 0.02), inertia=(0.03, 0.04, 0.05))
    scene.joint("shoulder", cd.Revolute(AXIS), scene.ground, upper)
    scene.joint("elbow", kind, upper.at(0.4, 0.1, 0, rotation=("XYZ", 0.3, 0.2, 0.1)), lower)
    return lower


def _beam(scene: cd.Scene, start: object, end: object, elements: int = 2) -> cd.Beam:
    return scene.beam("rod", start, end, ROD, elements=elements)


def tip(kind: object) -> Callable[[cd.Scene], None]:
    def make(scene: cd.Scene) -> None:
        lower = _arm(scene, kind)
        rod = _beam(scene, lower.at(0.1, 0, 0.05, rotation=("XYZ", 0.4, 0, 0.2)), (1.2, 0.3, 0.2))
        scene.force("pull", cd.Force(rod.end, (1.0, 2.0, -0.5)))

    return make


def at_origin(scene: cd.Scene) -> None:
    _beam(scene, _arm(scene, cd.Revolute("y")), (1.2, 0.3, 0.2), 1)


def between_bodies_of_one_tree(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Revolute("y"))
    _beam(scene, "upper", lower.at(0.2, 0.1, 0), 1)


def from_a_tree_to_a_tree(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Spherical())
    cart = scene.body("cart", mass=2.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("rail", cd.Prismatic("x"), scene.ground.at(1.0, 0.5, 0), cart)
    _beam(scene, lower.at(0.1, 0, 0), cart, 3)


def to_a_body_that_floats(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Universal())
    tool = scene.body("tool", mass=0.4, inertia=(0.01, 0.02, 0.03), pose=(1.3, 0.2, 0.1))
    _beam(scene, lower.at(0.1, 0, 0), tool.at(-0.05, 0, 0), 1)


def on_a_body_that_floats(scene: cd.Scene) -> None:
    hub = scene.body("hub", mass=3.0, inertia=(0.3, 0.2, 0.4))
    scene.joint("space", cd.Free(), scene.ground, hub)
    panel = scene.body("panel", mass=0.5, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))
    scene.joint("hinge", cd.Revolute("z"), hub.at(0.2, 0, 0), panel)
    _beam(scene, panel.at(0.2, 0, 0), (1.0, 0, 0))
    scene.beam("mast", hub, (0, 0.8, 0), ROD, elements=1)


def declared_outward_in(scene: cd.Scene) -> None:
    lower = scene.body("lower", mass=0.7, com=(0.1, 0, 0.02), inertia=(0.03, 0.04, 0.05))
    scene.joint("shoulder", cd.Revolute("y"), lower.at(-0.1, 0, 0), scene.ground)
    _beam(scene, lower.at(0.1, 0, 0), (0.9, 0.1, 0))


def geared(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Gear("shoulder", ratio=-1.5, axis="y"))
    _beam(scene, lower.at(0.1, 0, 0), (1.2, 0.3, 0.2))


def released(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Prismatic("x"))
    scene.beam(
        *("rod", lower.at(0.1, 0, 0), (1.2, 0.3, 0.2), ROD), elements=2, release_start=("ry", "rz")
    )


def loaded(scene: cd.Scene) -> None:
    lower = _arm(scene, cd.Revolute("y"))
    tube = cd.section.tube(0.05, 0.004)
    rod = scene.beam("rod", lower.at(0.1, 0, 0), (1.2, 0.3, 0.2), tube, RUBBER, elements=2)
    scene.force("wind", cd.LineLoad(rod, force=(0.5, -1.0, 0.3), moment=(0.1, 0, 0.2)))
    scene.force("jet", cd.LineLoad(rod, force=(0.1, 0.4, 0), follower=True))


KINDS = {
    "revolute": cd.Revolute("y"),
    "prismatic": cd.Prismatic("x"),
    "spherical": cd.Spherical(),
    "rotation_vector": cd.Spherical(rotation="rotation_vector"),
    "universal": cd.Universal(),
    "cylindrical": cd.Cylindrical("x"),
    "planar": cd.Planar("z"),
    "free": cd.Free(),
}
SCENES: dict[str, Callable[[cd.Scene], None]] = {name: tip(k) for name, k in KINDS.items()} | {
    "at_origin": at_origin,
    "between_bodies_of_one_tree": between_bodies_of_one_tree,
    "from_a_tree_to_a_tree": from_a_tree_to_a_tree,
    "to_a_body_that_floats": to_a_body_that_floats,
    "on_a_body_that_floats": on_a_body_that_floats,
    "declared_outward_in": declared_outward_in,
    "geared": geared,
    "released": released,
    "loaded": loaded,
}
ROUNDING = 1e-10


@cache
def pair(name: str) -> tuple[FiniteElementRecord, FiniteElementRecord]:
    """A scene with ends of beams on bodies of trees, and on nodes of their own."""
    scene = cd.Scene(name, gravity=(0.5, -1.0, -9.81))
    SCENES[name](scene)
    system = build(scene)
    return (
        lowered(system, nodes=ends_with_nodes(system)),
        lowered(system, nodes=ends_of_beams(system)),
    )


def at(name: str) -> tuple[Reference, Reference]:
    """Both at the same state: of joints a random one, of nodes inside beams one not far."""
    equations, rng = pair(name), np.random.default_rng(len(name))
    system = equations[0].system
    joints = defaults(system)
    joints["q"] = np.concatenate(
        [_coordinates(joint.element, rng) for joint in system.joints if joint.q >= 0]
    )
    joints["u"] = rng.uniform(-1, 1, system.nu)
    inner = equations[0].inner.copy()
    if inner.size:
        inner[:, :4] += rng.uniform(-0.1, 0.1, (len(inner), 4))
        inner[:, :4] /= np.linalg.norm(inner[:, :4], axis=1, keepdims=True)
        inner[:, 4:] += rng.uniform(-0.05, 0.05, (len(inner), 3))
    speeds = rng.uniform(-1, 1, 6 * len(inner))
    found = []
    for one in equations:
        start = evaluate(one.states, joints, "numpy")
        q, u = np.concatenate([start["q"], inner.ravel()]), np.concatenate([start["u"], speeds])
        found.append(Reference(one, q, u))
    return found[0], found[1]


def _coordinates(element: object, rng: np.random.Generator) -> np.ndarray:
    values = [c.default for c in element.coordinates]  # type: ignore[attr-defined]
    moved = np.array(values) + rng.uniform(-0.4, 0.4, len(values))
    names = [c.name for c in element.coordinates]  # type: ignore[attr-defined]
    quaternion = [k for k, n in enumerate(names) if n in ("qw", "qx", "qy", "qz")]
    if len(quaternion) == 4:
        moved[quaternion] /= np.linalg.norm(moved[quaternion])
    return moved


@pytest.mark.parametrize("name", SCENES)
def test_elements_on_trees_move_like_those_on_nodes(name: str) -> None:
    trees, nodes = at(name)
    assert trees.scene.places.nu < nodes.scene.places.nu
    assert np.abs(np.concatenate(nodes.constraints())).max() < 1e-12
    (udot, lam, error), (expected, forces, other) = trees.solved(), nodes.solved()
    bound = max(ROUNDING, 400 * max(error, other)) * (1 + np.abs(expected).max())
    for k, speed in enumerate(trees.scene.speeds):
        assert abs(udot[k] - expected[nodes.scene.speeds.index(speed)]) < bound, speed
    for joint in nodes.scene.tree_joints + tuple(nodes.scene.joints):
        gap = trees.reaction(joint, udot, lam) - nodes.reaction(joint, expected, forces)
        assert np.abs(gap).max() < bound * 10, joint
    for function in ("energy", "momentum"):
        mine, others = trees.sum(function), nodes.sum(function)
        assert mine.keys() == others.keys()
        for key, value in others.items():
            assert np.abs(mine[key] - value).max() < 1e-11 * (1 + np.abs(value).max()), key
    assert trees.scene.powers == nodes.scene.powers
    powers = [trees.listed("power", udot, lam), nodes.listed("power", expected, forces)]
    assert np.abs(powers[0] - powers[1]).max(initial=0) < bound


@pytest.mark.parametrize("name", SCENES)
def test_tangents(name: str) -> None:
    tangents_agree(at(name)[0])
