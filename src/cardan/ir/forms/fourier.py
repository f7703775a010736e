"""Polynomials in symbols, sines and cosines, kept as Fourier sums.

A product of sines and cosines is a sum of sines and cosines of sums of the angles, and that sum is
unique: kept in this form, sin² + cos² = 1 and sin(a + b) = sin a cos b + cos a sin b need no rule,
equal expressions are equal dictionaries, and what cancels is gone.

Work is counted in products and sums of single terms and stops at a budget, so that the same
expression gives the same result on every machine.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import field
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeVar

from ...records import dataclass
from ..exact import exact
from ..function import operands
from ..graph import Graph

# powers of generators by number: ((3, 2), (5, -1)) is g3²/g5
Mono = tuple[tuple[int, int], ...]
# an angle as multiples of monomials; whole ones are int, which is fast to compare
Multiple = int | Fraction
Angle = tuple[tuple[Mono, Multiple], ...]
# cosine (0) or sine (1) of an angle; cosine of the empty angle is 1
Wave = tuple[int, Angle]
Poly = dict[tuple[Mono, Wave], Fraction]
PolyKey = tuple[tuple[tuple[Mono, Wave], Fraction], ...]
Key = TypeVar("Key", bound=Hashable)
Generator = tuple[Any, ...]  # an operator or "leaf", and its operands

COS, SIN = 0, 1
HALF = Fraction(1, 2)
CONSTANT: Wave = (COS, ())
# terms of a polynomial that somebody reads; products of terms in one step
TERMS, PRODUCTS = 2000, 60_000

# operators that are taken as they are, with nothing inside simplified
OPAQUE = frozenset(["select", "lt", "le", "eq", "and", "or", "not", "table", "item", "solve"])


@dataclass
class Budget:
    """Elementary steps that may still be taken: one product or sum of two terms each."""

    left: int

    def spend(self, steps: int) -> bool:
        """Take the steps where they are left; none are taken otherwise."""
        if steps > self.left:
            return False
        self.left -= steps
        return True


@dataclass
class Expansion:
    """Nodes of a graph as polynomials, each made once.

    Attributes:
        graph: Where the nodes live.
        budget: What may be spent.
        generators: What a generator stands for: ("leaf", node), ("pi",) or
            (operator, polynomials of its operands).
        units: Monomial of an angle -> greatest common divisor of its multiples as written: half
            of it is not an angle of this system.
        polynomials: Node -> its polynomial, None where it is too long.
        long: Nodes too long to be written as part of something that is not a polynomial.
    """

    graph: Graph
    budget: Budget
    generators: list[Generator] = field(default_factory=list)
    units: dict[Mono, Multiple] = field(default_factory=dict)
    polynomials: dict[int, Poly | None] = field(default_factory=dict)
    long: frozenset[int] = frozenset()
    _numbers: dict[Generator, int] = field(default_factory=dict)

    def expand(self, nodes: Iterable[int]) -> None:
        """Make the polynomials of nodes in topological order."""
        for i in nodes:
            if i not in self.polynomials:
                value = self._node(i)
                self.polynomials[i] = value if value is None or len(value) <= TERMS else None

    def _node(self, i: int) -> Poly | None:
        node = self.graph.nodes[i]
        op = node[0]
        if op == "const":
            return self._number(node[1])
        if op in ("var", "atom") or op in OPAQUE:
            return self._alone(("leaf", i))
        terms = [self.polynomials[k] for k in operands(node)]
        if any(value is None for value in terms):
            return None
        values = [value for value in terms if value is not None]
        if op in ("add", "sub"):
            return self.sum(values[0], values[1], -1 if op == "sub" else 1)
        if op == "neg":
            return {key: -c for key, c in values[0].items()}
        if op == "mul":
            return self.product(*values)
        if op == "div":
            if len(values[1]) > 1 and i in self.long:
                return None
            return self.product(values[0], self._inverse(values[1]))
        if op in ("sin", "cos") and _still(values[0]):
            angle = tuple(sorted((mono, lean(c)) for (mono, _), c in values[0].items()))
            for mono, multiple in angle:
                self.units[mono] = _divisor(self.units.get(mono, 0), multiple)
            wave, sign = canonical(SIN if op == "sin" else COS, angle)
            return {((), wave): Fraction(sign)} if sign else {}
        if i in self.long:
            return None
        if op in ("sin", "cos"):
            # what moves inside it is one angle as a whole
            angle = ((self._generator(("whole", _frozen(values[0]))), 1),)
            return {((), (SIN if op == "sin" else COS, angle)): Fraction(1)}
        return self._alone((op, *(_frozen(value) for value in values)))

    def _number(self, value: float) -> Poly:
        turns = _of_pi(value)
        if turns is not None:
            return {(self._generator(("pi",)), CONSTANT): turns}
        return {((), CONSTANT): exact(value)} if value else {}

    def sum(self, a: Poly, b: Poly, sign: int = 1) -> Poly | None:
        """a + sign b."""
        if not self.budget.spend(len(b)):
            return None
        total = dict(a)
        for key, c in b.items():
            accumulate(total, key, sign * c)
        return total

    def product(self, a: Poly, b: Poly) -> Poly | None:
        """a b, products of waves as sums of waves."""
        steps = len(a) * len(b)
        if steps > PRODUCTS or not self.budget.spend(steps):
            return None
        result: Poly = {}
        for (mono_a, wave_a), c in a.items():
            for (mono_b, wave_b), d in b.items():
                mono, value = times(mono_a, mono_b), c * d
                if wave_a != CONSTANT and wave_b != CONSTANT:
                    value = value * HALF
                for wave, sign in beats(wave_a, wave_b):
                    accumulate(result, (mono, wave), value if sign == 1 else -value)
        return result

    def _generator(self, key: Generator) -> Mono:
        if key not in self._numbers:
            self._numbers[key] = len(self.generators)
            self.generators.append(key)
        return ((self._numbers[key], 1),)

    def _alone(self, key: Generator) -> Poly:
        return {(self._generator(key), CONSTANT): Fraction(1)}

    def _inverse(self, a: Poly) -> Poly:
        """1 / a: of a monomial a monomial, of a sum a generator."""
        if len(a) == 1:
            ((mono, wave), c), *_ = a.items()
            if wave == CONSTANT:
                return {(tuple((g, -n) for g, n in mono), CONSTANT): 1 / c}
        return self._alone(("inverse", _frozen(a)))


def accumulate(sums: dict[Key, Fraction], key: Key, c: Fraction) -> None:
    """Add to an entry of a sum; what becomes zero goes."""
    total = sums[key] + c if key in sums else c
    if total:
        sums[key] = total
    else:
        sums.pop(key, None)


@lru_cache(maxsize=65536)
def times(a: Mono, b: Mono) -> Mono:
    """Product of two monomials."""
    if not a or not b:
        return a or b
    powers = dict(a)
    for g, n in b:
        powers[g] = powers.get(g, 0) + n
    return tuple(sorted((g, n) for g, n in powers.items() if n))


def canonical(kind: int, angle: Angle) -> tuple[Wave, int]:
    """A wave with a positive leading multiple, and its sign; sign 0 where it vanishes."""
    if not angle:
        return CONSTANT, 0 if kind == SIN else 1
    if angle[0][1] > 0:
        return (kind, angle), 1
    return (kind, tuple((mono, -c) for mono, c in angle)), -1 if kind == SIN else 1


def lean(value: Multiple) -> Multiple:
    """Whole numbers as int."""
    return value.numerator if value.denominator == 1 else value


def combined(a: Angle, b: Angle, sign: int = 1) -> Angle:
    """a + b or a - b."""
    sums = dict(a)
    for mono, c in b:
        total = sums.get(mono, 0) + sign * c
        if total:
            sums[mono] = lean(total)
        else:
            del sums[mono]
    return tuple(sorted(sums.items()))


def half(a: Angle) -> Angle:
    """a / 2."""
    return tuple((mono, lean(HALF * c)) for mono, c in a)


@lru_cache(maxsize=65536)
def beats(a: Wave, b: Wave) -> tuple[tuple[Wave, int], ...]:
    """Waves and signs of a product: a b is half their sum, the sum itself where one is constant.

    cos a cos b = (cos(a - b) + cos(a + b)) / 2 and its sisters.
    """
    if a == CONSTANT or b == CONSTANT:
        return ((b if a == CONSTANT else a, 1),)
    (kind_a, x), (kind_b, y) = a, b
    if kind_a == COS and kind_b == SIN:
        (kind_a, x), (kind_b, y) = b, a
    kind = SIN if kind_a != kind_b else COS
    waves = []
    for sign in (-1, 1):
        wave, sign_change = canonical(kind, combined(x, y, sign))
        flip = -1 if kind_a == kind_b == SIN and sign == 1 else 1
        if sign_change:
            waves.append((wave, sign_change * flip))
    return tuple(waves)


def _still(a: Poly) -> bool:
    """True when no sine or cosine is in it."""
    return all(wave == CONSTANT for _, wave in a)


def _of_pi(value: float) -> Fraction | None:
    """value / pi where that is a simple fraction, exactly."""
    simple = Fraction(value / math.pi).limit_denominator(12)
    return simple if simple and float(simple) * math.pi == value else None


def _divisor(a: Multiple, b: Multiple) -> Multiple:
    """Greatest common divisor of two fractions."""
    d = math.lcm(a.denominator, b.denominator)
    return Fraction(math.gcd(int(a * d), int(b * d)), d)


def _frozen(a: Mapping[tuple[Mono, Wave], Fraction]) -> PolyKey:
    return tuple(sorted(a.items()))
