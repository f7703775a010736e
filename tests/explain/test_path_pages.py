"""Pages on paths: what was solved, what lies on it, what is not certain; names stay names."""

from __future__ import annotations

import math
import re
import sys
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

import cardan as cd
from analyses.test_continuation import truss, two_links
from cardan.errors import DerivationError, ModelError
from cycle_scenes import duffing, step, walker
from explain.tex import problems
from laws.test_hostile_names import NAMES
from mechanisms.change_points import linkage

ENDINGS = (".html", ".tex", ".md")


@cache
def steep() -> Any:
    return truss(3.0).continuation(P=(0, 1), branches=1)


@cache
def positions() -> Any:
    return linkage(1, 2, 1, 2).continuation(A=(0.3, 7.0), of="positions", branches=1)


@cache
def resonance() -> Any:
    model, omega = duffing()
    start = {"period": 2 * sp.pi / omega, "settle": 20, "parameters": {"omega": 0.7}}
    cycle = model.cycle({"x": 0.6}, **start)
    return model.continuation(omega=(0.7, 3.0), of="cycles", start=cycle)


@cache
def gaits() -> Any:
    gait = step(walker(), 0.2003, -0.2)
    return gait.model.continuation(slope=(0.009, 0.018), of="cycles", start=gait)


def written(path: Any, folder: Path, **options: Any) -> str:
    """The page as Markdown, whose signs are easily read."""
    text: str = path.explain(folder / "page.md", **options).read_text("utf-8")
    return text.replace("\\", "")


