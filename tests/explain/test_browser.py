"""Pages as a browser lays them out: nothing is wider than its box, no TeX stands in the text."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import cardan as cd
from cardan.explain import document
from cardan.explain.writers.html import page
from explain.browser import BROWSER, WIDTHS, look
from explain.scenes import EXAMPLES, LONG, TWICE, equations_of
from laws.test_hostile_names import NAMES

pytestmark = pytest.mark.skipif(BROWSER is None, reason="no Chromium is installed")
QUICK = [path for path in EXAMPLES if path.stem not in LONG | TWICE]
REST = [path for path in EXAMPLES if path.stem in LONG | TWICE]


@pytest.mark.parametrize(
    "examples", [QUICK, pytest.param(REST, marks=pytest.mark.slow)], ids=["quick", "rest"]
)
def test_everything_fits_its_box(examples: list[Path], tmp_path: Path) -> None:
    pages = {path.name: page(document(equations_of(path))) for path in examples}
    found = look(pages, tmp_path)
    for name, seen in found.items():
        assert seen["wide"] == [], name
        assert not re.search(r"\\[A-Za-z(\[]", seen["text"]), name
        assert seen["math"] > 3
        assert "Sources" in seen["text"]
    assert {int(name.rpartition(" ")[2]) for name in found} == set(WIDTHS)


def scene_of(word: str) -> cd.Scene:
    """A pendulum with a motor all of whose names have the word in them."""
    scene = cd.Scene(f"m {word}", gravity=(0, 0, -9.81))
    length = scene.parameter(f"l {word}", 1.0, unit="m")
    body = scene.body(f"b {word}", mass=1.0, com=(0, 0, -length), inertia=(0.1, 0.1, 0.1))
    scene.joint(f"j {word}", cd.Revolute("y"), scene.ground, body)
    scene.force(f"f {word}", cd.JointForce(f"j {word}", scene.input(f"r {word}")))
    return scene


def test_hostile_names_fit_and_what_does_not_is_seen(tmp_path: Path) -> None:
    words = ("tex", "long", "script", "letters")
    pages = {word: page(document(cd.derive(scene_of(NAMES[word])))) for word in words}
    wide = '<body><div style="width:9rem"><math><mi>' + "x" * 90 + "</mi></math></div></body>"
    found = look({**pages, "wide": f"<!DOCTYPE html>{wide}"}, tmp_path)
    for name, seen in found.items():
        word = name.partition(" ")[0]
        assert (seen["wide"] == []) == (word != "wide"), name
        assert word == "wide" or NAMES[word][:12] in seen["text"]
