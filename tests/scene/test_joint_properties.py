"""Limits and dry friction of files act when asked."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.cli import main
from cardan.scene.summary import notes_of

LINK = (
    '<link name="{0}"><inertial><origin xyz="0 0 -0.5"/><mass value="2"/>'
    '<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
)
HINGE = (
    '<joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/>'
    '<axis xyz="{axis}"/><limit lower="{lower}" upper="{upper}" effort="1" velocity="9"/>'
    '<dynamics friction="{friction}"/></joint>'
)
INERTIA = 0.1 + 2 * 0.5**2  # about the hinge along y


@pytest.fixture
def file(tmp_path: Path):
    def write(axis="0 1 0", lower=-1.0, upper=0.8, friction=0.0, more="") -> Path:
        hinge = HINGE.format(axis=axis, lower=lower, upper=upper, friction=friction)
        path = tmp_path / "arm.urdf"
        path.write_text(
            f'<robot name="r">{LINK.format("base")}{LINK.format("arm")}{hinge}{more}</robot>'
        )
        return path

    return write


def test_a_joint_stays_inside_its_limits_and_lies_against_one(file) -> None:
    path = file()
    scene = cd.load(path, limits="stop")
    assert not any("limits are ignored;" in note for note in cd.derive(scene).system.notes)
    motion = cd.compile(scene).simulate(1.5, u={"hinge": 6.0}, rtol=1e-9)
    assert motion["hinge"].max() == pytest.approx(0.8, abs=1e-9)
    # as listed, the limit is passed
    free = cd.compile(cd.load(path)).simulate(1.5, u={"hinge": 6.0}, rtol=1e-9)
    assert free["hinge"].max() > 1.0


def test_a_bounce_off_a_limit_leaves_no_speed(file) -> None:
    motion = cd.compile(cd.load(file(), limits="stop")).simulate(0.2, u={"hinge": 6.0}, rtol=1e-10)
    hit = next(event for event in motion.events if "upper" in event.name)
    # energy of the pendulum up to the stop, by hand
    speed = np.sqrt(36 - 2 * 2 * 9.81 * 0.5 * (1 - np.cos(0.8)) / INERTIA)
    before = motion.at(hit.t - 1e-9)[1]
    assert before == pytest.approx(speed, rel=1e-6)
    after = motion.at(hit.t + 1e-6)[1]
    assert abs(after) < 1e-4


def test_dry_friction_brings_a_joint_to_rest_where_the_book_says(file) -> None:
    """A vertical axis: w^2 I / 2 c of turning, then rest."""
    scene = cd.load(file("0 0 1", -9, 9, friction=0.5), friction=True)
    motion = cd.compile(scene).simulate(2.0, u={"hinge": 3.0}, rtol=1e-10)
    assert motion["hinge"][-1] == pytest.approx(3.0**2 * 0.1 / (2 * 0.5), rel=1e-8)
    assert abs(motion.u[-1, 0]) < 1e-15


def test_a_range_without_zero_starts_in_its_middle(file) -> None:
    scene = cd.load(file(lower=0.5, upper=1.5), limits="stop")
    assert scene.joints["hinge"].q0 == (1.0,)
    assert any("starts at 1" in note for note in scene.notes)
    assert cd.compile(scene).simulate(0.1).success


FOLLOWER = (
    LINK.format("finger")
    + '<joint name="follow" type="revolute"><parent link="arm"/><child link="finger"/>'
    '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
    '<mimic joint="hinge"/></joint>'
)


def test_a_joint_that_follows_another_has_no_stop_of_its_own(file) -> None:
    scene = cd.load(file(more=FOLLOWER), limits="stop", friction=True)
    assert set(scene.forces) == {"hinge.stop"}
    assert any("follow: limits are ignored" in note for note in cd.derive(scene).system.notes)


def test_a_stop_of_a_scene_file_is_not_doubled(tmp_path: Path) -> None:
    scene = cd.Scene("one")
    arm = scene.body("arm", mass=1.0, com=(0, 0, -1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm, limits=(-1, 1))
    scene.force("end", cd.Stop("hinge", upper=1.0))
    scene.save(tmp_path / "one.yaml")
    assert set(cd.load(tmp_path / "one.yaml", limits="stop").forces) == {"end"}


def test_other_words_are_refused(file) -> None:
    with pytest.raises(cd.ModelError, match="limits must be 'note' or 'stop', not 'hard'"):
        cd.load(file(), limits="hard")


def test_the_command_line_lets_them_act(file, capsys) -> None:
    words = ["simulate", str(file(friction=0.1)), "--time", "0.1", "--limits", "stop", "--friction"]
    assert main(words) == 0
    assert "are ignored;" not in capsys.readouterr().err


def test_notes_say_what_cannot_act(file) -> None:
    """Limits of a joint that follows another are ignored, whatever the options say."""
    follower = (
        f"{LINK.format('hand')}"
        '<joint name="wrist" type="revolute"><parent link="arm"/><child link="hand"/>'
        '<axis xyz="0 1 0"/><limit lower="-1" upper="1"/><mimic joint="hinge"/>'
        '<dynamics friction="0.2"/></joint>'
    )
    scene = cd.load(file(friction=0.1, more=follower), limits="stop", friction=True)
    assert set(scene.forces) == {"hinge.stop", "hinge.friction"}
    said = [note for note in notes_of(scene) if "wrist" in note]
    assert said == [
        "joints wrist: friction is ignored on joints that follow others or have several "
        "coordinates",
        "joints wrist: limits are ignored on joints that follow others, are prescribed or have "
        "several coordinates",
    ]
