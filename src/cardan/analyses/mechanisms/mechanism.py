"""Loops of a model at one instant, in numbers without units, for analyses in NumPy.

Lengths count in sizes of the mechanism and angles in radians, so that rows and columns of Jacobians
can be compared, and a rank says something.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.constraint_projection import Closing, columns_of, size_of
from ...runtime.models.finite_elements.joint_driven_nodes import SIGN_TOL
from ...runtime.models.random_states import random_state
from ...runtime.verification.rotations import unit
from ...schema.mechanism import CutRow
from .mechanism_record import Connection, connect

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

LIMIT_TOL = 1e-9  # beyond limits that counts as on them
TIGHT, ROUNDED_TOL = 1e-10, 3e-5  # the latter as kernels/solve/dependent.h has it
NEARBY = 1e-5  # of a central difference; its error of 1e-10 slows no search


class Mechanism:
    """A model at a time and with inputs.

    Attributes:
        model, t, r: The model, the time [s], the inputs (nr,).
        s: Discrete states (ns,), which say what elements hold; None for those of a start.
        size: Against which lengths count [m].
        columns: Size of the unit of every speed (nu,): ``size`` where it is a velocity.
        released: Relations of the user that are not asked to hold.
        closure_tol: Residual without units up to which redundant conditions may
            disagree, as rounded lengths make them; 0 where they agree.
        searches: How many searches are begun before a start is refused.
    """

    released: frozenset[str] = frozenset()
    closure_tol: float = 0.0
    searches: int = 16

    def __init__(self, model: LoadedModel, t: float = 0.0, r: object = None, s: Any = None) -> None:
        """Args:
        model: Compiled.
        t: Time, where something is prescribed [s].
        r, s: Inputs (nr,) and discrete states (ns,), or by name; those of a start if left out.
        """
        self.model, self.t = model, float(t)
        if isinstance(r, Mapping):
            r = model._vector("r", r)
        self.r: Array | None = None if r is None else np.asarray(r, dtype=np.float64)
        self.s: Array | None = None if s is None else model._vector("s", s)
        self.size = size_of(model)
        self.columns = columns_of(model, self.size)
        self._cache: dict[str, tuple[bytes, Any]] = {}

    @property
    def inputs(self) -> Array:
        """Inputs (nr,), by default as the scene states them."""
        return (
            np.array([x.default for x in self.model.manifest.inputs]) if self.r is None else self.r
        )

    @classmethod
    def at(cls, model: LoadedModel, t: float, r: Array | None) -> Mechanism:
        """Same as the class; everything that is constant in time is computed once for a model."""
        cached = model._derived.get(cls)
        if cached is None:
            cached = cls(model)
            # what copies share
            _ = cached.rows, cached.angular, cached.connection, cached._bounds, cached._unreleased
            model._derived[cls] = cached
        assert isinstance(cached, cls)
        return cached.moved_to(t, r)

    def moved_to(self, t: float, r: Array | None, model: LoadedModel | None = None) -> Mechanism:
        """The same mechanism at another time, with other inputs (nr,) or values of parameters."""
        other = copy.copy(self)
        other.t, other.r, other._cache = float(t), r, {}
        if model is not None:
            other.model = model
            for name in ("connection", "_bounds"):
                other.__dict__.pop(name, None)
        return other

    def _once(self, what: str, q: Array, function: Callable[[Array], Any]) -> Any:
        """A function of the position, found again only at another one."""
        key, cached = q.tobytes(), self._cache.get(what)
        if cached is None or cached[0] != key:
            cached = self._cache[what] = key, function(q)
        return cached[1]

    # constraints

    @cached_property
    def closing(self) -> Closing:
        """The constraints, whether or not runs keep to them."""
        rows = tuple(self.model.manifest.multipliers)
        return Closing(rows, self.size)

    @cached_property
    def rows(self) -> Array:
        """Size of the unit of every constraint (m,)."""
        return np.array([self.size if r.unit == "N" else 1.0 for r in self.closing.rows])

    @property
    def cuts(self) -> list[CutRow]:
        """The joints that close loops, from the manifest."""
        return list(self.model.manifest.cuts)

    def evaluate(self, name: str, *values: ArrayLike, more: tuple[object, ...] = ()) -> Array:
        """Result of a function of t, the values, r, and more."""
        return self.model._evaluate((name, None), (self.t, *values, self.r, *more), None, None)

    def residuals(self, q: Array) -> Array:
        """Residuals (mp,) of the constraints of positions, without units."""
        count = self.closing.positions
        if count == 0:
            return np.zeros(0)
        residuals: Array = self.evaluate("constraints", q) / self.rows[:count]
        return residuals[self._required[:count]]

    def reversed_axis(self, q: Array) -> str:
        """The cut joint whose closing conditions hold with an axis turned round; "" if none."""
        if not self.cuts or "assembly_signs" not in self.model.manifest.available:
            return ""
        values = self.evaluate("assembly_signs", q)
        wrong = np.flatnonzero(values <= SIGN_TOL)
        if not len(wrong):
            return ""
        entries = self.model.manifest.functions["assembly_signs"].outputs[0].entries
        return str(entries[wrong[0]]).rpartition(".")[0]

    @property
    def nu(self) -> int:
        """Number of steps."""
        return self.model.nu

    def jacobian(self, q: Array) -> Array:
        """G (m, nu), without units."""
        G: Array = self._once("jacobian", q, self._jacobian)
        return G

    def _jacobian(self, q: Array) -> Array:
        if not self.closing.rows:
            return np.zeros((0, self.nu))
        G = self.evaluate("constraint_jacobian", q, more=(self.s,))
        return np.asarray(G * self.columns / self.rows[:, None])[self._required]

    def decomposition(self, q: Array) -> tuple[Array, Array]:
        """Left singular vectors (m, m) and singular values of G."""
        factors: tuple[Array, Array] = self._once(
            "decomposition", q, lambda q: np.linalg.svd(self.jacobian(q))[:2]
        )
        return factors

    @property
    def rank(self) -> float:
        """Singular values below this part of the largest are those of dependent conditions."""
        return ROUNDED_TOL if self.closure_tol else TIGHT

    @property
    def positions(self) -> int:
        """Rows of :meth:`jacobian` that belong to :meth:`residuals`."""
        return int(self._required[: self.closing.positions].sum())

    @cached_property
    def connection(self) -> Connection:
        """The mechanism as searches in C know it."""
        return connect(self, self._required[: self.closing.positions])

    def without(self, relations: Iterable[str]) -> Mechanism:
        """The same mechanism with relations of the user released."""
        other = copy.copy(self)
        other.released = frozenset(relations)
        for name in ("connection", "_unreleased"):
            other.__dict__.pop(name, None)
        other._cache = {}
        return other

    @property
    def relations(self) -> list[str]:
        """Relations of positions that the user wrote."""
        rows = self.closing.rows[: self.closing.positions]
        return [str(row.name) for row in rows if row.name == row.joint]

    @cached_property
    def _unreleased(self) -> NDArray[np.bool_]:
        return np.array([row.name not in self.released for row in self.closing.rows], bool)

    @property
    def _required(self) -> NDArray[np.bool_]:
        """Mask of the rows that must hold."""
        return self._unreleased

    def rates(self, q: Array, u: Array) -> Array:
        """Residuals (m,) of the constraints of velocities, lengths without units."""
        if not self.closing.rows:
            return np.zeros(0)
        return self.evaluate("constraint_rates", q, u) / self.rows

    # coordinates

    def advance(self, q: Array, step: Array) -> Array:
        """Coordinates a step (nu,) without units away."""
        moved = self.moved(q, step * self.columns)
        return unit(moved, self.model.manifest.quaternions)

    def moved(self, q: Array, along: Array) -> Array:
        """Coordinates moved along speeds (nu,), whatever these are."""
        if self.chosen:
            along = self._joint_speeds(q) @ along
        return np.asarray(self.model.integrate(q, along))

    def difference(self, q0: Array, q1: Array) -> Array:
        """The step (nu,) without units from q0 to q1."""
        difference: Array = self.model.difference(q0, q1)
        if self.chosen:
            difference = np.asarray(
                np.linalg.lstsq(self._joint_speeds(q0), difference)[0], np.float64
            )
        step: Array = difference / self.columns
        return step

    @cached_property
    def chosen(self) -> bool:
        """True when the speeds are not those of the joints, along which coordinates are moved."""
        return any(row.joint is None for row in self.model.manifest.speeds)

    def _joint_speeds(self, q: Array) -> Array:
        """Speeds of the joints per chosen speed (nu, nu), by central differences along qdot."""
        rates = (self.kinematics(q) / self.columns).T
        ahead, behind = (self.model.difference(q, q + h * rates) for h in (NEARBY, -NEARBY))
        return np.asarray(ahead - behind).T / (2 * NEARBY)

    def kinematics(self, q: Array) -> Array:
        """N (nq, nu): coordinates per step without units."""
        N: Array = self._once("kinematics", q, self._kinematics)
        return N

    def _kinematics(self, q: Array) -> Array:
        model = self.model
        basis = np.concatenate([np.zeros((1, model.nu)), np.diag(self.columns)])
        rates = model.qdot(q, basis, t=self.t, r=self.r)
        return np.asarray(rates[1:] - rates[0]).T

    @cached_property
    def led(self) -> NDArray[np.intp]:
        """Entries of q that are coordinates of joints (n,)."""
        return np.arange(self.model.nq)

    def drawn(self, rng: np.random.Generator) -> Array:
        """Random coordinates (nq,)."""
        return random_state(self.model.manifest, rng)[: self.model.nq]

    def frame_jacobian(self, frame: str, q: Array) -> Array:
        """Angular velocity and velocity of a frame per step (6, nu)."""
        J: Array = self.model.frame_jacobian(frame, q, t=self.t, r=self.r)
        return J * self.columns

    def steps_of(self, u: Array) -> Array:
        """Steps per second (nu,) of speeds of the model."""
        return np.asarray(u / self.columns)

    def speeds_at(self, q: Array, steps: Array) -> Array:
        """Speeds of the model at a position, by steps per second (nu,)."""
        return np.asarray(steps * self.columns)

    def locked_speeds(
        self, q: Array, chosen: NDArray[np.intp], values: Array
    ) -> tuple[NDArray[np.intp], Array, Array]:
        """Conditions on steps from prescribed speeds:

        locked entries, and rows R with R steps = right.

        Args:
            q: Position (nq,).
            chosen, values: Entries of u that are given.
        """
        return chosen, np.zeros((0, self.nu)), np.zeros(0)

    def mass(self, q: Array) -> Array | None:
        """Mass matrix per step (nu, nu), None where the model has none."""
        if "mass_matrix" not in self.model.manifest.available:
            return None
        M: Array = self.model.mass_matrix(q, t=self.t, r=self.r)
        return M * np.outer(self.columns, self.columns)

    @cached_property
    def angular(self) -> Array:
        """Mask of the coordinates that are angles and return after a turn (nq,):

        of free joints alone.
        """
        manifest = self.model.manifest
        kinds = ("revolute", "cylindrical", "universal", "planar")
        leaders = {j.coupled.leader for j in manifest.joints if j.coupled}
        full_turn = {j.name for j in manifest.joints if j.kind in kinds} - leaders
        rows = manifest.coordinates
        return np.array([row.unit == "rad" and row.joint in full_turn for row in rows], bool)

    def nearest(self, q: Array, to: Array) -> Array:
        """The same position with every angle within half a turn of that of another one."""
        away = (q - to)[self.angular]
        if not len(away) or abs(away).max() < np.pi:
            return q
        turns = np.where(self.angular, np.round((q - to) / (2 * np.pi)), 0.0)
        unwrapped: Array = q - 2 * np.pi * turns
        if self._open(unwrapped) <= self._open(q) + TIGHT:
            return unwrapped
        # relations of the user may hold for one of equal angles only
        unwrapped = q
        for k in np.flatnonzero(turns):
            other = unwrapped.copy()
            other[k] -= 2 * np.pi * turns[k]
            if self._open(other) <= self._open(unwrapped) + TIGHT:
                unwrapped = other
        return unwrapped

    def _open(self, q: Array) -> float:
        """The largest residual of the constraints of positions."""
        return float(np.abs(self.residuals(q)).max(initial=0.0))

    @cached_property
    def _bounds(self) -> tuple[NDArray[np.intp], Array, Array]:
        """Entries of q that have limits, and these."""
        places, rows = self.model._layout.slots["q"], list[tuple[int, float, float]]()
        for name, limits in self.model.limits.items():
            low, high = (limits.get(side) for side in ("lower", "upper"))
            place = places.get(name, slice(0, 0))
            for k in range(place.start, place.stop):
                rows.append((k, -np.inf if low is None else low, np.inf if high is None else high))
        table = np.array(rows, dtype=np.float64).reshape(-1, 3)
        return table[:, 0].astype(np.intp), table[:, 1], table[:, 2]

    def outside(self, q: Array) -> int:
        """Number of coordinates outside their limits."""
        limited, low, high = self._bounds
        if not len(limited):
            return 0
        values = q[limited]
        return int(np.sum((values < low - LIMIT_TOL) | (values > high + LIMIT_TOL)))

    def inward(self, q: Array) -> Array:
        """Coordinates with those outside of two limits in the middle of them."""
        limited, low, high = self._bounds
        bounded = np.isfinite(low) & np.isfinite(high)
        limited, low, high = limited[bounded], low[bounded], high[bounded]
        inner, values = q.copy(), q[limited]
        inner[limited] = np.where((values < low) | (values > high), (low + high) / 2, values)
        return inner

    def gaps(self, q: Array) -> dict[str, tuple[float, float]]:
        """Cut joint or constraint -> what is left open: a distance [m] and anything else [1]."""
        count = self.closing.positions
        values = self.evaluate("constraints", q) if count else np.zeros(0)
        gaps: dict[str, tuple[float, float]] = {}
        for row, value in zip(self.closing.rows[:count], values.tolist(), strict=True):
            length, other = gaps.get(row.joint, (0.0, 0.0))
            if row.unit == "N":
                length = float(np.hypot(length, value))
            else:
                other = float(np.hypot(other, value))
            gaps[row.joint] = length, other
        return gaps


def refuse_nodes(model: LoadedModel, what: str) -> None:
    """Kinematics alone moves joints; where nodes stand they do not tell everything.

    Args:
        model: The model.
        what: The analysis that was asked for.

    Raises:
        ModelError: the model is in absolute coordinates.
    """
    if not model.manifest.absolute:
        return
    cure = "its bodies are nodes. Compile it with coordinates='relative', which has joints for it"
    if model.manifest.beams:
        cure = (
            "it has beams, which forces bend. assemble and sweep take by='strain_energy'; "
            "model.equilibrium(locked={'...': value}) and model.statics(locked={'...': (start, "
            "end)}) count loads too"
        )
    raise ModelError(
        f"{what}: model '{model.name}' is in absolute coordinates, where kinematics alone does not "
        f"tell a position: {cure}"
    )
