"""Whatever stands in a scene file: a model or one of our errors, nothing else."""

from __future__ import annotations

import json
import random

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

import cardan as cd
from cardan.api.scene import Scene
from cardan.errors import CardanError, ModelError, TopologyError
from cardan.scene.files.expression import FUNCTIONS, MOTION, parse
from cardan.scene.files.yaml import from_text, keys
from cardan.topology import build
from scene.fuzzing import FUZZ


def survives(text: str) -> bool:
    """True for a model; an error of ours is fine, any other is not."""
    try:
        scene = from_text(text, name="scene.yaml")
    except (ModelError, TopologyError) as problem:
        return check(problem, "scene.yaml")
    try:
        build(scene)
    except CardanError:
        return False
    return True


def check(problem: Exception, place: str) -> bool:
    """An error says where."""
    assert place in str(problem)
    return False


# documents of the right words in the wrong places

LISTS = (keys.TOP, keys.BODY, keys.JOINT, keys.FRAME, keys.SIMULATE)
OTHERS = "a b upper ground revolute damping free m t x XYZ -l/2 q(j) 1/0 on null ~ .inf 1e-10"
WORDS = st.sampled_from([*(key.name for known in LISTS for key in known), *OTHERS.split(" ")])
SCALARS = st.one_of(
    WORDS, st.integers(-3, 3), st.floats(), st.booleans(), st.none(), st.text(max_size=6)
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=4), st.dictionaries(st.one_of(WORDS, st.text()), inner, max_size=4)
    ),
    max_leaves=12,
)
SECTIONS = st.fixed_dictionaries({}, optional={key.name: VALUES for key in keys.TOP[1:]})
GOOD = st.fixed_dictionaries(
    {
        "bodies": st.just({"a": {"mass": 1}, "b": {"mass": 2}}) | VALUES,
        "joints": st.fixed_dictionaries(
            {"j": st.fixed_dictionaries(
                {"type": st.sampled_from(["revolute", "free", "custom", "screw", "nothing"]),
                 "parent": st.just("ground") | VALUES, "child": st.just("a")},
                optional={key.name: VALUES for key in keys.of_joint("screw") if not key.required},
            )}
        ),
    },
    optional={key.name: VALUES for key in keys.TOP if key.name not in ("bodies", "joints")},
)  # fmt: skip


@FUZZ
@given(SECTIONS | GOOD)
def test_documents(sections: dict[str, object]) -> None:
    survives(json.dumps({**sections, "cardan": 1}, ensure_ascii=False))


# texts that were scenes once

NAMED = ("double_pendulum", "bucket")
SEEDS = [cd.examples.path(name).read_text(encoding="utf-8") for name in NAMED]
PIECES = [*"{}[]:,&*!|>'\"%@`#-?\n\t 0é", "- ", ": ", "&a ", "*a", "!!x ", "---\n", "<<", "\x00"]


@FUZZ
@given(st.sampled_from(SEEDS), st.integers(0, 2**32))
def test_damaged_files(text: str, seed: int) -> None:
    rng = random.Random(seed)
    for _ in range(rng.randint(1, 4)):
        at, span = rng.randrange(len(text)), rng.choice((0, 0, 1, 5, 40))
        text = text[:at] + rng.choice([*PIECES, text[at : at + 30]]) + text[at + span :]
    survives(text)


def test_the_seeds_are_scenes() -> None:
    assert all(map(survives, SEEDS))


# expressions

SCENE = Scene("fuzz")
NAMES = {name: SCENE.parameter(name, 1.0) for name in ("m", "l")}
SIGNS = "+ - * / ^ ( ) ( ) ( ) , . < > == ** 0 1 2 1e3 .5 1e299 1000 wrt in ' ; \u2212 ² lambda"
TOKENS = st.sampled_from(
    [*FUNCTIONS, *MOTION, *NAMES, *SIGNS.split(" "), "select", "pi", '"m"', "9" * 25, "\\", "\n"]
)


@FUZZ
@given(st.lists(TOKENS, max_size=14).map("".join) | st.text(max_size=20))
def test_expressions(text: str) -> None:
    assert is_expression(text) in (True, False)


def is_expression(text: str) -> bool:
    """True for an expression in the known names; an error of ours is fine, any other is not."""
    try:
        found = parse(text, NAMES, where="here")
    except ModelError as problem:
        return check(problem, "here")
    assert isinstance(found, sympy.Expr)
    assert found.free_symbols <= set(NAMES.values())
    return True


@pytest.mark.parametrize("text", ["m" * 5000, "(" * 2000, "-" * 3999 + "m", "m^" * 1000 + "m"])
def test_long_expressions(text: str) -> None:
    assert is_expression(text) == (len(text) < 4001 and text.startswith("-"))
