"""Sums of products of powers in the form people write: common factors before brackets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm

from ...records import dataclass
from ..exact import is_fraction

Powers = Mapping[Hashable, int]
Term = tuple[Fraction, Powers]
Rank = Callable[[Hashable, int], tuple[bool | int | str, ...]]


@dataclass(frozen=True)
class Nested:
    """A number times powers of factors times a sum: -2 l m (x + y).

    Attributes:
        number: In front.
        powers: Factors and their exponents; a factor may be a :class:`Bracket`.
        inside: Summands of the last bracket, () where there is none.
    """

    number: Fraction
    powers: tuple[tuple[Hashable, int], ...]
    inside: tuple[Nested, ...] = ()


@dataclass(frozen=True)
class Bracket:
    """A sum that several terms have as a factor."""

    parts: frozenset[Nested]


def nested(terms: Sequence[Term], rank: Rank) -> Nested:
    """A sum with common factors taken out.

    Args:
        terms: Number and powers of each term.
        rank: (factor, terms that have it) -> the larger, the earlier it is taken out.
    """
    number, powers = _common(terms)
    remaining = [_divided(term, number, powers) for term in terms]
    front = tuple(powers.items())
    if len(remaining) == 1:
        return Nested(number, front)
    parts: list[Nested] = []
    while remaining:
        best = _best(remaining, rank)
        if best is None:
            parts += [Nested(c, tuple(exponents.items())) for c, exponents in remaining]
            break
        group = [term for term in remaining if term[1].get(best, 0) > 0]
        remaining = [term for term in remaining if term[1].get(best, 0) <= 0]
        parts.append(nested(group, rank))
    brackets = Counter(frozenset(part.inside) for part in parts if part.inside)
    if not any(count > 1 for count in brackets.values()):
        return Nested(number, front, tuple(parts))
    # brackets that stand in several parts are factors like any other
    again = nested([_bracketed(part) for part in parts], rank)
    both = Counter(dict(again.powers))
    both.update(powers)
    return Nested(number * again.number, tuple(both.items()), again.inside)


def _bracketed(part: Nested) -> Term:
    powers = dict(part.powers)
    if part.inside:
        powers[Bracket(frozenset(part.inside))] = 1
    return part.number, powers


def _best(terms: Sequence[Term], rank: Rank) -> Hashable:
    """The factor to be taken out of several terms, None where they have none in common."""
    counts = Counter(factor for _, powers in terms for factor, n in powers.items() if n > 0)
    several = (factor for factor, count in counts.items() if count > 1)
    return max(several, key=lambda factor: rank(factor, counts[factor]), default=None)


def flat(terms: Sequence[Term]) -> Nested:
    """A sum as it stands."""
    parts = tuple(Nested(c, tuple(powers.items())) for c, powers in terms)
    return parts[0] if len(parts) == 1 else Nested(Fraction(1), (), parts)


def _common(terms: Sequence[Term]) -> tuple[Fraction, Powers]:
    """Greatest common factor; its sign is that of most terms, of the first where they balance."""
    numerator = gcd(*(c.numerator for c, _ in terms))
    number = Fraction(numerator, lcm(*(c.denominator for c, _ in terms)))
    if not is_fraction(number) and all(abs(c) != number for c, _ in terms):
        # x - 0.9 and not 0.1 (10 x - 9); measured numbers have nothing in common
        number = Fraction(1)
    if sum(1 if c < 0 else -1 for c, _ in terms) >= (terms[0][0] > 0):
        number = -number
    powers: dict[Hashable, int] = {}
    for factor in terms[0][1]:
        exponents = [powers_of.get(factor, 0) for _, powers_of in terms]
        least = min(exponents, key=abs)
        # of powers with different signs nothing is common
        if least and all(n * least > 0 for n in exponents):
            powers[factor] = least
    return number, powers


def _divided(term: Term, number: Fraction, powers: Powers) -> Term:
    c, exponents = term
    left = {factor: n - powers.get(factor, 0) for factor, n in exponents.items()}
    return c / number, {factor: n for factor, n in left.items() if n}
