"""MJCF files as we read them and as MuJoCo does: M, bias and accelerations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.scene.files.mjcf import from_text
from scene.mjcf_texts import linkage

mujoco = pytest.importorskip("mujoco", reason="MuJoCo is not installed: pip install mujoco")

SEED, STATES = 5, 8
FUNCTIONS = ("forward_dynamics", "mass_matrix", "bias")
# of numbers that both compute, and of inertias that MuJoCo turns to principal axes: its iteration
# stops where a tensor is diagonal to 1e-12, which leaves its axes turned by about 1e-8
ROUNDING, PRINCIPAL = 1e-12, 1e-7

HINGE = '<joint axis="0.3 1 0.2" pos="0.1 0 0.2"/>'


def one(inside: str, settings: str = "", place: str = 'pos="0.1 0.2 1"') -> str:
    return f"<mujoco>{settings}<worldbody><body {place}>{inside}</body></worldbody></mujoco>"


TREES = {
    "inertial": one(HINGE + '<inertial pos="0.1 0.2 0.3" quat="1 2 3 4" mass="2" '
                    'diaginertia="1 1.2 1.5"/>'),
    "sphere": one(HINGE + '<geom size="0.1" pos="0.2 0.3 0"/>'),
    "box": one(HINGE + '<geom type="box" size="0.1 0.2 0.3" quat="0.7 0.1 0.2 0.3" mass="2"/>'),
    "capsule": one(HINGE + '<geom type="capsule" fromto="0 0 0 0.3 0.1 0.5" size="0.05"/>'),
    "cylinder": one(HINGE + '<geom type="cylinder" size="0.1 0.2" zaxis="1 1 1" pos="0 1 0"/>'),
    "ellipsoid": one(HINGE + '<geom type="ellipsoid" size="0.1 0.2 0.15" xyaxes="1 1 0 0 1 1"/>'),
    "ends of a box": one(HINGE + '<geom type="box" fromto="0 0 0 1 1 0" size="0.1"/>'),
    "euler": one(HINGE + '<geom type="box" size="0.1 0.2 0.3" euler="10 20 30"/>',
                 '<compiler eulerseq="zXy"/>', 'euler="20 -30 40"'),
    "ball": one('<joint type="ball" pos="0 0 0.3"/><geom type="box" size="0.1 0.2 0.3"/>'),
    "free": one('<freejoint/><geom type="box" size="0.1 0.2 0.3" pos="0.1 0 0"/>',
                '<option gravity="1 2 -9"/>', 'pos="1 2 3" euler="10 20 30"'),
    "three joints": one(
        '<joint type="slide" axis="1 0 1" ref="0.1" damping="2" stiffness="10" springref="0.2"/>'
        '<joint axis="0 0 1" pos="0 0.1 0.2" stiffness="3" springref="15" armature="0.3"/>'
        '<joint axis="0 1 0" pos="0.2 0.1 0" ref="40"/>'
        '<geom type="cylinder" size="0.1 0.2" pos="0.3 0 0"/>'),
    "damped free": one('<joint type="free" damping="0.5"/><geom type="box" size="0.1 0.2 0.3"/>'),
    "frames": '<mujoco><worldbody><frame pos="0 1 0" euler="10 20 30"><body pos="1 0 0"><frame '
              'pos="0 0 2" quat="1 1 0 0"><joint axis="1 2 3" pos="0.1 0 0"/><geom type="box" '
              'size="0.1 0.2 0.3"/></frame></body></frame></worldbody></mujoco>',
    "classes": '<mujoco><compiler angle="radian"/><default><joint damping="0.3" axis="0 1 0"/>'
               '<geom density="300"/><default class="heavy"><geom density="3000"/>'
               '<joint armature="0.2" stiffness="2" springref="0.3"/></default></default>'
               '<worldbody><body name="a"><joint/><geom size="0.1" pos="0.2 0 0"/>'
               '<body childclass="heavy" pos="0.3 0 0" axisangle="1 1 0 0.7"><joint/>'
               '<geom size="0.1" pos="0 0.2 0"/><body pos="0 0.3 0"><joint class="main"/>'
               '<geom size="0.1" class="main" pos="0.1 0 0"/></body></body></body></worldbody>'
               "</mujoco>",
}  # fmt: skip
COMBINED = {
    "full inertia": one(HINGE + '<inertial pos="0 0 -0.1" mass="1.5" '
                        'fullinertia="0.1 0.12 0.09 0.01 0.02 -0.01"/>'),
    "two geoms": one(HINGE + '<geom type="capsule" fromto="0 0 0 0.3 0.1 0.5" size="0.05"/>'
                     '<geom type="box" size="0.1 0.2 0.3" quat="0.7 0.1 0.2 0.3" mass="2"/>'),
}  # fmt: skip
CASES = {**dict.fromkeys(TREES, ROUNDING), **dict.fromkeys(COMBINED, PRINCIPAL)}


class Theirs:
    """MuJoCo's model of a file, in our order of coordinates and speeds."""

    def __init__(self, text: str) -> None:
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        self.q: list[int] = []
        self.u: list[int] = []
        for j in range(self.model.njnt):
            kind, q, u = (int(a[j]) for a in (
                self.model.jnt_type, self.model.jnt_qposadr, self.model.jnt_dofadr))  # fmt: skip
            if kind == mujoco.mjtJoint.mjJNT_FREE:
                self.q += [q + 3, q + 4, q + 5, q + 6, q, q + 1, q + 2]
                self.u += [u + 3, u + 4, u + 5, u, u + 1, u + 2]
            else:
                ball = kind == mujoco.mjtJoint.mjJNT_BALL
                self.q += range(q, q + (4 if ball else 1))
                self.u += range(u, u + (3 if ball else 1))

    def at(self, q: np.ndarray, u: np.ndarray) -> Any:
        self.data.qpos[self.q], self.data.qvel[self.u] = q, u
        mujoco.mj_forward(self.model, self.data)
        return self.data

    @property
    def mass_matrix(self) -> np.ndarray:
        columns = np.zeros((self.model.nv, self.model.nv))
        for column, unit in zip(columns, np.eye(self.model.nv), strict=True):
            mujoco.mj_mulM(self.model, self.data, column, unit)
        return columns[np.ix_(self.u, self.u)]


