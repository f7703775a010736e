"""Converted states in MuJoCo: poses, velocities, M and bias of every kind of joint."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

import cardan as cd
from cardan.scene.files.mjcf import from_text

mujoco = pytest.importorskip("mujoco", reason="MuJoCo is not installed: pip install mujoco")

SEED = 11
FUNCTIONS = ("pose", "velocity", "mass_matrix", "bias")
HINGE, SLIDE = 'type="hinge" axis', 'type="slide" axis'
INERTIA = '<inertial pos="0.1 0.2 -0.3" mass="1.5" diaginertia="0.4 0.5 0.6"/>'
KINDS: dict[str, tuple[Any, str]] = {
    "revolute": (cd.Revolute("y"), f'<joint name="j" {HINGE}="0 1 0"/>'),
    "prismatic": (cd.Prismatic("x"), f'<joint name="j" {SLIDE}="1 0 0"/>'),
    "universal": (
        cd.Universal("x", "y"),
        f'<joint name="j.angle1" {HINGE}="1 0 0"/><joint name="j.angle2" {HINGE}="0 1 0"/>',
    ),
    "cylindrical": (
        cd.Cylindrical("z"),
        f'<joint name="j.displacement" {SLIDE}="0 0 1"/><joint name="j.angle" {HINGE}="0 0 1"/>',
    ),
    "planar": (
        cd.Planar("z"),
        f'<joint name="j.x" {SLIDE}="1 0 0"/><joint name="j.y" {SLIDE}="0 1 0"/>'
        f'<joint name="j.angle" {HINGE}="0 0 1"/>',
    ),
    "translation": (
        cd.Translation(),
        "".join(f'<joint name="j.{n}" {SLIDE}="{a}"/>' for n, a in (
            ("x", "1 0 0"), ("y", "0 1 0"), ("z", "0 0 1"))),
    ),
    "spherical": (cd.Spherical(), '<joint name="j" type="ball"/>'),
    "free": (cd.Free(), '<freejoint name="j"/>'),
}  # fmt: skip


def same_mechanics(model: cd.CompiledModel, peer: Any, bodies: dict[str, str]) -> None:
    """At converted states: poses, velocities, M and bias forces."""
    data = mujoco.MjData(peer)
    for seed in range(3):
        q, u = model.split(model.random_state(SEED + seed))
        data.qpos[:], data.qvel[:] = cd.convert.to_mujoco(model, q, u, peer=peer)
        mujoco.mj_forward(peer, data)
        for ours, theirs in bodies.items():
            pose, body = model.pose(ours, q), data.body(theirs)
            assert_allclose(pose[:3, 3], body.xpos, atol=1e-13)
            assert_allclose(pose[:3, :3].ravel(), body.xmat, atol=1e-13)
            velocity = np.zeros(6)
            kind = mujoco.mjtObj.mjOBJ_XBODY
            mujoco.mj_objectVelocity(peer, data, kind, body.id, velocity, 0)
            assert_allclose(model.velocity(ours, q, u), velocity, atol=1e-12)
        m = np.zeros((peer.nv, peer.nv))
        for column, unit in zip(m, np.eye(peer.nv), strict=True):
            mujoco.mj_mulM(peer, data, column, unit)
        x = cd.convert.to_mujoco(model, q, np.eye(model.nu), peer=peer)[1].T
        assert_allclose(model.mass_matrix(q), x.T @ m @ x, atol=1e-12)
        # the axes are the same there: X is a permutation, and forces follow it as well
        assert_allclose(model.bias(q, u), x.T @ data.qfrc_bias, atol=1e-11)
        back = cd.convert.from_mujoco(model, data.qpos, data.qvel, peer=peer)
        assert_allclose(back[0], q, atol=1e-14)
        assert_allclose(back[1], u, atol=1e-14)


@pytest.mark.parametrize("kind", KINDS)
def test_joint_by_joint(kind: str) -> None:
    joint, text = KINDS[kind]
    scene = cd.Scene(kind)
    first = scene.body("first", 1.5, (0.1, 0.2, -0.3), (0.4, 0.5, 0.6))
    second = scene.body("second", 1.5, (0.1, 0.2, -0.3), (0.4, 0.5, 0.6))
    scene.joint("j", joint, scene.ground, first)
    scene.joint("k", cd.Revolute("y"), first.at(0.3, 0, -0.2), second)
    peer = mujoco.MjModel.from_xml_string(
        f'<mujoco><worldbody><body name="first">{text}{INERTIA}'
        f'<body name="second" pos="0.3 0 -0.2"><joint name="k" {HINGE}="0 1 0"/>{INERTIA}'
        "</body></body></worldbody></mujoco>"
    )
    model = cd.compile(scene, functions=FUNCTIONS)
    same_mechanics(model, peer, {"first": "first", "second": "second"})


TREE = f"""<mujoco><worldbody>
<body name="cart" pos="1 0 0"><freejoint/>{INERTIA}
  <body name="mast" pos="0 0 1">{INERTIA}
    <body name="flag" pos="0 0 1"><joint name="a flag" type="ball"/>{INERTIA}</body></body>
  <body name="wheel" pos="0.5 0 0"><joint axis="0 1 0"/>{INERTIA}</body></body>
<body name="ball" pos="0 3 0"><freejoint/>{INERTIA}</body>
</worldbody></mujoco>"""


def test_joints_without_names() -> None:
    peer = mujoco.MjModel.from_xml_string(TREE)
    model = cd.compile(from_text(TREE), functions=FUNCTIONS)
    same_mechanics(model, peer, {name: name for name in ("cart", "flag", "wheel", "ball")})
    # the order of an MJCF file is the rule
    q, u = model.split(model.random_state(SEED))
    by_model = np.concatenate(cd.convert.to_mujoco(model, q, u, peer=peer))
    assert_allclose(np.concatenate(cd.convert.to_mujoco(model, q, u)), by_model)
