"""Which components of reactions are determined, by the conditions of free bodies.

The judge knows the scene alone: every joint is written as conditions between two free bodies, and
combinations of these that vanish load no body. What they bring to a joint is not determined.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest

import cardan as cd
from laws.maximal import Maximal
from laws.test_cut_joints import INSTANCES, machine
from mechanisms.closed import CLOSED
from mechanisms.overconstrained import bennett, bennett_angles, five_angles, five_revolutes

KINDS = ("relative", "absolute", "closed_form")
PLACE = 0.1  # of the motion that the loops of a mechanism allow
TOUCHED = 1e-7
Made = tuple[Callable[[], cd.Scene], Mapping[str, Any]]


def door(*ways: str) -> cd.Scene:
    """A leaf on coaxial hinges, declared from the ground or from the leaf."""
    scene = cd.Scene("door", gravity=(1.0, -2.0, -9.81))
    leaf = scene.body("door", mass=2.0, com=(0.4, 0, 0), inertia=(0.1, 0.1, 0.15))
    for k, way in enumerate(ways):
        ends = scene.ground.at(0, 0, k), leaf.at(0, 0, k)
        scene.joint(f"h{k}", cd.Revolute("z"), *(ends if way == "ground" else ends[::-1]))
    return scene


def turned() -> cd.Scene:
    """A planar four-bar in an oblique plane, its links placed anywhere along their hinges."""
    scene = cd.Scene("turned", gravity=(0.0, 0.0, -9.81))
    lengths, shifts = (1.0, 3.0, 2.5), (0.2, -0.3, 0.5)
    axis = np.array([1.0, 2.0, -2.0]) / 3
    along = np.array([2.0, 1.0, 2.0]) / 3
    place = scene.ground
    for k, (length, shift) in enumerate(zip(lengths, shifts, strict=True)):
        link = scene.body(f"link{k}", mass=1.0, com=0.5 * length * along, inertia=(0.3, 0.3, 0.3))
        scene.joint(f"J{k}", cd.Revolute(axis), place, link)
        place = link.at(*(length * along + shift * axis))
    scene.joint(
        "J3", cd.Revolute(axis), place, scene.ground.at(*(3.0 * along + sum(shifts) * axis))
    )
    return scene


SCENES: dict[str, Made] = {
    "door": (lambda: door("ground", "leaf"), {"h0": 0.3}),
    "door of three": (lambda: door("leaf", "ground", "leaf"), {"h0": 0.3}),
    "oblique four-bar": (turned, {"J0": 1.0}),
    "bennett": (bennett, bennett_angles(0.7)),
    **{name: (lambda m=m: m.build(), m.configuration(PLACE)) for name, m in CLOSED.items()},
    **{
        name: (lambda name=name: five_revolutes(name), five_angles(name, 0.7))
        for name in ("goldberg", "myard")
    },
}
SHOWN = ("door", "bennett", "four_bar", "slider_crank")
COUNTS: dict[str, int] = {}


def slowly(names: Any) -> list[Any]:
    return [n if n in SHOWN else pytest.param(n, marks=pytest.mark.slow) for n in names]


def started(scene: cd.Scene, kind: str, q: Mapping[str, Any]) -> tuple[cd.CompiledModel, Any]:
    """A model and its coordinates where some joints are."""
    if kind == "closed_form":
        model = cd.compile(cd.derive(scene, constraints="closed_form"))
    else:
        model = cd.compile(cd.derive(scene, coordinates=kind))
    slots = {row["joint"] for row in model.manifest["coordinates"]}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        x = model.initial({name: value for name, value in q.items() if name in slots})
    return model, x[: model.nq]


def self_stresses(scene: cd.Scene, poses: Mapping[str, Any]) -> tuple[int, dict[str, list[bool]]]:
    """Number of conditions too many, and which components of reactions are determined.

    Components that a joint leaves free pass nothing: they are determined.
    """
    judge = Maximal(scene)
    rows: dict[str, int] = {}
    for joint in scene.joints.values():
        judge.scene = type("One", (), {"joints": {joint.name: joint}})()
        rows[joint.name] = len(judge.residuals(poses))
    judge.scene = scene
    G = judge.jacobian(poses)
    U, s, _ = np.linalg.svd(G)
    stresses = U[:, (s > 1e-9 * s[0]).sum() :].T
    at, found = 0, {}
    for joint in scene.joints.values():
        own = slice(at, at + rows[joint.name])
        at = own.stop
        R, p = judge.frame(poses, joint.child)
        moved = joint.child if joint.child.body.name in judge.slot else joint.parent
        k, body = judge.slot[moved.body.name], moved.body
        pushes = stresses[:, own] @ G[own, k : k + 6]
        center = poses[body.name][1] + poses[body.name][0] @ np.asarray(body.com, float)
        force, moment = pushes[:, 3:], pushes[:, :3] + np.cross(center - p, pushes[:, 3:])
        seen = np.hstack([moment @ R, force @ R])
        found[joint.name] = (np.abs(seen).max(axis=0, initial=0.0) < TOUCHED).tolist()
    return len(stresses), found


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", slowly(SCENES))
def test_reactions_are_determined_where_free_bodies_say_so(name: str, kind: str) -> None:
    build, at = SCENES[name]
    scene = build()
    model, q = started(scene, kind, at)
    try:
        poses = {body: np.asarray(model.pose(body, q)) for body in scene.bodies}
    except cd.SolveError as nowhere:
        # formulas of two parallelograms take branches that do not fit together
        assert (name, kind) == ("parallelogram", "closed_form")
        pytest.skip(str(nowhere))
    count, known = self_stresses(scene, {b: (T[:3, :3], T[:3, 3]) for b, T in poses.items()})
    found = model.redundancy(q)
    assert found.redundant == count
    assert len(found.directions) == len(found.vectors) == count
    assert set(found.components) <= set(known)
    for joint, components in known.items():
        # a joint outside of all loops passes no self-stress
        assert list(found.components.get(joint, [True] * 6)) == components, joint
    # one warning marks all that is not determined, by components
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        for joint in known:
            model.reaction(joint, q, np.zeros(model.nu))
    marks = [str(w.message) for w in said if "are not determined" in str(w.message)]
    assert len(marks) == (not all(map(all, known.values())))
    listed = marks[0].split("determined in ")[1].split(": constraints")[0] if marks else ""
    groups = [group.split(" of ") for group in listed.split("; ") if group]
    marked = {name: which for which, names in groups for name in names.split(", ")}
    assert marked == {f"'{n}'": found.released(n) for n in known if not all(known[n])}
    COUNTS[f"{name} {kind}"] = len(known)


def test_enough_reactions_were_judged() -> None:
    """Every joint of the scenes that are shown, in every kind."""
    assert len(SCENES) == 13
    print("joints judged:", COUNTS)
    shown = [COUNTS.get(f"{name} {kind}", 0) for name in SHOWN for kind in KINDS]
    assert not all(shown) or sum(shown) == 3 * (2 + 4 + 4 + 4)


@pytest.mark.slow
@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("name", INSTANCES)
def test_every_joint_that_closes_a_loop_tells_alike(name: str, back: bool) -> None:
    """In joint coordinates and in absolute ones; the float of the load is not a joint of a loop."""
    found = []
    for kind in ("relative", "absolute"):
        try:
            model = cd.compile(cd.derive(machine(INSTANCES[name], True, back), coordinates=kind))
        except cd.DerivationError as refused:
            pytest.skip(str(refused))
        found.append(model.redundancy({"pivot": 0.4}))
    assert found[0].redundant == found[1].redundant
    shared = set(found[0].components) & set(found[1].components)
    assert shared
    for joint in shared:
        assert found[0].components[joint] == found[1].components[joint], joint
