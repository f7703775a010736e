"""The structure of the tree of a model, and what judges it, as the manifest holds it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Self

from .fields import (
    Misfit,
    Record,
    count,
    either,
    field,
    flag,
    integer,
    is_number,
    kind,
    listed,
    maybe,
    number,
    table,
    text,
)


class Treatment(Record):
    """Treatment of the constraints in the accelerations."""

    name: str = field(text)
    exact: bool = field(flag, "whether accelerations fulfil the constraints to rounding")


class CloserRow(Record):
    """Motion of a joint that closes a kinematic loop."""

    pose: str = field(text, "the saved Function of its pose by its coordinates and p, as declared")
    rotation: str | None = field(
        text, "how its first coordinates describe a free rotation", default=None
    )
    q: int = field(count, "number of coordinates")
    u: int = field(count, "number of speeds")


class SampleRow(Record):
    """Reference values by SymPy of written equations at a state."""

    held: Sequence[str] = field(listed(text), "constraints")
    t: float = field(number)
    q: Sequence[float] = field(listed(number))
    u: Sequence[float] = field(listed(number))
    r: Mapping[str, float] = field(table(number), "by input")
    p: Mapping[str, float] = field(table(number), "by parameter")
    qdot: Sequence[float] = field(listed(number))
    M: Sequence[Sequence[float]] = field(listed(listed(number)))
    f: Sequence[float] = field(listed(number))
    rows: Sequence[Sequence[float]] = field(
        listed(listed(number)), "A of A u' = b, constraints included"
    )
    right: Sequence[float] = field(listed(number), "b")


class Tree(Record):
    """The structure of the tree; its numbers are the saved Function scene in functions.json."""

    parents: Sequence[int] = field(
        listed(integer), "number of the parent body, -1 for the ground", run=()
    )
    kinds: Sequence[str] = field(
        listed(text),
        "joint kinds; after the word 'reversed' where the pose of the parent in the child is meant",
        run=(),
    )
    rotations: Sequence[str | None] = field(listed(maybe(text)), run=())
    poses: Sequence[str] = field(
        listed(text),
        "the saved Function of each joint's pose by its coordinates and p, as declared",
        default=(),
    )
    forces: Sequence[str] = field(listed(text), run=())
    unknown: Sequence[str] = field(
        listed(text), "why an independent program cannot know the masses of this model", run=()
    )
    curves: Sequence[Sequence[Any] | None] = field(
        listed(maybe(kind("a curve", lambda value: _is_curve(value), type="array"))),
        "of points on curves: breaks, coefficients by component and piece (highest power first), "
        "period or 0; absent without any",
        default=(),
    )
    pressed: Sequence[tuple[int, bool]] = field(
        listed(listed(either(count, flag), 2)),
        "of friction that follows from reactions its joint, and whether that has a line",
        default=(),
    )
    samples: Sequence[SampleRow] = field(
        listed(SampleRow), "absent in models of bodies", default=()
    )
    cuts: Sequence[str] = field(
        listed(text), "kinds of the joints in the manifest's cuts, as in kinds", default=()
    )
    closers: Sequence[CloserRow] = field(
        listed(CloserRow), "how the joints in the manifest's cuts move", default=()
    )
    treatment: Treatment | None = field(
        Treatment, "absent where nothing binds the tree", default=None
    )
    locked: Sequence[str] = field(
        listed(text), "elements that hold a joint in the modes of the start", default=()
    )

    @classmethod
    def read(cls, plain: object, run: bool = False) -> Self:
        """Same as :meth:`Record.read`; a saved run says all of it or nothing."""
        return super().read(plain, run and not plain)

    @property
    def empty(self) -> bool:
        """True when a file says nothing of it."""
        return self.kinds == ()


def _is_curve(value: object) -> bool:
    """Breaks, coefficients (3, pieces, powers) and period."""
    if not isinstance(value, list) or len(value) != 3:
        return False
    breaks, components, period = value
    numbers = listed(number)
    try:
        numbers.read(breaks, False)
        interval_coefficients = listed(listed(numbers, len(breaks) - 1), 3).read(components, False)
    except Misfit:
        return False
    powers = {len(powers) for component in interval_coefficients for powers in component}
    return len(breaks) > 1 and len(powers) == 1 and min(powers) > 0 and is_number(period)
