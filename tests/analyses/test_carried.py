"""Joints that close loops with coordinates of their own: what users see of them."""

from __future__ import annotations

import dataclasses
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.explain import facts
from mechanisms.carried import CARRIED
from mechanisms.closed import four_bar

BASE, LIFT, SPEED = 0.05, 0.012, 20.0
ANGLES = np.linspace(0, 2 * math.pi, 24, endpoint=False)
EDGE = [
    ((BASE + LIFT * math.cos(a)) * math.cos(a), (BASE + LIFT * math.cos(a)) * math.sin(a), 0.0)
    for a in ANGLES
]


def cut(scene: cd.Scene, name: str, **changes: Any) -> cd.Scene:
    """The scene with a joint cut."""
    scene.joints[name] = dataclasses.replace(scene.joints[name], cut=True, **changes)
    return scene


def follower(rotation: str = "quaternion") -> cd.Scene:
    """A disc drives a rod that a spring keeps down, by a roller on its edge."""
    scene = cd.Scene("follower", gravity=(0, -9.81, 0))
    disc = scene.body("disc", mass=0.5, com=(0.005, 0, 0), inertia=(2e-4, 2e-4, 4e-4))
    rod = scene.body("rod", mass=0.2, com=(0, 0.05, 0), inertia=(1e-4, 1e-5, 1e-4))
    scene.joint("shaft", cd.Revolute("z"), scene.ground, disc, prescribed=SPEED * cd.t)
    scene.joint("guide", cd.Prismatic("y"), scene.ground, rod)
    scene.joint("roller", cd.PointOnCurve(EDGE, True, rotation), disc, rod, cut=True)
    scene.force("spring", cd.SpringDamper(scene.ground, rod, stiffness=300.0, rest_length=0.02))
    return scene


@pytest.fixture(scope="module")
def run() -> cd.Trajectory:
    model = cd.compile(follower())
    # four turns; at every time a point of the edge is on top
    times = np.linspace(0, 8 * math.pi / SPEED, 97)
    return model.simulate(times, q={"guide": BASE}, rtol=1e-10, atol=1e-12)


def test_a_cam_lifts_its_follower(run: cd.Trajectory) -> None:
    assert run.success, run.message
    lift = BASE + LIFT * np.cos(math.pi / 2 - SPEED * run.t)
    np.testing.assert_allclose(run["guide"], lift, atol=1e-9)
    turns = np.unwrap(2 * np.arctan2(run["roller.qz"], run["roller.qw"]))
    np.testing.assert_allclose(turns, -SPEED * run.t, atol=1e-9)


def test_its_force_moves_the_rod_and_its_drive_does_the_work(run: cd.Trajectory) -> None:
    model = run.model
    change = np.array([model.rhs(t, x) for t, x in zip(run.t, run.x, strict=True)])
    lift = run["guide"]
    upward = change[:, model.nq + model.speeds.index("guide.u")]
    # across the plane both the roller and the bearings hold
    with pytest.warns(cd.SolveWarning, match="translation along z of joint 'roller'"):
        wrench = run.reaction("roller")
    # the axes of the child are those of the ground
    wanted = 0.2 * (upward + 9.81) + 300.0 * (lift - 0.02)
    np.testing.assert_allclose(wrench[:, 4], wanted, rtol=1e-8)
    work, energy = run.work["shaft.motion"], run.energy.total
    np.testing.assert_allclose(energy - energy[0], work, atol=1e-7)


def test_the_run_is_that_of_another_cut(run: cd.Trajectory) -> None:
    scene, start = follower("XYZ"), run["roller.s"][0]
    scene.joints["roller"] = dataclasses.replace(scene.joints["roller"], cut=False)
    other = cd.compile(cut(scene, "guide")).simulate(run.t, q={"roller.s": start}, rtol=1e-10)
    assert other.success, other.message
    np.testing.assert_allclose(other["roller.s"], run["roller.s"], atol=1e-8)


