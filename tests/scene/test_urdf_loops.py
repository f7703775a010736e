"""Joints of a URDF that close loops."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.codegen.fingerprint import fingerprint
from cardan.scene.files.urdf import from_text
from cardan.topology.scene_files import save
from mechanisms.closed import four_bar
from mechanisms.closed_planar import four_bar_angles
from table import each

EPS = float(np.finfo(float).eps)


def link(name: str, length: float) -> str:
    """A box as the mechanisms have it: 1 kg per meter."""
    xx, yy, zz = cd.inertia.box(length, length, 0.02, 0.01)
    return (
        f'<link name="{name}"><inertial><origin xyz="{length / 2} 0 0"/><mass value="{length}"/>'
        f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    )


def joint(name: str, parent: str, child: str, place: str) -> str:
    return (
        f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{place}"/><axis xyz="0 0 1"/></joint>'
    )


def robot(loop: str) -> str:
    """The four-bar of the mechanisms, its last joint still to be written."""
    return (
        f'<robot name="four_bar"><link name="base"/>{link("crank", 0.1)}{link("coupler", 0.25)}'
        f"{link('rocker', 0.2)}{joint('A', 'base', 'crank', '0 0 0')}"
        f"{joint('B', 'crank', 'coupler', '0.1 0 0')}{joint('D', 'base', 'rocker', '0.3 0 0')}"
        f"\n{loop}</robot>"
    )


def loop(inside: str = "", kind: str = "revolute", more: str = "", axis: str = "0 0 1") -> str:
    return (
        f'<loop_joint name="C" type="{kind}"><link1 link="coupler"/><link2 link="rocker">{inside}'
        f'</link2><origin xyz="0.25 0 0"/><axis xyz="{axis}"/>{more}</loop_joint>'
    )


PIN = loop('<origin xyz="0.2 0 0"/>')


def compiled(scene: cd.Scene) -> cd.CompiledModel:
    return cd.compile(scene, functions=("forward_dynamics", "constraints", "constraint_rates"))


def test_a_four_bar_is_that_of_the_mechanisms() -> None:
    read, written = from_text(robot(PIN)), four_bar()
    read.gravity = written.gravity
    ours, other = compiled(read), compiled(written)
    angles = four_bar_angles(0.7)
    q = [angles[name] for name in ours.coordinates]
    assert ours.coordinates == other.coordinates == ("A", "B", "D")
    np.testing.assert_allclose(ours.constraints(q), 0, atol=10 * EPS)
    u = np.zeros(3)
    udot = other.forward_dynamics(q, u)
    np.testing.assert_allclose(ours.forward_dynamics(q, u), udot, rtol=1e-13)


@each(
    ("kind", "more", "element"),
    [
        ("revolute", "", cd.Revolute((0, 0, 1))),
        ("continuous", "", cd.Revolute((0, 0, 1))),
        ("prismatic", "", cd.Prismatic((0, 0, 1))),
        ("planar", "", cd.Planar((0, 0, 1))),
        ("cylindrical", "", cd.Cylindrical((0, 0, 1))),
        ("fixed", "", cd.Fixed()),
        ("spherical", "", cd.Spherical()),
        ("ball", "", cd.Spherical()),
        ("universal", '<axis2 xyz="0 2 0"/>', cd.Universal((0, 0, 1), (0, 1, 0))),
    ],
)
def test_types(kind: str, more: str, element: object) -> None:
    made = from_text(robot(loop(kind=kind, more=more))).joints["C"]
    assert made.kind == element
    assert made.cut


@pytest.mark.parametrize("kind", ["revolute", "fixed", "spherical", "planar"])
def test_frames_coincide_in_the_reference_configuration(kind: str) -> None:
    model = from_text(
        robot(loop(kind=kind).replace('xyz="0.25 0 0"', 'xyz="0.25 0 0" rpy="1 2 3"'))
    )
    child = model.joints["C"].child
    # coupler at 0.1, rocker at 0.3 on the same line
    np.testing.assert_allclose(child.coordinates, [0.05, 0, 0], atol=1e-15)
    turn = Rotation.from_euler("xyz", child.orientation[1:])
    np.testing.assert_allclose(turn.as_matrix(), Rotation.from_euler("xyz", [1, 2, 3]).as_matrix())
    functions = ("constraints",)
    found = cd.compile(model, functions=functions).constraints(np.zeros(3))
    np.testing.assert_allclose(found, 0, atol=1e-15)


def test_a_loop_comes_back_from_a_scene_file(tmp_path: Path) -> None:
    scene = from_text(robot(PIN))
    save(scene, tmp_path / "loop.yaml")
    assert "cut: true" in (tmp_path / "loop.yaml").read_text(encoding="utf-8")
    again = cd.load(tmp_path / "loop.yaml")
    assert again.joints["C"].cut
    assert fingerprint(cd.derive(again)) == fingerprint(cd.derive(scene))


def test_what_does_not_act_on_it_is_said() -> None:
    notes = from_text(robot(loop(more='<limit lower="0" upper="1"/><dynamics damping="1"/>'))).notes
    assert notes == ["text:2: loop joint 'C': limit, dynamics does not act on it"]


REFUSED = {
    "no name": (PIN.replace('name="C" ', ""), "text:2: <loop_joint>: <loop_joint> lacks"),
    "no type": (PIN.replace('type="revolute"', ""), "text:2: loop joint 'C': <loop_joint> lacks"),
    "type": (loop(kind="revolut"), "type 'revolut' closes no loop"),
    "floating": (loop(kind="floating"), "type 'floating' closes no loop"),
    "link": (PIN.replace("rocker", "roker"), "link2 'roker' is not a link"),
    "near": (PIN.replace("rocker", "roker"), "Did you mean 'rocker'?"),
    "missing": (PIN.replace("<link1", "<linkA"), "<link1 link=.../> is missing"),
    "itself": (PIN.replace("rocker", "coupler"), "it joins link 'coupler' to itself"),
    "axis": (loop(axis="0 0 0"), "text:2: loop joint 'C': its axis is zero"),
    "axes": (loop(kind="universal"), "needs <axis2 xyz=.../>"),
    "taken": (PIN.replace('"C"', '"A"'), "a joint has this name"),
    "twice": (PIN + PIN, "a joint has this name"),
    "number": (PIN.replace("0.25", "nan"), "'nan' is not a number"),
    "two parents": (joint("C", "coupler", "rocker", "0 0 0"), "as <loop_joint>"),
}  # fmt: skip


@each("case", REFUSED)
def test_refused(case: str) -> None:
    text, words = REFUSED[case]
    with pytest.raises(cd.CardanError) as caught:
        from_text(robot(text))
    assert words in str(caught.value)
