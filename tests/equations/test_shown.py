"""What notebooks show of models, equations and runs."""

from __future__ import annotations

import re
import time
from xml.etree import ElementTree

import numpy as np

import cardan as cd
from equations.classical import CLASSICAL
from equations.slider_crank import by_angles, by_relative_angle
from equations.test_reading import chain
from mechanisms import ZOO
from mechanisms.closed import CLOSED
from table import each


def html(shown: object) -> ElementTree.Element:
    """An output as a tree: whatever is opened is closed."""
    text = shown._repr_html_()
    assert not re.search(r"<(script|link|img|iframe)|https?://(?!www.w3.org)", text)
    # no color that is seen on light pages only, but of curves and lines
    assert "background" not in text
    return ElementTree.fromstring(text.replace("&InvisibleTimes;", ""))


def text(shown: object) -> str:
    return "".join(html(shown).itertext())


def formulas(shown: object) -> int:
    return len(list(html(shown).iter("math")))


def test_equations_of_a_tree() -> None:
    found = text(cd.derive(CLASSICAL["cart"].scene()))
    assert "M u̇ + h = f + τ" in found
    assert "Gᵀλ" not in found
    assert "q̇ = u" in found
    assert "f = 0" in found
    assert "forward_dynamics" in found
    assert "M = 2" not in found
    assert formulas(cd.derive(CLASSICAL["cart"].scene())) == 2


def test_equations_of_a_circuit() -> None:
    equations = cd.derive(by_relative_angle())
    found = text(equations)
    assert "M u̇ + h = f + τ + Gᵀλ, G u̇ = γ" in found
    # M, h, g, G and gamma
    assert formulas(equations) == 5
    tex = equations._repr_latex_()
    for sign in ("M &= ", "h &= ", "g &= ", "G &= ", r"\gamma &= ", r"G(q)^T \lambda"):
        assert sign in tex
    assert tex.count("{") == tex.count("}")


def test_what_follows_stands_below() -> None:
    equations = cd.derive(by_angles(), independent="theta")
    shown = html(equations)
    below = next(x for x in shown.iter("details") if "circuits determine" in x[0].text)
    # x, phi and two derivatives of each, on both sides of the sign
    assert len(list(below.iter("math"))) == 12
    indices = {index[1].text for index in below.iter("msub")}
    assert {"θ", "θθ"} <= indices


def test_long_ones_say_how_many_intermediates() -> None:
    found = text(cd.derive(chain(8, planar=False)))
    assert re.search(r"h: \d+ intermediates, equations.symbolic\('bias'\)", found)


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


def test_runs() -> None:
    motion = cd.compile(by_angles(), independent="theta").simulate(1.0, u={"theta": 5.0})
    shown = html(motion)
    (curve,) = [x for x in shown.iter("{http://www.w3.org/2000/svg}path") if x.get("stroke-width")]
    points = np.array([p.split() for p in curve.get("d").strip("M").split("L")], dtype=float)
    assert len(points) > 300
    assert (np.diff(points[:, 0]) >= 0).all()
    # the least and the largest value touch the frame
    assert points[:, 1].min() == 8
    assert points[:, 1].max() == 150
    assert "drift" in text(motion)


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
    assert "second.base_xx" in text(cd.derive(CLASSICAL["arm"].scene()).base_parameters())


def test_what_is_prescribed_altogether_has_no_matrices() -> None:
    scene = cd.Model("clock", gravity=(0, 0, -9.81))
    hand = scene.body("hand", mass=1, com=(0, 0, -1))
    scene.joint("axle", cd.Revolute("y"), scene.ground, hand, motion=cd.t)
    equations = cd.derive(scene)
    assert equations.mass_matrix.shape == (0, 0)
    assert "M: none" in ElementTree.tostring(html(equations), encoding="unicode")
