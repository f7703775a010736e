"""Laws of bushings as a user gives them: matrices, tables and branches that relax."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...errors import ModelError, brief, near
from ...records import dataclass
from ..quantity import Curves, Quantity, Rows, Value
from ..tables import Interpolation
from ..validation import is_expression, number, vector
from .relative_springs import DIRECTIONS

# of the strain and of an entry of the stiffness, rotations before displacements
STRAIN = ("rad", "rad", "rad", "m", "m", "m")
STIFFNESS = ("N*m/rad", "N", "N/m")
PAIR = "give a pair of a stiffness and a relaxation time, such as ((0, 0, 0, 0, 0, 1e4), 0.05)"


def six_by_six(name: str, value: Rows) -> tuple[Rows, ...]:
    """Six entries, or the rows of a symmetric matrix.

    Raises:
        ModelError: it is neither.
    """
    value = _entries(value)
    nested = isinstance(value, Sequence) and any(isinstance(row, (list, tuple)) for row in value)
    if not nested:
        return vector("bushing", name, value, 6)
    rows = tuple(vector("bushing", f"{name}[{i}]", row, 6) for i, row in enumerate(value))
    if len(rows) != 6:
        raise ModelError(f"bushing: {name} has {len(rows)} rows; give six numbers or a 6x6 matrix")
    for i in range(6):
        for j in range(i):
            pair = (rows[i][j], rows[j][i])
            if not any(map(is_expression, pair)):
                largest = max(map(abs, pair))
                equal = abs(pair[0] - pair[1]) <= 1e-12 * largest
            else:
                equal = pair[0] == pair[1]
            if not equal:
                raise ModelError(
                    f"bushing: {name}[{i}][{j}] is {pair[0]} and {name}[{j}][{i}] is {pair[1]}; "
                    "give a symmetric matrix: without symmetry there is no energy. A force that "
                    "has none is cd.Force and cd.Torque with expressions"
                )
    return rows


def matrix_quantity(value: tuple[Rows, ...], rate: str = "") -> Quantity:
    """Six entries, or the upper triangle of a matrix; ``rate`` stands behind their units."""
    pairs = [(i, i) for i in range(6)]
    if isinstance(value[0], tuple):
        pairs = [(i, j) for i in range(6) for j in range(i, 6)]
    entries = tuple(value[i][j] if isinstance(value[0], tuple) else value[i] for i, j in pairs)
    labels = tuple(
        DIRECTIONS[i] if i == j else f"{DIRECTIONS[i]}_{DIRECTIONS[j]}" for i, j in pairs
    )
    units = tuple(STIFFNESS[(i > 2) + (j > 2)] + rate for i, j in pairs)
    return Quantity(entries, labels=labels, units=units)


# tables


def tables_by_direction(value: Curves) -> tuple[tuple[str, Interpolation], ...]:
    """Pairs of a direction and its table, in the order of the directions.

    Raises:
        ModelError: no mapping, an unknown direction, or what is not a table.
    """
    if isinstance(value, tuple | list):
        # as it is stored
        value = dict(value) if all(isinstance(x, tuple) and len(x) == 2 for x in value) else None
    if not isinstance(value, Mapping):
        raise ModelError(
            "bushing: tables maps directions to tables, such as {'z': cd.table(x, force)}"
        )
    for direction, points in value.items():
        if direction not in DIRECTIONS:
            said = str(direction)
            raise ModelError(
                f"bushing: tables has the key {brief(direction)}, which is not a direction."
                + near(said, DIRECTIONS)
            )
        if not isinstance(points, Interpolation):
            raise ModelError(
                f"bushing: tables['{direction}'] is {brief(points)}; give cd.table(x, y) of the "
                "strain and the force or moment"
            )
    return tuple((name, value[name]) for name in DIRECTIONS if name in value)


# springs in series with dampers


@dataclass(frozen=True)
class Branch:
    """A spring in series with a damper in six directions.

    Attributes:
        stiffness: Six entries, or the rows of a symmetric matrix.
        time: Of relaxation [s].
        directions: Numbers of those in which it has stiffness, and a state.
    """

    stiffness: tuple[Rows, ...]
    time: Value
    directions: tuple[int, ...]


def branches_of(value: Rows) -> tuple[tuple[tuple[Rows, ...], Value], ...]:
    """Pairs of a stiffness and a relaxation time; one pair may stand alone.

    Raises:
        ModelError: other than such pairs, or a stiffness that would give energy for ever.
    """
    value = _entries(value)
    if not isinstance(value, list | tuple):
        raise ModelError(f"bushing: branches is {brief(value)}; {PAIR}")
    if len(value) == 2 and not isinstance(_entries(value[1]), list | tuple):
        value = (value,)
    pairs = []
    for n, pair in enumerate(value):
        pair = _entries(pair)
        if not isinstance(pair, list | tuple) or len(pair) != 2:
            raise ModelError(f"bushing: branches[{n}] is {brief(pair)}; {PAIR}")
        stiffness = six_by_six(f"branches[{n}].stiffness", pair[0])
        _check_passive(n, stiffness)
        pairs.append((stiffness, number("bushing", f"branches[{n}].time", pair[1])))
    return tuple(pairs)


def branch(stiffness: tuple[Rows, ...], time: Value) -> Branch:
    """A branch with the directions in which its stiffness is not zero as written."""
    rows = [row if isinstance(row, tuple) else (row,) for row in stiffness]
    used = (n for n, row in enumerate(rows) if any(is_expression(x) or x != 0 for x in row))
    return Branch(stiffness, time, tuple(used))


def _check_passive(n: int, stiffness: tuple[Rows, ...]) -> None:
    """Refuse a branch of numbers that has no stiffness, or a negative one in some direction.

    Raises:
        ModelError: it is such a branch.
    """
    if not branch(stiffness, 1.0).directions:
        raise ModelError(f"bushing: branches[{n}] has no stiffness; leave it out")
    entries = [x for row in stiffness for x in (row if isinstance(row, tuple) else (row,))]
    if any(map(is_expression, entries)):
        return
    import numpy as np

    values = np.array(stiffness, dtype=float)
    values = np.diag(values) if values.ndim == 1 else values
    least = float(np.linalg.eigvalsh(values)[0])
    if least < -1e-12 * np.abs(values).max():
        raise ModelError(
            f"bushing: branches[{n}].stiffness has the eigenvalue {least:g}; give a stiffness "
            "without negative ones: such a branch would give energy for ever"
        )


def _entries(value: Rows) -> Rows:
    """An array or a SymPy matrix as lists; other things as they are."""
    return value.tolist() if hasattr(value, "tolist") else value
