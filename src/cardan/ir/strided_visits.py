"""Visits at regular distances as turns: tables of visits that do not grow with the bodies."""

from __future__ import annotations

from collections.abc import Sequence

from .recursion import Turns, Visit, ahead

# visits of the longest turn that is looked for: joints whose axes alternate
LONGEST = 6
# turns from which it pays to tell them as such
FEWEST = 4


def as_turns(visits: Sequence[Visit]) -> tuple[Visit | Turns, ...]:
    """Visits in their order, repeated ones as turns."""
    parts: list[Visit | Turns] = []
    at = 0
    while at < len(visits):
        longest = max((_turns(visits, at, n) for n in range(1, LONGEST + 1)), key=_length)
        if longest.times >= FEWEST:
            parts.append(longest)
            at += _length(longest)
        else:
            parts.append(visits[at])
            at += 1
    return tuple(parts)


def _length(turns: Turns) -> int:
    return len(turns.visits) * turns.times if turns.times >= FEWEST else 0


def _turns(visits: Sequence[Visit], at: int, n: int) -> Turns:
    """The turns of n visits that begin at one."""
    first = tuple(visits[at : at + n])
    strides = tuple(
        visit_stride(a, b) for a, b in zip(first, visits[at + n : at + 2 * n], strict=False)
    )
    if len(strides) < n or None in strides:
        return Turns(first, (), 1)
    complete = tuple(s for s in strides if s is not None)
    times, end = 2, at + 3 * n
    while end <= len(visits) and all(
        ahead(visits[end - 2 * n + k], complete[k], 1) == visits[end - n + k] for k in range(n)
    ):
        times, end = times + 1, end + n
    return Turns(first, complete, times)


def visit_stride(a: Visit, b: Visit) -> Visit | None:
    """Offset from one visit to the next; None where they are of different steps."""
    if a.step != b.step:
        return None

    def differences(x: Sequence[int], y: Sequence[int]) -> tuple[int, ...]:
        return tuple([k - j for j, k in zip(x, y, strict=True)])

    reads = {block: differences(a.reads[block], b.reads[block]) for block in a.reads}
    return Visit(a.step, reads, differences(a.stores, b.stores), differences(a.outs, b.outs))
