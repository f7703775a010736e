"""A joint declared from child to parent is the same joint: motion, energy, reactions."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.cases import EPS, call, derived, deviation, slots, states
from laws.circuits import EVERY
from mechanisms import ZOO
from table import each

# the rotor of a drive turns on the declared parent: with that exchanged it is another machine;
# that of a body has a joint that nobody declares
MEMBERS = [
    name
    for name, scene in ((name, member.build()) for name, member in ZOO.items())
    if not any(isinstance(f.element, cd.Drive | cd.Rotor) for f in scene.forces.values())
    # a tree has one joint for each body
    and len(scene.joints) <= len(scene.bodies)
    and not scene.constraints
]


def turned(scene: cd.Scene, every: int = 1) -> cd.Scene:
    """The scene with each n-th joint declared the other way round."""
    for key, joint in list(scene.joints.items())[::every]:
        kind = joint.kind if joint.kind.kind == "fixed" else joint.kind.reversed()
        scene.joints[key] = dataclasses.replace(
            joint, kind=kind, parent=joint.child, child=joint.parent
        )
    return scene


@pytest.fixture(scope="module", params=MEMBERS)
def both(request: pytest.FixtureRequest) -> tuple[str, Any, Any]:
    name = request.param
    return name, derived(name), cd.derive(turned(ZOO[name].build()), method=derived(name).method)


def test_equations_are_the_same(both: tuple[str, Any, Any]) -> None:
    name, forth, back = both
    assert [j.name for j in forth.system.joints] == [j.name for j in back.system.joints]
    pairs = zip(forth.system.joints, back.system.joints, strict=True)
    assert all(one.reversed is not other.reversed for one, other in pairs)
    q, u = states(name)
    tau = np.random.default_rng(1).uniform(-1, 1, u.shape)
    for function in ("forward_dynamics", "energy", "qdot"):
        given = {"tau": tau} if function == "forward_dynamics" else {}
        one, other = (call(e, function, q=q, u=u, **given) for e in (forth, back))
        for key, value in one.items():
            # the same formulas but for the signs and the order in which poses are composed
            assert deviation(other[key], value).max() < 1e6 * EPS, (function, key)


def pose(equations: Any, frame: str, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    (whole,) = call(equations, "pose", frame, q=q).values()
    return whole[:, :3, :3], whole[:, :3, 3]


def in_ground(wrench: np.ndarray, rotation: np.ndarray, place: np.ndarray) -> np.ndarray:
    """A wrench told at a frame in its axes, about the ground origin in ground axes."""
    moment, force = (np.einsum("nij,nj->ni", rotation, wrench[:, k : k + 3]) for k in (0, 3))
    return np.concatenate([moment + np.cross(place, force), force], axis=1)


def test_reactions_are_opposite(both: tuple[str, Any, Any]) -> None:
    """That of parent on child; told in ground axes it changes its sign with the declaration."""
    name, forth, back = both
    q, u = states(name)
    parts = sum(len(body.parts) for body in forth.system.bodies)
    given = {"q": q, "u": u, "wrench": np.random.default_rng(2).uniform(-1, 1, 6 * parts)}
    for i, joint in enumerate(forth.system.joints):
        told = []
        for equations in (forth, back):
            own = equations.system.joints[i]
            frame = equations.system.frames[own.parent_frame if own.reversed else own.child_frame]
            (wrench,) = call(equations, "reaction", joint.name, **given).values()
            told.append(in_ground(wrench, *pose(equations, frame.name, q)))
        one, other = told
        assert np.abs(one + other).max() < 1e7 * EPS * (1 + np.abs(one).max()), joint.name


@each("every", [1, 2, 3])
@each("name", EVERY)
def test_circuits_of_joints_in_either_direction(name: str, every: int) -> None:
    """Each n-th joint exchanged, in the tree or closing a loop: the same accelerations."""
    forth = EVERY[name].build()
    back = turned(EVERY[name].build(), every)
    found = []
    for scene in (forth, back):
        equations = cd.derive(scene)
        joints = equations.system.joints
        state = EVERY[name].state(0.3, joints=[j.name for j in joints if j.q >= 0])
        q, u = slots(equations.system, state)
        (udot,) = call(equations, "forward_dynamics", q=q, u=u).values()
        total = float(call(equations, "energy", q=q, u=u)["total"])
        found.append((dict(zip(equations.speeds, udot, strict=True)), total))
    assert found[0][1] == pytest.approx(found[1][1], rel=1e-12)
    wanted, computed = found[0][0], found[1][0]
    assert set(wanted) == set(computed)
    size = max(map(abs, wanted.values()))
    # the speeds of the state are right to about 1e-12 of accelerations times some condition
    assert max(abs(wanted[key] - computed[key]) for key in wanted) < 1e-8 * size
