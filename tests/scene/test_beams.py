"""Beams as users write them: in Python, in scene files, and what is refused at once."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import cardan as cd
from cardan.errors import ModelError
from cardan.topology import build
from mechanisms.flexible import FLEXIBLE
from scene.scene_schema import schema
from scene.test_scene import assert_same
from scene.test_scene_round_trip import again
from scene.test_scene_schema import document
from table import each

STEEL = {"E": 2.1e11, "nu": 0.3, "rho": 7850}
SECTION = cd.section.circle(0.01)


def frame() -> cd.Scene:
    """Every way to say something about a beam."""
    scene = cd.Scene("frame")
    l, r = scene.parameter("l", 2.0, unit="m"), scene.parameter("r", 10, unit="mm")
    k = scene.parameter("k", 5)
    steel = cd.material(**STEEL, damping=1e-4, expansion=1.2e-5)
    base = scene.body("base", mass=1, pose=(0, 0, 1))
    scene.joint("turn", cd.Revolute("z"), scene.ground, base)
    mast = scene.beam(
        "mast", base.at(0, 0, l / 4), (0, 0, l), cd.section.tube(2 * r, r), steel,
        elements=7, up="-y", inertia="lumped", temperature=3 * k, prestrain={"twist": 0.1},
    )  # fmt: skip
    top = mast.at(0.75, name="top")
    side = mast.at(0.3).at(0.5, 0, 0)
    scene.beam(
        "arc", top, (3, 0, 3), cd.section.rectangle(0.01, 0.02, shear=(0.8, 0.9)), steel,
        line=cd.arc(through=(1, 0, 2.9)), release_start=("ry",), up=(0, 1, 0.5),
    )  # fmt: skip
    points = [(0.5, 0, 1.95), (1, 0.2, 1), (2, 0, 0), (2, -1, 0)]
    scene.beam(
        "wire", (0.5, 0, 1.95), points[-1],
        cd.section.general(EA=1e3, GA=(1e3, 2e3), GJ=1, EI=2, rhoA=k, rhoI=(0.1, 0.2)),
        line=cd.spline(points),
    )  # fmt: skip
    scene.beam("stay", side, (0.5, 0, 4), cd.section.i_beam(0.1, 0.2, 0.01, 0.005), steel)
    scene.force("wind", cd.LineLoad("mast", force=(k, 0, 0)))
    scene.force("twist", cd.LineLoad("arc", moment=(1, 0, 0), follower=True))
    scene.force("pull", cd.Force(scene.beams["stay"].end, (0, 0, 5)))
    scene.output("height", top.position()[2], unit="m")
    return scene


def test_round_trip(tmp_path: Path) -> None:
    scene = frame()
    loaded = again(scene, tmp_path)
    assert_same(scene, loaded)
    assert repr(loaded.beams["mast"]) == "Beam('mast', tube, 7 elements)"
    validator = jsonschema.Draft202012Validator(schema())
    assert not [error.message for error in validator.iter_errors(document(tmp_path / "first.yaml"))]


@pytest.mark.parametrize("name", FLEXIBLE)
def test_published_problems_come_back(name: str, tmp_path: Path) -> None:
    scene = FLEXIBLE[name]()
    assert_same(scene, again(scene, tmp_path))


def test_included_beams_come_back(tmp_path: Path) -> None:
    scene = cd.Scene("two")
    scene.include(frame(), "left", at=scene.ground.at(1, 0, 0))
    assert_same(scene, again(scene, tmp_path))


FILE = """\
cardan: 2
name: crane
parameters:
  reach: {value: 3, unit: m}
bodies:
  load: {mass: 20}
beams:
  boom:
    start: ground
    end: [reach, 0, 0]
    section: {tube: {outer: 0.05, inner: 0.04}}
    material: {E: 2.1e11, nu: 0.3, rho: 7850}
    elements: 6
    nodes: {middle: 0.5}
  jib:
    start: {body: middle, at: [0, 0, 0.1]}
    end: [reach, 1, 1]
    section: {general: {EA: 1, GA: 1, GJ: 1, EI: [1, 2]}}
joints:
  hook: {type: spherical, parent: boom.end, child: load}
forces:
  snow: {type: line_load, beam: boom, force: [0, 0, -100]}
outputs:
  sag: {expression: "position(boom.end).z", unit: m}
