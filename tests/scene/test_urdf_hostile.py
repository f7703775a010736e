"""Robots that mean harm: each is refused with its cure or read as what it says."""

from __future__ import annotations

from pathlib import Path

import pytest

import cardan as cd
from cardan.scene.files.urdf import from_text

BOMB = "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10))
LINKS = '<link name="a"/><link name="b"/>'


def robot(inside: str, head: str = "") -> str:
    return f'{head}<robot name="r">{inside}</robot>'


def link(name: str, inside: str = "") -> str:
    return robot(f'<link name="{name}">{inside}</link>')


def mesh(path: str) -> str:
    return link("a", f'<visual><geometry><mesh filename="{path}"/></geometry></visual>')


def weight(value: str) -> str:
    return link("a", f'<inertial><mass value="{value}"/></inertial>')


REFUSED = {
    "laughs": (robot("&a9;", f'<!DOCTYPE r [<!ENTITY a0 "x">{BOMB}]>'), "declares entities"),
    "external": (robot("&x;", '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hosts">]>'), "declares"),
    "parameter": (robot("", '<!DOCTYPE r [<!ENTITY % x SYSTEM "a.dtd"> %x;]>'), "entities"),
    "undeclared": (robot("&x;"), "not XML"),
    "huge": (weight("1e999"), "not a number"),
    "absurd": (weight("1e31"), "not a number"),
    "nan": (weight("nan"), "not a number"),
    "infinite": (weight("-inf"), "not a number"),
    "underscores": (weight("1_0"), "not a number"),
    "long number": (weight("9" * 10**6), "not a number"),
    "negative": (weight("-1"), "must not be negative"),
    "control": (robot('<link name="a\x01"/>'), "not XML"),
    "line": (link("a&#10;b"), "printable"),
    "direction": (link("a\u202eb"), "printable"),
    "bytes": (b'<robot name="\xff"><link name="a"/></robot>', "not XML"),
    "encoding": (b'<?xml version="1.0" encoding="none"?><robot/>', "not XML"),
    "deep": (robot("<link>" * 5000 + "</link>" * 5000), "nested more than"),
    "endless name": (link("a" * 10**6), "at most 200"),
    "climbs": (mesh("../../../etc/passwd"), "leads out"),
    "package climbs": (mesh("package://../../etc/passwd"), "leads out"),
    "climbs inside": (mesh("meshes/../../x.stl"), "leads out"),
    "web": (mesh("http://example.org/a.stl"), "paths are not read"),
    "null": (robot('<link name="\x00"/>'), "not XML"),
    "loop": (robot(LINKS + '<joint name="j" type="fixed"><parent link="a"/><child link="a"/>'
                   "</joint>"), "form a loop"),
    "empty": ("", "not XML"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str, tmp_path: Path) -> None:
    text, words = REFUSED[case]
    with pytest.raises((cd.ModelError, cd.TopologyError), match=words) as caught:
        from_text(text, name="r.urdf", folder=tmp_path)
    assert len(str(caught.value)) < 700


def test_absolute_meshes_are_not_found() -> None:
    scene = from_text(mesh("file:///etc/passwd"), folder=Path("/nonexistent"))
    assert any("not found" in note for note in scene.notes)
