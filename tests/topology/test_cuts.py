"""Which joint of a loop is cut, why, and what cannot be."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import pytest

import cardan as cd
from cardan.topology.tree import spanning_tree
from mechanisms.closed import four_bar


def cuts(scene: cd.Scene) -> dict[str, str]:
    """Cut joint -> reason."""
    return {closing.joint.name: closing.reason for closing in spanning_tree(scene)[1]}


def spring(scene: cd.Scene) -> None:
    scene.force("spring", cd.JointSpring("C", stiffness=3.0))


def dial(scene: cd.Scene) -> None:
    disk = scene.body("disk", mass=1.0, inertia=(1, 1, 1))
    scene.joint("dial", cd.Revolute("z"), scene.ground, disk, couple=("C", 2.0))


def law(scene: cd.Scene) -> None:
    scene.force("brake", cd.JointForce("A", -0.2 * scene.u("C")))


def test_without_reason_the_deepest_is_cut() -> None:
    assert list(cuts(four_bar())) == ["C"]


@pytest.mark.parametrize("use", [spring, dial, law])
def test_a_joint_whose_coordinate_is_wanted_is_not_cut(use: Callable[[cd.Scene], None]) -> None:
    scene = four_bar()
    use(scene)
    assert "C" not in cuts(scene)
    assert "C" in cd.compile(scene).coordinates


@pytest.mark.parametrize("use", [spring, dial, law])
def test_cut_it_keeps_its_coordinate(use: Callable[[cd.Scene], None]) -> None:
    whole, cut = four_bar(), four_bar()
    cut.joints["C"] = dataclasses.replace(cut.joints["C"], cut=True)
    found = []
    for scene in (whole, cut):
        use(scene)
        model = cd.compile(scene)
        at = model.assemble({"A": 0.5}, u={"A": 2.0}, branch={"D": "+"})
        found.append(dict(zip([*at.coordinates, *at.speeds], [*at.q, *at.u], strict=True)))
        found[-1] |= {f"{n}dot": x for n, x in zip(at.speeds, at.udot, strict=True)}
    assert "C" in cuts(cut)
    for name in ("A", "C", "D", "A.u", "C.u", "D.u", "A.udot", "C.udot", "D.udot"):
        one, other = (each[name] for each in found)
        assert one == pytest.approx(other, rel=1e-10)


def test_a_circuit_in_which_every_coordinate_is_wanted() -> None:
    scene = four_bar()
    for name in "ABCD":
        scene.force(f"spring_{name}", cd.JointSpring(name, stiffness=1.0))
    assert cuts(scene) == {"C": "the coordinates of all joints here are wanted"}
    told = "cut at C (revolute), which keeps its coordinates, as the coordinates of all joints here"
    equations = cd.derive(scene)
    assert told in str(equations)
    assert set(equations.coordinates) == set("ABCD")
    assert not equations.system.notes