@pytest.mark.parametrize("case", CASES)
def test_trees(case: str) -> None:
    text = {**TREES, **COMBINED}[case]
    ours, theirs = cd.compile(from_text(text), functions=FUNCTIONS), Theirs(text)
    for state in range(STATES):
        q, u = ours.split(ours.random_state(SEED + state))
        data = theirs.at(q, u)
        for what, mine, other in (
            ("mass matrix", ours.mass_matrix(q), theirs.mass_matrix),
            ("bias", ours.bias(q, u), data.qfrc_bias[theirs.u]),
            ("accelerations", ours.forward_dynamics(q, u), data.qacc_smooth[theirs.u]),
        ):
            size = max(1.0, float(np.abs(other).max()))
            error = float(np.abs(mine - other).max()) / size
            assert error <= CASES[case], f"{what}, seed {SEED + state}: {error:.2e}"


PUSHED = (
    '<mujoco><compiler angle="radian"/>{0}<worldbody><body><joint name="a" axis="0 1 0" ref="0.2"/>'
    '<geom type="box" size="0.1 0.2 0.3" pos="0 0.1 0.2"/><body pos="0 0 0.5"><joint name="b" '
    'type="slide" axis="1 0 1"/><geom type="box" size="0.1 0.2 0.1"/></body></body></worldbody>'
    "<actuator>{1}</actuator></mujoco>"
)
ACTUATORS = {
    "motor": ("", '<motor joint="a" gear="3"/><motor jointinparent="b"/>'),
    "position": ("", '<position joint="a" kp="20" kv="2" gear="1.5"/><position joint="b"/>'),
    "velocity": ("", '<velocity joint="a" kv="5"/><velocity joint="b" gear="-2"/>'),
    "general": (
        "",
        '<general joint="a" gainprm="3" biastype="affine" biasprm="1 -2 -0.3"/>'
        '<general joint="b" gaintype="affine" gainprm="3 0.5 0.2" gear="2" biasprm="9 9 9"/>',
    ),
    "classes": (
        '<default><general gear="2" gainprm="7" biastype="affine" biasprm="1 -2 -3"/>'
        '<default class="p"><position kv="4"/></default>'
        '<default class="q"><motor gear="5"/></default></default>',
        '<general joint="a"/><position joint="a"/><velocity joint="a"/><motor joint="a"/>'
        '<position class="p" joint="b"/><position class="p" kp="3" joint="b"/>'
        '<velocity class="p" joint="b"/><general class="p" joint="b"/>'
        '<motor class="q" joint="b"/><general class="q" joint="b"/>',
    ),
}


