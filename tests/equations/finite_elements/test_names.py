"""Kinds of elements stand for all members: no name of the user is in what they share."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.codegen.finite_elements.model_folder import functions
from laws.test_hostile_names import NAMES, scene_of
from table import each


@each("word", NAMES.values())
def test_functions_have_no_names_of_the_scene(word: str) -> None:
    plain = cd.derive(scene_of("plain"), coordinates="absolute")
    hostile = cd.derive(scene_of(word), coordinates="absolute")
    assert [kind.name for kind in plain.kinds] == [kind.name for kind in hostile.kinds]
    for one, other in zip(functions(plain), functions(hostile), strict=True):
        assert (one.name, one.roots, one.owners) == (other.name, other.roots, other.owners)
        for mine, theirs in zip(one.inputs, other.inputs, strict=True):
            # inputs of the scene are read by their names
            assert mine.name == "r" or mine == theirs


@pytest.mark.parametrize("name", ["comment end", "quotes", "keyword", "letters", "long"])
def test_hostile_names_run(name: str) -> None:
    word = NAMES[name]
    absolute, relative = (
        cd.compile(scene_of(word), coordinates=c) for c in ("absolute", "relative")
    )
    q, u = absolute.split(absolute.initial(q={f"j {word}": 0.3}, u={f"j {word}": 1.0}))
    joints, rates = relative.split(relative.initial(q={f"j {word}": 0.3}, u={f"j {word}": 1.0}))
    mine, theirs = absolute.forward_dynamics(q, u), relative.forward_dynamics(joints, rates)
    at = [absolute.speeds.index(speed) for speed in relative.speeds]
    np.testing.assert_allclose(mine[at], theirs, rtol=0, atol=1e-11 * (1 + np.abs(theirs).max()))
