"""Fourier sums as short sums of products: 1/2 - cos(2a)/2 is sin²a again.

Two terms that differ in one wave meet by the sum-to-product formulas,
cos a + cos b = 2 cos((a + b)/2) cos((a - b)/2) and its three sisters, as long as that saves
operations. A constant counts as cos 0, so that squares are found by the same rule.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from .fourier import (
    CONSTANT,
    COS,
    SIN,
    Angle,
    Budget,
    Mono,
    Multiple,
    Wave,
    accumulate,
    canonical,
    combined,
    half,
)

# factors of a term in their order, equal ones repeated
Product = tuple[Wave, ...]
Sum = dict[Product, Fraction]
# waves of one coefficient beyond which nothing is tried
MOST = 24


def shortest(waves: Mapping[Wave, Fraction], units: Mapping[Mono, Multiple], budget: Budget) -> Sum:
    """Few short products equal to a sum of waves.

    Args:
        waves: The sum.
        units: Angles that occur: no other angle is halved further.
        budget: Every pair of terms that is compared costs a step.
    """
    terms: Sum = {() if wave == CONSTANT else (wave,): c for wave, c in waves.items()}
    while 1 < len(terms) <= MOST and budget.spend(len(terms) ** 2):
        best, gain = None, (0, 0)
        items = sorted(terms.items())
        for i, (p, a) in enumerate(items):
            for q, b in items[:i]:
                before = cost(p, a) + cost(q, b) + 1
                for merged in _merged(p, a, q, b, units):
                    after = sum(cost(x, c) for x, c in merged.items()) + len(merged) - 1
                    # of two forms as long the one with fewer terms
                    if (before - after, 2 - len(merged)) > gain:
                        best, gain = (p, q, merged), (before - after, 2 - len(merged))
        if best is None:
            break
        p, q, merged = best
        del terms[p], terms[q]
        for product, c in merged.items():
            accumulate(terms, product, c)
    return terms


def cost(product: Product, c: Fraction) -> int:
    """Operations of a term: functions, their arguments, powers, products, the number in front."""
    count = sum(1 + _written(angle) for _, angle in set(product))
    powers = sum(product.count(wave) > 1 for wave in set(product))
    number = (abs(c.numerator) != 1) + (c.denominator != 1)
    return count + powers + max(len(set(product)) - 1, 0) + number


def _written(angle: Angle) -> int:
    """Operations of an argument."""
    return len(angle) - 1 + sum(abs(c) != 1 for _, c in angle)


def split(terms: Mapping[Product, Fraction], units: Mapping[Mono, Multiple]) -> Sum:
    """The sine of a double angle as 2 sin cos."""
    products: Sum = {}
    for product, c in terms.items():
        factors: list[Wave] = []
        for kind, angle in product:
            single = half(angle)
            if kind == SIN and _is_multiple(single, units):
                factors += [(SIN, single), (COS, single)]
                c = 2 * c
            else:
                factors.append((kind, angle))
        accumulate(products, tuple(sorted(factors)), c)
    return products


def _merged(
    p: Product, a: Fraction, q: Product, b: Fraction, units: Mapping[Mono, Multiple]
) -> Iterator[Sum]:
    """Sums that equal a p + b q."""
    common, (left, right) = _difference(p, q)
    if len(left) > 1 or len(right) > 1:
        return
    (kind, x), (other, y) = (left or (CONSTANT,))[0], (right or (CONSTANT,))[0]
    if kind != other:
        return
    plus, minus = half(combined(x, y, 1)), half(combined(x, y, -1))
    if not (_is_multiple(plus, units) and _is_multiple(minus, units)):
        return
    if abs(a) == abs(b):
        yield _pair(common, kind, a, 1 if a == b else -1, plus, minus)
    elif not (left and right):
        # c0 + c1 cos 2x, by the square of either
        (one, c0), (c1, double) = ((p, a), (b, y)) if not left else ((q, b), (a, x))
        single = half(double)
        for wave, sign in (((COS, single), 1), ((SIN, single), -1)):
            yield {tuple(sorted((*common, wave, wave))): 2 * sign * c1, one: c0 - sign * c1}


def _pair(common: Product, kind: int, a: Fraction, sign: int, plus: Angle, minus: Angle) -> Sum:
    """common a (f(x) + sign f(y)) as a product."""
    if kind == COS:
        waves = (COS, COS) if sign == 1 else (SIN, SIN)
        a = a if sign == 1 else -a
    else:
        waves = (SIN, COS) if sign == 1 else (COS, SIN)
    first, s = canonical(waves[0], plus)
    second, t = canonical(waves[1], minus)
    # a constant of the formulas disappears: cos 0 = 1
    factors = [wave for wave in (first, second) if wave != CONSTANT]
    return {tuple(sorted((*common, *factors))): 2 * a * s * t} if s * t else {}


def _difference(p: Product, q: Product) -> tuple[Product, tuple[Product, Product]]:
    """Common factors of two products, and what is left of each."""
    left, right, common = list(p), list(q), []
    for wave in p:
        if wave in right:
            left.remove(wave)
            right.remove(wave)
            common.append(wave)
    return tuple(common), (tuple(left), tuple(right))


def _is_multiple(angle: Angle, units: Mapping[Mono, Multiple]) -> bool:
    """True when an angle is made of whole multiples of what occurs."""
    return all(mono in units and (Fraction(c) / units[mono]).denominator == 1 for mono, c in angle)
