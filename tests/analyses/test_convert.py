"""States in coordinates and speeds of Pinocchio and MuJoCo: every kind of joint, there and back."""

from __future__ import annotations

import types
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

import cardan as cd
from mechanisms.robots import folder
from spread import some

SEED = 7
EPS = float(np.finfo(float).eps)
KINDS: dict[str, Any] = {
    "revolute": cd.Revolute("y"),
    "prismatic": cd.Prismatic("x"),
    "screw": cd.Screw("z", pitch=0.1),
    "universal": cd.Universal("x", "y"),
    "cylindrical": cd.Cylindrical("z"),
    "planar": cd.Planar("z"),
    "translation": cd.Translation(),
    "spherical": cd.Spherical(),
    "free": cd.Free(),
}
NOT_IN = {"pinocchio": {"cylindrical"}, "mujoco": {"screw"}}
FUNCTIONS = ("pose", "velocity", "mass_matrix", "bias")


def chain(*kinds: str, **couple: Any) -> cd.Scene:
    """Bodies one after the other, joints named after their kinds."""
    scene = cd.Scene("chain")
    parent: Any = scene.ground
    for k, kind in enumerate(kinds):
        body = scene.body(f"b{k}", 1 + 0.3 * k, (0.1, 0.2 * k, -0.3), (0.4, 0.5, 0.6))
        scene.joint(kind, KINDS[kind], parent, body)
        parent = body.at(0.3, 0, -0.2)
    return scene


def states(model: cd.CompiledModel, *shape: int) -> tuple[np.ndarray, np.ndarray]:
    return model.split(model.random_state(SEED, shape))


CHAIN = tuple(kind for kind in KINDS if kind != "free")


@pytest.mark.parametrize("program", NOT_IN)
def test_there_and_back(program: str) -> None:
    kinds = [kind for kind in ("free", *CHAIN) if kind not in NOT_IN[program]]
    model = cd.compile(chain(*kinds), functions=("pose",))
    q, u = states(model, 3, 2)
    there = getattr(cd.convert, f"to_{program}")(model, q, u)
    back = getattr(cd.convert, f"from_{program}")(model, *there)
    assert_allclose(back[0], q, atol=8 * EPS)
    assert_allclose(back[1], u, atol=8 * EPS)
    # one state, no speeds, and speeds that broadcast
    alone = getattr(cd.convert, f"to_{program}")(model, q[1, 0])
    assert_allclose(alone, there[0][1, 0], rtol=0, atol=0)
    several = getattr(cd.convert, f"to_{program}")(model, q[1, 0], u)[1]
    assert several.shape == there[1].shape
    assert_allclose(several[1, 0], there[1][1, 0], rtol=0, atol=4 * EPS)


def test_layouts_by_hand() -> None:
    model = cd.compile(chain("free"), functions=("pose",))
    # a quarter turn about z: x of the body is y of the ground
    half = np.sqrt(0.5)
    q, u = [half, 0, 0, half, 1, 2, 3], [0.1, 0.2, 0.3, 4, 5, 6]
    q_pin, v = cd.convert.to_pinocchio(model, q, u)
    assert_allclose(q_pin, [1, 2, 3, 0, 0, half, half])
    assert_allclose(v, [5, -4, 6, 0.1, 0.2, 0.3], atol=4 * EPS)
    qpos, qvel = cd.convert.to_mujoco(model, q, u)
    assert_allclose(qpos, [1, 2, 3, half, 0, 0, half])
    assert_allclose(qvel, [4, 5, 6, 0.1, 0.2, 0.3])


def pinocchio_joint(pin: Any, kind: str) -> Any:
    return {
        "revolute": pin.JointModelRY,
        "prismatic": pin.JointModelPX,
        "screw": lambda: pin.JointModelHZ(0.1),
        "universal": lambda: pin.JointModelUniversal(np.eye(3)[0], np.eye(3)[1]),
        "planar": pin.JointModelPlanar,
        "translation": pin.JointModelTranslation,
        "spherical": pin.JointModelSpherical,
        "free": pin.JointModelFreeFlyer,
    }[kind]()


def pinocchio_chain(pin: Any, *kinds: str) -> Any:
    model, parent = pin.Model(), 0
    for k, kind in enumerate(kinds):
        place = pin.SE3(np.eye(3), np.array([0.3, 0, -0.2] if k else [0, 0, 0.0]))
        parent = model.addJoint(parent, pinocchio_joint(pin, kind), place, kind)
        com, moments = np.array([0.1, 0.2 * k, -0.3]), np.diag([0.4, 0.5, 0.6])
        model.appendBodyToJoint(parent, pin.Inertia(1 + 0.3 * k, com, moments), pin.SE3.Identity())
    return model


