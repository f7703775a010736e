"""What is refused, and why: theorems and missing quantities, and what is known to be missing."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Refusal:
    """A refusal that is expected.

    Attributes:
        features: What the scene has; all of them.
        asked: The use, integrator or kind of coordinates; all of them refuse.
        message: Of the refusal, a pattern.
        reason: The theorem, or the quantity that is missing. "" of what is not written yet: the
            test says when it is, so that the row is taken out.
        unless: The scene has none of these.
    """

    features: tuple[str, ...]
    asked: tuple[str, ...]
    message: str
    reason: str = ""
    unless: tuple[str, ...] = ()

    def concerns(self, names: Iterable[str], asked: str) -> bool:
        """Whether a scene and what is asked of it are meant."""
        there = {*names}
        return (
            asked in self.asked and there.issuperset(self.features) and not there & {*self.unless}
        )


REFUSALS: tuple[Refusal, ...] = (
    Refusal(
        ("friction from reaction",),
        ("absolute",),
        "friction.*follows from the reaction of its joint",
    ),
)


def expected(names: Iterable[str], asked: str, message: str) -> Refusal:
    """The row that a refusal belongs to.

    Raises:
        AssertionError: there is none.
    """
    for row in REFUSALS:
        if row.concerns(names, asked) and re.search(row.message, message, re.DOTALL):
            return row
    raise AssertionError(f"{asked} of {', '.join(names)}: {message}")
