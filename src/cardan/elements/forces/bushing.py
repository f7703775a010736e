"""A bushing: springs and dampers in six directions between two frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from ...errors import ModelError
from ..formulas import Lines, Shapes
from ..quantity import Place, Quantity, Rows
from ..validation import is_expression, vector
from .force import Action, ForceElement, Places, constant
from .relative_springs import DIRECTIONS, SHAPES, spring_lines, springs, square

# of the stress by the strain, and of the strain; rotations before displacements
STRESS, STRAIN = ("N*m", "N"), ("rad", "m")


@dataclass(frozen=True)
class Bushing(ForceElement):
    """Springs and dampers in all six relative directions of two frames, coupled as one likes.

    Strain ``y`` is the rotation vector of frame b seen from frame a, and their distance in the axes
    halfway between them, so that both ends are treated alike: ``energy = (y - rest)·k (y - rest) /
    2`` at angles up to half a turn. The order is rx, ry, rz, x, y, z: rotations before
    displacements.

    Args:
        frame_a, frame_b: Frames or bodies at its ends; they coincide without load unless ``rest``
            says otherwise.
        stiffness: Six numbers, or a symmetric 6x6 matrix [N m/rad, N/m; N between them].
        damping: The same of the rate of the strain [N m s/rad, N s/m; N s between them].
        rest: Strain without load (6) [rad, m].

    Raises:
        ModelError: other than six numbers or a symmetric 6x6 matrix.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 7.7; Masarati and
        Morandini, Multibody System Dynamics 24 (2010) for the halfway axes.
    """

    kind: ClassVar[str] = "bushing"
    symbol_shapes: ClassVar[Shapes] = SHAPES
    frame_a: Place
    frame_b: Place
    stiffness: Rows = (0, 0, 0, 0, 0, 0)
    damping: Rows = (0, 0, 0, 0, 0, 0)
    rest: Rows = (0, 0, 0, 0, 0, 0)

    def __post_init__(self) -> None:
        for name in ("stiffness", "damping"):
            object.__setattr__(self, name, _six_by_six(name, getattr(self, name)))
        object.__setattr__(self, "rest", vector("bushing", "rest", self.rest, 6))
        super().__post_init__()

    def quantities(self) -> dict[str, Quantity]:
        return {
            "stiffness": _matrix(self.stiffness, ""),
            "damping": _matrix(self.damping, "*s"),
            "rest": Quantity(
                self.rest, labels=DIRECTIONS, units=tuple(STRAIN[k > 2] for k in range(6))
            ),
        }

    def linear(self) -> tuple[str, ...]:
        return ("stiffness", "damping")

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        graph, data = at.motion.graph, at.data
        stiffness, damping = (square(graph, data[name]) for name in ("stiffness", "damping"))
        return springs(at, stiffness, damping, data["rest"])

    def formulas(self, at: Places) -> Lines:
        terms = [
            term
            for name, term in (("stiffness", "k @ y"), ("damping", "c @ ydot"))
            if not at.data[name].is_zero
        ]
        strain = "column(theta, e)" + " - y_0" * (not at.data["rest"].is_zero)
        return spring_lines(strain, " + ".join(terms), self._stores(at)) if terms else ()

    def _stores(self, at: Places) -> bool:
        return not at.data["stiffness"].is_zero and constant(at.data["stiffness"], at.data["rest"])


def _six_by_six(name: str, value: Rows) -> tuple[Rows, ...]:
    """Six entries, or the rows of a symmetric matrix.

    Raises:
        ModelError: it is neither.
    """
    value = value.tolist() if hasattr(value, "tolist") else value
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


def _matrix(value: tuple[Rows, ...], rate: str) -> Quantity:
    """Six entries, or the upper triangle of a matrix."""
    pairs = [(i, i) for i in range(6)]
    if isinstance(value[0], tuple):
        pairs = [(i, j) for i in range(6) for j in range(i, 6)]
    entries = tuple(value[i][j] if isinstance(value[0], tuple) else value[i] for i, j in pairs)
    labels = tuple(
        DIRECTIONS[i] if i == j else f"{DIRECTIONS[i]}_{DIRECTIONS[j]}" for i, j in pairs
    )
    units = tuple(_unit(i, j) + rate for i, j in pairs)
    return Quantity(entries, labels=labels, units=units)


def _unit(i: int, j: int) -> str:
    """Of an entry of the stiffness: work is symmetric in both."""
    return ("N*m/rad", "N", "N/m")[(i > 2) + (j > 2)]
