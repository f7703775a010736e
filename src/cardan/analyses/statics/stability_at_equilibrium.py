"""Stability of a system at equilibrium: stable, unstable, or with free parts.

Where forces have a potential the inertia of the stiffness tells, the number of its negative
eigenvalues on what constraints allow. Forces that follow the motion have none, and dampers may feed
it: a system can begin to oscillate (flutter) while its stiffness holds it, and eigenvalues of the
small motions tell.

Source: H. Ziegler, Principles of Structural Stability (1968), chapters 2 and 3.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from scipy.linalg import block_diag
from scipy.sparse import issparse
from scipy.sparse.linalg import ArpackError

from ...arrays import Array, Complex
from ...records import dataclass
from ..linear.first_order import eigenvalues
from ..systems.dynamic_system import DynamicSystem, Moment, dense
from ..systems.saddle_point import FREE_TOL, SKEW, Lowest, Singular, Sparse, near_quadratic, split
from .static_problem import Load, Point, Problem, scaled

SHARE = 0.2  # entries of a motion below this part of the largest are not told
MOST = 3
# real parts that count as growth, over the largest modulus: of what rests, of what moves fast.
# What is known to a part KNOWN of the square of the largest leaves as much of other squares
UNSTABLE_TOL, RELATIVE_ERROR = 1e-6, 1e-10
SINGULAR = 1e-12  # of the largest singular value: what rounding leaves of none
FLUTTER = 1e-3  # imaginary parts over the modulus: below that growth is not an oscillation
MANY = 300  # speeds up to which all eigenvalues are looked at
FEEDING = 1e-9  # of the largest entry of the damping: rounding
FEW, SHIFT = 12, 1e-3  # of more speeds: pairs next to 0, and how near [rad/s]


@dataclass(frozen=True, eq=False)
class Stability:
    """Stability of a system at equilibrium.

    Attributes:
        stable: None where the stiffness alone does not tell and eigenvalues were not to be had.
        negative: Negative eigenvalues of the stiffness on what constraints allow: independent
            directions in which the system is pushed away.
        least: The lowest eigenvalue of the stiffness on what constraints allow, without units of
            length: an energy [J]. It passes 0 where stability changes.
        direction: Its direction (nu,), without units.
        free_motions: Motions that nothing resists, in words.
        side: A number that is another one beyond a critical load: negative eigenvalues; where
            forces have no potential motions that grow, or 0 or 1 by the sign of the determinant
            where those were not to be had. None where it is not known.
        signed: The same, eigenvalues that may be rounding counted by their sign.
        margin: How far the nearest eigenvalue of the stiffness is from 0; NaN where forces have no
            potential.
        frequency: Of an oscillation that grows [rad/s]; 0 where none does.
        dead: How it stands under dead loads in place of the displacements that are prescribed;
            None where none are.
    """

    stable: bool | None
    negative: int
    least: float
    direction: Array
    free_motions: tuple[str, ...]
    side: int | None = None
    signed: int | None = None
    margin: float = np.nan
    frequency: float = 0.0
    dead: Stability | None = None

    @property
    def under_dead_load(self) -> Stability:
        """Stability under loads that stay where now displacements are prescribed."""
        return self if self.dead is None else self.dead


def stand(problem: Problem, point: Point, load: Load) -> Stability:
    """Classify the stability of a system at an equilibrium."""
    stability = _stand(problem, point, load, load)
    if not load.prescribed:
        return stability
    locked = {name: value for name, value in load.locked.items() if name not in load.prescribed}
    return replace(stability, dead=_stand(problem, point, load, replace(load, locked=locked)))


def _stand(problem: Problem, point: Point, load: Load, constrained: Load) -> Stability:
    """The same under a load, where what is kept holds (no more than the load does)."""
    system = problem.system
    K, G = problem.tangent(point, constrained)
    nu = len(system.columns)
    try:
        lowest = system.saddle.lowest(K[:nu, :nu], G[:, :nu])
    except Singular:
        return Stability(None, 0, 0.0, np.zeros(nu), ())
    # zero stiffness: rigid-body motions; negative: buckled under a potential load
    free_motions = tuple(largest_motions(system, motion) for motion in lowest.free_directions.T)
    least = float(lowest.values[0]) if len(lowest.values) else np.inf
    direction = lowest.vectors[:, 0] if len(lowest.values) else np.zeros(nu)
    stability = Stability(None, lowest.negative, least, direction, free_motions)
    potential = lowest.skew <= SKEW and _damped(system, point.at)
    if potential and not system.internals:
        stability = replace(stability, side=lowest.negative, signed=lowest.signed)
        stability = replace(stability, margin=_margin(lowest))
        # gyroscopic forces do no work: what a potential holds they leave stable
        if not lowest.negative and not lowest.free_directions.size:
            return replace(stability, stable=True)
        # at rest under potential forces a negative eigenvalue decides (Lagrange-Dirichlet)
        if constrained.u is None:
            return replace(stability, stable=False if lowest.negative else None)
    locked = [system.place(name)[1] for name in constrained.locked]
    # follower, gyroscopic or dissipative forces: the eigenvalues of the motion decide
    values = _motions(problem, point, load, constrained, locked)
    if not potential:
        side = int(lowest.sign < 0) if lowest.sign else None
        stability = replace(stability, side=side, signed=side)
    elif system.internals:
        stability = replace(stability, side=lowest.negative, signed=lowest.signed)
    if values is None:
        return stability
    # internal states lag behind, and feed a motion that stiffness and damping hold
    circulatory = not potential or bool(system.internals)
    sign = 0.0
    if circulatory and constrained.u is None and nu <= MANY:
        sign = _static_determinant_sign(dense(K), dense(G), nu)
    return _by_eigenvalues(stability, values, circulatory, sign)


def _static_determinant_sign(K: Array, G: Array, nu: int) -> float:
    """Sign of the determinant of the stiffness once internal states have come to rest.

    It is 0 where the stiffness is singular up to rounding, as of what only lags behind.

    Args:
        K, G: Tangents by speeds and internal states. nu: Number of speeds.
    """
    Z = split(G[:, :nu])[2]
    over = block_diag(Z, np.eye(len(K) - nu))
    inner = over.T @ K @ over
    for axis in (1, 0):
        sizes = np.abs(inner).max(axis=axis, keepdims=True, initial=0.0)
        inner = inner / np.where(sizes > 0, sizes, 1.0)
    values = np.linalg.svd(inner, compute_uv=False)
    if values.min(initial=np.inf) <= SINGULAR * values.max(initial=0.0):
        return 0.0
    # rates of internal states stand in the rows against forces in those of speeds
    return float(np.linalg.slogdet(inner)[0] * (-1) ** (len(K) - nu))


def _damped(system: DynamicSystem, at: Moment) -> bool:
    """True unless forces along the speeds feed a motion; of many speeds that is not looked at."""
    if len(system.columns) > MANY:
        return True
    C = dense(system.tangents(at).C)
    values = np.linalg.eigvalsh(0.5 * (C + C.T))
    return bool(values.min(initial=0.0) >= -FEEDING * np.abs(C).max(initial=0.0))


def _margin(lowest: Lowest) -> float:
    """Distance of the nearest eigenvalue from 0; free directions do not count."""
    sizes = np.abs(lowest.values)
    firm = sizes[sizes > FREE_TOL * lowest.largest]
    return float(firm.min()) if len(firm) else float("nan")


def _by_eigenvalues(
    stability: Stability, values: Complex, circulatory: bool, sign: float
) -> Stability:
    """Stability by the eigenvalues of the small motions [1/s].

    Args:
        stability: As far as the stiffness tells it.
        values: The eigenvalues.
        circulatory: Whether they tell how many motions grow, rather than the stiffness.
        sign: Of the determinant of the stiffness at rest; 0 where it is not known.
    """
    sizes = np.abs(values)
    largest = float(sizes.max(initial=0.0)) or 1.0
    off = RELATIVE_ERROR * largest**2 / np.maximum(sizes, RELATIVE_ERROR / UNSTABLE_TOL * largest)
    grows = values.real > off
    stability = replace(stability, stable=not grows.any())
    if not circulatory:
        return stability
    fastest = values[np.where(grows, values.real, -np.inf).argmax()] if grows.any() else 0j
    sways = abs(fastest.imag) > FLUTTER * abs(fastest)
    frequency = abs(fastest.imag) if sways else 0.0
    many = int(np.sum(grows))
    # oscillations grow in pairs, so that the sign tells of one real motion whose growth is as
    # small as rounding: next to a fold, over a wide range where something else moves fast
    definite = sign != 0 and not stability.free_motions
    slow = int(definite and (many % 2 == 1) != (sign < 0))
    return replace(stability, side=many, signed=many + slow, frequency=float(frequency))


def _motions(
    problem: Problem, point: Point, load: Load, constrained: Load, locked: Sequence[int]
) -> Complex | None:
    """Eigenvalues of small motions [1/s]: all, of many speeds those next to 0 at rest."""
    system, tau = problem.system, problem.locked_forces(point, load)[1]
    if len(system.columns) <= MANY:
        growth: Complex | None = eigenvalues(system, point.at, locked, tau)
        return growth
    if constrained.u is not None or not isinstance(system.saddle, Sparse) or system.internals:
        return None
    tangents, G = system.tangents(point.at), problem.tangent(point, constrained)[1]
    K, C, M = (
        scaled(x, system.columns, system.columns) for x in (tangents.K, tangents.C, tangents.M)
    )
    if not issparse(K):
        return None
    try:
        values: Complex = near_quadratic(K, C, M, G, SHIFT, 2 * FEW, system.saddle.factored)[0]
    except (Singular, ArpackError):
        return None
    return values


def largest_motions(system: DynamicSystem, motion: Array) -> str:
    """Names of the largest components of a motion (nu,):

    ``'cart', 'pole'``; among equals those that can be locked.
    """
    return largest_of(system.owners, system.speeds, motion)


def largest_of(owners: Sequence[str], names: Collection[str], motion: Array) -> str:
    """The same, from the owner of every speed and the names of speeds."""
    sizes: dict[str, float] = {}
    for owner, size in zip(owners, np.abs(motion[: len(owners)]), strict=False):
        sizes[owner] = max(sizes.get(owner, 0.0), float(size))
    largest = max(sizes.values(), default=0.0)
    speeds = set(names)

    def order(name: str) -> tuple[float, bool]:
        return -round(sizes[name] / largest, 1), f"{name}.u" not in speeds

    moving = sorted((n for n in sizes if sizes[n] >= SHARE * largest > 0), key=order)
    more = ", ..." if len(moving) > MOST else ""
    return ", ".join(f"'{name}'" for name in moving[:MOST]) + more


def lockable(system: DynamicSystem, motion: Array, locked: Collection[str] = ()) -> str:
    """The coordinate that a motion (nu,) moves most of those that can be held; "" without.

    Args:
        system, motion: Of what, in which direction.
        locked: Coordinates that are held already.
    """
    sizes = np.abs(motion[: len(system.owners)])
    shares = {name: sizes[k] for name, (_, k) in system.places.items() if name not in locked}
    name = max(shares, key=shares.__getitem__, default="")
    return name if name and shares[name] >= SHARE * sizes.max(initial=0.0) > 0 else ""
