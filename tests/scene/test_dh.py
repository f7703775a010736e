"""Denavit-Hartenberg tables against products of matrices, in both conventions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.errors import ModelError
from table import each

ROWS = [
    {"a": 0.1, "alpha": math.pi / 2, "d": 0.3, "theta": 0.2},
    {"a": 0.4, "alpha": -0.7, "d": 0.0, "theta": -math.pi / 2, "type": "prismatic"},
    {"a": -0.2, "alpha": math.pi, "d": 0.15, "theta": 0.0},
    {"a": 0.0, "alpha": 0.3, "d": -0.1, "theta": 1.1, "type": "prismatic"},
]
Q = np.array([0.5, -0.2, 0.9, 0.35])


def turn(axis: int, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    T = np.eye(4)
    T[i, i], T[i, j], T[j, i], T[j, j] = c, -s, s, c
    return T


def shift(axis: int, length: float) -> np.ndarray:
    T = np.eye(4)
    T[axis, 3] = length
    return T


def product(rows: list[dict[str, Any]], convention: str) -> np.ndarray:
    T = np.eye(4)
    for row, q in zip(rows, Q, strict=True):
        slides = row.get("type") == "prismatic"
        theta, d = row["theta"] + q * (not slides), row["d"] + q * slides
        about_z = turn(2, theta) @ shift(2, d)
        about_x = shift(0, row["a"]) @ turn(0, row["alpha"])
        T = T @ (about_z @ about_x if convention == "standard" else about_x @ about_z)
    return T


def heavy(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [{"mass": 1.0, "inertia": (0.1, 0.1, 0.1), **row} for row in rows]


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_poses(convention: str) -> None:
    model = cd.compile(cd.from_dh(heavy(ROWS), convention))
    expected = product(ROWS, convention)
    np.testing.assert_allclose(model.pose("link4", Q), expected, rtol=0, atol=1e-15 * 10)


def test_both_conventions_describe_one_robot() -> None:
    # the geometry along x belongs to the row before in the standard convention
    modified = [
        {**row, "a": before["a"], "alpha": before["alpha"]}
        for row, before in zip(ROWS, [{"a": 0.0, "alpha": 0.0}, *ROWS[:-1]], strict=True)
    ]
    tool = shift(0, ROWS[-1]["a"]) @ turn(0, ROWS[-1]["alpha"])
    standard = cd.compile(cd.from_dh(heavy(ROWS))).pose("link4", Q)
    other = cd.compile(cd.from_dh(heavy(modified), "modified")).pose("link4", Q)
    np.testing.assert_allclose(other @ tool, standard, rtol=0, atol=1e-14)


def test_symbols() -> None:
    scene = cd.Scene("arm")
    l, alpha = scene.parameter("l", 0.5, unit="m"), scene.parameter("alpha", 0.3, unit="rad")
    from cardan.scene.dh import add_dh

    add_dh(scene, heavy([{"a": l, "alpha": alpha, "d": 2 * l}, {"a": l / 2}]), "modified")
    model = cd.compile(scene)
    q = np.array([0.4, -1.2])
    for values in ({"l": 0.5, "alpha": 0.3}, {"l": 0.7, "alpha": -0.9}):
        T = np.eye(4)
        for (a, angle, d), x in zip(
            [(values["l"], values["alpha"], 2 * values["l"]), (values["l"] / 2, 0.0, 0.0)],
            q,
            strict=True,
        ):
            T = T @ shift(0, a) @ turn(0, angle) @ turn(2, x) @ shift(2, d)
        found = model.with_parameters(values).pose("link2", q)
        np.testing.assert_allclose(found, T, rtol=0, atol=1e-14)


def test_printed_quarter_turns_become_exact_and_are_listed() -> None:
    scene = cd.from_dh(heavy([{"alpha": 1.5708, "a": 0.2}, {"alpha": 1.6}]))
    assert scene.snaps == ["joint 'joint1' alpha: 1.5708 -> pi/2"]
    rotation = cd.compile(scene).pose("link1", [0.0, 0.0])[:3, :3]
    np.testing.assert_array_equal(np.abs(rotation), [[1, 0, 0], [0, 0, 1], [0, 1, 0]])


def test_motors_and_damping() -> None:
    rows = heavy([{"rotor_inertia": 2e-4, "gear_ratio": 100.0, "damping": 0.3, "friction": 1e-3}])
    with_motor = cd.compile(cd.from_dh(rows))
    plain = cd.compile(cd.from_dh(heavy([{}])))
    assert with_motor.mass_matrix([0.1])[0, 0] - plain.mass_matrix([0.1])[0, 0] == pytest.approx(
        2.0
    )
    # viscous friction at the rotor acts ratio^2 times at the joint
    assert with_motor.applied_forces([0.1], [2.0])[0] == pytest.approx(-2.0 * (0.3 + 10.0))


@each(
    ("rows", "convention", "words"),
    [
        ([{"alfa": 1.0}], "standard", "row 1: 'alfa' does not exist.*Did you mean 'alpha'"),
        ([{}, (0, 1, 2)], "standard", "row 2: 3 values"),
        ([{"type": "revolut"}], "standard", "Did you mean 'revolute'"),
        ([{}], "craig", "convention 'craig' does not exist"),
        ([{"mass": -1.0}], "standard", "link1.*mass"),
        ([{"a": float("nan")}], "standard", "nan|finite"),
        ([{"name": "x"}, {"name": "x"}], "standard", "'x'"),
        ([5], "standard", "row 1: 5; give"),
        (5, "standard", "5 is not a table"),
        (["abcd"], "standard", "row 1: 'abcd'; give"),
        ([{"type": []}], "standard", "type is .*; give a text"),
        ([{"theta": "x"}], "standard", "theta is 'x'; give a number"),
        ([{"a": True}], "standard", "a is True; give a number"),
    ],
)
def test_faults(rows: list[Any], convention: str, words: str) -> None:
    with pytest.raises(ModelError, match=words):
        cd.from_dh(rows, convention)


def test_rows_of_four_numbers() -> None:
    scene = cd.from_dh([(0.1, 0.0, 0.2, 0.3)] * 3)
    assert list(scene.joints) == ["joint1", "joint2", "joint3"]
    assert sp.Symbol("unused") not in scene.parameters


def test_the_table_of_a_scene_file_is_the_same_robot() -> None:
    from cardan.scene.dh import Row
    from cardan.scene.files.yaml import keys
    from cardan.scene.files.yaml.reader import from_text

    rows = ", ".join(
        "{" + ", ".join(f"{key}: {value}" for key, value in row.items()) + "}"
        for row in heavy([*ROWS[:2], {"alpha": 1.5708}])
    ).replace("(0.1, 0.1, 0.1)", "[0.1, 0.1, 0.1]")
    scene = from_text(f"cardan: 2\nname: arm\ndh: {{arm: {{rows: [{rows}]}}}}\n")
    assert scene.snaps == ["joint 'arm.joint3' alpha: 1.5708 -> pi/2"]
    poses = [
        cd.compile(made).pose(link, Q[:3])
        for made, link in (
            (scene, "arm.link3"),
            (cd.from_dh(heavy([*ROWS[:2], {"alpha": math.pi / 2}])), "link3"),
        )
    ]
    np.testing.assert_allclose(poses[0], poses[1], rtol=0, atol=1e-15)
    assert {key.name for key in keys.LINK} == set(Row.__dataclass_fields__)
    with pytest.raises(ModelError, match=r"text:2:\d+: dh.arm.rows\[0\].*'alfa'"):
        from_text("cardan: 2\ndh: {arm: {rows: [{alfa: 1}]}}\n")


def test_a_table_may_start_on_a_frame() -> None:
    """Of the ground, or of a body in the middle of a scene."""
    from cardan.scene.files.yaml.reader import from_text

    rows = str(heavy(ROWS[:2])).replace("'", "").replace("(", "[").replace(")", "]")
    place = "at: [0.2, -0.1, 0.4], rotation: [XYZ, 0.1, 0.5, -0.3]"
    text = f"cardan: 2\ndh: {{arm: {{parent: {{body: ground, {place}}}, rows: {rows}}}}}\n"
    there = cd.compile(from_text(text)).pose("arm.link2", Q[:2])
    base = shift(0, 0.2) @ shift(1, -0.1) @ shift(2, 0.4)
    base = base @ turn(0, 0.1) @ turn(1, 0.5) @ turn(2, -0.3)
    alone = cd.compile(cd.from_dh(heavy(ROWS[:2]))).pose("link2", Q[:2])
    np.testing.assert_allclose(there, base @ alone, rtol=0, atol=1e-15)
