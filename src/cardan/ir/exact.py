"""The exact number that a float stands for: 1/12 where somebody wrote m*l**2/12."""

from __future__ import annotations

from fractions import Fraction

# denominators of fractions that people write
LARGEST = 1000


def exact(value: float) -> Fraction:
    """The simple fraction that rounds to a float, else its shortest decimal."""
    simple = Fraction(value).limit_denominator(LARGEST)
    return simple if float(simple) == value else Fraction(repr(value))


def is_fraction(value: Fraction) -> bool:
    """True when a book would write p/q: halves, thirds, 1/12, 3/128, but 0.05 and not 1/20."""
    q = value.denominator
    if q <= 9 or (q & (q - 1) == 0 and q <= 1024):
        return True
    while q % 2 == 0 or q % 5 == 0:
        q //= 2 if q % 2 == 0 else 5
    # what has no finite decimal is a fraction
    return q > 1 and value.denominator <= LARGEST
