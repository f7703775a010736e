"""A joint declared from child to parent is the same joint: motion, energy, reactions."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.cases import EPS, call, derived, deviation, states
from mechanisms import ZOO

# the rotor of a drive turns on the declared parent: with that exchanged it is another machine
MEMBERS = [
    name
    for name, member in ZOO.items()
    if not any(isinstance(f.element, cd.Drive) for f in member.build().forces.values())
    and not derived(name).system.closed
]


def exchanged(name: str) -> cd.Model:
    """A scene of the zoo in which every joint is declared the other way round."""
    scene = ZOO[name].build()
    for key, joint in scene.joints.items():
        kind = joint.kind if joint.kind.kind == "fixed" else joint.kind.reversed()
        scene.joints[key] = dataclasses.replace(
            joint, kind=kind, parent=joint.child, child=joint.parent
        )
    return scene


@pytest.fixture(scope="module", params=MEMBERS)
def both(request: pytest.FixtureRequest) -> tuple[str, Any, Any]:
    name = request.param
    return name, derived(name), cd.derive(exchanged(name), method=derived(name).method)


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