def same_mechanics_as_pinocchio(pin: Any, model: cd.CompiledModel, peer: Any) -> None:
    """Poses and velocities of bodies, M and bias forces at converted states."""
    data = peer.createData()
    for seed in range(3):
        q, u = model.split(model.random_state(SEED + seed))
        theirs, v = cd.convert.to_pinocchio(model, q, u, peer=peer)
        pin.forwardKinematics(peer, data, theirs, v)
        for row in model.manifest.joints:
            name = row.name if peer.existJointName(row.name) else "root_joint"
            pose = data.oMi[peer.getJointId(name)]
            assert_allclose(model.pose(row.child, q), pose.homogeneous, atol=1e-13)
            motion = pose.act(data.v[peer.getJointId(name)])
            omega, shift = motion.angular, pose.translation
            velocity = np.append(omega, motion.linear + np.cross(omega, shift))
            assert_allclose(model.velocity(row.child, q, u), velocity, atol=1e-12)
        m = np.array(pin.crba(peer, data, theirs))
        m = np.triu(m) + np.triu(m, 1).T
        x = cd.convert.to_pinocchio(model, q, np.eye(model.nu), peer=peer)[1].T
        assert_allclose(model.mass_matrix(q), x.T @ m @ x, atol=1e-12 * np.abs(m).max())
        # energy says it of both at once
        assert_allclose(
            pin.computeKineticEnergy(peer, data, theirs, v), u @ model.mass_matrix(q) @ u / 2
        )
        back = cd.convert.from_pinocchio(model, theirs, v, peer=peer)
        turns = np.round((back[0] - q) / (2 * np.pi)) * 2 * np.pi
        assert_allclose(back[0] - turns, q, atol=1e-13)
        assert_allclose(back[1], u, atol=1e-13)


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in NOT_IN["pinocchio"]])
def test_pinocchio_joint_by_joint(kind: str) -> None:
    pin = pytest.importorskip("pinocchio")
    kinds = (kind, "prismatic") if kind != "prismatic" else (kind,)
    model = cd.compile(chain(*kinds), functions=FUNCTIONS)
    peer = pinocchio_chain(pin, *kinds)
    same_mechanics_as_pinocchio(pin, model, peer)
    # the rule and names alone give the same
    q, u = states(model)
    expected = np.concatenate(cd.convert.to_pinocchio(model, q, u, peer=peer))
    for names in (None, list(peer.names)):
        assert_allclose(np.concatenate(cd.convert.to_pinocchio(model, q, u, peer=names)), expected)


ROBOTS = {
    "panda_description/urdf/panda.urdf": True,  # fingers that mimic
    "anymal_b_simple_description/robots/anymal.urdf": True,
    "double_pendulum_description/urdf/double_pendulum_continuous.urdf": False,
    "kinova_description/robots/kinova.urdf": False,  # joints of type continuous
}


@pytest.mark.parametrize("name", some(ROBOTS, 3))
def test_robots_of_pinocchio(name: str) -> None:
    pin = pytest.importorskip("pinocchio")
    path, free = str(folder() / name), ROBOTS[name]
    model = cd.compile(
        cd.load(path, base="free" if free else "fixed", snap=False), functions=("pose", "velocity")
    )
    peer = pin.buildModelFromUrdf(path, *[pin.JointModelFreeFlyer()] * free)
    data, (q, u) = peer.createData(), states(model)
    theirs, v = cd.convert.to_pinocchio(model, q, u, peer=peer)
    assert theirs.shape == (peer.nq,)
    assert v.shape == (peer.nv,)
    pin.forwardKinematics(peer, data, theirs, v)
    pin.updateFramePlacements(peer, data)
    for body in model.bodies:
        frame = peer.getFrameId(body, pin.FrameType.BODY)
        assert_allclose(model.pose(body, q), data.oMf[frame].homogeneous, atol=1e-12)
        motion = pin.getFrameVelocity(peer, data, frame, pin.LOCAL_WORLD_ALIGNED)
        assert_allclose(model.velocity(body, q, u), [*motion.angular, *motion.linear], atol=1e-11)
    q_back, u_back = cd.convert.from_pinocchio(model, theirs, v, peer=peer)
    assert_allclose(np.cos(q_back - q), 1, atol=1e-14)
    assert_allclose(u_back, u, atol=1e-13)
    # names in order, and which of them are continuous, suffice
    wheels = [n for n, nq, nv in zip(peer.names, peer.nqs, peer.nvs, strict=True) if nq > nv == 1]
    by_name = cd.convert.to_pinocchio(model, q, peer=list(peer.names), continuous=wheels)
    assert_allclose(by_name, theirs)


