"""Functions as SymPy matrices in the form of a textbook. Loads SymPy: import it on demand.

Every entry becomes a Fourier sum (:mod:`.fourier`), its waves short products again
(:mod:`.sum_to_product`), and common factors are taken out (:mod:`.nesting`). Of the forms found the
one with fewest terms is kept, and of these the one with fewest operations. An entry never gets
more operations than it came with, unless it has fewer terms then: I1 sin² + I3 cos² replaces
I3 + (I1 - I3) sin².
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from fractions import Fraction
from math import inf, prod
from typing import cast

import sympy

from ..exact import is_fraction
from ..function import live, operands
from ..graph import Graph
from ..ops import LEAVES
from .fourier import COS, OPAQUE, Budget, Expansion, Mono, Poly, PolyKey, Wave
from .nesting import Bracket, Nested, Rank, Term, flat, nested
from .sum_to_product import Sum, shortest, split
from .sympy_out import Leaves, Names, What, applied, expression_of, shaped, written_out

Form = tuple[float, float, sympy.Expr]  # operations, brackets and the expression
# elementary steps for all entries together: a few seconds at most
STEPS = 500_000
# operations of an entry that is written out; terms whose common factors are looked for in every way
LONGEST, NESTED = 4000, 120
# operations of a sum before anything is taken out that may get short enough; steps to write one
FLAT, WRITING = 4 * LONGEST, 4
# operations inside a function: longer ones nobody reads, and SymPy looks through for minutes
INSIDE = 200
# whole numbers beyond are written as floats
WRITTEN = 10**12


class TooLong(Exception):
    """An entry has too many operations to be read: ``operations`` of them, at least."""

    def __init__(self, operations: int) -> None:
        super().__init__(operations)
        self.operations = operations


def readable(
    what: What, names: Names | None = None, budget: Budget | None = None, longest: int = 0
) -> sympy.Expr:
    """Expressions written out as people write them.

    Args:
        what, names: As for :func:`cardan.ir.forms.sympy_out.to_sympy`.
        budget: Steps that simplification may take; what is over budget stays as it came.
        longest: Operations of an entry beyond which nothing is tried; by default there is no such
            limit as long as its simplified form can be read.

    Returns:
        A SymPy matrix, or an expression for a Scalar.

    Raises:
        TooLong: an entry is too long to be read, simplified or not.
    """
    graph, roots, rows, columns = written_out(what)
    if longest:
        sizes, _ = _sizes(graph, live(graph, roots))
        if max(sizes[root] for root in roots) > longest:
            raise TooLong(max(sizes[root] for root in roots))
    writer = Writer(graph, roots, Leaves(graph, what, names), budget or Budget(STEPS))
    entries = {root: writer.entry(root) for root in dict.fromkeys(roots)}
    return shaped(what, rows, columns, [entries[root] for root in roots])


class Writer:
    """Writes nodes of a graph.

    Args:
        graph: The graph.
        roots: Nodes that will be asked for.
        leaves: Symbols of inputs.
        budget: Steps for all of them.
    """

    def __init__(self, graph: Graph, roots: Sequence[int], leaves: Leaves, budget: Budget) -> None:
        order = live(graph, roots)
        self.sizes, self.terms = _sizes(graph, order)
        long = frozenset(i for i in order if self.sizes[i] > LONGEST)
        self.expansion = Expansion(graph, budget, long=long)
        # what is taken as a whole must be short enough to be written
        wholes = [i for i in order if graph.nodes[i][0] in (*OPAQUE, "var", "atom")]
        unwritten = _long(graph, order, self.sizes)
        short = [i for i in (*roots, *wholes) if i not in unwritten]
        self.plain: dict[int, sympy.Expr] = {}
        for i in live(graph, short):
            self.plain[i] = expression_of(graph, i, self.plain, leaves)
        self.expansion.polynomials.update((i, None) for i in wholes if i not in self.plain)
        self.expansion.expand(order)
        self._written: dict[PolyKey, Form] = {}
        self._sizes: dict[int, float] = {}

    def entry(self, root: int) -> sympy.Expr:
        """The best form of a node that is found.

        Raises:
            TooLong: none is short enough.
        """
        plain = self.plain.get(root)
        poly = self.expansion.polynomials[root]
        forms = [] if poly is None else self.forms(poly)
        if plain is None:
            short = [form for form in forms if form[1] <= LONGEST]
            if not short:
                raise TooLong(self.sizes[root])
            return min(short, key=_measure)[2]
        operations, terms = plain.count_ops(), self._plain_terms(root)
        better = [form for form in forms if form[1] <= operations or form[0] < terms]
        return min(better, key=_measure)[2] if better else plain

    def _plain_terms(self, root: int) -> int:
        """Terms of an entry as it came, multiplied out; 0 where they are many."""
        if self.terms[root] > NESTED:
            return 0
        return len(sympy.Add.make_args(sympy.expand(_opaque(self.plain[root], {}))))

    def forms(self, poly: Poly) -> list[Form]:
        """Ways to write a polynomial: terms, operations, expression."""
        forms: list[Form] = [] if poly else [(0, 0, sympy.Integer(0))]
        budget = self.expansion.budget
        for terms in self._sums(poly):
            # what is written inside other functions again and again may be long as a whole only
            size = sum(self._size(factor) for _, powers in terms for factor in powers)
            if size > FLAT:
                continue
            nests = [flat(terms)]
            for rank in RANKS if len(terms) <= NESTED else RANKS[:1]:
                # looking at a factor takes a twentieth of the time of a product
                if budget.spend(len(terms) ** 2 // 20):
                    nests.append(nested(terms, rank))
            for nest in nests:
                if budget.spend(WRITING * (len(terms) + int(size))):
                    expression = self._write(nest)
                    forms.append((len(terms), expression.count_ops(), expression))
        return forms

    def _size(self, factor: sympy.Expr) -> float:
        """Operations of a factor at most; infinite where it is too long to be written."""
        if not isinstance(factor, int):
            _, angle = factor
            return 1 + sum(2 + self._size(g) for mono, _ in angle for g, _ in mono)
        if factor not in self._sizes:
            op, *arguments = self.expansion.generators[factor]
            polys = arguments if op not in ("leaf", "pi") else []
            inside = max((self._poly(poly)[1] for poly in polys), default=0)
            self._sizes[factor] = 1.0 + inside if inside <= INSIDE else inf
            if op == "leaf":
                self._sizes[factor] += self.sizes[arguments[0]]
        return self._sizes[factor]

    def _sums(self, poly: Poly) -> list[list[Term]]:
        """The terms of a polynomial, with short products of waves in two variants."""
        units, budget = self.expansion.units, self.expansion.budget
        monos: dict[Mono, dict[Wave, Fraction]] = {}
        for (mono, wave), c in poly.items():
            monos.setdefault(mono, {})[wave] = c
        short = {mono: shortest(waves, units, budget) for mono, waves in monos.items()}
        halved = {mono: split(terms, units) for mono, terms in short.items()}
        variants = [short] if halved == short else [halved, short]
        variants = variants if poly else []
        return [_terms(variant) for variant in variants]

    def _poly(self, key: PolyKey) -> Form:
        """The best form of a polynomial inside a generator; one without end where there is none."""
        if key not in self._written:
            forms: list[Form] = self.forms(dict(key))
            self._written[key] = min(forms, key=_measure, default=(inf, inf, None))
        return self._written[key]

    def _write(self, form: Nested) -> sympy.Expr:
        factors = [_number(form.number), *(self._factor(key) ** n for key, n in form.powers)]
        if form.inside:
            factors.append(sympy.Add(*(self._write(part) for part in form.inside)))
        if len(factors) == 2 and form.inside and abs(form.number) != 1:
            # SymPy would multiply a number alone into the bracket
            return sympy.Mul(*factors, evaluate=False)
        return sympy.Mul(*factors)

    def _factor(self, key: Hashable) -> sympy.Expr:
        """A generator by its number, a wave, or a sum in brackets."""
        if isinstance(key, Bracket):
            return sympy.Add(*(self._write(part) for part in key.parts))
        if isinstance(key, tuple):
            kind, angle = key
            argument = sympy.Add(*(_number(Fraction(c)) * self._mono(mono) for mono, c in angle))
            return sympy.cos(argument) if kind == COS else sympy.sin(argument)
        op, *arguments = self.expansion.generators[cast(int, key)]
        if op == "leaf":
            return self.plain[arguments[0]]
        if op == "pi":
            return sympy.pi
        written = [self._poly(poly)[2] for poly in arguments]
        if op == "inverse":
            return 1 / written[0]
        return written[0] if op == "whole" else applied(op, *written)

    def _mono(self, mono: Mono) -> sympy.Expr:
        return sympy.Mul(*(self._factor(g) ** n for g, n in mono))


def _terms(sums: Mapping[Mono, Sum]) -> list[Term]:
    """Monomials times products of waves as terms with powers of both."""
    terms: list[Term] = []
    for mono, products in sorted(sums.items()):
        for product, c in sorted(products.items()):
            powers: dict[Hashable, int] = dict(mono)
            for wave in product:
                powers[wave] = powers.get(wave, 0) + 1
            terms.append((c, powers))
    return terms


def _number(c: Fraction) -> sympy.Expr:
    if is_fraction(c) and abs(c.numerator) < WRITTEN:
        return sympy.Rational(c.numerator, c.denominator)
    return sympy.Float(float(c))


def _sizes(graph: Graph, order: Sequence[int]) -> tuple[dict[int, int], dict[int, int]]:
    """Operations of every node written out in full, and its terms when that is multiplied out."""
    sizes: dict[int, int] = {}
    terms: dict[int, int] = {}
    for i in order:
        node = graph.nodes[i]
        read = operands(node)
        sizes[i] = sum(sizes[k] for k in read) + (node[0] not in LEAVES)
        counts = [terms[k] for k in read]
        if node[0] in ("add", "sub"):
            terms[i] = sum(counts)
        else:
            terms[i] = (
                prod(counts) if node[0] == "mul" else counts[0] if node[0] in ("neg", "div") else 1
            )
    return sizes, terms


def _long(graph: Graph, order: Sequence[int], sizes: Mapping[int, int]) -> frozenset[int]:
    """Nodes that are too long to be written, as a whole or inside a function."""
    long_nodes: set[int] = set()
    for i in order:
        read = operands(graph.nodes[i])
        function = graph.nodes[i][0] not in POLYNOMIAL
        inside = max((sizes[k] for k in read), default=0) if function else 0
        if sizes[i] > LONGEST or inside > INSIDE or any(k in long_nodes for k in read):
            long_nodes.add(i)
    return frozenset(long_nodes)


def _opaque(expression: sympy.Expr, dummies: dict[sympy.Expr, sympy.Expr]) -> sympy.Expr:
    """An expression with symbols for what multiplying out would only expand inside."""
    kind = expression.func
    if not expression.args or not (kind in (sympy.Add, sympy.Mul) or _is_power(expression)):
        return expression if expression.is_Atom else dummies.setdefault(expression, sympy.Dummy())
    return kind(*(_opaque(part, dummies) for part in expression.args))


def _is_power(expression: sympy.Expr) -> bool:
    return bool(expression.is_Pow and expression.exp.is_Integer and expression.exp > 0)


def _measure(form: Form) -> tuple[float, float]:
    return form[0], form[1]


def _frequent(factor: Hashable, count: int) -> tuple[bool | int | str, ...]:
    return isinstance(factor, Bracket), count, not isinstance(factor, tuple), str(factor)


def _first_declared(factor: Hashable, count: int) -> tuple[bool | int | str, ...]:
    declared = -factor if isinstance(factor, int) else 0
    return isinstance(factor, Bracket), not isinstance(factor, tuple), declared, str(factor)


def _waves(factor: Hashable, count: int) -> tuple[bool | int | str, ...]:
    return isinstance(factor, Bracket), isinstance(factor, tuple), count, str(factor)


POLYNOMIAL = frozenset(["add", "sub", "mul", "div", "neg", *LEAVES])
# which factor is taken out first
RANKS: tuple[Rank, ...] = (_frequent, _waves, _first_declared)
