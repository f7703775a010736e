"""Choose the independent increments and speeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...arrays import Array
from ...errors import DerivationError
from ...records import dataclass
from .pivoting import independent, independent_rows, null_space

REQUEST_WEIGHT = 1e3  # weight of what the user wants to be independent
VALUE_WEIGHT = (
    30.0  # of what has a value: it stays independent unless it moves that much less than others
)


@dataclass(frozen=True)
class Choice:
    """Places of speeds along which increments, and changes of speeds, are independent or not.

    Attributes:
        y, dependent_y: Increments. rows_y: Rows of G that hold the dependent ones.
        w, dependent_w, rows_w: The same for speeds.
    """

    y: list[int]
    dependent_y: list[int]
    rows_y: list[int]
    w: list[int]
    dependent_w: list[int]
    rows_w: list[int]


def choice(
    G: Array, positions: int, requested: Mapping[str, int], with_values: Sequence[int]
) -> Choice:
    """By pivoting on G (m, nu), whose first rows are of position level, wanted ones first.

    Args:
        G: Constraint Jacobian, the first ``positions`` rows of which are of positions.
        positions: Number of these rows.
        requested: Name of what is to be independent -> its speed.
        with_values: Speeds whose coordinates, or which themselves, have a value: they come next.

    Raises:
        DerivationError: something wanted cannot be independent.
    """
    nu = G.shape[1]
    weights = np.ones(nu)
    weights[list(with_values)] = VALUE_WEIGHT
    weights[list(requested.values())] = REQUEST_WEIGHT
    w = independent(G, weights)
    rolled = weights.copy()
    rolled[w] = np.maximum(rolled[w], 0.5 * REQUEST_WEIGHT)
    position_rows = G[:positions]
    y = independent(position_rows, rolled)
    for name, slot in requested.items():
        if slot not in w and slot not in y:
            raise DerivationError(
                f"linearize: '{name}' cannot be independent besides the others: "
                f"{null_space(G).shape[1]} speeds are"
            )
    other_y, other_w = (
        [k for k in range(nu) if k not in independent_slots] for independent_slots in (y, w)
    )
    return Choice(
        y,
        other_y,
        independent_rows(position_rows[:, other_y]),
        w,
        other_w,
        independent_rows(G[:, other_w]),
    )