def test_errors_name_the_joint() -> None:
    model = cd.compile(chain("free", "revolute", "cylindrical"), functions=("pose",))
    q = states(model)[0]
    with pytest.raises(cd.ArgumentError, match=r"'cylindrical' \(cylindrical\) has no counterpart"):
        cd.convert.to_pinocchio(model, q)
    screw = cd.compile(chain("screw"), functions=("pose",))
    with pytest.raises(cd.ArgumentError, match=r"'screw' .*no counterpart in MuJoCo"):
        cd.convert.to_mujoco(screw, [0.0])
    model = cd.compile(chain("revolute", "prismatic"), functions=("pose",))
    with pytest.raises(cd.ArgumentError, match=r"'prismatic' .*no joint there has its name"):
        cd.convert.to_mujoco(model, [0, 0], peer=["revolute"])
    with pytest.raises(
        cd.ArgumentError, match=r"joint 'revolut' of MuJoCo.*Did you mean 'revolute'"
    ):
        cd.convert.to_mujoco(model, [0, 0], peer=["revolut", "prismatic"])
    with pytest.raises(cd.ArgumentError, match="no revolute joint 'elbow'"):
        cd.convert.to_pinocchio(model, [0, 0], continuous=["elbow"])
    with pytest.raises(cd.ArgumentError, match=r"q has shape \(3,\), expected \(..., 2\)"):
        cd.convert.to_pinocchio(model, [0, 0, 0])
    for wrong in ("revolute", 5, [1, 2]):
        with pytest.raises(cd.ArgumentError, match=r"continuous=.*give the names of joints in a"):
            cd.convert.to_pinocchio(model, [0, 0], continuous=wrong)
    for wrong in ("revolute", [1, 2]):
        with pytest.raises(cd.ArgumentError, match=r"peer=.*give the names of joints in a list"):
            cd.convert.from_mujoco(model, [0, 0], peer=wrong)
    with pytest.raises(cd.ArgumentError, match=r"peer=array|give the model of MuJoCo"):
        cd.convert.from_mujoco(model, [0, 0], peer=np.zeros(2))
    with pytest.raises(cd.ArgumentError, match="give the model of Pinocchio or the names"):
        cd.convert.to_pinocchio(model, [0, 0], peer=3)
    with pytest.raises(cd.ArgumentError, match="first argument is the compiled model"):
        cd.convert.to_pinocchio([0, 0], [0, 0])
    ball = types.SimpleNamespace(
        names=["revolute", "prismatic"], idx_qs=[0, 4], idx_vs=[0, 3], nqs=[4, 1], nvs=[3, 1]
    )
    with pytest.raises(
        cd.ArgumentError, match=r"'revolute' .*counterpart in Pinocchio has 4 and 3"
    ):
        cd.convert.to_pinocchio(model, [0, 0], peer=ball)


def test_order_that_fixed_joints_decide(tmp_path: Path) -> None:
    scene = cd.Scene("fork")
    base, arm, left, right = (scene.body(n, 1, (0, 0, 1), (1, 1, 1)) for n in "abcd")
    scene.joint("root", cd.Revolute("x"), scene.ground, base)
    scene.joint("plate", cd.Fixed(), base, arm)
    scene.joint("z", cd.Revolute("x"), arm, left)
    scene.joint("m", cd.Revolute("x"), base, right)
    model = cd.compile(scene, functions=("pose",))
    with pytest.raises(cd.ArgumentError, match=r"'z', 'm' are on body 'a'.*give peer="):
        cd.convert.to_pinocchio(model, [0, 0, 0])
    q = cd.convert.to_pinocchio(model, [1, 2, 3], peer=["root", "m", "z"])
    assert_allclose(q, [1, 3, 2])


def test_branches_by_rule() -> None:
    scene = cd.Scene("branches")
    bodies = {n: scene.body(n, 1, (0, 0, 1), (1, 1, 1)) for n in "abcd"}
    scene.joint("root", cd.Revolute("x"), scene.ground, bodies["a"])
    scene.joint("right", cd.Revolute("x"), bodies["a"], bodies["b"])
    scene.joint("left", cd.Revolute("x"), bodies["a"], bodies["c"])
    scene.joint("tip", cd.Prismatic("x"), bodies["b"], bodies["d"])
    model = cd.compile(scene, functions=("pose",))
    q = {name: k for k, name in enumerate(model.coordinates)}
    ours = [0.0, 1.0, 2.0, 3.0]
    by_letter = [ours[q[n]] for n in ("root", "left", "right", "tip")]
    as_declared = [ours[q[n]] for n in ("root", "right", "tip", "left")]
    assert_allclose(cd.convert.to_pinocchio(model, ours), by_letter)
    assert_allclose(cd.convert.to_mujoco(model, ours), as_declared)


def test_followers() -> None:
    scene = cd.Scene("hand")
    palm, one, two = (scene.body(n, 1, (0, 0, 1), (1, 1, 1)) for n in ("palm", "one", "two"))
    scene.joint("wrist", cd.Revolute("z"), scene.ground, palm)
    scene.joint("finger", cd.Revolute("x"), palm, one)
    scene.joint("thumb", cd.Revolute("x"), palm, two, couple=("finger", -2.0, 0.1))
    model = cd.compile(scene, functions=("pose",))
    q, v = cd.convert.to_pinocchio(model, [0.5, 0.3], [1, 2], continuous=["thumb"])
    angle = -2 * 0.3 + 0.1
    assert_allclose(q, [0.5, 0.3, np.cos(angle), np.sin(angle)])
    assert_allclose(v, [1, 2, -4])
    back = cd.convert.from_pinocchio(model, q, v, continuous=["thumb"])
    assert_allclose(np.concatenate(back), [0.5, 0.3, 1, 2])