@pytest.mark.parametrize("path", [steep, positions, resonance, gaits])
def test_every_kind_has_its_page_in_three_languages(path: Any, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    texts = {end: path().explain(tmp_path / f"page{end}").read_text("utf-8") for end in ENDINGS}
    assert texts[".html"].count("<svg") == 1
    drawing = re.search(r"<svg.*?</svg>", texts[".html"], re.S)
    assert drawing is not None
    ET.fromstring(drawing[0])
    ET.fromstring((tmp_path / "page.svg").read_text("utf-8"))
    assert problems(texts[".tex"]) == []
    assert "draws it; pages of HTML and Markdown have it" in texts[".tex"]
    for title in ("Range and ends", "Equations", "Steps", "Branches", "Sources"):
        assert all(title in text for text in texts.values())
    for branch in path().branches.values():
        for point in branch.points:
            assert point.description.replace("'", "&#x27;") in texts[".html"]
    again = path().explain(tmp_path / "again.html").read_text("utf-8")
    assert again == texts[".html"]


def test_equilibria_say_what_was_solved_and_where_they_are_stable(tmp_path: Path) -> None:
    text = written(steep(), tmp_path)
    assert "$h$ $=$ $f$: forces balance" in text
    assert "| start | branch point 1 | 4 | stable | 0 |" in text
    assert "| branch point 1 | fold 1 | 5 | unstable | 1 |" in text
    # the last row is the end of the range
    assert "| branch point 4 | P = 1 | 6 | stable | 0 |" in text
    assert "its null space has 2 directions" in text
    assert "$frac{dsigma}{ds}$ $=$ 0" in text
    # cardan's own sentences
    assert "2 branches (2a, 2b) along 'aside'; mirror images: 2a and 2b" in text
    assert "It leaves branch point 1 of 'main' and branch point 4 of 'main'. From P = 0.24" in text
    assert "| 1a | 0 | -0.0959857 | falls |" in text
    assert "Note: not complete (singular): '2a', '2b', '3a', '3b'" in text
    # 1a passes branch points 1 and 4, at both of their sides
    assert "not followed" not in text


def test_what_is_held_and_loops_are_in_the_equations(tmp_path: Path) -> None:
    held = truss(0.3).continuation(locked={"up": (0, -0.6)})
    text = written(held, tmp_path)
    assert "$f$ $+ tau$" in text
    assert "what is held has its values: up" in text
    assert "| start | up = -0.6 | 9 | stable, then unstable, then stable | stable | 0 |" in text
    assert "Stability changes between points of the path, where none was located" in text
    assert "up.holding_force over up" in text
    links = two_links().continuation(P=(0, 4), bounds={"theta": (-1.4, 1.4)})
    text = written(links, tmp_path)
    assert "$+ {G}^T , lambda$" in text
    assert "λ has 2 multipliers" in text
    assert "from branch point 1 of branch 'main' not followed: 1a, 1b" in text
    assert "ends where theta = -1.4 is reached" in text


def test_cycles_and_positions_have_equations_of_their_own(tmp_path: Path) -> None:
    text = written(resonance(), tmp_path)
    assert "$x_{T}$ $=$ $x_{0}$" in text
    assert "a lap lasts for the period T that is known" in text
    assert "There a multiplier is $mu$ $=$ $1$" in text
    assert "| fold 1 | fold 2 | 25 | unstable | 1 |" in text
    text = written(gaits(), tmp_path)
    assert "up to the symmetry S" in text
    assert "the event 'strike.up'" in text
    assert "not followed: cycles of twice the period" in text
    text = written(positions(), tmp_path)
    assert "$g$ $=$ $0$: 3 conditions for 3 motions of the joints" in text
    assert "No forces act: positions have no stability" in text


def test_axes_of_the_diagram(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    assert "aside over up." in written(steep(), tmp_path, along="up", up="aside")
    for ending in ENDINGS:
        with pytest.raises(ModelError, match="there is no 'upp'"):
            steep().explain(tmp_path / f"page{ending}", up="upp")
    with pytest.raises(DerivationError, match=r"'a\.pdf': pages end in \.html, \.tex, \.md"):
        steep().explain(tmp_path / "a.pdf")


def test_without_matplotlib_a_page_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] == "matplotlib"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    text = written(steep(), tmp_path)
    assert "It needs Matplotlib (pip install 'cardan[plot]')" in text
    assert not list(tmp_path.glob("*.svg"))


def test_a_point_that_is_not_accurate_is_noted(tmp_path: Path) -> None:
    """A path cut off in between, and a special point known to a step."""
    from dataclasses import replace

    with pytest.warns(cd.errors.SolveWarning, match="after 12 points"):
        path = truss(3.0).continuation(P=(0, 1), points=12)
    curve = path.main.curve
    curve.special[1] = replace(curve.special[1], accurate=False)
    text = written(path, tmp_path)
    assert "Note: not complete (budget): 'main', as many points as points= allows" in text
    assert "Note: fold 1 of branch 'main' is not accurate" in text
    assert "Not accurate: it is only known to lie within a short step." in text


@pytest.mark.parametrize("name", NAMES)
def test_names_stay_names(name: str, tmp_path: Path) -> None:
    hostile = NAMES[name]
    scene = cd.Scene(hostile, gravity=(0, 0, 0))
    load = scene.parameter(f"P{hostile}", 0.0)
    body = scene.body(f"b{hostile}", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint(f"j{hostile}", cd.Revolute("y"), scene.ground, body)
    q = scene.q(f"j{hostile}")
    scene.force(f"f{hostile}", cd.JointForce(f"j{hostile}", load * sp.sin(q) - q))
    sides = {f"j{hostile}": (-1.0, 1.0)}
    model = cd.compile(scene)
    path = model.continuation({f"P{hostile}": (0, 2)}, branches=1, bounds=sides)
    assert path.point("branch point 1")[f"P{hostile}"] == pytest.approx(1.0)
    html = path.explain(tmp_path / "page.html").read_text("utf-8")
    plain = steep().explain(tmp_path / "plain.html").read_text("utf-8")
    tags = [set(re.findall(r"<([a-zA-Z]+)", re.sub("<!--.*?-->", "", x, flags=re.S)))
            for x in (html, plain)]  # fmt: skip
    assert tags[0] <= tags[1] | {"wbr"}
    assert problems(path.explain(tmp_path / "page.tex").read_text("utf-8")) == []
    table = path.report().table()
    assert math.isfinite(path.report().residual)
    assert hostile in str(table.title)
