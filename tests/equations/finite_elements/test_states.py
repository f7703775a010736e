"""States of nodes by those of joints: steps for kinds of joints, not for bodies."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.equations.finite_elements.element_systems import Cutting
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.equations.kinematics.kinematics import Kinematics
from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from cardan.ir.visits import RepeatedRecursion
from mechanisms import ZOO
from mechanisms.chain import chain, full_chain
from mechanisms.random_trees import large_tree
from table import each


def derived(scene: cd.Scene) -> FiniteElementRecord:
    return cd.derive(scene, coordinates="absolute")


def cuttings(monkeypatch: pytest.MonkeyPatch, scene: cd.Scene) -> int:
    """Number of the small systems that are cut out of a scene."""
    count = 0
    begin = Cutting.__init__

    def counted(self: Cutting, *arguments: object) -> None:
        nonlocal count
        count += 1
        begin(self, *arguments)  # type: ignore[arg-type]

    with monkeypatch.context() as patch:
        patch.setattr(Cutting, "__init__", counted)
        derived(scene)
    return count


def test_the_work_does_not_grow_with_equal_bodies(monkeypatch: pytest.MonkeyPatch) -> None:
    short, long = (derived(chain(n)).state_visits for n in (20, 200))
    assert len(short.steps) == len(long.steps) == 3
    assert [len(s.parts) for s in short.sweeps] == [len(s.parts) for s in long.sweeps]
    assert cuttings(monkeypatch, chain(20)) == cuttings(monkeypatch, chain(200))
    # a tree of eight kinds of joints, whose numbers all differ
    assert cuttings(monkeypatch, large_tree(300)) < 100


def test_members_differ_in_places_and_data_alone() -> None:
    scene = derived(large_tree(60))
    rng = np.random.default_rng(3)
    p = rng.uniform(0.5, 1.5, len(scene.system.parameters))
    for group in scene.groups:
        if group.common is None or group.kind.name.partition("_")[0] != "body":
            continue
        data = np.reshape(evaluate(group.common, {"p": p.tolist()})["data"], (len(group), -1))
        names = [entry.name for entry in scene.system.parameters]
        for name, row in zip(group.members, data, strict=True):
            mass = p[names.index(f"{name}.mass")]
            assert np.any(np.isclose(row, mass, rtol=1e-14))


SCENES = {name: ZOO[name].build for name in ("driven", "gear", "planar", "gripper", "binary")}
SCENES |= {"large tree": lambda: large_tree(40), "full chain": lambda: full_chain(8)}


@pytest.mark.filterwarnings("ignore:.*triangle inequality")
@each("name", SCENES)
def test_nodes_stand_where_the_kinematics_of_the_tree_puts_them(name: str) -> None:
    """SciPy's quaternions of the rotations of all bodies, derived together."""
    scene = derived(SCENES[name]())
    visits, system = scene.state_visits, scene.system
    rng = np.random.default_rng(1)
    at = {b.name: rng.uniform(0.1, 0.9, len(b)).tolist() for b in visits.inputs}
    at["p"] = [entry.value for entry in system.parameters]
    for joint in system.joints:
        if joint.q >= 0 and joint.element.quaternion is not None:
            first = joint.q + joint.element.quaternion
            part = at["q"][first : first + 4]
            at["q"][first : first + 4] = (np.array(part) / np.linalg.norm(part)).tolist()
    found, k = RepeatedRecursion(visits)(at), Kinematics(system)
    q, u = np.array(found["q"]), np.array(found["u"])
    nodes, count = {n: i for i, n in enumerate(scene.places.names)}, 0
    for i, body in enumerate(system.bodies):
        place = nodes.get(f"{body.name}.node", nodes.get(body.name))
        if place is None or scene.places.kinds[scene.places.kind[place]].name != "node":
            continue
        R = k.ground_rotation[i]
        parts = {"R": R, "p": k.ground_position[i], "omega": k.omega[i], "v": R @ k.v[i]}
        outputs = tuple(Output(key, (len(m.nodes),), m.nodes) for key, m in parts.items())
        exact = evaluate(Function("body", k.graph, visits.inputs, outputs), at)
        first, speed = scene.places.q[place], scene.places.u[place]
        turned = Rotation.from_quat(q[first : first + 4], scalar_first=True).as_matrix()
        size = 1 + np.abs(q).max() + np.abs(u).max()
        # rounding of some hundred operations
        close = {"rtol": 0, "atol": 1e-14 * size}
        np.testing.assert_allclose(turned.reshape(-1), exact["R"], **close)
        np.testing.assert_allclose(q[first + 4 : first + 7], exact["p"], **close)
        np.testing.assert_allclose(u[speed : speed + 6], exact["omega"] + exact["v"], **close)
        count += 1
    assert count >= len(system.bodies) - len(system.cuts) - 1
