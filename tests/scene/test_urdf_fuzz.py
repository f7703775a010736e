"""Any text is a model or one of our errors."""

from __future__ import annotations

import warnings

from hypothesis import given
from hypothesis import strategies as st

from cardan.errors import CardanError
from cardan.scene.files.urdf import Options, from_text
from cardan.topology import build
from scene.fuzzing import FUZZ

NAMES = st.sampled_from(["a", "b", "c", "ground", "", "x y", 'q"&amp;', "base"])
WORDS = st.one_of(
    st.sampled_from(["0", "1", "-1", "nan", "inf", "1e309", "1e-320", "1.5708", "", "0x1", "1_0"]),
    st.floats().map(str),
    st.text(alphabet="0123456789.eE+- ", max_size=8),
)
TRIPLES = st.lists(WORDS, min_size=2, max_size=4).map(" ".join)


def quoted(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def written(name, attributes, inside):
    pairs = " ".join(f'{key}="{quoted(value)}"' for key, value in attributes.items())
    return f"<{name} {pairs}>{inside}</{name}>"


def tag(name, attributes, inside=None):
    pairs = st.fixed_dictionaries({}, optional=attributes)
    inside = st.just("") if inside is None else inside
    return st.builds(written, st.just(name), pairs, inside)


def several(*parts):
    return st.lists(st.one_of(*parts), max_size=5).map("".join)


ORIGIN = tag("origin", {"xyz": TRIPLES, "rpy": TRIPLES})
INERTIA = tag("inertia", dict.fromkeys(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), WORDS))
INERTIAL = tag("inertial", {}, several(ORIGIN, tag("mass", {"value": WORDS}), INERTIA))
FILES = st.sampled_from(["package://a/b.stl", "../x", "file:///etc/passwd", "\x7f", "a" * 5000])
SHAPES = several(
    tag("box", {"size": TRIPLES}),
    tag("cylinder", {"radius": WORDS, "length": WORDS}),
    tag("sphere", {"radius": WORDS}),
    tag("mesh", {"filename": FILES, "scale": TRIPLES}),
)
VISUAL = tag("visual", {}, several(ORIGIN, tag("geometry", {}, SHAPES)))
LINK = tag("link", {"name": NAMES}, several(INERTIAL, VISUAL))
TYPES = st.sampled_from(
    ["revolute", "continuous", "prismatic", "fixed", "floating", "planar", "ball"]
)
JOINT = tag(
    "joint",
    {"name": NAMES, "type": TYPES},
    several(
        tag("parent", {"link": NAMES}),
        tag("child", {"link": NAMES}),
        ORIGIN,
        tag("axis", {"xyz": TRIPLES}),
        tag("limit", dict.fromkeys(("lower", "upper", "velocity", "effort"), WORDS)),
        tag("dynamics", {"damping": WORDS, "friction": WORDS}),
        tag("mimic", {"joint": NAMES, "multiplier": WORDS, "offset": WORDS}),
    ),
)
LOOP = tag(
    "loop_joint",
    {"name": NAMES, "type": TYPES},
    several(
        tag("link1", {"link": NAMES}),
        tag("link2", {"link": NAMES}, several(ORIGIN)),
        ORIGIN,
        tag("axis", {"xyz": TRIPLES}),
    ),
)
CONSTRAINT = tag(
    "constraint",
    {"name": NAMES, "type": TYPES},
    several(
        tag("parent", {"link": NAMES}),
        tag("child", {"link": NAMES}),
        tag("child_origin", {"xyz": TRIPLES, "rpy": TRIPLES}),
        tag("parent_axis", {"xyz": TRIPLES}),
        tag("child_axis", {"xyz": TRIPLES}),
    ),
)
PARTS = st.lists(st.one_of(LINK, JOINT, LOOP, CONSTRAINT), max_size=10)
ROBOT = tag("robot", {"name": NAMES}, PARTS.map("".join))


@st.composite
def sound(draw):
    """A tree whose joints and links fit together; only numbers and kinds are wild."""
    parts = ['<link name="l0"/>']
    for k in range(draw(st.integers(1, 4))):
        inner = draw(st.integers(0, k))
        inside = draw(INERTIAL)
        parts.append(f'<link name="l{k + 1}">{inside}</link>')
        axis = draw(st.sampled_from(["1 0 0", "0 1 1", "0 0 -1", "1e-30 0 1"]))
        parts.append(
            f'<joint name="j{k}" type="{draw(TYPES)}"><parent link="l{inner}"/>'
            f'<child link="l{k + 1}"/><axis xyz="{axis}"/>{draw(ORIGIN)}</joint>'
        )
    if draw(st.booleans()):
        ends = f'<link1 link="l0"/><link2 link="l{k + 1}"/>{draw(ORIGIN)}'
        parts.append(f'<loop_joint name="loop" type="{draw(TYPES)}">{ends}</loop_joint>')
    return f'<robot name="r">{"".join(parts)}</robot>'


def read(text):
    """The nodes of the system, or None where an error of ours was raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return build(from_text(text, Options(base="free"))).graph.nodes
        except CardanError:
            return None


@FUZZ
@given(ROBOT)
def test_documents(text):
    assert read(text) == read(text)


@FUZZ
@given(sound())
def test_trees_with_wild_numbers(text):
    assert read(text) == read(text)


@FUZZ
@given(st.one_of(st.text(max_size=60), st.binary(max_size=60)))
def test_any_text(text):
    assert read(text) is None


@FUZZ
@given(ROBOT, st.data())
def test_damaged_documents(text, data):
    at = data.draw(st.integers(0, len(text)))
    junk = data.draw(st.text(max_size=5))
    damaged = text[:at] + junk + text[at + data.draw(st.integers(0, 5)) :]
    assert read(damaged) == read(damaged)
