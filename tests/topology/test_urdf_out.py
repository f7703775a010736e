"""Scenes as URDF: read again by cardan and by Pinocchio, with a list of what is not in it."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as xml

import numpy as np
import pytest

import cardan as cd
from cardan.cli.demo import PACKAGE, locate
from cardan.errors import BuildError, ModelWarning
from full_disk import full_disk
from mechanisms import ZOO

ODD = 'a "b" <c> & \u00e9 ]]>'


def branched() -> cd.Scene:
    """Offsets, turned frames, reversed joints, merged bodies, a mimicking joint, odd names."""
    scene = cd.Scene('robot <"&"> \u00e9', gravity=(0, 0, -9.81))
    m, l = scene.parameter("m", 1.5, unit="kg"), scene.parameter("l", 0.4, unit="m")
    inertia = {"xx": 0.02 * m, "yy": 0.03, "zz": 0.04, "xy": 0.001, "xz": -0.002, "yz": 0.003}
    shape = [
        cd.shape.box(0.1, 0.2, l, position=(0, 0, -l / 2), rotation=("XYZ", 0.1, 0.2, 0.3)),
        cd.shape.cylinder(0.02, 0.3, axis="x", color=(1, 0, 0.5)),
        cd.shape.capsule(0.02, 0.3, axis="y"),
        cd.shape.sphere(0.03),
    ]
    base = scene.body("base", mass=2, inertia=(0.1, 0.1, 0.1))
    upper = scene.body("upper", mass=m, com=(0.1, 0, -l / 2), inertia=inertia, shape=shape)
    lower = scene.body(ODD, mass=1, com=(0, 0.02, -0.2), inertia=inertia)
    tool = scene.body("tool", mass=0.3, com=(0, 0, 0.1), inertia=inertia)
    wheel = scene.body("wheel", mass=0.2, inertia=(0.001, 0.002, 0.001))
    slider = scene.body("slider", mass=0.7, inertia=(0.01, 0.01, 0.01))
    scene.joint("foot", cd.Fixed(), scene.ground.at(0.1, 0.2, 0.3), base)
    scene.joint(
        "shoulder",
        cd.Revolute((0.6, 0, 0.8)),
        base.at(0, 0, 0.5, rotation=("ZYX", 0.3, -1.2, 0.7)),
        upper.at(0.05, 0, 0, rotation=("XYZ", 0.4, 0.5, 0.6)),
        limits={"lower": -1, "upper": 2, "speed": 3, "effort": 40},
    )
    # the child is nearer to the ground
    scene.joint("elbow", cd.Revolute("y"), lower.at(0, 0, 0.1), upper.at(0, 0, -l))
    flange = lower.at(0, 0, -0.3, rotation=("XYZ", np.pi / 2, 0.0, 0.1))
    scene.joint("flange", cd.Fixed(), flange, tool)
    scene.joint("gear", cd.Gear("elbow", -2.5, "y", 0.1), tool.at(0, 0.1, 0), wheel)
    scene.joint("rail", cd.Prismatic("-z"), base, slider, limits=(-0.1, 0.2))
    scene.force("bearing", cd.JointDamper("elbow", 0.3 * m))
    tool.at(0, 0, 0.2, rotation=("XYZ", 0, np.pi / 2, 0), name="tip & <end>")
    return scene


def several() -> cd.Scene:
    """Joints with several coordinates."""
    scene = cd.Scene("several", gravity=(0, 0, -9.81))
    inner = scene.ground.at(0, 0, 1)
    kinds = {
        "cardan": cd.Universal("x", (0, 0.6, 0.8)),
        "tube": cd.Cylindrical("y"),
        "plane": cd.Planar("x"),
        "gantry": cd.Translation(),
        "ball": cd.Spherical("ZYX"),
    }
    for k, (name, kind) in enumerate(kinds.items()):
        body = scene.body(f"b{k}", mass=1 + k, com=(0.1, 0, 0.2), inertia=(0.1, 0.2, 0.25))
        scene.joint(name, kind, inner, body)
        inner = body.at(0.1, 0.2, 0.3, rotation=("XYZ", 0.1, 0.2, 0.3))
    return scene


def lone_parameter() -> cd.Scene:
    """A number that was set by its dotted name."""
    scene = cd.Scene("set", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1, com=(0, 0, -1), inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    scene.values |= {"bob.mass": 3.0, "bob.com.z": -0.7}
    return scene


def saved(scene: cd.Scene, path: Path) -> tuple[str, ...]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelWarning)
        return scene.save(path)


def compare(scene: cd.Scene, path: Path) -> cd.CompiledModel:
    """Mass matrix, bias and poses of all bodies and named frames, at random states."""
    one, two = cd.compile(scene), cd.compile(cd.load(path))
    assert two.coordinates == one.coordinates
    # speeds of joints in a row are rates; those of a ball are not
    q, u = one.split(one.random_state(np.random.default_rng(2), (8,)))
    rates = one.qdot(q, u)
    here, there = one.mass_matrix(q), two.mass_matrix(q)
    size = np.abs(here).max()
    if rates.shape == u.shape and np.allclose(rates, u):
        np.testing.assert_allclose(there, here, rtol=0, atol=1e-12 * size)
        bias = one.bias(q, u)
        np.testing.assert_allclose(two.bias(q, u), bias, rtol=0, atol=1e-12 * np.abs(bias).max())
    energy = one.energy(q, u)
    u = rates if rates.shape == u.shape else u
    np.testing.assert_allclose(two.energy(q, u).kinetic, energy.kinetic, rtol=1e-12)
    frames = [*scene.bodies, *(n for n, f in scene.frames.items() if f.named)]
    for name in frames:
        np.testing.assert_allclose(two.pose(name, q), one.pose(name, q), atol=1e-12)
    return two


@pytest.mark.parametrize("make", [branched, several, lone_parameter], ids=lambda f: f.__name__)
def test_scenes_come_back(make: Callable[[], cd.Scene], tmp_path: Path) -> None:
    scene = make()
    path = tmp_path / "robot.urdf"
    losses = saved(scene, path)
    again = compare(scene, path)
    if make is branched:
        assert losses == ()
        # damping acts at the values of the parameters
        assert again.parameters["elbow.damping"] == pytest.approx(0.45)
        joint = cd.load(path).joints["shoulder"]
        assert joint.limits == (-1, 2, 3, 40)
        assert [shape.kind for shape in cd.load(path).bodies["upper"].shapes] == [
            "box", "cylinder", "cylinder", "sphere", "sphere", "sphere",
        ]  # fmt: skip


def test_a_file_that_was_read_is_written_alike(tmp_path: Path) -> None:
    for name in ("acrobat", "panda"):
        try:
            path = locate(name)
        except BuildError as missing:
            pytest.skip(str(missing))
        packages = [parent for parent in path.parents if parent.name == PACKAGE]
        robot = cd.load(path, packages=packages)
        assert robot.save(tmp_path / "one.urdf", strict=True) == ()
        compare(robot, tmp_path / "one.urdf")
        cd.load(tmp_path / "one.urdf", packages=packages).save(tmp_path / "two.urdf", strict=True)
        assert (tmp_path / "one.urdf").read_text() == (tmp_path / "two.urdf").read_text()


TREES = [
    name
    for name, mechanism in ZOO.items()
    if name in ("double_pendulum", "cart_pole", "chain", "spherical_ZYX", "free_quaternion")
]


@pytest.mark.parametrize("name", TREES)
def test_mechanisms_of_the_zoo_come_back(name: str, tmp_path: Path) -> None:
    scene = ZOO[name].build()
    saved(scene, tmp_path / "robot.urdf")
    compare(scene, tmp_path / "robot.urdf")


def test_every_scene_of_the_zoo_is_written_and_read(tmp_path: Path) -> None:
    for name, mechanism in ZOO.items():
        scene = mechanism.build()
        if any(joint.kind.bodiless for joint in scene.joints.values()):
            continue
        path = tmp_path / f"{name}.urdf"
        losses = saved(scene, path)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ModelWarning)
            again = cd.load(path)
        assert set(scene.bodies) <= set(again.bodies), name
        if not losses and scene.joints:
            assert set(cd.compile(again).coordinates) == set(cd.compile(scene).coordinates)


def test_a_loop_is_said_and_read_again(tmp_path: Path) -> None:
    scene = cd.examples["four_bar"]
    losses = saved(scene, tmp_path / "loop.urdf")
    assert any("it closes a loop; <loop_joint> says so" in loss for loss in losses)
    one, two = cd.compile(scene), cd.compile(cd.load(tmp_path / "loop.urdf"))
    driver = one.coordinates[0]
    at = {driver: 0.4706591}
    left, right = (model.assemble(at) for model in (one, two))
    for body in scene.bodies:
        np.testing.assert_allclose(
            one.pose(body, left.q), two.pose(body, right.q), atol=1e-9, err_msg=body
        )


def everything() -> cd.Scene:
    scene = cd.Scene("all", gravity=(0, 0, -1.62))
    body = scene.body("bob", mass=1, inertia=(0.1, 0.1, 0.1))
    far = scene.body("far", mass=1, inertia=(0.1, 0.1, 0.1))
    odd = scene.body("odd", mass=1, inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, body, q0=0.1, limits={"upper": 1})
    scene.joint("ball", cd.Spherical(), body, far)
    scene.joint("screw", cd.Screw("z", 0.01), body, odd)
    scene.force("spring", cd.JointSpring("pivot", 3.0))
    scene.force("drag", cd.JointDamper("pivot", scene.u("pivot") ** 2))
    scene.force("push", cd.JointForce("pivot", scene.input("drive", 0.3)))
    scene.output("height", body.position()[2])
    scene.settings = {"t": 3.0}
    return scene


LOSSES = (
    "joint 'pivot' (revolute): its initial values",
    "joint 'pivot': a limit on one side alone",
    "joint 'ball' (spherical): its coordinates; three joints about x, y, z",
    "joint 'screw' (screw): its motion; it is fixed in the file",
    "gravity (0, 0, -1.62)",
    "force 'spring' (joint_spring)",
    "force 'drag' (joint_damper)",
    "force 'push' (joint_force)",
    "input 'drive'",
    "output 'height'",
    "how it is simulated: t",
)


def test_what_urdf_cannot_say_is_listed_or_refused(tmp_path: Path) -> None:
    scene, path = everything(), tmp_path / "all.urdf"
    with pytest.raises(cd.ModelError, match=r"URDF cannot say 11 things of 'all'") as refused:
        scene.save(path, strict=True)
    assert not path.exists()
    with pytest.warns(ModelWarning, match=r"does not say 11 things of 'all'.*save\(\) returns"):
        losses = scene.save(path)
    assert len(losses) == len(LOSSES)
    for loss in LOSSES:
        assert any(said.startswith(loss) for said in losses), loss
        assert loss in str(refused.value)


def test_beams_and_events_are_named(tmp_path: Path) -> None:
    scene = cd.Scene("bent", gravity=(0, 0, -9.81))
    steel = cd.material(E=2e9, nu=0.3, rho=2000)
    tip = scene.body("tip", mass=0.2, pose=(1, 0, 0))
    scene.beam("rod", scene.ground, tip, cd.section.circle(0.01), steel, elements=2)
    scene.force("hit", cd.Event(tip.position()[2] + 0.1))
    losses = saved(scene, tmp_path / "bent.urdf")
    assert {"beam 'rod'", "force 'hit' (event)"} <= set(losses)
    assert "tip" in cd.load(tmp_path / "bent.urdf").bodies


def test_endings_and_disks(tmp_path: Path) -> None:
    scene = branched()
    with pytest.raises(cd.ModelError, match=r"\.yaml, \.yml, \.urdf, not '\.udrf'.*\.urdf\?"):
        scene.save(tmp_path / "robot.udrf")
    path = tmp_path / "robot.urdf"
    path.write_text("old")
    with full_disk(1000), pytest.raises(cd.ModelError, match="Make room"):
        scene.save(path)
    assert path.read_text() == "old"


def test_names_are_escaped(tmp_path: Path) -> None:
    saved(branched(), tmp_path / "robot.urdf")
    root = xml.parse(tmp_path / "robot.urdf").getroot()
    assert root.get("name") == 'robot <"&"> \u00e9'
    names = [link.get("name") for link in root.findall("link")]
    assert {ODD, "tip & <end>"} <= set(names)
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("make", [branched, lone_parameter], ids=lambda f: f.__name__)
def test_pinocchio_reads_the_same(make: Callable[[], cd.Scene], tmp_path: Path) -> None:
    pinocchio: Any = pytest.importorskip("pinocchio")
    scene = make()
    path = tmp_path / "robot.urdf"
    saved(scene, path)
    # it leaves mimicking joints free and damping out
    model = cd.compile(cd.load(path, mimic="free"))
    damping = {name: 0.0 for name in model.parameters if name.endswith(".damping")}
    model = model.with_parameters(damping) if damping else model
    peer = pinocchio.buildModelFromUrdf(str(path))
    data = peer.createData()
    joints = [int(peer.getJointId(name)) for name in model.coordinates]
    assert peer.nv == model.nu
    places = [peer.idx_vs[j] for j in joints]
    rng = np.random.default_rng(3)
    for _ in range(5):
        q, u, tau = rng.uniform(-1, 1, (3, model.nu))
        at, speed, torque = np.zeros(peer.nq), np.zeros(peer.nv), np.zeros(peer.nv)
        for j, x in zip(joints, q, strict=True):
            entries = [np.cos(x), np.sin(x)] if peer.nqs[j] == 2 else [x]
            at[peer.idx_qs[j] : peer.idx_qs[j] + len(entries)] = entries
        speed[places], torque[places] = u, tau
        M = pinocchio.crba(peer, data, at)
        M = np.triu(M) + np.triu(M, 1).T
        ours = model.mass_matrix(q)
        np.testing.assert_allclose(M[np.ix_(places, places)], ours, atol=1e-10 * np.abs(ours).max())
        bias = pinocchio.nonLinearEffects(peer, data, at, speed)[places]
        np.testing.assert_allclose(bias, model.bias(q, u), atol=1e-10 * np.abs(bias).max())
        pinocchio.framesForwardKinematics(peer, data, at)
        for name in (*scene.bodies, *(n for n, f in scene.frames.items() if f.named)):
            there = data.oMf[peer.getFrameId(name)].homogeneous
            np.testing.assert_allclose(model.pose(name, q), there, atol=1e-10)
