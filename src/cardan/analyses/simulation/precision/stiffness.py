"""Stiffness of a model at a state: its fastest rate against the rate at which it moves.

Estimated from a few evaluations of the right-hand side, so that nothing is compiled for it.

Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.2
(automatic stiffness detection, with a power iteration in place of one product).
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ....arguments import checked
from ....arrays import Array
from ....errors import counted
from ....records import dataclass
from ....runtime.calls.calling import numbers
from ....runtime.calls.evaluation import State
from ....runtime.models.loaded_model import LoadedModel

PRODUCTS = 16  # of the Jacobian with a vector
RELATIVE = 1e-7  # size of differences
# h times the fastest rate up to which explicit steps of order 8 are stable, measured on springs
STABLE = 3.0
# steps of a method of order 5 over a radian of the motion at tolerance 1, from which they grow
ROUGH = 0.5
FEW = 100  # steps that any method may take
GAIN = 10.0  # fewer steps that make up for a Jacobian and its factors


@dataclass(frozen=True)
class Stiffness:
    """Rates of a model at a state.

    Attributes:
        fastest: Largest modulus of the eigenvalues of d rhs / d x, estimated [1/s].
        present: Rate at which the motion itself changes there [1/s]: far below ``fastest`` where
            the fast part rests.
    """

    fastest: float
    present: float

    def __str__(self) -> str:
        explicit = round(self.explicit_steps(1.0))
        return (
            f"fastest rate {self.fastest:.3g} 1/s, the motion changes at {self.present:.3g} 1/s: "
            f"over a second, stability asks {counted(explicit, 'step')} of explicit methods, "
            f"accuracy {self.implicit_steps(1.0, 1e-6):.0f} of implicit ones at rtol 1e-6"
        )

    def explicit_steps(self, length: float) -> float:
        """Steps that stability alone asks of an explicit method over a time [s]."""
        return abs(length) * self.fastest / STABLE

    def implicit_steps(self, length: float, rtol: float) -> float:
        """Steps that accuracy asks of an implicit method of order 5 over a time [s]."""
        return FEW + ROUGH * abs(length) * self.present / math.pow(max(rtol, 1e-15), 0.2)

    def implicit_pays(self, length: float, rtol: float, steps: float | None = None) -> bool:
        """True when an implicit method needs so many fewer steps that it is faster.

        Args:
            length: Of the run [s].
            rtol: Its tolerance.
            steps: Of an explicit method; by default what stability asks.
        """
        explicit = self.explicit_steps(length) if steps is None else steps
        return explicit > GAIN * self.implicit_steps(length, rtol)


@checked
def stiffness(
    model: LoadedModel, x: ArrayLike, t: float = 0.0, r: State | None = None, s: State | None = None
) -> Stiffness:
    """Rates of a model at a state, from about twenty evaluations of ``rhs``.

    Args:
        model: The compiled model.
        x: State [q, u, z] (nx,).
        t: Time [s].
        r: Inputs (nr,), taken as constant. s: Modes (ns,).

    Raises:
        SolveError: there, or close to it, the model has no accelerations.
    """

    def right(y: Array) -> Array:
        value: Array = model.rhs(t, y, r, s=s)
        return value

    at = numbers("x", x)
    start = right(at)

    def product(v: Array) -> Array:
        return _product(right, at, start, v)

    return Stiffness(_fastest(product, start), _present(product, start, model.nq))


def _product(right: Callable[[Array], Array], x: Array, start: Array, v: Array) -> Array:
    """J v by one difference; 0 for a vector that is 0."""
    largest = float(np.abs(v / np.maximum(np.abs(x), 1.0)).max(initial=0.0))
    if not 0 < largest < np.inf:
        return np.zeros_like(v)
    by = RELATIVE / largest
    change: Array = (right(x + by * v) - start) / by
    return change


def _fastest(product: Callable[[Array], Array], start: Array) -> float:
    """Spectral radius by a power iteration; pairs of eigenvalues show over two products."""
    v = np.random.default_rng(1).uniform(0.5, 1.0, len(start))
    growth = []
    for _ in range(PRODUCTS):
        before = float(np.linalg.norm(v))
        v = product(v / before) if before > 0 else v
        growth.append(float(np.linalg.norm(v)))
    late = growth[PRODUCTS // 2 :]
    if not all(0 < g < np.inf for g in late):
        return 0.0
    return float(np.exp(np.mean(np.log(late))))


def _present(product: Callable[[Array], Array], start: Array, nq: int) -> float:
    """Rate of the motion: of its second change against its first, by coordinates and speeds."""
    second = product(product(start))
    rates = [
        np.sqrt(np.linalg.norm(second[part]) / np.linalg.norm(start[part]))
        for part in (slice(0, nq), slice(nq, None))
        if np.linalg.norm(start[part]) > 0
    ]
    return float(max(rates, default=0.0))
