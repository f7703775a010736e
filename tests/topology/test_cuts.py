"""Which joint of a circuit is cut, why, and what cannot be."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

import cardan as cd
from cardan.topology.tree import spanning_tree
from mechanisms.closed import four_bar


def cuts(scene: cd.Model) -> dict[str, str]:
    """Cut joint -> reason."""
    return {closing.joint.name: closing.reason for closing in spanning_tree(scene)[1]}


def spring(scene: cd.Model) -> None:
    scene.force("spring", cd.TorsionSpring("C", stiffness=3.0))


def dial(scene: cd.Model) -> None:
    disk = scene.body("disk", mass=1.0, inertia=(1, 1, 1))
    scene.joint("dial", cd.Revolute("z"), scene.ground, disk, couple=("C", 2.0))


def law(scene: cd.Model) -> None:
    scene.force("brake", cd.JointForce("A", -0.2 * scene.u("C")))


def test_without_reason_the_deepest_is_cut() -> None:
    assert list(cuts(four_bar())) == ["C"]


@pytest.mark.parametrize("use", [spring, dial, law])
def test_a_joint_whose_coordinate_is_wanted_is_not_cut(use: Callable[[cd.Model], None]) -> None:
    scene = four_bar()
    use(scene)
    assert "C" not in cuts(scene)
    assert "C" in cd.compile(scene).coordinates


@pytest.mark.parametrize(
    ("use", "reason"),
    [
        (spring, "force 'spring' acts on its coordinate"),
        (dial, "joint 'dial' follows it"),
        (law, "'C.u' stands in an expression"),
    ],
)
def test_cutting_such_a_joint_is_refused(use: Callable[[cd.Model], None], reason: str) -> None:
    scene = cd.Model("bars")
    a, b = scene.body("a", mass=1.0), scene.body("b", mass=1.0)
    scene.joint("A", cd.Revolute("z"), scene.ground, a)
    scene.joint("B", cd.Revolute("z"), a.at(1, 0, 0), b)
    scene.joint("C", cd.Revolute("z"), b.at(1, 0, 0), scene.ground.at(1, 1, 0), cut=True)
    use(scene)
    said = f"joint 'C' (revolute): cut=True, but {reason}; a cut joint has no coordinate. Cut "
    with pytest.raises(cd.TopologyError, match=re.escape(said + "another joint of its circuit")):
        cd.derive(scene)


def test_a_circuit_in_which_every_coordinate_is_wanted() -> None:
    scene = four_bar()
    for name in "ABCD":
        scene.force(f"spring_{name}", cd.TorsionSpring(name, stiffness=1.0))
    said = "of which none can be cut: .*'B': force 'spring_B' acts on its coordinate"
    with pytest.raises(cd.TopologyError, match=said):
        cd.derive(scene)
