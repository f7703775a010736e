"""Notations of books: one table, distinct symbols, pages that keep their meaning."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

import cardan as cd
from cardan.equations.reading import book_symbols
from cardan.equations.reading.book_symbols import (
    CARDAN,
    LETTERS,
    NOTATIONS,
    NUMBER_QUANTITIES,
    OVERLOADED,
    TABLE,
    BookNotation,
)
from cardan.equations.reading.typesetting import typeset
from cardan.errors import DerivationError
from cardan.explain import content as d
from cardan.explain import document
from cardan.explain.book_forms import FORMS, NOTES
from cardan.explain.writers import WRITERS
from cardan.schema.blocks import of_rate
from companions.symbol_page import CALLS, ROOT, double_pendulum, four_bar, written
from explain.tex import problems
from mechanisms import ZOO
from mechanisms.flexible import FLEXIBLE

ACCEPT = "pytest tests/companions/test_notations.py --accept"
BOOKS = [key for key in NOTATIONS if key != "cardan"]
QUANTITIES = [row[0] for row in TABLE]


@pytest.mark.parametrize("key", NOTATIONS)
def test_every_quantity_has_a_symbol_of_its_own(key: str) -> None:
    book = NOTATIONS[key]
    assert list(book.symbols) == QUANTITIES == list(CALLS)
    by_symbol: dict[str, list[str]] = {}
    for quantity, symbol in book.symbols.items():
        assert symbol, quantity
        by_symbol.setdefault(symbol, []).append(quantity)
    twice = {symbol for symbol, quantities in by_symbol.items() if len(quantities) > 1}
    assert twice == (OVERLOADED if key == "cardan" else set())
    assert len({book.sign(quantity) for quantity in QUANTITIES}) == len(by_symbol)


def test_tables_agree() -> None:
    assert set(NOTATIONS) == set(FORMS) == set(NOTES) == set(book_symbols.BOOKS)
    assert {*LETTERS.values(), *NUMBER_QUANTITIES.values()} <= set(QUANTITIES)
    assert not CARDAN.ours


def subjects() -> dict[str, Any]:
    """Equations with a loop, a ball, forces and beams."""
    ball = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = ball.body("body", mass=1.0, com=(0, 0, -0.3), inertia=(0.1, 0.2, 0.3))
    ball.joint("j", cd.Spherical(), ball.ground, body)
    return {
        "loop": cd.derive(four_bar()),
        "tree": cd.derive(double_pendulum()),
        "ball": cd.derive(ball),
        "nodes": cd.derive(double_pendulum(), coordinates="absolute"),
        "beam": cd.derive(next(iter(FLEXIBLE.values()))()),
    }


cached = cache(subjects)


@pytest.mark.parametrize("key", NOTATIONS)
def test_documents_ask_for_quantities_of_the_table(
    key: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    asked: set[str] = set()
    plain = BookNotation.sign

    def sign(book: BookNotation, quantity: str, index: str = "", dots: int = 0) -> Any:
        assert book.key == key
        asked.add(quantity)
        return plain(book, quantity, index, dots)

    monkeypatch.setattr(BookNotation, "sign", sign)
    for equations in cached().values():
        page = document(equations, notation=key)
        for writer in WRITERS.values():
            texts = writer.write(page, tmp_path / "page")
            assert problems(texts.get(".tex", "")) == []
    assert {"outer_forces", "energy", "base_inertia", "speeds"} <= asked <= set(QUANTITIES)


@cache
def formulas() -> tuple[Any, ...]:
    """Formulas of all kinds of elements that the scenes of the zoo have."""
    lines = dict[Any, None]()
    for build in [*(mechanism.build for mechanism in ZOO.values()), *FLEXIBLE.values()]:
        try:
            equations = cd.derive(build(), coordinates="absolute")
        except cd.CardanError:
            continue
        lines |= dict.fromkeys(kind.formulas for kind in equations.kinds if kind.formulas)
    return tuple(lines)


@pytest.mark.parametrize("key", BOOKS)
def test_formulas_of_elements_only_change_their_names(key: str) -> None:
    assert len(formulas()) > 20
    for lines in formulas():
        renamed = NOTATIONS[key].renamed(lines)
        names: dict[str, str] = {}
        for (_, old), (_, new) in zip(lines, renamed, strict=True):
            trees = [list(ast.walk(ast.parse(line))) for line in (old, new)]
            for a, b in zip(*trees, strict=True):
                assert type(a) is type(b)
                if isinstance(a, ast.Name) and isinstance(b, ast.Name):
                    assert names.setdefault(a.id, b.id) == b.id
            assert typeset(new)
        assert len(set(names.values())) == len(names), lines
        assert CARDAN.renamed(lines) is lines


def test_formulas_in_letters_of_books() -> None:
    lines = (("of p", "d = R.T @ p"), ("", "b = -(G.T @ lam)"), ("", "x = dot(d, omegadot)"))
    assert NOTATIONS["gc"].renamed(lines) == (
        ("of x", "d = R.T @ x"),
        ("", "b = -(B.T @ lam)"),
        ("", "xbar = dot(d, Omegadot)"),
    )
    assert NOTATIONS["rs"].renamed(lines)[0] == ("of r", "d = A.T @ r")
    assert NOTATIONS["kane"].renamed((("", "V = R @ K"),)) == (("", "P = C @ Kbar"),)


def test_forces_of_kane_are_the_equations_of_motion() -> None:
    for name in ("tree", "ball", "loop"):
        equations = cached()[name]
        page = document(equations, notation="kane")
        (section,) = (one for one in page.sections if one.title == "Equations of motion")
        rows = [block for block in section.blocks if isinstance(block, d.Formula)]
        rates = sp.Matrix([sp.Symbol(n) for n in equations.blocks["udot"].entries])
        balance = equations.forces - equations.bias - equations.mass_matrix * rates
        total = {of_rate(speed): sp.Integer(0) for speed in equations.speeds}
        for row in rows:
            if row.left.letter != "F":
                continue
            total[row.left.index] += row.right
            if row.terms:
                assert sp.simplify(sum(part for _, part in row.terms) - row.right) == 0
        for found, expected in zip(total.values(), balance, strict=True):
            assert sp.simplify(found - expected) == 0


def test_partial_velocities_are_columns_of_the_jacobian() -> None:
    equations = cached()["tree"]
    page = document(equations, notation="kane")
    (section,) = (one for one in page.sections if one.title == "Partial velocities")
    table = next(block for block in section.blocks if isinstance(block, d.Table))
    velocity = cd.vectors(equations).center_of_mass("lower").dt().express("lower")
    for body, speed, of, *cells in table.rows:
        if body == "lower" and of == "velocity":
            expected = velocity.diff(speed.expression)
            parts = sp.Matrix([cell.expression for cell in cells]) - expected
            assert sp.simplify(parts) == sp.zeros(3, 1)
    assert {row[2] for row in table.rows} == {"velocity", "angular velocity"}


def test_long_equations_of_kane_are_listed_by_function() -> None:
    equations = cd.derive(cd.load(cd.examples.path("bicycle")))
    page = document(equations, notation="kane")
    (section,) = (one for one in page.sections if one.title == "Equations of motion")
    texts = [x.text for b in section.blocks if isinstance(b, d.Paragraph) for x in b.text
             if isinstance(x, d.Written)]  # fmt: skip
    assert "m_rs" in texts


def test_unknown_notations_are_refused(tmp_path: Path) -> None:
    equations = cached()["tree"]
    with pytest.raises(DerivationError, match=r"no notation 'kan'.*rs, gc, kane.*'kane'"):
        equations.explain(tmp_path / "a.md", notation="kan")
    assert not list(tmp_path.iterdir())
    assert "In the notation of" not in equations.explain(tmp_path / "a.md").read_text("utf-8")


def test_on_the_command_line(tmp_path: Path) -> None:
    scene = cd.examples.path("double_pendulum")
    call = [sys.executable, "-m", "cardan", "inspect", str(scene), "--notation"]
    shown = subprocess.run([*call, "kane"], capture_output=True, text=True, check=True).stdout
    assert "F*[elbow] = " in shown
    assert "PARTIAL VELOCITIES" in shown
    page = tmp_path / "a.md"
    subprocess.run([*call, "gc", "-o", str(page)], capture_output=True, check=True)
    assert "Géradin" in page.read_text("utf-8")
    refused = subprocess.run([*call, "wittenburg"], capture_output=True, text=True, check=False)
    assert refused.returncode == 1
    assert "no notation 'wittenburg'" in refused.stderr


@pytest.mark.parametrize(("place", "text"), list(written()), ids=lambda value: str(value)[:40])
def test_written_of_the_table(place: str, text: str, pytestconfig: pytest.Config) -> None:
    if pytestconfig.getoption("--accept"):
        (ROOT / place).parent.mkdir(parents=True, exist_ok=True)
        (ROOT / place).write_text(text, "utf-8")
    assert (ROOT / place).read_text("utf-8") == text, f"{place} is not of this table: {ACCEPT}"
