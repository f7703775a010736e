"""Pairwise covering arrays: few sets in which every two entries meet at least once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import combinations

Pair = frozenset[str]


def pairs_of(names: Iterable[str]) -> set[Pair]:
    """All pairs of a set."""
    return {frozenset(pair) for pair in combinations(sorted(names), 2)}


def covering(
    names: Sequence[str], size: int, complete: Callable[[Iterable[str]], tuple[str, ...]]
) -> list[tuple[str, ...]]:
    """Sets of about ``size`` names in which every pair occurs, found greedily.

    Each set begins with a pair that is left, and takes the name that covers the most pairs that are
    left until it is full; of equals the one with the most pairs left altogether, then the first.

    Args:
        names: What is combined.
        size: Names of a set; what they require comes besides.
        complete: Names with all that they require.

    Source: D. M. Cohen, S. R. Dalal, M. L. Fredman, G. C. Patton, The AETG system, IEEE
        Transactions on Software Engineering 23 (1997).
    """
    order = {name: k for k, name in enumerate(names)}
    left, sets = pairs_of(names), []
    while left:
        degree = {name: sum(name in pair for pair in left) for name in names}
        first = min(left, key=lambda p: (-sum(degree[n] for n in p), sorted(order[n] for n in p)))
        chosen = complete(sorted(first, key=order.__getitem__))
        while len(chosen) < min(size, len(names)):
            gains = {
                name: (len(pairs_of(complete((*chosen, name))) & left), degree[name], -order[name])
                for name in names
                if name not in chosen
            }
            best = max(gains, key=lambda name: gains[name])
            if not gains[best][0]:
                break
            chosen = complete((*chosen, best))
        left -= pairs_of(chosen)
        sets.append(chosen)
    return sets


def smallest(names: Sequence[str], fails: Callable[[tuple[str, ...]], bool]) -> tuple[str, ...]:
    """A part of a failing set that fails, and fails no more if any name is taken out.

    Args:
        names: A set that fails.
        fails: Whether a set fails.
    """
    left = tuple(names)
    reduced = True
    while reduced:
        reduced = False
        for name in left:
            fewer = tuple(n for n in left if n != name)
            if fails(fewer):
                left, reduced = fewer, True
                break
    return left