simulate: {time: 2, u: {boom.end.u.x: 0.5}}
"""


def read(text: str, folder: Path) -> cd.Scene:
    path = folder / "crane.yaml"
    path.write_text(text, encoding="utf-8")
    return cd.load(path)


def test_scene_file(tmp_path: Path) -> None:
    found = read(FILE, tmp_path)
    made = cd.Scene("crane", gravity=(0, 0, -9.81))
    reach = made.parameter("reach", 3, unit="m")
    load = made.body("load", mass=20)
    tube = cd.section.tube(outer=0.05, inner=0.04)
    boom = made.beam("boom", "ground", (reach, 0, 0), tube, cd.material(**STEEL), elements=6)
    corner = boom.at(0.5, name="middle").at(0, 0, 0.1)
    made.beam("jib", corner, (reach, 1, 1), cd.section.general(EA=1, GA=1, GJ=1, EI=(1, 2)))
    made.joint("hook", cd.Spherical(), boom.end, load)
    made.force("snow", cd.LineLoad(boom, force=(0, 0, -100)))
    made.output("sag", boom.end.position()[2], unit="m")
    assert_same(found, made)
    assert len(build(found).segments) == 3
    assert found.settings["u"] == {"boom.end.u.x": 0.5}


MISTAKES = {
    "tube: {": (
        "pipe: {",
        "11:15: beams.boom.section.pipe: section 'pipe' does not exist. Known: .*tube",
    ),
    "inner: 0.04": ("inner: -1", "11:\\d+: .*inner is -1"),
    "nu: 0.3": ("nu: 3", "12:5: beams.boom.material: .*nu is 3"),
    "elements: 6": ("elements: 0.5", "8:3: .*beam 'boom': elements is 0.5"),
    "start: ground": ("start: grund", "9:5: .*'grund' does not exist.* Did you mean 'ground'"),
    "middle: 0.5": ("middle: 1.5", "8:3: .*beam 'boom': at\\(1.5\\) lies outside"),
    "boom.end, child": ("boom.ned, child", "20:.*'boom.ned' does not exist.*'boom.end'"),
    "[reach, 0, 0]": ("[0, 0, 0]", "8:3: beam 'boom': its ends are the same point"),
    "beam: boom": ("beam: bom", "22:3: force 'snow' \\(line_load\\): there is no beam 'bom'.*boom"),
}


@pytest.mark.parametrize("right", MISTAKES)
def test_mistakes_are_found_with_line_and_column(right: str, tmp_path: Path) -> None:
    wrong, words = MISTAKES[right]
    assert FILE.count(right) == 1
    with pytest.raises(ModelError, match=f"crane.yaml:{words}"):
        build(read(FILE.replace(right, wrong), tmp_path))


def beam(**changes: Any) -> Callable[[cd.Scene], Any]:
    given = {"start": (0, 0, 0), "end": (1, 0, 0), "section": SECTION, **changes}
    given.setdefault("material", cd.material(**STEEL))
    return lambda scene: scene.beam("b", **given)


WRONG: dict[str, Callable[[cd.Scene], Any]] = {
    "elements is 0;": beam(elements=0),
    "elements is 2.5;": beam(elements=2.5),
    "elements; a beam has at most 100000": beam(elements=10**400),
    "elements is True;": beam(elements=True),
    "elements is nan;": beam(elements=float("nan")),
    "elements is inf;": beam(elements=float("inf")),
    "release_start is 3; give directions": beam(start="ground", release_start=3),
    "prestrain is 3; give strains by name": beam(prestrain=3),
    "element \\['helicoidal'\\] does not exist": beam(element=["helicoidal"]),
    "element 'hellinger' does not exist.*'hellinger_reissner'": beam(element="hellinger"),
    "inertia 'lump' does not exist.*'lumped'": beam(inertia="lump"),
    "section is None; give one of cd.section": beam(section=None),
    "material is 'steel'; give cd.material": beam(material="steel"),
    "must say E and nu": beam(material=cd.material(rho=7850)),
    "leave E, nu, G and rho out": beam(section=cd.section.general(EA=1, GA=1, GJ=1, EI=1)),
    "line is 'round'": beam(line="round"),
    "start has 2 entries.*An end is a frame": beam(start=(0, 0)),
    "start 'nowhere' does not exist": beam(start="nowhere"),
    "up is the zero vector": beam(up=(0, 0, 0)),
    "up 'w' is not a direction": beam(up="w"),
    "no direction 'rxx'.*'rx'": beam(start="ground", release_start="rxx"),
    "is not a joint. Known: rx, ry": beam(start="ground", release_start=("x", "ry")),
    "release_end: that end is free": beam(release_end="rx"),
    "prestrain has no 'curvature'": beam(prestrain={"curvature": 1}),
    "temperature is nan": beam(temperature=math.nan),
    "temperature= acts through the expansion": beam(temperature=5),
    "belongs to model 'other'": beam(start=cd.Scene("other").ground),
    "at: a number is wanted, not 'mid'": lambda s: beam()(s).at("mid"),
    "is called 'b.end'": lambda s: beam()(s).at(1, name="tip"),
    "'b.end': the name is taken": lambda s: (s.body("b.end"), beam()(s)),
    "'b.start': the name is taken by a node": lambda s: (beam()(s), s.body("b.start")),
    "beam 'b': the name is taken": lambda s: (beam()(s), beam()(s)),
    "neither|give force=": lambda s: cd.LineLoad("b"),
    "force has 2 entries": lambda s: cd.LineLoad("b", force=(0, 1)),
    r"force is 3.0; give 3 numbers": lambda s: cd.LineLoad("b", force=3.0),
    r"moment\[1\] is nan": lambda s: cd.LineLoad("b", moment=(0, math.nan, 0)),
    r"force\[2\] is inf": lambda s: cd.LineLoad("b", force=(0, 0, math.inf)),
    r"force\[0\] is \[0.0, 0.0": lambda s: cd.LineLoad("b", force=[[0.0, 0.0, 0.0]] * 3),
    r"force\[0\] is 'a'": lambda s: cd.LineLoad("b", force=("a", 0, 0)),
    r"Body\('o'\) is not a beam: give": lambda s: cd.LineLoad(s.body("o"), force=(0, 0, 1)),
    "beam 'b' belongs to model 'other', not to 'm'": lambda s: s.force(
        "load", cd.LineLoad(beam()(cd.Scene("other")), force=(0, 0, 1))
    ),
    "None is not a beam": lambda s: cd.LineLoad(None, force=(0, 0, 1)),
    "follower is True or False, not 1": lambda s: cd.LineLoad("b", force=(0, 0, 1), follower=1),
}


@each("words", WRONG)
def test_refusals(words: str) -> None:
    with pytest.raises(ModelError, match=words):
        WRONG[words](cd.Scene("m"))


def test_an_end_that_is_clamped_is_the_frame_it_is_clamped_to() -> None:
    scene = cd.Scene("m")
    body = scene.body("body", mass=1)
    place = body.at(1, 0, 0)
    made = beam(start=place, end=body)(scene)
    assert (made.start, made.end) == (place, body)
    assert scene.place("who", "b.start") is place
    held = scene.beam(
        "c", place, (3, 0, 0), SECTION, cd.material(**STEEL), release_start=("rx", "ry", "rz")
    )
    assert held.start is not place
    assert held.start.name == "c.start"


def tool(base: str | None, tmp_path: Path) -> cd.CompiledModel:
    """A rod on a hand that stands oblique; from a file where its points are told in the hand."""
    scene = cd.Scene("tool", gravity=(0, 0, 0))
    arm = scene.body("arm", mass=1, inertia=(0.1, 0.1, 0.1))
    scene.joint("turn", cd.Revolute("y"), scene.ground.at(0.1, 0, 0.2), arm)
    hand = scene.body("hand", mass=0.2, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("wrist", cd.Fixed(), arm.at(0.3, 0, 0, rotation=("XYZ", 0.2, 0.5, -0.3)), hand)
    hand.at(0, 0, 0.4, name="tip")
    if base is not None:
        steel, section = cd.material(**STEEL), cd.section.rectangle(0.01, 0.004)
        scene.beam("rod", hand, (0, 0, 0.4), section, steel, elements=2, up="x", base=base)
        scene = again(scene, tmp_path)
    return cd.compile(scene)


def test_points_of_a_beam_are_told_in_axes_of_its_base(tmp_path: Path) -> None:
    rigid, flexible = tool(None, tmp_path), tool("hand", tmp_path)
    for angle in (0.0, 0.7):
        begin = flexible.initial({"turn": angle})
        found = flexible.pose("rod.end", flexible.split(begin)[0])
        tip = rigid.pose("tip", [angle])
        np.testing.assert_allclose(found[:3, 3], tip[:3, 3], atol=1e-12)
        # e1 along z of the hand, e3 along its x
        np.testing.assert_allclose(found[:3, 0], rigid.pose("hand", [angle])[:3, 2], atol=1e-12)
        np.testing.assert_allclose(found[:3, 2], rigid.pose("hand", [angle])[:3, 0], atol=1e-12)


def test_a_free_end_that_moves_says_how_to_place_it() -> None:
    scene = cd.Scene("m")
    hand = scene.body("hand", mass=1)
    scene.joint("turn", cd.Revolute("y"), scene.ground, hand)
    tip = hand.at(0, 0, 0.4)
    with pytest.raises(
        ModelError, match=r"end reads '.*', which moves.*give three numbers and base="
    ):
        beam(start=hand, end=tip.position())(scene)
    with pytest.raises(ModelError, match=r"base is the frame .*; give its body, 'hand'"):
        beam(start=hand, base=tip)(scene)


def test_summary_counts_beams() -> None:
    text = str(frame())
    assert "4 beams" in text
    assert "mast" in text
