"""What a path consists of: equilibria, positions of a mechanism, cycles; and where it starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol, TypeAlias

from numpy.typing import ArrayLike

from ...arguments import LockedValues
from ...arrays import Array
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from .family import Family, Point
from .follow import Place, Step
from .special_points import Corner, Onset, Special, Test

Quantity: TypeAlias = Callable[[Point], float]
Solution: TypeAlias = object  # as users take it: an equilibrium, a position, a cycle


class Solutions(Protocol):
    """Solutions of a model as something changes, and what is said of them."""

    @property
    def model(self) -> LoadedModel:
        """The model."""

    @property
    def kind(self) -> str:
        """Solutions of this kind, in words."""

    @property
    def family(self) -> Family:
        """The equations, and how their unknowns change."""

    def values(self, point: Point) -> Mapping[str, float]:
        """Swept quantities by name."""

    def quantity(self, name: str) -> Quantity:
        """A number of a solution by its name.

        Raises:
            ModelError: there is no such number.
        """

    def record(self, point: Point) -> Solution:
        """A solution as users take it."""

    def independent_residual(self, point: Point) -> tuple[Array, Array]:
        """Sizes of what a solution misses its equations by, computed anew, and of what meets there.

        Raises:
            SolveError: the equations cannot be evaluated there.
        """

    @property
    def residual_description(self) -> str:
        """The residual of these solutions, in a sentence."""

    def coordinates(self, point: Point) -> Array:
        """Coordinates (nq,) of a solution."""

    def multipliers(self, point: Point) -> Array:
        """Multipliers (m,) of a solution."""

    def stable(self, point: Point, prescribed: bool) -> bool | None:
        """Stability with what is prescribed held, or under its forces; None where not known."""

    def count(self, place: Place) -> int | None:
        """Unstable directions with the parameter kept; None where they are not known."""

    def growth(self, place: Place) -> tuple[float, float]:
        """Real part and frequency [rad/s] of the oscillation that grows or decays least.

        Raises:
            SolveError: nothing oscillates, or it is not known.
        """

    def corner(self, step: Step, number: int) -> Corner | None:
        """The first place within a step behind which the equations are others; None without any.

        Args:
            step: A step of a path.
            number: Of the place from which it goes.
        """

    @property
    def oscillation(self) -> str:
        """Kind of the points at which it begins to grow."""

    @property
    def onsets(self) -> Sequence[Onset]:
        """Changes of stability besides those at folds, branch points and of oscillations."""

    @property
    def ends(self) -> Sequence[Test]:
        """Ends of curves besides their range."""

    def beginning(self, special: Special) -> tuple[Solutions, Place] | None:
        """Solutions of another kind that begin at a point, such as those of twice the period.

        Returns:
            What they are, and their first place; None where none begin, or none are told apart.
        """

    def consistent(self, point: Point) -> bool:
        """True where equations hold that were left out, as they follow from others on a path."""

    def motion(self, dz: Array) -> Array:
        """The part of increments (N, ...) that moves the system (n, ...)."""

    def moving(self, dz: Array) -> str:
        """What moves most in an increment (N,), in words."""

    def description(self, special: Special) -> str:
        """What happens at a fold or where a stability changes, behind where that is."""


@dataclass(frozen=True)
class PathRequest:
    """Arguments of ``model.continuation`` that concern its solutions.

    Attributes:
        swept: Name -> (start, end).
        q: Coordinates to start from, by name or (nq,).
        locked: Coordinate -> value it keeps, or (start, end).
        u: Speed of a steady motion -> value it keeps, or (start, end).
        inputs, parameters: Values by name that stay, else those of the model.
        t: Time [s].
        start: A solution or special point to start from.
    """

    swept: Mapping[str, object]
    q: Mapping[str, ArrayLike] | ArrayLike | None
    locked: LockedValues
    u: Mapping[str, object] | None
    inputs: Mapping[str, float] | None
    parameters: Mapping[str, float] | None
    t: float
    start: object = None


@dataclass(frozen=True)
class PathStart:
    """The start of a path.

    Attributes:
        solutions: What it consists of.
        places: Its first places.
        special: The first one, where curves cross there.
        end: Where it ends.
    """

    solutions: Solutions
    places: Sequence[Place]
    special: Sequence[Special]
    end: Test
