"""Any text is a model or one of our errors."""

from __future__ import annotations

import warnings

from hypothesis import given
from hypothesis import strategies as st

from cardan.errors import CardanError
from cardan.scene.files.sdf import Options, from_text
from cardan.topology import build
from scene.fuzzing import FUZZ
from scene.test_urdf_fuzz import NAMES, TRIPLES, WORDS, several, tag, written

PLACES = st.sampled_from(["a", "b", "c", "world", "__model__", "n::a", "", "::", "x"])
POSES = st.one_of(st.lists(WORDS, min_size=5, max_size=7).map(" ".join), TRIPLES)


def value(name, texts):
    """An element with text inside."""
    quoted = texts.map(lambda text: text.replace("&", "&amp;").replace("<", "&lt;"))
    return st.builds(written, st.just(name), st.just({}), quoted)


POSE = st.builds(
    written,
    st.just("pose"),
    st.fixed_dictionaries(
        {}, optional={"relative_to": PLACES, "degrees": st.sampled_from(["true", "1", "x"])}
    ),
    st.one_of(st.just("0 0 1 0 0 0"), POSES),
)
INERTIA = tag("inertia", {}, several(*(value(k, WORDS) for k in ("ixx", "iyy", "izz", "ixy"))))
INERTIAL = tag("inertial", {}, several(POSE, value("mass", WORDS), INERTIA))
SHAPE = tag("geometry", {}, several(tag("box", {}, value("size", TRIPLES)), tag("mesh", {})))
LINK = tag("link", {"name": NAMES}, several(INERTIAL, POSE, tag("visual", {}, SHAPE)))
LIMIT = tag("limit", {}, several(value("lower", WORDS), value("upper", WORDS)))
DYNAMICS = tag("dynamics", {}, several(value("damping", WORDS), value("spring_stiffness", WORDS)))
MIMIC = tag("mimic", {"joint": NAMES}, value("multiplier", WORDS))
AXIS = tag("axis", {}, several(value("xyz", TRIPLES), LIMIT, DYNAMICS, MIMIC))
TYPES = st.sampled_from(
    ["revolute", "continuous", "prismatic", "screw", "universal", "ball", "fixed", "gearbox"]
)
JOINT = tag(
    "joint",
    {"name": NAMES, "type": TYPES},
    several(
        value("parent", PLACES), value("child", PLACES), POSE, AXIS, value("thread_pitch", WORDS)
    ),
)
FRAME = tag("frame", {"name": NAMES, "attached_to": PLACES}, POSE)
INNER = tag("model", {"name": st.just("n"), "placement_frame": PLACES}, several(LINK, POSE))
MODEL = tag(
    "model",
    {"name": NAMES},
    st.lists(st.one_of(LINK, JOINT, FRAME, INNER), max_size=9).map("".join),
)
VERSIONS = st.sampled_from(["1.4", "1.6", "1.7", "1.11"])
FILE = st.builds(lambda v, model: f'<sdf version="{v}">{model}</sdf>', VERSIONS, MODEL)


@st.composite
def sound(draw):
    """Links and joints that fit together, loops among them; only numbers and kinds are wild."""
    count = draw(st.integers(1, 4))
    parts = [f'<link name="l{k}">{draw(INERTIAL)}{draw(POSE)}</link>' for k in range(count + 1)]
    for k in range(count + draw(st.integers(0, 2))):
        one, other = (k, k + 1) if k < count else (draw(st.integers(0, count)), 0)
        parts.append(
            f'<joint name="j{k}" type="{draw(TYPES)}"><parent>l{one}</parent>'
            f"<child>l{other}</child>{draw(AXIS)}{draw(POSE)}</joint>"
        )
    return f'<sdf version="1.7"><model name="m">{"".join(parts)}</model></sdf>'


def read(text):
    """The nodes of the system, or None where an error of ours was raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return build(from_text(text, Options(base="free"))).graph.nodes
        except CardanError:
            return None


@FUZZ
@given(FILE)
def test_documents(text):
    assert read(text) == read(text)


@FUZZ
@given(sound())
def test_models_with_wild_numbers(text):
    assert read(text) == read(text)


@FUZZ
@given(FILE, st.data())
def test_damaged_documents(text, data):
    at = data.draw(st.integers(0, len(text)))
    junk = data.draw(st.text(max_size=5))
    damaged = text[:at] + junk + text[at + data.draw(st.integers(0, 5)) :]
    assert read(damaged) == read(damaged)