@pytest.mark.parametrize("case", ACTUATORS)
def test_actuators(case: str) -> None:
    text = PUSHED.format(*ACTUATORS[case])
    ours, theirs = cd.compile(from_text(text), functions=FUNCTIONS), Theirs(text)
    assert ours.nr == theirs.model.nu
    rng = np.random.default_rng(SEED)
    for state in range(STATES):
        q, u = ours.split(ours.random_state(SEED + state))
        control = rng.uniform(-1, 1, ours.nr)
        theirs.data.ctrl[:] = control
        expected = theirs.at(q, u).qacc_smooth[theirs.u]
        error = np.abs(ours.forward_dynamics(q, u, r=control) - expected).max()
        assert error <= ROUNDING * max(1.0, np.abs(expected).max())


# constraints: MuJoCo's give way in proportion to 1 - d, d being what it calls impedance, at most
# 0.9999; it leaves out the derivative of their Jacobian, so that states are at rest

SOFTNESS = (1e-1, 1e-2, 1e-3, 1e-4)
LOOSE = (
    '<body name="c" pos="0.1 0 1.2"><freejoint/>'
    '<inertial pos="0.1 0 0" mass="0.5" diaginertia="0.01 0.02 0.015"/>'
    '<site name="sc" pos="0.05 0.1 0"/></body>'
)
EQUALITIES = {
    "connect": linkage('<connect body1="a" body2="c" anchor="0.2 0.1 1"/>', LOOSE),
    "connect at sites": linkage('<connect site1="sa" site2="sc"/>', LOOSE),
    "weld": linkage('<weld body1="b" body2="c"/>', LOOSE),
    "weld with a pose": linkage('<weld body1="b" body2="c" relpose="0 0.2 1 1 0.3 0 0.1"/>', LOOSE),
    "joint": linkage('<joint joint1="jb" joint2="ja" polycoef="0.1 -1.5"/>'),
    "joint by a curve": linkage('<joint joint1="jb" joint2="ja" polycoef="0.1 0.5 0.7 0 0.2"/>'),
}


@pytest.mark.parametrize("case", EQUALITIES)
def test_constraints_that_harden(case: str) -> None:
    text = EQUALITIES[case].replace('name="b" pos', 'name="b" euler="10 0 40" pos')
    scene = from_text(text)
    ours = cd.compile(scene)
    q = ours.assemble({"ja": 0.3}).q
    udot = ours.forward_dynamics(q, np.zeros(ours.nu))
    q, udot = followed(scene, ours, q), followed(scene, ours, udot, rates=True)
    theirs = Theirs(text)
    theirs.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    theirs.model.opt.iterations, theirs.model.opt.tolerance = 1000, 0.0
    errors = []
    for soft in SOFTNESS:
        theirs.model.eq_solimp[:] = (1 - soft, 1 - soft, 0.001, 0.5, 2)
        data = theirs.at(q, np.zeros_like(udot))
        errors.append(np.abs(data.qacc[theirs.u] - udot).max() / np.abs(udot).max())
    slopes = np.diff(np.log10(errors)) / np.diff(np.log10(SOFTNESS))
    print(f"{case}: errors {errors}, slopes {slopes}")
    # first order, better the harder; the first step is not small yet
    np.testing.assert_allclose(slopes[1:], 1, atol=0.05)
    assert errors[-1] < 1e-2


def followed(
    scene: cd.Scene, ours: cd.CompiledModel, values: np.ndarray, rates: bool = False
) -> np.ndarray:
    """Coordinates, or accelerations, with those of coupled joints, which have no slot of ours."""
    couple = scene.joints["jb"].couple
    if couple is None:
        return values
    leader = values[ours.coordinates.index(couple.leader)]
    return np.array([leader, couple.ratio * leader + (0 if rates else couple.offset)])
