"""Base parameters by numbers: the combinations of inertial parameters that forces depend on.

Columns of the regressor at random states are gone through in the order of bodies from the ground,
those of a body from products of inertia to the mass. A column that those before it make up belongs
to a parameter that goes into theirs; what is left are the base parameters.

Source: Gautier, Numerical Calculation of the Base Inertial Parameters of Robots, J. Robotic Systems
8 (1991).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import TYPE_CHECKING, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments import Seed, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError
from ...records import dataclass
from .estimate import triangle

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

# what is left of a column, relative to it, if others make it up; rounding leaves 1e-13
RANK = 1e-9
# states for each parameter, speeds and accelerations at them
EACH, FAST, JERKY = 2, 3.0, 10.0
# of the ten numbers of a body: what goes into others comes last, first of all the mass
TURNS = (7, 8, 9, 6, 4, 5, 1, 2, 3, 0)
REQUIRED = ("regressor", "inverse_dynamics", "inertial_parameters")
# coefficients below this part of the largest are rounding
ROUNDED = 1e-9


@final
@dataclass(frozen=True, repr=False, eq=False)
class Base:
    """Combinations beta = B phi of the inertial parameters phi, with Y phi = Y_b beta.

    Attributes:
        name: Of the model.
        parameters: Names of phi (n,).
        columns: Of the regressor that are independent of each other (nb,): Y_b.
        matrix: B (nb, n); the columns named by ``columns`` are those of the identity.
        without_effect: Parameters that no force depends on.
        least_independent, dropped: What is left of columns beside those before them, relative to
            them: the least of those that are kept, the most of those that are not. The gap between
            tells how sure the number is.
    """

    name: str
    parameters: tuple[str, ...]
    columns: NDArray[np.intp]
    matrix: Array = field(repr=False)
    without_effect: tuple[str, ...]
    least_independent: float
    dropped: float

    def __len__(self) -> int:
        return len(self.columns)

    @property
    def names(self) -> tuple[str, ...]:
        """A base parameter is called after the parameter that the others are added to (nb,)."""
        return tuple(self.parameters[k] for k in self.columns)

    @property
    def expressions(self) -> dict[str, str]:
        """Name -> combination, such as ``arm.xx - arm.yy + 0.25 hand.mass``."""
        return {name: self._written(row) for name, row in zip(self.names, self.matrix, strict=True)}

    def _written(self, row: Array) -> str:
        text = ""
        for name, factor in zip(self.parameters, row, strict=True):
            if factor:
                size = "" if abs(factor) == 1 else f"{abs(factor):.6g} "
                sign = " - " if factor < 0 else " + "
                text += f"{sign}{size}{name}"
        return text.removeprefix(" + ").replace(" - ", "-", 1 if text.startswith(" - ") else 0)

    @checked
    def of(self, phi: ArrayLike) -> Array:
        """Base parameters (..., nb) of inertial parameters (..., n)."""
        return np.asarray(self._all("phi", phi) @ self.matrix.T)

    @checked
    def regressor(self, Y: ArrayLike) -> Array:
        """Y_b (..., nb) of a regressor Y (..., n): its independent columns."""
        return np.asarray(self._all("regressor Y", Y)[..., self.columns])

    def _all(self, word: str, values: ArrayLike) -> Array:
        """Numbers (..., n) for all parameters."""
        array, count = np.asarray(values, dtype=float), len(self.parameters)
        if array.shape[-1:] != (count,):
            raise ArgumentError(f"{word}: shape {array.shape}, expected (..., {count})")
        return array

    def __repr__(self) -> str:
        lines = [f"'{self.name}': {len(self)} base parameters of {len(self.parameters)}"]
        expressions = self.expressions.items()
        lines += [
            f"  {name}" if name == text else f"  {name} = {text}" for name, text in expressions
        ]
        lines.append("without effect: " + (", ".join(self.without_effect) or "none"))
        return "\n".join(lines)


@checked
def base_parameters(
    model: LoadedModel, rows: ArrayLike | None = None, *, seed: Seed = 0, rank: float = RANK
) -> Base:
    """Base parameters of a model.

    Args:
        model: A tree; with loops ``rows`` are needed.
        rows: Regressors (..., n) to judge by, such as those of a motion; by default at random
            states.
        seed: Of the states.
        rank: What must be left of a column, relative to it, to be independent.

    Raises:
        SolveError: a system with loops and no rows; a rank that is not certain.
    """
    names = tuple(model.inertial_parameters())
    if rows is None:
        rows = _random_rows(model, len(names), seed)
    array = np.asarray(rows, dtype=float)
    if array.shape[-1:] != (len(names),):
        raise ArgumentError(
            f"base_parameters: rows have shape {array.shape}, expected (..., {len(names)}), as "
            "model.regressor gives them"
        )
    flat = array.reshape(-1, len(names))
    if not np.isfinite(flat).all():
        raise ArgumentError("base_parameters: rows hold numbers that are not finite")
    return _independent_columns(model.name, names, flat, rank)


def _random_rows(model: LoadedModel, count: int, seed: int) -> Array:
    """Regressors (k, nu, n) at random states of a tree."""
    if circuits(model):
        raise SolveError(
            f"model '{model.name}' has loops, whose states are not random: give "
            "base_parameters(rows=) of a motion, or identify(...), which does"
        )
    rng = np.random.default_rng(seed)
    number = EACH * count + 10
    q, u, _ = model.parts_of(model.random_state(rng, (number,)))
    u, udot = rng.uniform(-FAST, FAST, u.shape), rng.uniform(-JERKY, JERKY, u.shape)
    return model.regressor(q, u, udot, t=rng.uniform(0, 1, number))


def needed(model: LoadedModel, who: str, functions: Sequence[str]) -> None:
    """Check that the model has the functions that identification needs.

    Raises:
        ModelError: it does not.
    """
    for name in functions:
        if name not in model.manifest.available:
            raise ModelError(
                f"{who}: model '{model.name}' has no function '{name}'. Compile it in relative "
                f"coordinates, with functions=(..., '{name}') if you choose them"
            )


def circuits(model: LoadedModel) -> bool:
    """True when constraints bind a model always; those of sticking friction do not."""
    return any(not row.switched for row in model.manifest.multipliers)


def _independent_columns(name: str, names: tuple[str, ...], rows: Array, rank: float) -> Base:
    # a triangle has the same relations between its columns as the rows
    # R of a QR factorization has the dependencies of all rows
    factor = triangle(rows)
    sizes = np.linalg.norm(factor, axis=0)
    effect = sizes > rank * sizes.max(initial=0.0)
    scaled = factor / np.where(effect, sizes, 1.0)
    directions = np.zeros((len(factor), 0))
    chosen, least_independent, dropped = list[int](), 1.0, 0.0
    for k in _turns(names):
        if not effect[k]:
            continue
        column = scaled[:, k]
        # Gram-Schmidt, twice for orthogonality to rounding
        for _ in range(2):
            column = column - directions @ (directions.T @ column)
        left = float(np.linalg.norm(column))
        # independent of the columns before it: a base parameter
        if left > rank:
            least_independent, directions = (
                min(least_independent, left),
                np.column_stack([directions, column / left]),
            )
            chosen.append(k)
        else:
            dropped = max(dropped, left)
    chosen.sort()
    matrix = _combined(scaled, chosen, effect, sizes)
    without = tuple(n for n, has in zip(names, effect, strict=True) if not has)
    return Base(
        name, names, np.array(chosen, dtype=np.intp), matrix, without, least_independent, dropped
    )


def _turns(names: tuple[str, ...]) -> list[int]:
    """The order in which columns are gone through."""
    order, k = list[int](), 0
    while k < len(names):
        body = names[k].endswith(".mass") and names[k + 1 : k + 2] == (
            f"{names[k].removesuffix('.mass')}.moment_x",
        )
        order += [k + turn for turn in TURNS] if body else [k]
        k += len(TURNS) if body else 1
    return order


def _combined(scaled: Array, chosen: list[int], effect: NDArray[np.bool_], sizes: Array) -> Array:
    """B (nb, n): every column by the chosen ones, in the units of the parameters."""
    matrix = np.zeros((len(chosen), scaled.shape[1]))
    if not chosen:
        return matrix
    coefficients = np.linalg.lstsq(scaled[:, chosen], scaled[:, effect], rcond=None)[0]
    coefficients[np.abs(coefficients) < ROUNDED] = 0.0
    matrix[:, effect] = coefficients * sizes[effect] / sizes[chosen][:, None]
    # numbers that parameters are exactly, such as 1 and lengths that are read
    rounded = np.rint(matrix)
    near = np.abs(matrix - rounded) < ROUNDED * np.maximum(1.0, np.abs(rounded))
    matrix[near] = rounded[near]
    return matrix
