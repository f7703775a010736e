"""Pages of all examples, in three languages: complete, well-formed, the same every time."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from cardan.equations.formalisms import FORMALISMS
from cardan.errors import DerivationError
from cardan.explain import document
from cardan.explain.writers import WRITERS
from explain.scenes import EXAMPLES, equations_of, scene_of, short
from explain.tex import problems
from spread import some

TITLES = ("Bodies and joints", "Coordinates and speeds", "Conserved quantities", "Frames",
          "Operations", "Sources")  # fmt: skip


@pytest.mark.parametrize("example", short(EXAMPLES))
def test_every_example_has_its_page(example: Path, tmp_path: Path) -> None:
    equations = equations_of(example)
    made = document(equations)
    assert set(TITLES) <= {section.title for section in made.sections}
    texts: dict[str, str] = {}
    for writer in WRITERS.values():
        texts |= writer.write(made, tmp_path / "page")
    assert set(texts) == {".html", ".tex", ".md", ".svg"}
    names = [part.name for body in equations.system.bodies for part in body.parts]
    names += [p.name for p in equations.system.parameters]
    for name in names:
        assert name in texts[".html"].replace("<wbr/>", "")
        assert name.replace("_", r"\_") in texts[".md"] or name in texts[".svg"]
    ET.fromstring(texts[".svg"])
    assert problems(texts[".tex"]) == []
    assert _dollars(texts[".md"]) == []


def _dollars(text: str) -> list[str]:
    """Lines of Markdown in which a formula does not end."""
    plain = re.sub(r"\\[$`]", "", text)
    lines = re.sub(r"^\$\$\n.*?\n\$\$$", "", plain, flags=re.S | re.M).split("\n")
    return [line for line in lines if line.count("$") % 2]


def test_written_by_their_endings(tmp_path: Path) -> None:
    equations = equations_of(EXAMPLES[0])
    assert equations.explain(tmp_path / "a.html").read_text("utf-8").startswith("<!DOCTYPE html>")
    assert equations.explain(str(tmp_path / "a.tex")).read_text("utf-8").startswith(r"\document")
    assert "(a.svg)" in equations.explain(tmp_path / "a.md").read_text("utf-8")
    assert {path.name for path in tmp_path.iterdir()} == {"a.html", "a.tex", "a.md", "a.svg"}
    with pytest.raises(DerivationError, match=r"'a\.pdf': pages end in \.html, \.tex, \.md"):
        equations.explain(tmp_path / "a.pdf")


@cache
def derived_anew(k: int) -> Any:
    """Every number gives equations of its own."""
    return cd.derive(cd.load(EXAMPLES[-2]))


@pytest.mark.parametrize("ending", WRITERS)
def test_the_same_every_time(ending: str, tmp_path: Path) -> None:
    texts = []
    for k in range(2):
        texts.append(derived_anew(k).explain(tmp_path / f"{k}{ending}").read_text("utf-8"))
    assert texts[0].replace("(0.svg)", "(1.svg)") == texts[1]


@pytest.mark.parametrize("method", some(FORMALISMS, 3, 1))
def test_every_method_has_a_page(method: str, tmp_path: Path) -> None:
    scene = scene_of(EXAMPLES[0])
    page = cd.derive(scene, method=method).explain(tmp_path / "a.md").read_text("utf-8")
    assert "- upper, weight:" in page
    assert "Energy" in page


def test_says_where_terms_come_from(tmp_path: Path) -> None:
    text = equations_of(EXAMPLES[0]).explain(tmp_path / "a.md").read_text("utf-8")
    # of two rods of one mass and length
    entry = text.split(r"M_{\mathrm{shoulder, shoulder}} &=")[1].split("\n\n")
    assert "cos" in entry[0]
    assert entry[1].startswith("- upper: $\\frac{l^{2} \\, m}{3}$\n- lower: ")


def test_scenes_in_which_nothing_moves_freely(tmp_path: Path) -> None:
    scene = cd.Scene("driven")
    wheel = scene.body("wheel", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("axle", cd.Revolute("x"), scene.ground, wheel, prescribed=2 * cd.t)
    for name, made in (("empty", cd.Scene("empty")), ("driven", scene)):
        text = cd.derive(made).explain(tmp_path / f"{name}.md").read_text("utf-8")
        assert "Nothing moves freely" in text


def test_formulas_are_read_by_another_program(tmp_path: Path) -> None:
    parser = pytest.importorskip("matplotlib.mathtext").MathTextParser("path")
    text = equations_of(EXAMPLES[0]).explain(tmp_path / "a.tex").read_text("utf-8")
    formulas = set(re.findall(r"\$([^$]*)\$", text.split(r"\begin{document}")[1]))
    assert len(formulas) > 30
    for formula in formulas:
        # which has no displaystyle
        parser.parse(f"${formula.replace(chr(92) + 'displaystyle', '')}$")


def test_long_names_and_numbers_stay_within_a_page() -> None:
    import sympy as sp

    from cardan.explain.breaking import Breaker

    a, b, c = sp.symbols("a b c")
    long = sp.expand((a + b + c) ** 6)
    pieces = Breaker({}, 20.0).segments(sp.sin(long) * long / (long + 1))
    assert len(pieces) > 50
    assert all(piece.body is None or Breaker({}, 20.0).width(piece.body) <= 20 for piece in pieces)
    # nothing is lost, and brackets match
    opened = sum(mark.count("(") for piece in pieces for mark in piece.before)
    assert opened == sum(mark == ")" for piece in pieces for mark, _ in piece.after)
    bodies = [piece.body for piece in pieces if piece.body is not None]
    assert sum(body.count_ops() for body in bodies) > 0.5 * long.count_ops() * 3
