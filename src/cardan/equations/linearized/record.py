"""Linear models as formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import DerivationError, ModelWarning, counted, listed, warn
from ...ir.function import Function, count, live
from ...ir.matrix import Matrix
from ...records import dataclass
from .all_coordinates import DYNAMIC, FullMatrices
from .first_order import Plant
from .matrices import Written
from .reduced import Reduced
from .reference import Reference, picked
from .second_order import parts_of, second_order

if TYPE_CHECKING:
    import sympy

    from .along import LinearizedAlong

NEGLIGIBLE = 1e-9  # forces below this part of the largest ones at hand are none
SECOND = (
    "M", "damping", "K", "dissipative", "gyroscopic", "conservative", "circulatory", "forces",
    "inner",
)  # fmt: skip


@final
@dataclass(frozen=True, repr=False, eq=False)
class SecondOrder:
    """M y'' + damping y' + K y = forces r + inner z: damping is D + G, K is K + N by symmetry.

    Attributes:
        coordinates: Names of y.
        inputs: Names of r.
        matrices: ``M damping K dissipative gyroscopic conservative circulatory forces
            inner``, the last for internal states z.
    """

    coordinates: tuple[str, ...]
    inputs: tuple[str, ...]
    matrices: Written = field(repr=False)

    def __getattr__(self, name: str) -> sympy.Matrix:
        """A matrix by its name, as SymPy.

        Raises:
            DerivationError: an entry is too long to write out; :meth:`symbolic` is not.
        """
        if name not in SECOND:
            raise AttributeError(name)
        return self.matrices.read(name)

    def symbolic(self, name: str) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
        """A matrix with named intermediates, like :func:`sympy.cse`."""
        return self.matrices.symbolic(name)

    def at(self, parameters: dict[str, Any] | None = None, **values: object) -> dict[str, Array]:
        """Numbers of all matrices (..., n, n); see :meth:`Linearized.at`."""
        return self.matrices.numbers({**(parameters or {}), **values})

    def function(self) -> Function:
        """All matrices as a Function of t, p and the symbols of the reference."""
        return self.matrices.function()

    def __repr__(self) -> str:
        return f"SecondOrder({', '.join(self.coordinates)})"

    def __str__(self) -> str:
        from .formula import rows_of

        return "\n".join(rows_of(self))

    def _repr_latex_(self) -> str:
        from .formula import second_order_latex

        return rf"$\displaystyle {second_order_latex(self)}$"


@final
@dataclass(frozen=True, repr=False, eq=False)
class Linearized:
    """x' = A x + B r, y = C x + D r as formulas: distances from a reference motion.

    x are independent increments, independent speeds, internal states. Matrices are SymPy; where
    their entries are too long they raise, :meth:`symbolic` names intermediates and :meth:`at`
    gives numbers.

    Attributes:
        name: Of the model.
        states: Names of x; ``along base.u.x`` is an increment along a speed that is not a rate.
        inputs, outputs: Names of r and y.
        route: ``"from_start"`` or ``"differentiated"``: how it was derived.
    """

    name: str
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    route: str
    _reference: Reference = field(repr=False)
    _full: FullMatrices = field(repr=False)
    _reduced: Reduced = field(repr=False)
    _plant: Plant = field(repr=False)
    _with: Callable[[list[str]], Linearized] = field(repr=False)

    # equations of first order

    @cached_property
    def _first(self) -> Written:
        p = self._plant
        matrices = {"A": p.A, "B": p.B, "C": p.C, "D": p.D, "xdot": p.xdot}
        return Written(self._reference, matrices)

    @property
    def A(self) -> sympy.Matrix:
        """(nx, nx)."""
        return self._first.read("A")

    @property
    def B(self) -> sympy.Matrix:
        """(nx, nr)."""
        return self._first.read("B")

    @property
    def C(self) -> sympy.Matrix:
        """(ny, nx)."""
        return self._first.read("C")

    @property
    def D(self) -> sympy.Matrix:
        """(ny, nr): outputs by inputs."""
        return self._first.read("D")

    @property
    def xdot(self) -> sympy.Matrix:
        """Rates of the states along the reference (nx, 1): the constant part of the model.

        Distances from the reference state itself, which stays where it is, obey
        x' = xdot + A x + B r where speeds are rates of coordinates. Increments ``along`` others
        are seen in axes that move with the reference.
        """
        return self._first.read("xdot")

    def symbolic(self, name: str) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
        """A matrix of any name and size with named intermediates, like :func:`sympy.cse`."""
        if name in self._first.matrices:
            return self._first.symbolic(name)
        return self._second.symbolic(name)

    def at(self, parameters: dict[str, Any] | None = None, **values: object) -> dict[str, Array]:
        """Numbers of A, B, C, D and xdot.

        Args:
            parameters: Parameters, symbols of the reference and ``t`` by name, numbers or arrays
                that broadcast; the rest by default. Assembled loops are assembled anew.
            values: The same by keyword.

        Raises:
            DerivationError: an unknown name, or a symbol of the reference without a value.
        """
        return self._first.numbers({**(parameters or {}), **values})

    def along(self, t: ArrayLike, **values: object) -> LinearizedAlong:
        """A, B, C and D over times (nt,) [s] of a reference that depends on ``t``.

        Args:
            t: Times.
            values: Parameters and symbols of the reference, as for :meth:`at`.
        """
        from .along import over

        return over(self, t, values)

    def function(self) -> Function:
        """A, B, C, D and xdot as a Function of t, p and the symbols of the reference."""
        return self._first.function()

    # equations of second order

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the independent increments."""
        return tuple(self._reference.increments[k] for k in self._reference.y)

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of the independent speeds."""
        return tuple(self._reference.names["u"][k] for k in self._reference.w)

    def second_order(self, coordinates: Iterable[str] | None = None) -> SecondOrder:
        """M y'' + (D + G) y' + (K + N) y = B r of some coordinates, if theirs are closed.

        Args:
            coordinates: Names; all that are independent if left out. Those of a rolling wheel
                that others do not depend on are left out: ``["lean", "steer"]`` of a bicycle.
                Others than the independent ones become so.

        Raises:
            DerivationError: unknown names, such as depend on each other, or others that enter
                their equations.
        """
        at = self._reference
        names = self.coordinates
        if coordinates is not None:
            names = tuple(dict.fromkeys(listed("coordinates", coordinates, "steer")))
        if not names:
            raise DerivationError("linearize: name at least one coordinate")
        places = [
            at.increments.index(name) if name in at.increments else at.slot(name) for name in names
        ]
        if coordinates is not None and any(k not in at.y or k not in at.w for k in places):
            # the same with these as the independent ones, if they can be
            other = self._with([at.names["u"][k] for k in places])
            if all(k in other._reference.y and k in other._reference.w for k in places):
                return other.second_order(names)
        x = second_order(at, self._reduced, places)
        (D, G), (K, N) = parts_of(x.damping), parts_of(x.K)
        matrices = dict(
            zip(
                SECOND,
                (x.M, x.damping, x.K, D, G, K, N, self._pushes(places), x.inner),
                strict=True,
            )
        )
        coordinates_chosen = tuple(at.increments[k] for k in places)
        return SecondOrder(coordinates_chosen, self.inputs, Written(at, matrices))

    def _pushes(self, places: list[int]) -> Matrix:
        """Forces along chosen increments by the inputs of the plant."""
        at = self._reference
        rows = [at.w.index(k) for k in places]
        return picked(self._plant.push, rows, range(len(self.inputs)))

    @cached_property
    def _second(self) -> SecondOrder:
        return self.second_order()

    @property
    def M(self) -> sympy.Matrix:
        """Mass matrix (n, n) of the independent increments; see :meth:`second_order`."""
        return self._second.M

    @property
    def damping(self) -> sympy.Matrix:
        """Factor of y' (n, n): damping and gyroscopic forces."""
        return self._second.damping

    @property
    def dissipative(self) -> sympy.Matrix:
        """Damping (n, n), symmetric."""
        return self._second.dissipative

    @property
    def gyroscopic(self) -> sympy.Matrix:
        """Gyroscopic forces by y' (n, n), skew."""
        return self._second.gyroscopic

    @property
    def K(self) -> sympy.Matrix:
        """Factor of y (n, n): stiffness and circulatory forces."""
        return self._second.K

    @property
    def conservative(self) -> sympy.Matrix:
        """Stiffness (n, n), symmetric."""
        return self._second.conservative

    @property
    def circulatory(self) -> sympy.Matrix:
        """Circulatory forces by y (n, n), skew."""
        return self._second.circulatory

    @property
    def forces(self) -> sympy.Matrix:
        """Factor of the inputs (n, nr) in the equations of second order."""
        return self._second.forces

    # the reference

    @cached_property
    def needed(self) -> dict[str, sympy.Expr]:
        """Forces along independent speeds without which the reference is not a motion; {}: it is
        one.

        They are looked at in numbers, at the default parameters; symbols of the reference without
        a value have any. The linear model holds while these forces act as they are.
        """
        if not self._forced_speeds:
            return {}
        read = Written(
            self._reference, {"needed": picked(self._reference.needed, self._forced_speeds, [0])}
        ).read("needed")
        return {self.speeds[n]: read[i] for i, n in enumerate(self._forced_speeds)}

    @cached_property
    def _forced_speeds(self) -> list[int]:
        """Independent speeds along which the reference needs a force."""
        at = self._reference
        values = at.number(at.needed)[:, 0]
        balance = float(np.abs(at.number(at.put(at.balance))).max(initial=0.0))
        # forces that small changes of the motion would make are none
        x = self._reduced
        row_sizes = np.hstack([np.abs(at.number(m)) for m in (x.M, x.C, x.K)]).max(
            axis=1, initial=0.0
        )
        return [n for n, x in enumerate(values) if abs(x) > NEGLIGIBLE * max(balance, row_sizes[n])]

    def _warn_if_forced(self) -> None:
        """Warn about a reference of numbers that is not a motion by itself."""
        at = self._reference
        followed = [] if at.assembly is None else at.assembly.names
        if (
            at.timed
            or at.trusted
            or set(at.symbols.names) - set(followed)
            or not self._forced_speeds
        ):
            return
        along = ", ".join(self.speeds[n] for n in self._forced_speeds)
        warn(
            f"linearize: '{self.name}' accelerates there: that udot is 0 takes forces along "
            f"{along} (.needed). Give udot='free' for the motion by itself, as model.linearize has "
            "it, or udot={} for this one",
            ModelWarning,
        )

    @property
    def operations(self) -> dict[str, int]:
        """Operations by operator of the matrices of all increments, the reference being known.

        These are what was derived: M, damping, stiffness, constraints and what changes them.
        """
        nodes = [x for name in DYNAMIC for x in getattr(self._full, name).nodes]
        graph, reference_nodes = self._reference.graph, list(self._reference.values.values())
        before = set(live(graph, reference_nodes))
        return count(graph, [x for x in live(graph, nodes) if x not in before])

    def __repr__(self) -> str:
        return f"Linearized('{self.name}', {counted(len(self.states), 'state')}, {self.route})"

    def __str__(self) -> str:
        from .formula import overview

        return overview(self)

    def _repr_latex_(self) -> str:
        """The equations of second order, or A, B, C and D, in notebooks."""
        from .formula import latex

        return rf"$\displaystyle {latex(self)}$"