def test_nobody_sees_the_body_that_stands_for_the_joint(run: cd.Trajectory, tmp_path: Path) -> None:
    model, equations = run.model, cd.derive(follower())
    assert model.bodies == ("disc", "rod")
    assert model.joints == ("shaft", "guide", "roller")
    assert not [name for name in model.frames if "carried" in name]
    assert {frame["name"] for frame in facts(equations)["frames"]} == set(model.frames)
    assert not equations.system.notes
    assert "  2 bodies, 6 coordinates, 5 speeds" in str(equations)
    assert "loop of shaft, guide, roller: cut at roller (point_on_curve), which" in str(equations)
    assert "carried" not in run.animate(tmp_path / "run.html").html
    run.save(tmp_path / "run.nc")
    assert cd.load_motion(tmp_path / "run.nc")["roller.s"][-1] == run["roller.s"][-1]
    with pytest.raises(cd.ModelError, match=r"frame 'roller.carried' does not exist"):
        model.pose("roller.carried", run.q[0])


@pytest.mark.parametrize("name", ["cam", "geared", "custom"])
def test_the_judge_says_yes(name: str) -> None:
    joint = {"cam": "edge", "geared": "wheel", "custom": "B"}[name]
    model = cd.compile(cut(CARRIED[name].build(), joint))
    model.prepare("forward_dynamics", "multipliers", "constraint_jacobian")
    told = {check.function: check for check in model.verify().checks}
    assert told["multipliers"].error < 1e-12


def test_its_coordinates_are_assembled_and_drive() -> None:
    model = cd.compile(cut(CARRIED["cam"].build(), "edge"))
    found = model.assemble({"edge.s": 0.2}, u={"edge.u.s": 0.1})
    place = model.pose("edge.child", found.q)[:3, 3]
    rim = model.pose("disc", found.q)
    wanted = model.assemble({"shaft": found["shaft"]})
    assert wanted["edge.s"] == pytest.approx(0.2, abs=1e-12)
    assert np.linalg.norm(rim[:3, :3].T @ place) == pytest.approx(np.linalg.norm(place), abs=1e-12)
    turn = model.sweep("edge.s", [0.15, 0.2, 0.25], start={"edge.s": 0.15})
    assert turn["shaft"][1] == pytest.approx(found["shaft"], abs=1e-10)
    scene = CARRIED["cam"].build()
    cut(scene, "edge", child=scene.bodies["arm"].at(0, 0, -9.0))
    said = r"loop that joint 'edge' closes \('shaft', 'post'\) .* frame 'edge.child' and where"
    with pytest.warns(cd.SolveWarning, match="the loop that 'edge' closes stays open"):
        model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match=said):
        model.assemble({})


DRIVES = {"rigid": {}, "gyroscopic": {"gyroscopic": True}, "elastic": {"stiffness": 50.0}}


@pytest.mark.parametrize("way", [*DRIVES, "prescribed"])
def test_what_drives_a_joint_drives_it_where_it_is_cut(way: str) -> None:
    found = []
    for closing in ("C", "A"):
        scene = four_bar()
        if way == "prescribed":
            moved = 0.5 + 3 * cd.t + sp.sin(cd.t) / 5
            scene.joints["A"] = dataclasses.replace(scene.joints["A"], prescribed=moved)
        else:
            drive = cd.Drive("A", inertia=1e-5, ratio=20.0, torque=0.01, **DRIVES[way])
            scene.force("motor", drive)
        model = cd.compile(cut(scene, closing))
        start = {} if way == "prescribed" else {"A": 0.5}
        motion = model.simulate([0, 0.2, 0.4], q=start, rtol=1e-11, atol=1e-12)
        assert motion.success, motion.message
        wrench = motion.reaction("A")
        found.append(np.concatenate([motion["D"], motion["D.u"], wrench.ravel()]))
        assert set(model.bodies) >= {"crank", "coupler", "rocker"}
    np.testing.assert_allclose(found[0], found[1], rtol=1e-8, atol=1e-8)


def test_files_keep_what_was_written(tmp_path: Path) -> None:
    scene = cut(CARRIED["cam"].build(), "edge")
    scene.save(tmp_path / "cam.yaml")
    text = (tmp_path / "cam.yaml").read_text(encoding="utf-8")
    assert "carried" not in text
    again = cd.load(tmp_path / "cam.yaml")
    assert json.dumps(facts(cd.derive(again))) == json.dumps(facts(cd.derive(scene)))
