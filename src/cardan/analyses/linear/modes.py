"""Modes of vibration about equilibria, under prestress, and about steady motions.

At rest with symmetric stiffness and no damping they are those of K and M on what constraints
allow. Else, as for whirling rotors, where gyroscopic forces or dampers act, they are those of the
equations of first order; large sparse systems solve the quadratic problem next to a shift.

Source: M. Géradin, D. Rixen, Mechanical Vibrations, 3rd ed. (2015), chapters 2 and 3; F. Tisseur,
K. Meerbergen, SIAM Review 43 (2001), 235-286 (quadratic eigenproblem).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.linalg
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array, issparse, vstack
from scipy.sparse.linalg import ArpackError

from ...arguments import Count, checked
from ...arrays import Array
from ...errors import ModelError, SolveError, SolveWarning, warn
from ...runtime.calls.evaluation import State
from ..statics.equilibrium import EquilibriumRecord
from ..statics.static_problem import scaled
from ..systems import dynamic_system_of
from ..systems.dynamic_system import DynamicSystem, Moment
from ..systems.saddle_point import (
    Factor,
    Matrix,
    Singular,
    Sparse,
    factored,
    is_small,
    near,
    near_quadratic,
    split,
)
from .first_order import FULL, Choice, first_order
from .linearize import stance
from .mode_shapes import ModesRecord

if TYPE_CHECKING:
    from ...runtime.models.loaded_model import LoadedModel

Complex = NDArray[np.complex128]
RESTS = 1e-6  # accelerations below this are none [rad/s^2, or sizes/s^2]
ALIKE = 1e-8  # of the largest entry: parts of matrices that are rounding
STILL = 1e-7  # of the largest modulus: eigenvalues that are 0
SQUARE = 1e-12  # the same of squares of frequencies
FEW = 12  # modes of a sparse system if no number is given
SHIFT = 1e-3  # rad/s next to 0
NEAR_QUOTIENT = 1e-6  # of an eigenvalue: what its quotient may change
ROUNDING = 2e-15  # of the stiffness of the parts of a shape: below it there is none
FARTHEST = 1e-3  # of what the largest stiffness over the largest mass makes


@checked
def modes(
    model: LoadedModel,
    count: Count | None = None,
    x: ArrayLike | EquilibriumRecord | None = None,
    *,
    q: State | None = None,
    u: State | None = None,
    r: State | None = None,
    t: float = 0.0,
    parameters: Mapping[str, float] | None = None,
    damped: bool = True,
) -> ModesRecord:
    """Modes about an equilibrium or a steady motion, from the lowest frequency.

    Args:
        model: The compiled model.
        count: How many; all of a small system if left out.
        x: State (nx,), or an equilibrium, whose loads then prestress; or q, u by name or as
            arrays. If all are left out the equilibrium next to the initial position.
        r: Inputs by name or (nr,). t: Time [s]. parameters: Values by name.
        damped: Whether dampers act. False holds at rest only, where modes are then real.

    Raises:
        ModelError: unknown names, a count that is none, ``damped=False`` in motion.
        SolveError: the mass matrix is singular on what constraints allow.
    """
    if count is not None and (not isinstance(count, int | np.integer) or count < 1):
        raise ModelError(f"modes: count={count!r}: a number of modes, at least 1")
    model, at, locked, tau, choice = stance(model, x, q, u, None, r, t, parameters)
    system = dynamic_system_of(model)
    if choice is None:
        _steady(system, at, locked)
    still = not np.any(at.u)
    values, shapes = _solved(system, at, locked, tau, choice, count, damped, still)
    momentum = _momentum(model, at)
    return ModesRecord(
        model, at, values, shapes, system.increments, system.owners, momentum, system.size
    )


def _momentum(model: LoadedModel, at: Moment) -> Array:
    """Momentum by speeds (6, nu); (0, nu) of equations without bodies."""
    if "momentum" in model.manifest.absent:
        return np.zeros((0, len(at.u)))
    columns = np.asarray(model.momentum(at.q, np.eye(len(at.u)), t=at.t, r=at.r)).T
    offset = np.asarray(model.momentum(at.q, 0 * at.u, t=at.t, r=at.r))
    return np.asarray(columns - offset[:, None])


def _steady(system: DynamicSystem, at: Moment, locked: list[int]) -> None:
    """Warn where a state neither rests nor moves steadily."""
    left = np.delete((at.udot - system.steady(at)) / system.columns, locked)
    worst = float(np.abs(left).max(initial=0.0))
    if worst > RESTS * max(1.0, float(np.abs(at.u / system.columns).max(initial=0.0)) ** 2):
        name = np.delete(np.array(system.speeds), locked)[int(np.abs(left).argmax())]
        warn(
            f"modes of '{system.name}' about a state that accelerates ('{name}' by {worst:.3g}): "
            "they hold for an instant only. Take model.equilibrium(...), or hold what is held",
            SolveWarning,
        )


def _solved(
    system: DynamicSystem, at: Moment, locked: list[int], tau: Array, choice: Choice | None,
    count: int | None, damped: bool, still: bool,
) -> tuple[Complex, Any]:  # fmt: skip
    """Eigenvalues (k,) [1/s] and shapes (nu, k), from the lowest frequency."""
    tangents = system.tangents(at)
    K, C, M = (
        scaled(x, system.columns, system.columns) for x in (tangents.K, tangents.C, tangents.M)
    )
    G = scaled(tangents.G, 1.0 / system.rows, system.columns)
    # small systems: dense solvers are faster and find all modes
    if issparse(K) and is_small(G):
        K, C, M, G = (x.toarray() for x in (K, C, M, G))
    # locked speeds are further constraint rows
    if locked:
        shape = (len(locked), len(system.columns))
        locked_rows = csr_array((np.ones(len(locked)), (np.arange(len(locked)), locked)), shape)
        G = (
            csr_array(vstack([G, locked_rows]))
            if issparse(G)
            else np.concatenate([G, locked_rows.toarray()])
        )
    by = system.saddle.factored if isinstance(system.saddle, Sparse) else factored
    values: Complex
    shapes: Any
    quiet = still and (not damped or not _size(C)) and not system.internals
    real = quiet and _size(K - K.T) <= ALIKE * _size(K)
    if not damped and not real:
        raise ModelError(
            f"modes of '{system.name}': damped=False needs a state at rest, a symmetric stiffness "
            "and no internal states; elsewhere damping is one with other effects. Leave it out"
        )
    small = len(system.columns) <= FULL
    try:
        # undamped and symmetric: K x = omega^2 M x with real modes
        if real:
            values, shapes = _undamped(K, M, G, count, by)
        # sparse and damped or spinning: shift and invert on the quadratic eigenvalue problem
        elif issparse(K) and (still or system.uniform(at)):
            E, W = (
                csr_array(scaled(csr_array(x), 1 / system.columns, system.columns))
                for x in system.observer(at)
            )
            # v = e' - E e, and M (v' + W v) + C v + K e
            damping = C + M @ W
            shifted = (K - damping @ E, damping - M @ E)
            # a part of the speeds: nearer to rotations that nothing holds others would be lost
            shift = SHIFT * max(1.0, 100 * float(np.abs(at.u / system.columns).max(initial=0.0)))
            try:
                values, shapes = _near(*shifted, M, G, shift, 2 * (count or FEW), by)
            except ArpackError:
                if not small:
                    raise
                values, shapes = _first(system, at, locked, tau, choice)
        else:
            values, shapes = _first(system, at, locked, tau, choice)
    except ArpackError:
        raise SolveError(
            f"modes of '{system.name}': the search for {count or FEW} modes next to 0 did not end, "
            f"and {len(system.columns)} speeds are too many for full matrices. Ask for fewer "
            "(count=), or let beams have fewer elements"
        ) from None
    except (np.linalg.LinAlgError, Singular) as problem:
        raise SolveError(
            f"modes of '{system.name}': the mass matrix is singular on what constraints allow (a "
            f"part without mass?), or stiffness and mass have no modes: {problem}"
        ) from None
    chosen = _chosen(values, count, np.iscomplexobj(shapes))
    shapes = shapes[:, chosen]
    # unit modal mass, and a phase that makes the largest entries real
    weight = np.sqrt(np.abs(np.einsum("ik,ik->k", shapes.conj(), M @ shapes)))
    shapes = shapes / np.where(weight > 0, weight, 1.0)
    return values[chosen], _phased(shapes) * system.columns[:, None]


def _near(
    K: Matrix, C: Matrix, M: Matrix, G: Matrix, shift: float, count: int, by: Factor
) -> tuple[Complex, Complex]:
    """Modes next to 0 of a quadratic problem, from a shift at which rigid bodies resist.

    Beside stiff elements the inertia that a small shift adds to free motions is rounding: it grows
    until there is a solution, or it is what :func:`_real` takes.
    """
    largest = float(np.sqrt(np.abs(K.diagonal()).max() / np.abs(M.diagonal()).max()))
    while True:
        try:
            values, shapes = near_quadratic(K, C, M, G, shift, count, by)
            return _resolved(values, shapes, K, C, M), shapes
        except Singular:
            if shift >= FARTHEST * largest:
                raise
        shift = min(10 * shift, FARTHEST * largest)


def _undamped(K: Any, M: Any, G: Any, count: int | None, by: Factor) -> tuple[Complex, Array]:
    """Undamped modes; of sparse matrices by full ones where the search for few does not end."""
    try:
        return _real(K, M, G, count, by)
    except ArpackError:
        if not issparse(K) or K.shape[0] > FULL:
            raise
        values, shapes = _real(K.toarray(), M.toarray(), G.toarray(), count, by)
        return values[: count or FEW], shapes[:, : count or FEW]


def _real(
    K: Any, M: Any, G: Any, count: int | None, by: Factor = factored
) -> tuple[Complex, Array]:
    """Undamped modes."""
    if issparse(K):
        shift = (
            -(FARTHEST**2) * float(np.abs(K.diagonal()).max()) / float(np.abs(M.diagonal()).max())
        )
        half = csr_array(0.5 * (K + K.T))
        squares, shapes = near(half, csr_array(M), G, shift, count or FEW, by)
    else:
        Z = split(G)[2]
        inner = 0.5 * (K + K.T)
        squares, inside = scipy.linalg.eigh(Z.T @ inner @ Z, Z.T @ M @ Z)
        shapes = Z @ inside
    largest = float(np.abs(squares).max(initial=0.0))
    squares = np.where(np.abs(squares) <= SQUARE * largest, 0.0, squares)
    values = np.where(squares >= 0, 1j, 1.0) * np.sqrt(np.abs(squares))
    return _resolved(values.astype(np.complex128), shapes, K, 0 * K, M), shapes


def _resolved(values: Complex, shapes: Array | Complex, K: Matrix, C: Matrix, M: Matrix) -> Complex:
    """Eigenvalues, 0 where the stiffness k of their shape is but rounding of that of its parts.

    By v^2 m + v c + k = 0 they are 0 then, or -c / m. Those of a rigid body come in pairs that
    rounding splits, further than k says; only as 0 do they count once.
    """
    size = np.abs(shapes)
    rounding = ROUNDING * np.einsum("ik,ik->k", size, abs(K) @ size)
    k, c, m = (np.einsum("ik,ik->k", shapes.conj(), matrix @ shapes) for matrix in (K, C, M))
    free = (np.abs(k) <= rounding) & (np.abs(values * m + c) > 0.5 * np.abs(c))
    if _size(C) and _size(C + C.T) <= ALIKE * _size(C) and _size(K - K.T) <= ALIKE * _size(K):
        values = _by_quotients(values, k.real, c.imag, m.real)
    return np.where(free, 0.0, values)


def _by_quotients(values: Complex, k: Array, c: Array, m: Array) -> Complex:
    """Eigenvalues (n,) of gyroscopic systems by x^H (K + values C + values^2 M) x = 0.

    With K symmetric and C skew their errors are those of the shapes squared; far from the shift
    those of the search are not.

    Source: P. Lancaster, Lambda-Matrices and Vibrating Systems (1966), section 5.3.

    Args:
        values: Approximations.
        k, c, m: Quotients (n,) of K, C / i and M.
    """
    root = np.sqrt(c**2 + 4 * k * m + 0j)
    roots = 1j * np.stack([-c + root, -c - root]) / (2 * m)
    nearest = roots[np.abs(roots - values).argmin(axis=0), np.arange(len(values))]
    near = np.abs(nearest - values) <= NEAR_QUOTIENT * np.abs(values)
    return np.where(near, nearest, values)


def _first(
    system: DynamicSystem, at: Moment, locked: list[int], tau: Array, choice: Choice | None
) -> tuple[Complex, Complex]:
    """Modes of the equations of first order, without units."""
    small = first_order(system, at, locked, tau, choice)
    values, vectors = np.linalg.eig(small.A.astype(np.complex128))
    shapes = (small.increments @ vectors) / system.columns[:, None]
    return values, shapes


def _chosen(values: Complex, count: int | None, double: bool) -> NDArray[np.intp]:
    """One of every pair, from the lowest frequency; what is not periodic by its rate."""
    size = float(np.abs(values).max(initial=0.0))
    values[np.abs(values) <= STILL * size] = 0.0
    values.imag[np.abs(values.imag) <= ALIKE * np.abs(values)] = 0.0
    upper = np.flatnonzero(values.imag >= -ALIKE * np.abs(values))
    # a rigid body counts once: it has a position and a speed
    still = upper[values[upper] == 0]
    upper = np.setdiff1d(upper, still[(len(still) + 1) // 2 :]) if double else upper
    order = np.lexsort((values[upper].real, np.round(np.abs(values[upper]), 12)))
    return upper[order][:count]


def _phased(shapes: Any) -> Any:
    """Shapes whose largest entry is real and positive."""
    top = np.take_along_axis(shapes, np.abs(shapes).argmax(axis=0)[None], axis=0)
    shapes_in_phase = shapes * np.where(
        np.abs(top) > 0, np.conj(top) / np.maximum(np.abs(top), 1e-300), 1.0
    )
    return shapes_in_phase.real if np.isrealobj(shapes) else shapes_in_phase


def _size(matrix: Any) -> float:
    return float(abs(matrix).max()) if min(matrix.shape) else 0.0
