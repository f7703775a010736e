"""The <constraint> proposed for URDF: two frames, joined."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.scene.files.urdf import from_text
from scene.test_urdf_loops import PIN, compiled, joint, robot
from table import each


def constraint(
    kind: str = "revolute",
    parent: str = '<parent_origin xyz="0.25 0 0"/><parent_axis xyz="0 0 1"/>',
    child: str = '<child_origin xyz="0.2 0 0"/><child_axis xyz="0 0 1"/>',
    more: str = "",
) -> str:
    return (
        f'<constraint name="C" type="{kind}"><parent link="coupler"/>{parent}'
        f'<child link="rocker"/>{child}{more}</constraint>'
    )


def test_it_closes_the_four_bar_like_a_loop_joint() -> None:
    ours, other = (compiled(from_text(robot(text))) for text in (constraint(), PIN))
    q, u = np.array([0.7, -0.3, 1.1]), np.array([1.0, 2.0, 3.0])
    np.testing.assert_array_equal(ours.constraints(q), other.constraints(q))
    np.testing.assert_array_equal(ours.forward_dynamics(q, u), other.forward_dynamics(q, u))


@each(
    ("kind", "parent", "child", "element"),
    [
        ("revolute", "0 0 1", "0 0 1", cd.Revolute((0, 0, 1))),
        ("continuous", "0 0 1", "0 0 1", cd.Revolute((0, 0, 1))),
        ("prismatic", "0 1 0", "0 2 0", cd.Prismatic((0, 1, 0))),
        ("cylindrical", "0 1 0", "0 1 0", cd.Cylindrical((0, 1, 0))),
        ("planar", "0 1 0", "0 1 0", cd.Planar((0, 1, 0))),
        ("spherical", "0 1 0", "0 0 1", cd.Spherical()),
        ("ball", "0 1 0", "0 0 1", cd.Spherical()),
        ("fixed", "0 1 0", "0 0 1", cd.Fixed()),
        ("universal", "0 1 0", "0 0 1", cd.Universal((0, 1, 0), (0, 0, 1))),
    ],
)
def test_types(kind: str, parent: str, child: str, element: object) -> None:
    axes = (f'<parent_axis xyz="{parent}"/>', f'<child_axis xyz="{child}"/>')
    made = from_text(robot(constraint(kind, *axes))).joints["C"]
    assert made.kind == element
    assert made.cut


@each("kind", ["revolute", "cylindrical", "planar"])
def test_different_axes_are_brought_together(kind: str) -> None:
    """Both axes, each on its link, have the same direction when the joint is closed."""
    one, other = np.array([0.3, -0.5, 0.8]), np.array([-0.7, 0.2, 0.4])
    rpy = [0.4, -0.2, 0.9]
    text = constraint(
        kind,
        f'<parent_axis xyz="{" ".join(map(str, one))}"/>',
        f'<child_origin xyz="0 0 0" rpy="{" ".join(map(str, rpy))}"/>'
        f'<child_axis xyz="{" ".join(map(str, other))}"/>',
    )
    child = from_text(robot(text)).joints["C"].child
    frame = Rotation.from_euler("xyz", child.orientation[1:])
    # the axis has the components of parent_axis in the joint frame
    on_link = frame.apply(one / np.linalg.norm(one))
    expected = Rotation.from_euler("xyz", rpy).apply(other / np.linalg.norm(other))
    np.testing.assert_allclose(on_link, expected, atol=1e-15)


def test_missing_elements() -> None:
    bare = from_text(robot(constraint(parent="", child=""))).joints["C"]
    assert bare.kind == cd.Revolute((1, 0, 0))
    assert (bare.parent.name, bare.child.name) == ("coupler", "rocker")
    parent = '<parent_axis xyz="0 0 1"/>'
    assert from_text(robot(constraint(parent=parent, child=""))).joints["C"].kind.axis == (0, 0, 1)


def test_what_does_not_act_on_it_is_said() -> None:
    notes = from_text(robot(constraint(more="<limit/><mimic/>"))).notes
    assert notes == ["text:2: constraint 'C': limit, mimic does not act on it"]


REFUSED = {
    "no name": (constraint().replace('name="C" ', ""), "<constraint>: <constraint> lacks"),
    "type": (constraint("revolut"), "type 'revolut' closes no loop"),
    "link": (constraint().replace("rocker", "roker"), "child 'roker' is not a link"),
    "missing": (constraint().replace("<child link", "<x link"), "<child link=.../> is missing"),
    "itself": (constraint().replace("rocker", "coupler"), "it joins link 'coupler' to itself"),
    "zero": (constraint(child='<child_axis xyz="0 0 0"/>'), "its child_axis is zero"),
    "prismatic": (
        constraint("prismatic", child='<child_axis xyz="0 1 0"/>'),
        "of a prismatic joint differ",
    ),
    "universal": (constraint("universal", child=""), "needs <child_axis xyz=.../> too"),
    "taken": (constraint().replace('"C"', '"A"'), "a joint has this name"),
    "beside a loop joint": (PIN + constraint(), "a joint has this name"),
    "older": (constraint(more='<predecessor link="a"/>'), "<predecessor> and <successor> are not"),
    "number": (constraint().replace("0.25", "nan"), "'nan' is not a number"),
    "two parents": (joint("C", "coupler", "rocker", "0 0 0"), "or as <constraint>"),
}  # fmt: skip


@each("case", REFUSED)
def test_refused(case: str) -> None:
    text, words = REFUSED[case]
    with pytest.raises(cd.CardanError) as caught:
        from_text(robot(text))
    assert words in str(caught.value)
