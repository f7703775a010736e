"""A compiled system as analyses see it, whatever its formulation.

Equilibria, load paths, linear models and modes work on :class:`DynamicSystem`. Motion is

    balance: M udot + h - f - Gᵀ lam = 0,   g = 0,   G u + g_t = 0,   zdot = its own rates,

with tangents along increments of the coordinates (rotations in body axes). Matrices are arrays or
sparse; which method factors them belongs to the system (:mod:`.saddle`).

Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapters 1, 12 and 13.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import issparse

from ...arrays import Array
from ...errors import ModelError, near
from ...records import dataclass
from .saddle_point import Saddle

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

Matrix: TypeAlias = Any  # an array, or a sparse one of scipy
Parameters = Mapping[str, ArrayLike] | None


def _none() -> Array:
    return np.zeros(0)


@dataclass(frozen=True, eq=False)
class Moment:
    """Everything that the equations of a system depend on at an instant.

    Attributes:
        t: Time [s].
        q, u, udot: Coordinates (nq,), speeds and their derivatives (nu,).
        lam: Multipliers (m,).
        r: Inputs (nr,).
        z, s: Internal states (nz,) and modes (ns,) of elements.
        parameters: Other values than the model's own, by name.
        inner: What elements keep themselves while one searches; empty else.
    """

    t: float
    q: Array
    u: Array
    udot: Array
    lam: Array = field(default_factory=_none)
    r: Array = field(default_factory=_none)
    z: Array = field(default_factory=_none)
    s: Array = field(default_factory=_none)
    parameters: Parameters = None
    inner: Array = field(default_factory=_none)


@dataclass(frozen=True, eq=False)
class Tangents:
    """Derivatives of the balance.

    Attributes:
        K, C, M: Of its forces along increments, by speeds and by accelerations (nu, nu).
        R: Of the rates of the constraints along increments (m, nu).
        G: The constraint Jacobian (m, nu).
    """

    K: Matrix
    C: Matrix
    M: Matrix
    R: Matrix
    G: Matrix


def dense(matrix: Matrix) -> Array:
    """A matrix as an array."""
    return np.asarray(matrix.toarray() if issparse(matrix) else matrix)


@dataclass(frozen=True, eq=False)
class Internal:
    """Coupling of internal states and forces.

    Attributes:
        balance: Of the forces of the balance by z (nu, nz).
        along, by_u, by_z: Of zdot along increments, by speeds, by z: (nz, nu), (nz, nu), (nz, nz).
    """

    balance: Array
    along: Array
    by_u: Array
    by_z: Array


@dataclass(frozen=True, eq=False)
class Rates:
    """Derivatives of [udot, zdot] (nu + nz) of the motion under the forces of the scene.

    Attributes:
        along, by_u, by_z, by_r: Along increments, by speeds, internal states and inputs.
    """

    along: Array
    by_u: Array
    by_z: Array
    by_r: Array


@dataclass(frozen=True, eq=False)
class OutputJacobians:
    """Derivatives of outputs.

    Attributes:
        along, by_u, by_z, by_r: Along increments, by speeds, internal states and inputs.
    """

    along: Array
    by_u: Array
    by_z: Array
    by_r: Array


class NamedState(ABC):
    """A state of a model, by its names; what takes a state takes it.

    Attributes:
        model: Whose.
        x: State (nx,).
    """

    model: LoadedModel
    x: Array

    @property
    @abstractmethod
    def named(self) -> dict[str, float]:
        """All its numbers by name."""

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.x, dtype=dtype)

    @property
    def q(self) -> Array:
        """Coordinates (nq,)."""
        return self.x[: self.model.nq]

    @property
    def u(self) -> Array:
        """Speeds (nu,): 0 at rest."""
        return self.x[self.model.nq : self.model.nq + self.model.nu]

    def __getitem__(self, name: str) -> Any:
        if name not in self.named:
            raise ModelError(f"'{name}': there is no such entry.{near(name, self.named)}")
        return self.named[name]


class DynamicSystem(Protocol):
    """A compiled system as analyses see it.

    Attributes:
        name: Of the model.
        coordinates, speeds, multipliers, internals, inputs: Names of q, u, lam, z and r.
        outputs: Names of the declared outputs.
        owners: Joint or node that every speed belongs to (nu,).
        positions: Which of the multipliers hold positions (mp,).
        size: Length against which displacements count [m].
        columns: Unit of every increment (nu,): ``size`` of lengths, 1 of angles.
        rows: Unit of every constraint (m,).
        reach: Longest step of Newton's method that means something, without units.
        saddle: How its linear systems are solved.
    """

    name: str
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    multipliers: tuple[str, ...]
    internals: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    owners: tuple[str, ...]
    positions: NDArray[np.intp]
    size: float
    columns: Array
    rows: Array
    reach: float
    saddle: Saddle

    @property
    def modes(self) -> Array:
        """Modes of elements as they start (ns,)."""

    @property
    def leading(self) -> NDArray[np.bool_]:
        """Mask of the speeds of joints (nu,); the others follow from them."""

    def start(
        self, t: float, q: object, r: Array, locked: Mapping[str, object], p: Parameters
    ) -> Moment:
        """A moment at rest next to named coordinates, with all loops closed.

        Args:
            t, r, p: Time [s], inputs (nr,), parameters.
            q: Coordinates by name or (nq,), None for the initial position.
            locked: Coordinates that have exactly this value.
        """

    def state(
        self, x0: object, q: object, u: object, z: object, t: float, r: Array, p: Parameters
    ) -> Moment:
        """A moving state on the constraints, as runs start from it.

        Args:
            x0: State; or q, u, z: by name or as arrays.
            t, r, p: Time [s], inputs (nr,), parameters.
        """

    @property
    def events(self) -> tuple[tuple[str, str, str], ...]:
        """Element, kind and meaning of a negative start, for every event."""

    @property
    def sign_units(self) -> tuple[str, ...]:
        """Units of the sign functions of events (ne,); "" of numbers, and of what users wrote."""

    def labels(self, s: Array) -> dict[str, str]:
        """Labels of the modes (ns,), by the name of the mode."""

    def signs(self, at: Moment) -> Array:
        """A number for every event (ne,): it happens where that falls through 0."""

    def modes_after(self, at: Moment, fired: NDArray[np.bool_]) -> Array:
        """Modes (ns,) behind events (ne,) that happen."""

    def input_vector(self, named: object) -> Array:
        """Inputs (nr,) by name, the rest at their defaults; or (nr,) as they are."""

    def changed(self, values: Mapping[str, float]) -> Parameters:
        """Parameters by name, checked; what :class:`Moment` takes."""

    def balance(self, at: Moment) -> Array:
        """[M udot + h - f - Gᵀ lam (nu), g (mp), G u + g_t (m)]."""

    def tangents(self, at: Moment) -> Tangents:
        """K, C, M, R and G."""

    def stiffness(self, at: Moment) -> tuple[Matrix, Matrix]:
        """K and G of these alone, which equilibria need."""

    def loads(self, at: Moment) -> Array:
        """Sizes (nu,) of the loads that act, without units: weights, forces, not of springs."""

    def strain_energy(self, at: Moment) -> float:
        """Energy of all strains [J]; its forces are those of a system of strains alone."""

    def sizes(self, at: Moment) -> Array:
        """Sizes of the coordinates that increments change (nu,), without units.

        Of positions the distance from the origin: what rounding of theirs counts against.
        """

    def internal_rates(self, at: Moment) -> Array:
        """zdot (nz,)."""

    def internal(self, at: Moment) -> Internal:
        """Coupling of internal states and forces at a state."""

    def rates(self, at: Moment, tau: Array | None = None) -> Rates:
        """Derivatives of the accelerations that follow from the forces, constraints kept.

        Args:
            at: A moment whose accelerations are not read.
            tau: Forces along the speeds besides those of the scene.
        """

    def accelerations(self, at: Moment, tau: Array | None = None) -> Moment:
        """The moment with the accelerations and multipliers that follow from the forces."""

    @property
    def increments(self) -> tuple[str, ...]:
        """Name of every increment (nu,): that of its coordinate where it is one."""

    def output_jacobians(self, at: Moment) -> OutputJacobians:
        """Derivatives of the declared outputs."""

    def kinematic_matrix(self, at: Moment) -> Array:
        """N (nq, nu): how coordinates change with increments."""

    def drift(self, at: Moment) -> Array:
        """Rates of increments that no speed makes (nu,): n in qdot = N u + n, along them."""

    def observer(self, at: Moment) -> tuple[Matrix, Matrix]:
        """E and W (nu, nu) in axes in which small motions are told.

        Increments change at the rate E increments + change v of the speeds; accelerations change
        by v' + W v.
        """

    def with_internal_unknowns(self, at: Moment) -> Moment:
        """The moment with what elements keep themselves while one searches, if they do."""

    def retract(self, at: Moment, du: Array) -> Moment:
        """The moment an increment (nu,) away, multipliers and speeds as they are."""

    def integrate(self, q: Array, du: Array) -> Array:
        """Coordinates (nq,) an increment away."""

    def difference(self, q0: Array, q: Array) -> Array:
        """The increment (nu,) that leads from q0 to q."""

    @property
    def places(self) -> Mapping[str, tuple[int, int]]:
        """Coordinates that can be held, as their speeds are their derivatives: entries in q, u."""

    def place(self, name: str) -> tuple[int, int]:
        """Entries in q and u of a coordinate that can be held.

        Raises:
            ModelError: there is none.
        """

    def steady_state(self, at: Moment, speeds: Mapping[str, object]) -> Moment:
        """The moment with speeds that the constraints allow and given ones, and their rates.

        Joints keep their speeds; rates are those of a steady motion with them.

        Raises:
            ModelError: an unknown name, or inconsistent speeds.
        """

    def steady_state_tangent(
        self, at: Moment, speeds: Mapping[str, object]
    ) -> tuple[Matrix, Matrix]:
        """Derivatives of the speeds of :meth:`steady_state` and their rates along increments (nu,
        nu).
        """

    def steady(self, at: Moment) -> Array:
        """Rates (nu,) of the speeds of a moment if its motion is steady."""

    def advance_steady(self, at: Moment) -> Moment | None:
        """The moment a radian further in a steady motion that turns; None where that is open."""

    def uniform(self, at: Moment) -> bool:
        """True when matrices are constant in a steady motion, not only what follows from them."""
