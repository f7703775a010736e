"""Lines of beams against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.elements.centerlines import CENTERLINES, Centerline, Curve, Straight
from cardan.errors import ModelError

RADIUS = 100.0
START = np.zeros(3)
MIDDLE, END = (RADIUS * np.array([1 - np.cos(a), np.sin(a), 0.0]) for a in (np.pi / 7, np.pi / 4))
HELIX = np.stack([np.cos(t := np.linspace(0, 4 * np.pi, 161)), np.sin(t), 0.2 * t], axis=1)
LINES: dict[str, tuple[Centerline, np.ndarray, np.ndarray]] = {
    "straight": (Straight(), START, END),
    "arc about": (cd.arc(center=(RADIUS, 0, 0)), START, END),
    "arc through": (cd.arc(through=MIDDLE), START, END),
    "long arc": (cd.arc(through=END), START, MIDDLE),
    "spline": (cd.spline(HELIX), HELIX[0], HELIX[-1]),
}


def curve(name: str) -> Curve:
    line, start, end = LINES[name]
    data = {key: np.asarray(q.value, float) for key, q in line.quantities().items()}
    return line.curve(start, end, data)


def test_every_line_is_tested() -> None:
    assert {line.kind for line, *_ in LINES.values()} == set(CENTERLINES)


@pytest.mark.parametrize("name", LINES)
def test_ends_are_met_and_tangents_are_rates(name: str) -> None:
    found, (_, start, end) = curve(name), LINES[name]
    size = found.length
    positions, tangents = found.at(np.linspace(0, size, 11))
    assert np.allclose(positions[[0, -1]], [start, end], atol=1e-12 * size)
    h = 1e-4 * size
    s = np.linspace(0.1, 0.9, 7) * size
    rates = (found.at(s + h)[0] - found.at(s - h)[0]) / (2 * h)
    # central differences: h^2 / 6 times a third derivative of about (turn / length)^2
    assert np.allclose(rates, found.at(s)[1], atol=1e-8 * (40 if name == "spline" else 7))
    assert np.allclose(np.linalg.norm(tangents, axis=1), 1, atol=1e-14)


def test_lengths() -> None:
    assert curve("arc about").length == pytest.approx(RADIUS * np.pi / 4, rel=1e-15)
    assert curve("arc through").length == pytest.approx(RADIUS * np.pi / 4, rel=1e-13)
    assert curve("long arc").length == pytest.approx(RADIUS * (2 * np.pi - np.pi / 7), rel=1e-13)
    # 80 points a turn: the error of a cubic spline falls as the fourth power of their distance
    assert curve("spline").length == pytest.approx(4 * np.pi * np.hypot(1, 0.2), rel=1e-6)


def test_arc_length_of_a_spline_is_even() -> None:
    found = curve("spline")
    s = np.linspace(0, found.length, 4001)
    gaps = np.linalg.norm(np.diff(found.at(s)[0], axis=0), axis=1)
    assert np.ptp(gaps) < 1e-6 * gaps.mean()


def test_refusals() -> None:
    for words, make in {
        "either center= or through=": lambda: cd.arc(),
        "both are given": lambda: cd.arc(center=(0, 0, 0), through=(1, 0, 0)),
        "center has 2 entries": lambda: cd.arc(center=(0, 0)),
        "at least three points": lambda: cd.spline([(0, 0, 0), (1, 0, 0)]),
        "points\\[1\\] has 2 entries": lambda: cd.spline([(0, 0, 0), (1, 0), (1, 1, 1)]),
    }.items():
        with pytest.raises(ModelError, match=words):
            make()


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (cd.arc(center=(0.3, 0, 0)), "no circle"),
        (cd.arc(center=(0.5, 0, 0)), "on one line"),
        (cd.arc(through=(0.5, 0, 0)), "leave out line="),
        (cd.spline([(0, 0, 0), (0.5, 1, 0), (0.5, 1, 0), (1, 0, 0)]), "points 2 and 3"),
        (cd.spline([(0, 0.1, 0), (0.5, 1, 0), (1, 0, 0)]), "first point is 0.1 m apart"),
    ],
)
def test_lines_that_do_not_fit(line: Centerline, words: str) -> None:
    scene = cd.Scene("one")
    section = cd.section.general(EA=1, GA=1, GJ=1, EI=1)
    scene.beam("b", (0, 0, 0), (1, 0, 0), section, line=line)
    with pytest.raises(ModelError, match=f"beam 'b': .*{words}"):
        cd.derive(scene)
