"""Beams in the system graph: nodes, segments, joints at nodes, and what cannot be placed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.api.scene import Scene
from cardan.errors import ModelError, TopologyError
from cardan.topology import System, build
from cardan.topology.beams.beams import quaternion
from mechanisms.flexible import FLEXIBLE
from topology.numbers_of import body_poses, default_q, homogeneous, values

GENERAL = cd.section.general(EA=1e6, GA=1e6, GJ=1e3, EI=1e3, rhoA=1)
FAR = {"rtol": 0, "atol": 1e-14}


def reference_q(system: System) -> list[float]:
    """Coordinates of the reference configuration."""
    q = np.array(default_q(system) or [0.0])
    for joint in system.joints:
        if joint.implicit:
            q[joint.q : joint.q + 7] = joint.q0
    return [float(x) for x in q]


def pose(system: System, frame: int) -> np.ndarray:
    """Pose (4, 4) of a frame in the reference configuration."""
    entry = system.frames[frame]
    x = values(system, (*entry.rotation, *entry.position))
    return body_poses(system, reference_q(system))[entry.body] @ homogeneous(x[:9], x[9:])


def assert_joined(system: System) -> None:
    """Ends of segments lie in their frames, and joints that close loops are closed."""
    for segment in system.segments:
        for frame, k in ((segment.frame_a, 0), (segment.frame_b, -1)):
            wanted = homogeneous(segment.line.rotations[k], segment.line.positions[k])
            np.testing.assert_allclose(pose(system, frame), wanted, **FAR)
    for cut in system.closing:
        gap = np.linalg.inv(pose(system, cut.parent_frame)) @ pose(system, cut.child_frame)
        np.testing.assert_allclose(gap[:3, 3], 0, **FAR)


def names(system: System) -> list[tuple[str, str]]:
    """Bodies with the kinds of their joints."""
    pairs = zip(system.bodies, system.joints, strict=True)
    return [(body.name, joint.element.kind) for body, joint in pairs]


def test_a_cantilever_has_one_node() -> None:
    scene = Scene("m")
    scene.beam("b", scene.ground, (2, 0, 0), GENERAL, elements=4)
    system = build(scene)
    assert names(system) == [("b.end", "free")]
    (joint,), (segment,) = system.joints, system.segments
    assert joint.implicit
    assert joint.name == "b.end"
    assert joint.q0 == (1, 0, 0, 0, 2, 0, 0)
    assert system.frames[segment.frame_b].name == "b.end"
    assert system.frames[segment.frame_a].body == -1
    np.testing.assert_allclose(segment.line.stations, [0, 0.5, 1, 1.5, 2])
    np.testing.assert_allclose(segment.line.positions[:, 0], segment.line.stations)
    np.testing.assert_allclose(segment.line.rotations, np.broadcast_to(np.eye(3), (5, 3, 3)))
    assert_joined(system)


@pytest.mark.parametrize("name", FLEXIBLE)
def test_ends_of_published_problems_lie_where_they_are_joined(name: str) -> None:
    assert_joined(build(FLEXIBLE[name]()))


def test_named_nodes_cut_a_beam_into_segments() -> None:
    scene = Scene("m")
    beam = scene.beam("b", (0, 0, 0), (3, 0, 0), GENERAL, elements=6)
    late, early = beam.at(0.5), beam.at(0.25, name="quarter")
    assert beam.at(0.5) is late
    assert beam.at(0) is beam.start
    assert beam.at(1.0) is beam.end
    system = build(scene)
    assert [f.name for f in system.frames[1:]] == ["b.start", "b.end", "b.at1", "quarter"]
    ends = [(s.frame_a, s.frame_b, s.line.elements) for s in system.segments]
    assert [(system.frames[a].name, system.frames[b].name, n) for a, b, n in ends] == [
        ("b.start", early.name, 2),
        (early.name, late.name, 1),
        (late.name, "b.end", 3),
    ]
    assert len({s.data["EA"] for s in system.segments}) == 1
    assert_joined(system)


@pytest.mark.parametrize(
    ("end", "up", "axes"),
    [
        ((0, 3, 0), None, [(0, 1, 0), (-1, 0, 0), (0, 0, 1)]),
        ((0, 0, 2), None, [(0, 0, 1), (0, 1, 0), (-1, 0, 0)]),
        ((0, 0, -2), None, [(0, 0, -1), (0, 1, 0), (1, 0, 0)]),
        ((1, 0, 0), "y", [(1, 0, 0), (0, 0, -1), (0, 1, 0)]),
        ((1, 0, 0), (5, 0, -1), [(1, 0, 0), (0, -1, 0), (0, 0, -1)]),
        ((3, 0, 4), None, [(0.6, 0, 0.8), (0, 1, 0), (-0.8, 0, 0.6)]),
    ],
)
def test_section_axes(end: Any, up: Any, axes: Any) -> None:
    scene = Scene("m")
    scene.beam("b", (0, 0, 0), end, GENERAL, up=up)
    system = build(scene)
    np.testing.assert_allclose(system.segments[0].line.rotations[3].T, axes, atol=1e-15)
    assert_joined(system)


def test_quaternions_of_rotations() -> None:
    drawn = [*Rotation.random(20, random_state=1), *Rotation.from_euler("xyz", np.pi * np.eye(3))]
    for turned in drawn:
        found = quaternion(turned.as_matrix())
        x, y, z, w = turned.as_quat()
        np.testing.assert_allclose(abs(np.dot(found, (w, x, y, z))), 1, rtol=4e-16 * 4)
        assert found[0] >= 0


def test_sections_of_a_curve_are_not_twisted() -> None:
    scene = Scene("m")
    t = np.linspace(0, 6, 40)
    points = np.stack([np.cos(t), np.sin(t), 0.3 * t], axis=1)
    scene.beam("b", points[0], points[-1], GENERAL, elements=300, line=cd.spline(points))
    system = build(scene)
    r = system.segments[0].line.rotations
    np.testing.assert_allclose(r.transpose(0, 2, 1) @ r, np.broadcast_to(np.eye(3), r.shape), **FAR)
    step = r[:-1].transpose(0, 2, 1) @ r[1:]
    np.testing.assert_allclose(step[:, 2, 1], step[:, 1, 2], **FAR)
    assert_joined(system)


def test_a_body_welded_to_a_node_is_a_part_of_it() -> None:
    scene = Scene("m")
    beam = scene.beam("b", scene.ground, (2, 0, 0), GENERAL)
    scene.joint("weld", cd.Fixed(), beam.end, scene.body("tip", mass=3))
    (body,) = build(scene).bodies
    assert [part.name for part in body.parts] == ["b.end", "tip"]


def test_a_beam_between_bodies_that_joints_place() -> None:
    scene = Scene("m")
    crank = scene.body("crank", mass=1)
    slider = scene.body("slider", mass=1, pose=(3, 0, 0))
    scene.joint("drive", cd.Revolute("y"), scene.ground, crank)
    scene.joint("guide", cd.Prismatic("x"), scene.ground, slider)
    scene.beam("rod", crank.at(0, 0, 1), slider, GENERAL, release_start="ry", release_end="ry")
    system = build(scene)
    kinds = {joint.name: joint.element.kind for joint in system.joints}
    wanted = {"drive": "revolute", "guide": "prismatic"}
    assert kinds == wanted | {"rod.start": "revolute", "rod.end": "revolute"}
    assert not any(joint.implicit for joint in system.joints)
    assert system.structural["rod.start.position.z"] == 1
    assert system.structural["slider.pose.position.x"] == 3
    assert_joined(system)
    np.testing.assert_allclose(system.segments[0].line.positions[[0, -1]], [[0, 0, 1], [3, 0, 0]])


def test_released_ends_have_coordinates(tmp_path: Path) -> None:
    scene = Scene("m")
    beam = scene.beam("b", scene.ground, (1, 0, 0), GENERAL, release_start=("ry",))
    scene.force("soft", cd.JointSpring("b.start", stiffness=10))
    scene.output("angle", scene.q("b.start") + 2 * scene.u("b.start"))
    scene.save(tmp_path / "soft.yaml")
    for one in (scene, cd.load(tmp_path / "soft.yaml")):
        system = build(one)
        (joint,) = (joint for joint in system.joints if not joint.implicit)
        assert (joint.name, joint.element.kind) == ("b.start", "revolute")
        assert system.forces[0].joints == {"joint": system.joints.index(joint)}
        assert values(system, [system.outputs[0].node], q=[3.0] * 8, u=[1.0] * 7) == 5
    with pytest.raises(ModelError, match=r"no such joint.*b\.start"):
        scene.q(beam.end.name)


def test_joints_at_nodes_have_the_axes_of_the_parent() -> None:
    scene = Scene("m")
    beam = scene.beam("b", (1, 0, 0), (1, 2, 0), GENERAL)
    scene.joint("pin", cd.Revolute("z"), scene.ground, beam.start)
    roller = scene.body("roller", mass=1)
    scene.joint("hinge", cd.Revolute("z"), beam.end, roller)
    system = build(scene)
    assert names(system)[0] == ("b.start", "revolute")
    assert_joined(system)
    pin = next(j for j in system.joints if j.name == "pin")
    np.testing.assert_allclose(pose(system, pin.parent_frame), homogeneous(np.eye(3), (1, 0, 0)))
    hinge = next(j for j in system.joints if j.name == "hinge")
    np.testing.assert_allclose(pose(system, hinge.parent_frame)[:3, 0], (0, 1, 0), atol=1e-15)


def test_a_body_with_a_pose_meets_a_node_where_that_is() -> None:
    scene = Scene("m")
    beam = scene.beam("b", scene.ground, (1, 0, 0), GENERAL)
    tip = scene.body("tip", mass=1, pose=((1.5, 0, 0.2), ("XYZ", 0.1, 0.2, 0.3)))
    scene.joint("hinge", cd.Revolute("y"), beam.end, tip)
    system = build(scene)
    hinge = next(j for j in system.joints if j.name == "hinge")
    for frame in (hinge.parent_frame, hinge.child_frame):
        np.testing.assert_allclose(pose(system, frame), homogeneous(np.eye(3), (1, 0, 0)), **FAR)
    number = next(k for k, f in enumerate(system.frames) if f.name == "tip")
    np.testing.assert_allclose(pose(system, number)[:3, 3], (1.5, 0, 0.2), **FAR)


def test_a_corner_is_two_beams() -> None:
    scene = Scene("m")
    first = scene.beam("first", scene.ground, (10, 0, 0), GENERAL, elements=3)
    second = scene.beam("second", first.end, (10, 10, 0), GENERAL, elements=5)
    third = scene.beam("third", first.at(0.5).at(0, 1, 0), second.at(0.4), GENERAL)
    system = build(scene)
    assert second.start is first.end
    assert third.end is second.at(0.4)
    assert [s.name for s in system.segments] == ["first"] * 2 + ["second"] * 2 + ["third"]
    assert_joined(system)


def test_order_of_declaration_does_not_matter() -> None:
    """Beams between bodies that hang on nodes of beams declared later."""
    scene = Scene("m")
    tip = scene.body("tip", mass=1)
    scene.beam("late", tip.at(0, 0, 1), (5, 5, 5), GENERAL)
    base = scene.beam("base", scene.ground, (2, 0, 0), GENERAL)
    scene.joint("hinge", cd.Revolute("y"), tip, base.end)
    system = build(scene)
    assert_joined(system)
    np.testing.assert_allclose(system.segments[0].line.positions[0], (2, 0, 1), **FAR)


def test_circuits_through_nodes_close() -> None:
    scene = Scene("m")
    beam = scene.beam("b", (0, 0, 0), (2, 0, 0), GENERAL)
    crank = scene.body("crank", mass=1)
    scene.joint("A", cd.Revolute("y"), scene.ground, crank)
    scene.joint("B", cd.Revolute("y"), crank.at(2, 0, 0), beam.end)
    scene.joint("C", cd.PointOnPlane("z"), scene.ground, beam.end)
    system = build(scene)
    assert [cut.name for cut in system.cuts] == ["C"]
    assert_joined(system)


def test_bodies_that_only_beams_hold() -> None:
    scene = Scene("m")
    disk = scene.body("disk", mass=1, pose=((1, 0, 1), ("XYZ", 0, 0.5, 0)))
    scene.beam("mast", scene.ground, disk, GENERAL)
    scene.beam("arm", disk.at(0.1, 0, 0), (3, 0, 1), GENERAL)
    system = build(scene)
    assert names(system) == [("disk", "free"), ("arm.end", "free")]
    np.testing.assert_allclose(system.joints[0].q0[4:], (1, 0, 1))
    assert_joined(system)
    # a joint of the user may have the name
    scene.joint("disk", cd.Fixed(), scene.ground, scene.body("other", mass=1))
    assert build(scene).joints[0].name == "disk_"


def test_a_beam_may_fly() -> None:
    scene = Scene("m")
    scene.beam("b", (6, 0, 0), (0, 8, 0), GENERAL)
    system = build(scene)
    assert names(system) == [("b.start", "free"), ("b.end", "free")]
    assert_joined(system)
    (note,) = system.notes
    assert note.startswith("beam 'b' flies: nothing joins it to the ground")
    # one note for all that fly together, none for what hangs on the ground
    scene.beam("c", scene.beams["b"].end, (0, 0, 1), GENERAL)
    held = scene.beam("d", (1, 1, 0), (1, 2, 0), GENERAL)
    scene.joint("pin", cd.Revolute("z"), held.end, scene.ground)
    assert build(scene).notes == (note,)


def test_included_beams_move_with_their_ground() -> None:
    part = Scene("part")
    l = part.parameter("l", 2.0)
    beam = part.beam("b", part.ground, (l, 0, 0), GENERAL, up=(0, 1, 0), elements=2)
    part.beam("c", beam.at(0.5).at(0, 0, 1), (0, 0, 3), GENERAL, line=cd.arc(through=(0, 0, 2)))
    part.force("w", cd.LineLoad(beam, force=(0, 0, -1)))
    scene = Scene("m")
    for k, prefix in enumerate(("left", "right")):
        scene.include(part, prefix, at=scene.ground.at(0, k, 0, rotation=("XYZ", 0, 0, 0.5 * k)))
    system = build(scene)
    assert [s.name for s in system.segments] == [
        "left.b", "left.b", "left.c", "right.b", "right.b", "right.c"
    ]  # fmt: skip
    assert_joined(system)
    turn = np.array([[np.cos(0.5), -np.sin(0.5), 0], [np.sin(0.5), np.cos(0.5), 0], [0, 0, 1]])
    for left, right in zip(system.segments[:3], system.segments[3:], strict=True):
        wanted = left.line.positions @ turn.T + (0, 1, 0)
        np.testing.assert_allclose(right.line.positions, wanted, **FAR)
        np.testing.assert_allclose(right.line.rotations, turn @ left.line.rotations, **FAR)
    assert set(system.structural) >= {"left.l", "right.l"}


def test_what_says_where_beams_are_is_built_in() -> None:
    scene = Scene("m")
    l, m = scene.parameter("l", 2.0), scene.parameter("m", 1.0)
    crank = scene.body("crank", mass=m * l)
    scene.joint("drive", cd.Revolute("y"), scene.ground, crank)
    scene.beam("rod", crank.at(l / 2, 0, 0), (3 * l, 0, 0), GENERAL, elements=1)
    system = build(scene)
    assert system.structural["l"] == 2
    assert "l" not in [parameter.name for parameter in system.parameters]
    assert any("'l'" in note and "beam" in note for note in system.notes)
    assert values(system, [system.bodies[0].mass]) == 2
    np.testing.assert_allclose(system.segments[0].line.positions[:, 0], (1, 6))
    # other values are taken when the equations are made
    np.testing.assert_allclose(build(scene, {"l": 3.0}).segments[0].line.positions[:, 0], (1.5, 9))


def test_loads_and_strains() -> None:
    scene = Scene("m")
    steel = cd.material(E=2e11, nu=0.3, rho=7800, damping=1e-4, expansion=1.2e-5)
    rise = scene.parameter("rise", 50.0, unit="K")
    beam = scene.beam(
        "b", scene.ground, (1, 0, 0), cd.section.circle(0.01), steel,
        temperature=rise, prestrain={"curvature3": 0.2, "stretch": 0.001},
    )  # fmt: skip
    scene.force("one", cd.LineLoad(beam, force=(0, 0, -3), moment=(1, 0, 0)))
    scene.force("two", cd.LineLoad(beam, force=(0, 2, -4)))
    scene.force("three", cd.LineLoad("b", force=(7, 0, 0), follower=True))
    system = build(scene)
    assert system.forces == ()
    data = {name: values(system, entry[2]) for name, entry in system.segments[0].data.items()}
    np.testing.assert_allclose(data["dead_force"], (0, 2, -7))
    np.testing.assert_allclose(data["dead_moment"], (1, 0, 0))
    np.testing.assert_allclose(data["follower_force"], (7, 0, 0))
    np.testing.assert_allclose(data["strain"], (0, 0, 0.2, 0.001 + 50 * 1.2e-5, 0, 0))
    np.testing.assert_allclose(data["damping"], 1e-4)


def test_the_graph_draws_beams() -> None:
    scene = Scene("m")
    beam = scene.beam("<b>", scene.ground, (1, 0, 0), GENERAL, elements=6)
    beam.at(0.5, name="mid")
    scene.joint("pin", cd.Revolute("z"), scene.ground, beam.end)
    view = scene.graph
    assert view.beams == (("beam", "<b>", "ground", "mid", 3), ("beam", "<b>", "mid", "<b>.end", 3))
    assert view.incidence["mid", "mid"] == -1
    assert "beam: ground == mid  [<b>: 3 elements]" in str(view)
    assert '"mid" -> "<b>.end" [label="<b>\\n3 elements", style=bold' in view.dot()
    assert view.svg().count('stroke-width="6"') == len(view.beams) == 2
    assert (view.svg().count("<circle"), view.svg().count("<b>")) == (4, 0)


def test_size_of_the_graph_does_not_depend_on_the_number_of_elements() -> None:
    def made(elements: int) -> System:
        scene = Scene("m")
        scene.beam("b", scene.ground, (1, 0, 0), GENERAL, elements=elements)
        return build(scene)

    few, many = made(2), made(100_000)
    assert len(few.graph.nodes) == len(many.graph.nodes)
    assert many.segments[0].line.elements == 100_000
    assert len(repr(many)) < 1.01 * len(repr(few))
    assert many.segments == made(100_000).segments
    assert many.segments[0].line != made(99_999).segments[0].line


WRONG: dict[str, Any] = {
    "its ends are the same point": lambda s: s.beam("b", s.ground, (0, 0, 0), GENERAL),
    "the same frame for both": lambda s: (
        s.beam("b", s.ground, (1, 0, 0), GENERAL).at(0.5),
        s.beams["b"].at(0.5 + 1e-13),
    ),
    "it is folded: between": lambda s: s.beam(
        "b", s.ground, (0, 1, 0), GENERAL, elements=1, line=cd.arc(through=(1, 0.5, 0))
    ),
    r"up=\(1, 0, 0\) is parallel to the beam at 0 m": lambda s: s.beam(
        "b", s.ground, (2, 0, 0), GENERAL, up="x"
    ),
    "where body 'loose' is": lambda s: s.beam("b", s.ground, s.body("loose"), GENERAL),
    "'knee' .*are 0.5 m apart": lambda s: s.joint(
        "knee", cd.Revolute("y"), s.beam("a", s.ground, (1, 0, 0), GENERAL).end,
        s.beam("b", (1.5, 0, 0), (2, 0, 0), GENERAL).start,
    ),
    "there is no beam 'c'": lambda s: s.force("f", cd.LineLoad("c", force=(0, 0, 1))),
    "'o' is a body, and there is no such beam": lambda s: (s.joint("j", cd.Free(), s.ground,
        s.body("o", mass=1)), s.force("f", cd.LineLoad("o", force=(0, 0, 1)))),
}  # fmt: skip


@pytest.mark.parametrize("words", WRONG)
def test_refusals(words: str) -> None:
    scene = Scene("m")
    WRONG[words](scene)
    assert scene._repr_html_()
    with pytest.raises((ModelError, TopologyError), match=words):
        build(scene)


def test_relative_coordinates_are_refused() -> None:
    scene = Scene("m")
    scene.beam("b", scene.ground, (1, 0, 0), GENERAL)
    with pytest.raises(cd.DerivationError, match=r"beam 'b'.*coordinates='absolute'"):
        cd.derive(scene, coordinates="relative")
