"""SDF files that mean harm or are at fault: each is refused with its place and its cure."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from time import perf_counter

import pytest

import cardan as cd
from cardan.scene.files.sdf import from_text
from scene.sdf_texts import joint, link, sdf

BOMB = "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10))
AB = link("a") + link("b")


def one(inside: str) -> str:
    return sdf(f'<link name="a">{inside}</link>')


def mesh(uri: str) -> str:
    return one(f'<visual name="v"><geometry><mesh><uri>{uri}</uri></mesh></geometry></visual>')


def axis(inside: str, kind: str = "revolute") -> str:
    return sdf(AB + "\n" + joint("j", "a", "b", kind, inside))


REFUSED = {
    "laughs": (f'<!DOCTYPE r [<!ENTITY a0 "x">{BOMB}]>' + sdf("&a9;"), "declares entities"),
    "external": (
        '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hosts">]>' + sdf("&x;"),
        "declares entities",
    ),
    "deep": (sdf("<model name='m'>" * 5000 + "</model>" * 5000), "nested more than"),
    "version": (sdf(AB, "2.0"), "SDF 2.0 is not read"),
    "version text": (sdf(AB, "one"), "the version of <sdf> is 'one'"),
    "no version": (sdf(AB, ""), "the version of <sdf> is ''"),
    "no model": ('<sdf version="1.7"/>', "0 worlds and 0 models"),
    "two models": (
        f'<sdf version="1.7"><model name="a">{AB}</model><model name="b"/></sdf>',
        "0 worlds and 2 models at its root, but one",
    ),
    "empty world": ('<sdf version="1.7"><world name="w"/></sdf>', "its world has no model"),
    "no links": (sdf(""), "the model has no links"),
    "include": (
        sdf("\n<include><uri>model://sun</uri></include>"),
        "text:2: <include> of 'model://sun' is not read; put its <model> here",
    ),
    "no name": (sdf("\n<link/>"), "text:2: <link> lacks the attribute 'name'"),
    "twice": (sdf(AB + "\n" + link("a")), "text:2: link 'a': the name is taken by a link"),
    "reserved": (sdf(link("__model__")), "the name is reserved"),
    "colons": (sdf(link("a::b")), "the name is reserved"),
    "endless name": (sdf(link("a" * 10**6)), "at most 200"),
    "line": (sdf(link("a&#10;b")), "printable"),
    "mass": (sdf(link("a").replace(">2<", ">-2<")), "must not be negative"),
    "nan": (sdf(link("a").replace(">2<", ">nan<")), "not a number"),
    "huge": (sdf(link("a").replace(">2<", ">1e31<")), "not a number up to"),
    "auto": (one('<inertial auto="true"/>'), "give mass and inertia"),
    "pose": (sdf(link("a", "1 2 3")), "has 3 numbers, expected 6"),
    "quaternion": (
        one('<pose rotation_format="quat_xyzw">0 0 0 0 0 0 0</pose>'),
        "the quaternion of its pose has length 0",
    ),
    "format": (one('<pose rotation_format="rpy">0 0 0 0 0 0</pose>'), "is none of euler_rpy"),
    "relative": (sdf(link("a", "0 0 0 0 0 0", "", "bse")), "relative_to 'bse' does not exist"),
    "near": (sdf(link("base") + link("a", "0 0 0 0 0 0", "", "bse")), "Did you mean 'base'?"),
    "itself": (sdf(link("a", "0 0 0 0 0 0", "", "a")), "its pose is relative to itself"),
    "each other": (
        sdf(link("a", "0 0 0 0 0 0", "", "b") + link("b", "0 0 0 0 0 0", "", "a")),
        "its pose is relative to itself",
    ),
    "attached": (
        sdf(AB + '<frame name="f" attached_to="g"/><frame name="g" attached_to="f"/>'),
        "it is attached to itself",
    ),
    "attached apart": (
        sdf(
            AB
            + '<frame name="f" attached_to="g"><pose relative_to="a"/></frame>'
            + '<frame name="g" attached_to="f"><pose relative_to="a"/></frame>'
        ),
        "it is attached to itself",
    ),
    "placement": (
        sdf(AB + '<model name="n" placement_frame="x">' + link("c") + "</model>"),
        "placement_frame 'x' does not exist",
    ),
    "type": (axis("", "revolut"), "text:2: joint 'j': type 'revolut' is unknown"),
    "gearbox": (axis("", "gearbox"), "type 'gearbox' is not read; couple two joints by <mimic>"),
    "parent": (sdf(AB + joint("j", "aa", "b")), "joint 'j': parent 'aa' does not exist"),
    "child": (sdf(AB + joint("j", "a", "c")), "joint 'j': child 'c' does not exist"),
    "no child": (
        sdf(AB + joint("j", "a", "b").replace("<child>b</child>", "")),
        "joint 'j': <joint> lacks <child>",
    ),
    "same": (sdf(AB + joint("j", "a", "a")), "it joins a link to itself"),
    "world twice": (sdf(AB + joint("j", "world", "world")), "it joins a link to itself"),
    "zero": (axis("<axis><xyz>0 0 0</xyz></axis>"), "its axis is zero"),
    "expressed": (
        axis('<axis><xyz expressed_in="q">0 0 1</xyz></axis>'),
        "expressed_in 'q' does not exist",
    ),
    "axis2": (axis("", "universal"), "needs <axis2> too"),
    "parallel": (
        axis("<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 -1</xyz></axis2>", "universal"),
        "are parallel",
    ),
    "pitch": (axis("", "screw"), "a screw needs <screw_thread_pitch>, meters per turn"),
    "no pitch": (axis("<thread_pitch>0</thread_pitch>", "screw"), "thread_pitch is 0"),
    "flag": (one("<gravity>maybe</gravity>"), "is 'maybe'; write true or false"),
    "mimic": (
        axis('<axis><mimic joint="x"/></axis>'),
        "joint to mimic 'x' does not exist",
    ),
    "climbs": (mesh("../../../etc/passwd"), "leads out"),
    "model climbs": (mesh("model://../../etc/passwd"), "leads out"),
    "web": (mesh("https://example.org/a.stl"), "paths are not read"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str, tmp_path: Path) -> None:
    text, words = REFUSED[case]
    with pytest.raises(cd.CardanError) as caught:
        from_text(text, folder=tmp_path)
    assert words in str(caught.value)
    assert len(str(caught.value)) < 700


def test_long_chains_of_poses_take_no_longer() -> None:
    """Each pose is relative to the one before: time grows like the file, and no recursion."""
    count = 2000
    names = ["root", *(f"f{k}" for k in range(count))]
    frames = "".join(
        f'<frame name="{name}"><pose relative_to="{before}">1 0 0 0 0 0</pose></frame>'
        for before, name in pairwise(names)
    )
    # from the last to the first
    backward = "".join(frames.replace("</frame>", "</frame>\n").splitlines()[::-1])
    began = perf_counter()
    scene = from_text(sdf(backward + link("root")))
    assert scene.frames[f"f{count - 1}"].coordinates == (count, 0, 0)
    assert perf_counter() - began < 20


def test_models_in_models_are_bounded_and_named() -> None:
    depth = 50
    text = "".join(f'<model name="n{k}">' for k in range(depth))
    scene = from_text(sdf(text + link("a") + "</model>" * depth))
    (name,) = scene.bodies
    assert name == ".".join([*(f"n{k}" for k in range(depth)), "a"])


def test_link_and_joint_of_one_name() -> None:
    """Files before 1.7 have them."""
    scene = from_text(sdf(AB + joint("b", "a", "b"), "1.6"))
    assert list(scene.joints) == ["base", "b"]
