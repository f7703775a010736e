"""MJCF files at fault, or of strangers: each is refused with its place, or read as what it says."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

import cardan as cd
from cardan.scene.files.mjcf import from_text
from cardan.scene.files.options import Options
from scene.fuzzing import FUZZ
from scene.mjcf_texts import SOLID, linkage, mujoco, one

REFUSED = {
    "root": ("<robot/>", "the root is <robot>, not <mujoco>"),
    "no world": ("<mujoco/>", "there is no <worldbody>"),
    "entities": ('<!DOCTYPE a [<!ENTITY x "y">]><mujoco>&x;</mujoco>', "declares entities"),
    "deep": (mujoco("<body>" * 300 + "</body>" * 300), "nested more than"),
    "free inside": (
        mujoco(f"<body>{SOLID}<joint/><body>{SOLID}<freejoint/></body></body>"),
        "text:1: <freejoint>: a free joint is the only one",
    ),
    "free and more": (one(f"{SOLID}<freejoint/><joint/>"), "is the only one"),
    "world joint": (mujoco("<joint/>"), "the world has no joints"),
    "axis": (one(f'{SOLID}<joint axis="0 0 0"/>'), "its axis has no direction"),
    "type": (one(f'{SOLID}<joint type="screw"/>'), "type='screw' of <joint> is none of hinge"),
    "twice": (one(SOLID, place='euler="0 0 1" quat="1 0 0 0"'), "given by quat and euler"),
    "quaternion": (one(SOLID, place='quat="0 0 0 0"'), "quat has no direction"),
    "global": (one(SOLID, '<compiler coordinate="global"/>'), "coordinate='global' is not read"),
    "sequence": (one(SOLID, '<compiler eulerseq="xyzz"/>'), "not three letters"),
    "size": (one('<geom type="box" size="1 2"/>'), "has 2 numbers, expected 3"),
    "negative": (one('<geom size="-1"/>'), "must be positive"),
    "density": (one('<geom size="1" density="-1"/>'), "density is negative"),
    "ends": (one('<geom type="capsule" size="1" fromto="0 0 0 0 0 0"/>'), "both ends at one point"),
    "mesh": (one('<geom mesh="m"/>'), "whose volume is not read"),
    "inertia": (
        one('<inertial pos="0 0 0" mass="1" fullinertia="1 1 1 0 0 0" quat="1 1 0 0"/>'),
        "fullinertia stands alone",
    ),
    "class": (one(f'{SOLID}<joint class="clas"/>', '<default class="class"/>'), "mean 'class'"),
    "class twice": (
        one(SOLID, '<default><default class="a"/><default class="a"/></default>'), "defined twice",
    ),
    "class unnamed": (one(SOLID, "<default><default/></default>"), "needs a class"),
    "replicate": (mujoco("<replicate count='3'/>"), "bodies would be missing"),
    "body": (
        linkage('<connect body1="c" anchor="0 0 0"/>'),
        "body1 'c' is not a body. Bodies: world",
    ),
    "site": (linkage('<weld site1="sa" site2="sd"/>'), "site2 'sd' is not a site"),
    "joint": (linkage('<joint joint1="jc"/>'), "joint1 'jc' is not a joint"),
    "same": (linkage('<weld body1="a" body2="a"/>'), "same body"),
    "negative mass": (
        one('\n<joint/><inertial pos="0 0 0" mass="-1" diaginertia="1 1 1"/>'),
        "text:1: body 'a': mass is -1.0",
    ),
    "twice named": (
        one(f'{SOLID}<joint name="j"/>\n<body>{SOLID}<joint name="j"/></body>'),
        "text:2: joint 'j': the name is taken",
    ),
    "bodies": (mujoco('<body name="a"/>\n<body name="a"/>'), "text:2: <body> 'a': another body"),
    "sites": (mujoco('<site name="a"/>\n<site name="a"/>'), "text:2: <site> 'a': another site"),
    "endless name": (one(f'{SOLID}<joint name="{"j" * 300}"/>'), "at most 200"),
    "nan": (one(f'{SOLID}<joint pos="nan 0 0"/>'), "not a number"),
    "include": (mujoco('<include file="../x.xml"/>'), "leads out of the declared folders"),
    "include nothing": (mujoco('<include file="x.xml"/>'), "there is no file 'x.xml'"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str, tmp_path: Path) -> None:
    text, words = REFUSED[case]
    with pytest.raises(cd.CardanError) as caught:
        from_text(text, folder=tmp_path)
    assert words in str(caught.value)
    assert len(str(caught.value)) < 700


def test_many_classes_take_no_longer() -> None:
    """Time and memory grow like the file."""
    long = " ".join(f'a{k}="1"' for k in range(20_000))
    classes = "".join(f'<default class="c{k}"><geom size="1"/></default>' for k in range(20_000))
    text = one(SOLID, f"<default><geom {long}/>{classes}</default>")
    began = perf_counter()
    assert len(from_text(text).bodies) == 1
    # quadratic growth would take minutes
    assert perf_counter() - began < 20


@pytest.mark.parametrize("options", [Options(base="free"), Options(mimic="free")])
def test_options_of_urdf_are_refused(options: Options) -> None:
    with pytest.raises(cd.ModelError, match="base= and mimic= are for URDF"):
        from_text(one(SOLID), options)


def test_errors_have_file_and_line(tmp_path: Path) -> None:
    path = tmp_path / "arm.xml"
    path.write_text(mujoco('\n<body name="a">\n<joint name="j" axis="0 0"/>\n</body>'))
    with pytest.raises(cd.ModelError, match=r"^arm.xml:3: <joint> 'j': axis='0 0'"):
        cd.load(path)


def test_the_root_tells_files_apart(tmp_path: Path) -> None:
    for name, text in (("a.xml", one(f"<joint/>{SOLID}")), ("b.mjcf", one(SOLID))):
        (tmp_path / name).write_text(text)
        assert list(cd.load(tmp_path / name).bodies) == ["a"]
    (tmp_path / "c.xml").write_text('<robot name="r"><link name="l"/></robot>')
    assert list(cd.load(tmp_path / "c.xml").bodies) == ["l"]
    (tmp_path / "d.xml").write_text("<x/>")
    with pytest.raises(cd.ModelError, match="the root is <x>; read are <robot>, <mujoco>, <sdf>"):
        cd.load(tmp_path / "d.xml")


def test_included_files_stand_in_place(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text(
        f"<mujoco>\n<body name='b'>{SOLID}<joint axis='0 0 0'/></body></mujoco>"
    )
    path = tmp_path / "whole.xml"
    path.write_text(one(f'{SOLID}<joint/><include file="part.xml"/>'))
    with pytest.raises(cd.ModelError, match=r"^part.xml:2: <joint>: its axis has no direction"):
        cd.load(path)
    (tmp_path / "part.xml").write_text(f"<mujoco><body name='b'>{SOLID}<joint/></body></mujoco>")
    assert list(cd.load(path).bodies) == ["a", "b"]
    path.write_text(one(f'{SOLID}<joint/><include file="part.xml"/><include file="part.xml"/>'))
    with pytest.raises(cd.ModelError, match="included twice"):
        cd.load(path)
    (tmp_path / "part.xml").write_text('<mujoco><include file="whole.xml"/></mujoco>')
    with pytest.raises(cd.ModelError, match="included twice"):
        cd.load(path)


WORDS = st.sampled_from(
    ["0", "1", "-1", "nan", "1e309", "", "0 0 1", "1 2 3 4", "a", "hinge", "1e-320"]
)
NAMES = (
    "pos",
    "quat",
    "axis",
    "type",
    "size",
    "fromto",
    "mass",
    "name",
    "joint1",
    "body1",
    "euler",
)
TAGS = ("body", "joint", "geom", "inertial", "site", "freejoint", "frame", "connect", "equality")


def written(tag: str, given: dict[str, str], inside: list[str]) -> str:
    pairs = " ".join(f'{name}="{word}"' for name, word in given.items())
    return f"<{tag} {pairs}>{''.join(inside)}</{tag}>"


ELEMENTS = st.recursive(
    st.builds(
        written, st.sampled_from(TAGS), st.dictionaries(st.sampled_from(NAMES), WORDS), st.just([])
    ),
    lambda inner: st.builds(
        written,
        st.sampled_from(TAGS),
        st.dictionaries(st.sampled_from(NAMES), WORDS),
        st.lists(inner, max_size=4),
    ),
    max_leaves=12,
)


@FUZZ
@given(st.lists(ELEMENTS, max_size=4).map("".join))
def test_any_file_is_a_model_or_one_of_our_errors(inside: str) -> None:
    found = []
    for _ in range(2):
        try:
            found.append(str(from_text(mujoco(inside))))
        except cd.CardanError as problem:
            found.append(str(problem))
    assert found[0] == found[1]


ACTUATOR = st.builds(
    written,
    st.sampled_from(["motor", "position", "velocity", "general", "muscle", "x"]),
    st.dictionaries(
        st.sampled_from(
            ["joint", "name", "kp", "kv", "gear", "gainprm", "biasprm", "gaintype", "biastype",
             "dyntype", "ctrlrange", "ctrllimited", "class", "timeconst", "tendon"]
        ),
        st.one_of(WORDS, st.sampled_from(["j", "affine", "fixed", "none", "c", "0 1", "1 2 3"])),
    ),
    st.just([]),
)  # fmt: skip


@FUZZ
@given(st.lists(ACTUATOR, max_size=3), st.lists(ACTUATOR, max_size=3))
def test_any_actuators_are_inputs_or_one_of_our_errors(
    defaults: list[str], actuators: list[str]
) -> None:
    classes = f'<default>{"".join(defaults)}<default class="c"/></default>'
    text = one(f'<joint name="j"/>{SOLID}', classes)
    text = text.replace("</mujoco>", f"<actuator>{''.join(actuators)}</actuator></mujoco>")
    found = []
    for _ in range(2):
        try:
            scene = from_text(text)
            assert len(scene.inputs) <= len(actuators)
            found.append(str(scene))
        except cd.CardanError as problem:
            found.append(str(problem))
    assert found[0] == found[1]
