"""How a system stands where it rests: stably, unstably, or with parts that nothing holds."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .contract import Contract
from .first_order import eigenvalues
from .saddle import SKEW, Lowest, Singular
from .static_problem import Load, Point, Problem

Array = NDArray[np.float64]
SHARE = 0.2  # entries of a motion below this part of the largest are not told
MOST = 3
GROWING = 1e-6  # real parts of eigenvalues, over the largest modulus
MANY = 300  # speeds up to which all eigenvalues are looked at


@dataclass(frozen=True, eq=False)
class Standing:
    """How a system stands.

    Attributes:
        stable: None where the stiffness alone does not tell and eigenvalues were not to be had.
        negative: Independent directions in which it is pushed away.
        least: The lowest eigenvalue of the stiffness on what constraints allow, without units of
            length: an energy [J]. It passes 0 where stability changes.
        direction: Its direction (nu,), without units.
        loose: Where it moves freely, in words.
        side: A number that is another one beyond a critical load: eigenvalues below 0, down to
            rounding; where forces have no potential 0 or 1 by the sign of the determinant. None
            where it is not known.
    """

    stable: bool | None
    negative: int
    least: float
    direction: Array
    loose: tuple[str, ...]
    side: int | None = None


def stand(problem: Problem, point: Point, load: Load) -> Standing:
    """How a system stands at a point where it rests."""
    system = problem.system
    K, G = problem.tangent(point, load)
    nu = len(system.columns)
    try:
        lowest = system.saddle.lowest(K[:nu, :nu], G[:, :nu])
    except Singular:
        return Standing(None, 0, 0.0, np.zeros(nu), ())
    loose = tuple(words(system, motion) for motion in lowest.loose.T)
    least = float(lowest.values[0]) if len(lowest.values) else np.inf
    direction = lowest.vectors[:, 0] if len(lowest.values) else np.zeros(nu)
    stable = _stable(problem, point, load, lowest)
    return Standing(stable, lowest.negative, least, direction, loose, _side(lowest))


def _side(lowest: Lowest) -> int | None:
    if lowest.skew <= SKEW:
        return int(np.sum(lowest.values < 0)) if lowest.loose.size else lowest.negative
    return int(lowest.sign < 0) if lowest.sign else None


def _stable(problem: Problem, point: Point, load: Load, lowest: Lowest) -> bool | None:
    """By the stiffness where forces have a potential; else by how small motions grow."""
    system = problem.system
    if lowest.skew <= SKEW and not system.internals:
        # gyroscopic forces do no work: what a potential holds they leave stable
        if not lowest.negative and not lowest.loose.size:
            return True
        if load.u is None:
            return False if lowest.negative else None
    if len(system.columns) > MANY:
        return None
    held, tau = problem.held(point, load)
    values = eigenvalues(system, point.at, held, tau)
    if values is None:
        return None
    return bool(np.real(values).max(initial=0.0) <= GROWING * np.abs(values).max(initial=1.0))


def words(system: Contract, motion: Array) -> str:
    """What moves most in a motion (nu,): ``'cart', 'pole'``; of equals those that can be held."""
    sizes: dict[str, float] = {}
    for owner, size in zip(system.owners, np.abs(motion[: len(system.owners)]), strict=False):
        sizes[owner] = max(sizes.get(owner, 0.0), float(size))
    largest = max(sizes.values(), default=0.0)
    speeds = set(system.speeds)

    def order(name: str) -> tuple[float, bool]:
        return -round(sizes[name] / largest, 1), f"{name}.u" not in speeds

    told = sorted((n for n in sizes if sizes[n] >= SHARE * largest > 0), key=order)
    more = ", ..." if len(told) > MOST else ""
    return ", ".join(f"'{name}'" for name in told[:MOST]) + more
