"""What notebooks show of models, equations and runs is what pages say of them."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from xml.etree import ElementTree

import numpy as np
import pytest

import cardan as cd
from cardan.explain import document
from cardan.explain.content import Block, Document, Folded, Formula, Listing, Table
from cardan.explain.notebook import document as cell
from cardan.explain.writers.html import fragment, page
from cardan.explain.writers.latex import text as tex
from equations.classical import CLASSICAL
from equations.slider_crank import by_angles, by_relative_angle
from equations.test_reading import chain
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from mechanisms.robots import panda
from table import each

SHOWN: dict[str, Callable[[], object]] = {
    "tree": lambda: cd.derive(CLASSICAL["arm"].scene()),
    "circuit": lambda: cd.derive(by_relative_angle()),
    "closed form": lambda: cd.derive(by_angles(), independent="theta"),
    "long": lambda: cd.derive(chain(4, planar=False)),
    "absolute": lambda: cd.derive(chain(2), coordinates="absolute"),
}


def html(result: object) -> ElementTree.Element:
    """An output as a tree: whatever is opened is closed."""
    text = result._repr_html_()
    assert not re.search(r"<(html|head|style|script|link|img|iframe)|https?://(?!www.w3.org)", text)
    assert "class=" not in text.replace('class="terms"', "")
    # no color that is seen on light pages only, but of curves and lines
    assert "background" not in text
    return ElementTree.fromstring(text.replace("&InvisibleTimes;", ""))


def text(result: object) -> str:
    return "".join(html(result).itertext())


def formulas(result: object) -> list[str]:
    """Formulas on lines of their own."""
    lines = html(result).iterfind(".//div")
    return ["".join(line.itertext()) for line in lines]


def unfolded(blocks: tuple[Block, ...]) -> list[Block]:
    """All blocks, and those inside of others."""
    found: list[Block] = []
    for block in blocks:
        found += [block, *(unfolded(block.blocks) if isinstance(block, Folded) else ())]
    return found


def said(made: Document) -> list[Block]:
    return [block for section in made.sections for block in unfolded(section.blocks)]


@pytest.mark.parametrize("name", SHOWN)
def test_cells_say_what_pages_say(name: str) -> None:
    equations = SHOWN[name]()
    whole = document(equations)
    formulas_of = {(f.left, f.right) for f in said(whole) if isinstance(f, Formula)}
    others = [block for block in said(whole) if isinstance(block, Table | Listing)]
    shown = said(cell(equations))
    assert sum(isinstance(block, Table) for block in shown) >= 3
    for block in shown:
        if isinstance(block, Formula):
            assert (block.left, block.right) in formulas_of
        elif isinstance(block, Table | Listing):
            assert block in others
    assert cell(equations).lead == whole.lead


@pytest.mark.parametrize("name", SHOWN)
def test_cells_are_set_as_pages_are(name: str) -> None:
    """The same document, as a page and as a fragment: only attributes of looks differ."""
    made = cell(SHOWN[name]())
    ours, theirs = (re.sub(r' (class|style)="[^"]*"', "", x(made)) for x in (fragment, page))
    for section in made.sections:
        ours = ours.replace(f"<p><b>{section.title}</b></p>\n", "")
    ours = ours.split("\n", 2)[2].removesuffix("\n</div>")
    theirs = re.sub(r"</?section>\n?|<h2>.*?</h2>\n?", "", theirs).split("</h1>\n")[1]
    assert ours == theirs.replace("</header>\n", "").split("\n</body>")[0]
    assert SHOWN[name]()._repr_html_() == fragment(made)


def test_equations_of_a_tree() -> None:
    equations = cd.derive(CLASSICAL["cart"].scene())
    found = text(equations)
    assert "Mu.+h=f+τ, where" in found
    assert "λ" not in found
    assert "The speeds are the rates of the coordinates: q.=u." in found
    assert "f, generalized applied forces of the model: zero." in found
    assert "forward dynamics" in found
    # three entries of M, two of h
    assert len(formulas(equations)) == 5


def test_equations_of_a_circuit() -> None:
    equations = cd.derive(by_relative_angle())
    assert "Mu.+h=f+τ+GTλ and Gu.=γ" in text(equations)
    assert {line[0] for line in formulas(equations)} == set("MhgGγ")
    assert tex(document(equations)).count(r"\gamma_{") == 2
    latex = equations._repr_latex_()
    for sign in ("M &= ", "h &= ", "g &= ", "G &= ", r"\gamma &= ", r"G(q)^T \lambda"):
        assert sign in latex
    assert latex.count("{") == latex.count("}")


def test_what_follows_stands_below() -> None:
    equations = cd.derive(by_angles(), independent="theta")
    below = text(equations).split("With what the loops determine:")[1]
    lines = [line for line in formulas(equations) if line in below]
    # x, phi and two derivatives of each
    assert [line.split("=")[0] for line in lines] == ["x", "φ", "xθ", "φθ", "xθθ", "φθθ"]


def test_long_ones_say_how_many_intermediates() -> None:
    found = text(cd.derive(chain(8, planar=False)))
    has = r"\d+ named intermediates, too many to be listed: equations.symbolic\('bias'\) has them"
    assert re.search(has, found)
    assert re.search(r"h, .{10,60}\. Written out it has [\d,]+ operations\.", found)
    middle = text(cd.derive(ZOO["parabola"].build()))
    assert re.search(r"h with \d+ named intermediates: equations.symbolic\('bias'\)", middle)


@each("name", [*list(ZOO)[::12], *list(CLOSED)[::2]])
def test_nothing_takes_long(name: str) -> None:
    scene = (ZOO.get(name) or CLOSED[name]).build()
    equations = cd.derive(scene)
    start = time.process_time()
    assert scene._repr_html_()
    assert equations._repr_html_()
    assert equations._repr_latex_()
    # a second or two on any machine; searches without end took minutes
    assert time.process_time() - start < 20


def test_an_arm_is_shown_at_once() -> None:
    equations = cd.derive(panda())
    start = time.process_time()
    found = text(equations)
    assert time.process_time() - start < 5
    assert "equations.symbolic('mass_matrix')" in found
    # no short form was looked for of what is long
    assert not {"mass_matrix", "bias"} & set(equations._read)


def test_runs() -> None:
    motion = cd.compile(by_angles(), independent="theta").simulate(1.0, u={"theta": 5.0})
    result = html(motion)
    svg = "{http://www.w3.org/2000/svg}"
    (curve,) = [x for x in result.iter(f"{svg}path") if x.get("stroke-width")]
    points = np.array([p.split() for p in curve.get("d").strip("M").split("L")], dtype=float)
    assert len(points) > 300
    assert (np.diff(points[:, 0]) >= 0).all()
    # the least and the largest value touch the frame
    assert points[:, 1].min() == 8
    assert points[:, 1].max() == 150
    assert {"theta", "[rad]", "1 s"} <= {x.text for x in result.iter(f"{svg}text")}
    # the rest is what is printed, line by line
    rows = ["".join(row.itertext()) for row in result.iter("tr")]
    head, *lines = str(motion).splitlines()
    assert rows == [line[2:12].strip() + line[12:] for line in lines]
    assert head in text(motion)
    assert any(row.startswith("energy") for row in rows)


def test_a_run_of_many_coordinates() -> None:
    motion = cd.compile(chain(10)).simulate(np.linspace(0, 0.1, 5), q={"joint0": 0.3})
    assert "and 2 more, motion.plot()" in text(motion)
    still = cd.compile(chain(1)).simulate([0.0, 1.0])
    assert "-0.5" in text(still)


def test_models_and_tables() -> None:
    scene = by_angles()
    found = text(scene)
    assert "prismatic" in found
    assert "parameter" in found
    assert "revolute" in text(scene.graph)
    assert "incidence" in text(scene.graph.incidence)
    equations = cd.derive(CLASSICAL["arm"].scene())
    bases = equations.base_parameters()
    assert "second.base_xx" in text(bases)
    shown = [block for block in said(cell(bases)) if isinstance(block, Formula)]
    assert len(shown) == len(bases.combinations)
    assert [block for block in said(document(equations)) if block in shown] == shown


def test_what_is_prescribed_altogether_has_no_matrices() -> None:
    scene = cd.Scene("clock", gravity=(0, 0, -9.81))
    hand = scene.body("hand", mass=1, com=(0, 0, -1))
    scene.joint("axle", cd.Revolute("y"), scene.ground, hand, prescribed=cd.t)
    equations = cd.derive(scene)
    assert equations.mass_matrix.shape == (0, 0)
    assert "Nothing moves freely" in text(equations)
