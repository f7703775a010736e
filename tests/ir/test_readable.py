"""The readable form: identities found, exact numbers, never worse, and the budget kept."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from cardan.ir.arithmetic import Scalar
from cardan.ir.exact import exact, is_fraction
from cardan.ir.forms.fourier import PRODUCTS, TERMS, Budget, Expansion, Poly
from cardan.ir.forms.readable import TooLong, readable
from cardan.ir.forms.sympy_bridge import from_sympy, to_sympy
from cardan.ir.function import live
from cardan.ir.graph import Graph
from table import each

a, b, c, m, l, k = sp.symbols("a b c m l k")
SYMBOLS = (a, b, c, m, l, k)


def scalar(expression: sp.Expr) -> Scalar:
    """An expression in a graph of its own; nothing is simplified that SymPy left."""
    graph = Graph()
    nodes = {symbol: graph.atom(symbol.name) for symbol in SYMBOLS}
    return Scalar(graph, from_sympy(graph, expression, nodes))


def read(expression: sp.Expr) -> sp.Expr:
    return readable(scalar(expression))


@each(
    ("given", "form"),
    [
        (m * sp.sin(a) ** 2 + m * sp.cos(a) ** 2, m),
        (sp.sin(a) * sp.cos(b) + sp.cos(a) * sp.sin(b), sp.sin(a + b)),
        (sp.cos(a) * sp.cos(b) + sp.sin(a) * sp.sin(b), sp.cos(a - b)),
        (sp.cos(a) * sp.cos(b), sp.cos(a) * sp.cos(b)),
        (sp.cos(a) * sp.cos(b) * sp.sin(c), sp.sin(c) * sp.cos(a) * sp.cos(b)),
        (2 * m * sp.sin(a) * sp.cos(a), m * sp.sin(2 * a)),
        (m - m * sp.sin(a) ** 2, m * sp.cos(a) ** 2),
        (sp.cos(a) ** 2 - sp.sin(a) ** 2, sp.cos(2 * a)),
        (1 + sp.cos(a) ** 2, 1 + sp.cos(a) ** 2),
        (m * l**2 / 12 + m * (l / 2) ** 2, m * l**2 / 3),
        (m * l**2 * sp.cos(a) + m * l * k * sp.cos(a), l * m * (k + l) * sp.cos(a)),
        (sp.sqrt(k * sp.sin(a) ** 2 + k * sp.cos(a) ** 2), sp.sqrt(k)),
        ((m * k + l * k) / (m + l), k * (l + m) / (l + m)),
        (m * sp.sin(sp.pi * a) ** 2 + m * sp.cos(sp.pi * a) ** 2, m),
        (sp.sin(a * b) * sp.cos(a * b), sp.sin(2 * a * b) / 2),
        (sp.Integer(0), sp.Integer(0)),
    ],
)
def test_forms(given: sp.Expr, form: sp.Expr) -> None:
    assert read(given) == form


def test_common_brackets_are_factors() -> None:
    given = sp.expand((2 * a + b) * (m + l) * k)
    assert read(given).count_ops() <= (k * (2 * a + b) * (m + l)).count_ops()


def test_angles_are_halved_only_where_halves_occur() -> None:
    found = read(sp.cos(a) + sp.cos(b))
    assert found == sp.cos(a) + sp.cos(b)
    assert read(sp.cos(2 * a) / 2 + sp.Rational(1, 2)).count_ops() <= 5


def test_what_is_no_polynomial_is_kept() -> None:
    given = sp.Piecewise((sp.sin(a) * m, a > 0), (k, True)) * sp.Abs(l) + sp.atan2(a, b)
    assert sp.simplify(read(given) - given) == 0


@pytest.mark.parametrize(
    ("value", "fraction", "shown"),
    [
        (1 / 12, Fraction(1, 12), True),
        (2 / 5, Fraction(2, 5), True),
        (0.05, Fraction(1, 20), False),
        (3 / 128, Fraction(3, 128), True),
        (9.81, Fraction(981, 100), False),
        (0.123456789012, Fraction(123456789012, 10**12), False),
    ],
)
def test_exact_numbers(value: float, fraction: Fraction, shown: bool) -> None:
    assert exact(value) == fraction
    assert is_fraction(fraction) is shown


leaves = st.sampled_from(
    [*SYMBOLS, *(f(x) for f in (sp.sin, sp.cos) for x in (a, b, a + b, 2 * c))]
)


def joined(children: st.SearchStrategy[sp.Expr]) -> st.SearchStrategy[sp.Expr]:
    pairs = st.tuples(children, children, st.sampled_from(["+", "-", "*"]))
    return pairs.map(
        lambda p: p[0] + p[1] if p[2] == "+" else p[0] - p[1] if p[2] == "-" else p[0] * p[1]
    )


@given(st.recursive(leaves, joined, max_leaves=12))
@settings(max_examples=150, deadline=None)
def test_equal_and_never_worse(expression: sp.Expr) -> None:
    x = scalar(expression)
    before, after = to_sympy(x), readable(x)
    values = {s: sp.Rational(7 + 3 * n, 11) for n, s in enumerate(SYMBOLS)}
    assert abs(sp.N((before - after).subs(values), 30)) < 1e-20
    fewer_terms = terms(after) < terms(before)
    assert after.count_ops() <= before.count_ops() or fewer_terms


def terms(expression: sp.Expr) -> int:
    return len(sp.Add.make_args(sp.expand(expression)))


def power_of_a_sum(n: int) -> Scalar:
    """Short as it is, endless multiplied out."""
    total = sum(sp.cos(x) * y for x in (a, b, c) for y in (m, l, k))
    x = scalar(total)
    result = x
    for _ in range(n):
        result = result * x
    return result


class Counting(Budget):
    """A budget that writes down what is taken from it."""

    def __init__(self, left: int) -> None:
        super().__init__(left)
        self.taken: list[int] = []

    def spend(self, steps: int) -> bool:
        allowed = super().spend(steps)
        if allowed:
            self.taken.append(steps)
        return allowed


@pytest.mark.parametrize("steps", [0, 10, 1000, 100_000])
def test_the_budget_is_kept(steps: int) -> None:
    budget = Counting(steps)
    x = power_of_a_sum(6)
    found = readable(x, budget=budget)
    assert sum(budget.taken) <= steps
    assert max(budget.taken, default=0) <= max(PRODUCTS, TERMS**2)
    # what is not simplified comes back as it went in
    values = {s: sp.Rational(1, n + 2) for n, s in enumerate(SYMBOLS)}
    assert abs(sp.N((found - to_sympy(x)).subs(values), 30)) < 1e-20


def test_every_product_is_paid_for(monkeypatch: pytest.MonkeyPatch) -> None:
    # the work itself is counted: products of terms made against steps paid
    made = 0
    product = Expansion.product

    def counted(self: Expansion, p: Poly, q: Poly) -> Poly | None:
        nonlocal made
        result = product(self, p, q)
        made += len(p) * len(q) if result is not None else 0
        return result

    monkeypatch.setattr(Expansion, "product", counted)
    x = power_of_a_sum(8)
    budget = Budget(50_000)
    expansion = Expansion(x.graph, budget)
    expansion.expand(live(x.graph, [x.node]))
    assert 0 < made <= 50_000 - budget.left <= 50_000
    assert expansion.polynomials[x.node] is None


def test_decimals_stay_what_they_were() -> None:
    assert str(read(m * (a - sp.Float(0.9)))) == "m*(a - 0.9)"
    assert str(read(sp.Float(0.7) * a * m + sp.Float(0.7) * b * m)) == "0.7*m*(a + b)"
    cosine, sine = sp.Float(0.955336489125606), sp.Float(0.29552020666134)
    found = read((cosine * a + sine * b) * (cosine * b - sine * a) * (cosine * m + sine * l))
    assert max(len(str(x)) for x in found.atoms(sp.Number)) < 20
    assert all(abs(x) < 10 for x in found.atoms(sp.Number))


def test_too_long_is_said() -> None:
    x = scalar(sp.sqrt(a) + b)
    for _ in range(14):
        x = (x * x + x * scalar_like(x, "a")).apply("exp")
    with pytest.raises(TooLong) as caught:
        readable(x)
    assert caught.value.operations > 10_000


def scalar_like(x: Scalar, name: str) -> Scalar:
    return Scalar(x.graph, x.graph.atom(name))
