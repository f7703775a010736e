"""Linear models along a motion: A, B, C and D over time, and what a small motion grows by.

Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13;
S. Blanes, F. Casas, J. A. Oteo, J. Ros, Physics Reports 470 (2009), section 5, for exponentials.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import ArrayLike

from ...arrays import Array, Complex
from ...errors import DerivationError, SolveError
from ...records import dataclass
from .reference_input import Placeholder

if TYPE_CHECKING:
    from ..record import EquationRecord
    from .record import Linearized

# of changes of speeds by independent ones: beyond, others must be chosen
LARGEST = 1e4
HALVINGS = 12
# Gauss's three points in an interval, and the order of the method on them
GAUSS = 0.5 + np.array([-1.0, 0.0, 1.0]) * np.sqrt(15) / 10
ORDER = 6


@final
@dataclass(frozen=True, repr=False, eq=False)
class LinearizedAlong:
    """x' = A(t) x + B(t) r, y = C(t) x + D(t) r: distances from a motion.

    Attributes:
        name: Of the model.
        t: Times (nt,) [s].
        A, B, C, D: (nt, nx, nx), (nt, nx, nr), (nt, ny, nx), (nt, ny, nr).
        states, inputs, outputs: Names of x, r and y.
    """

    name: str
    t: Array
    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    _interpolant: Callable[[Array], Array] = field(repr=False)

    def transition(self, rtol: float = 1e-9) -> Array:
        """Transition matrix of small motions: x(t) = transition x(t[0]), (nt, nx, nx).

        Raises:
            SolveError: A changes too fast between the times.
        """
        parts, last = 1, self._stepped(1)
        for _ in range(HALVINGS):
            parts *= 2
            refined = self._stepped(parts)
            gap = np.abs(refined - last).max(initial=0.0)
            if gap <= 2**ORDER * rtol * np.abs(refined).max(initial=0.0):
                return np.asarray(refined + (refined - last) / (2**ORDER - 1))
            last = refined
        raise SolveError(
            f"'{self.name}': small motions are not found to {rtol:g}: A changes too fast between "
            "the times of the motion. Give it at more times"
        )

    def _stepped(self, parts: int) -> Array:
        """Products of exponentials over every interval, cut in equal parts."""
        from scipy.linalg import expm

        shares = np.arange(parts) / parts
        step = np.diff(self.t) / parts
        starts = self.t[:-1, None] + np.diff(self.t)[:, None] * shares
        times = starts[..., None] + step[:, None, None] * GAUSS
        A = self._interpolant(times.ravel()).reshape(*times.shape, *self.A.shape[1:])
        exponent = _exponent(step[:, None, None, None], A[:, :, 0], A[:, :, 1], A[:, :, 2])
        products = [np.eye(self.A.shape[1])]
        for factors in expm(exponent):
            total = products[-1]
            for factor in factors:
                total = factor @ total
            products.append(total)
        return np.array(products)

    @property
    def multipliers(self) -> Complex:
        """Floquet multipliers (nx,) of a motion over one period, the largest first.

        Small motions grow by them from period to period; beyond 1 in size they are unstable.
        """
        values = np.linalg.eigvals(self.transition()[-1]).astype(np.complex128)
        return np.asarray(values[np.lexsort((-values.imag, -np.abs(values)))])

    def __repr__(self) -> str:
        span = f"{self.t[0]:g} to {self.t[-1]:g} s" if len(self.t) else "no time"
        lines = [f"'{self.name}' linearized along a motion, {len(self.t)} times, {span}"]
        for word in ("states", "inputs", "outputs"):
            lines.append(f"  {word:8}{', '.join(getattr(self, word)) or 'none'}")
        return "\n".join(lines)


def _exponent(h: Array, first: Array, middle: Array, last: Array) -> Array:
    """Magnus's exponent of order 6 over steps h from A at Gauss's points."""

    def bracket(a: Array, b: Array) -> Array:
        return a @ b - b @ a

    one, two = h * middle, np.sqrt(15) / 3 * h * (last - first)
    three = 10 / 3 * h * (last - 2 * middle + first)
    inner = bracket(one, two)
    outer = -bracket(one, 2 * three + inner) / 60
    return one + three / 12 + bracket(-20 * one - three + inner, two + outer) / 240


def over(linear: Linearized, t: ArrayLike, values: dict[str, Any]) -> LinearizedAlong:
    """A :class:`Linearized` at times."""
    times = np.atleast_1d(np.asarray(t, dtype=np.float64))

    def numbers(at: Array) -> dict[str, Array]:
        matrices = linear.at({**values, "t": at})
        return {name: np.broadcast_to(x, (len(at), *x.shape[-2:])) for name, x in matrices.items()}

    return _record(linear, times, numbers(times), lambda at: numbers(at)["A"])


def _record(
    linear: Linearized, t: Array, matrices: dict[str, Array], interpolant: Callable[[Array], Array]
) -> LinearizedAlong:
    A, B, C, D = (matrices[name].copy() for name in "ABCD")
    names = linear.states, linear.inputs, linear.outputs
    return LinearizedAlong(linear.name, t, A, B, C, D, *names, interpolant)


def along(
    equations: EquationRecord,
    motion: Any,
    inputs: Iterable[str] | None,
    outputs: Iterable[str] | None,
    independent: Iterable[str] | None,
) -> LinearizedAlong:
    """Linear models along a motion; see :meth:`cardan.api.equations.Equations.linearize_along`."""
    from .linear import linearized

    _check_motion(equations, motion)
    blocks = {letter: np.asarray(getattr(motion, letter)) for letter in "quzr"}
    start = {
        letter: {
            name: Placeholder(f"{name}(t)", float(x))
            for name, x in zip(equations.blocks[letter].entries, table[0], strict=True)
        }
        for letter, table in blocks.items()
    }
    modes = dict(zip(equations.blocks["s"].entries, np.asarray(motion.s)[0].tolist(), strict=True))
    linear = linearized(
        equations, {**start, "s": modes, "udot": "free", "t": None}, None, inputs, outputs,
        independent, "from_start",
    )  # fmt: skip
    parameters = dict(motion.model.parameters) if motion.model is not None else {}

    def numbers(table: dict[str, Array], times: Array) -> dict[str, Array]:
        values = {
            f"{name}(t)": table[letter][:, k]
            for letter in "quzr"
            for k, name in enumerate(equations.blocks[letter].entries)
        }
        matrices_at = linear.at({**parameters, **values, "t": times})
        return {
            name: np.broadcast_to(x, (len(times), *x.shape[-2:])) for name, x in matrices_at.items()
        }

    matrices = numbers(blocks, motion.t)
    _judge(linear, matrices["A"])
    return _record(
        linear, motion.t, matrices, _dense(motion, numbers) or _spline(motion.t, matrices["A"])
    )


def _check_motion(equations: EquationRecord, motion: Any) -> None:
    """The motion must be one of this system, in one mode."""
    shape = (len(equations.coordinates), len(equations.speeds))
    if (motion.q.shape[1], motion.u.shape[1]) != shape:
        raise DerivationError(
            f"linearize_along: the motion has {motion.q.shape[1]} coordinates and "
            f"{motion.u.shape[1]} speeds, the equations have {shape[0]} and {shape[1]}"
        )
    s = np.asarray(motion.s)
    if s.size and np.any(s != s[0]):
        raise DerivationError(
            "linearize_along: modes change along the motion, and small motions jump there: give "
            "the part between two events"
        )


def _judge(linear: Linearized, A: Array) -> None:
    """Independent ones must stay so."""
    if not np.isfinite(A).all() or np.abs(A).max(initial=0.0) > LARGEST * (
        1.0 + float(np.median(np.abs(A).max(axis=(1, 2))))
    ):
        names = ", ".join(linear.coordinates)
        raise DerivationError(
            f"linearize_along: {names} are not independent all along the motion: name others by "
            "independent=, or give a part of it"
        )


def _dense(motion: Any, numbers: Any) -> Callable[[Array], Array] | None:
    """A between the times of a run that knows its states there."""
    if motion.dense is None or (motion.r.size and motion.inputs_at is None):
        return None

    def interpolant(times: Array) -> Array:
        x = motion.at(times)
        nq, nu = motion.nq, motion.u.shape[1]
        r = motion.inputs_at(times) if motion.r.size else np.zeros((len(times), 0))
        table = {"q": x[:, :nq], "u": x[:, nq : nq + nu], "z": x[:, nq + nu :], "r": r}
        A_at: Array = numbers(table, times)["A"]
        return A_at

    return interpolant


def _spline(t: Array, A: Array) -> Callable[[Array], Array]:
    from scipy.interpolate import CubicSpline

    return CubicSpline(t, A) if len(t) > 1 else lambda times: np.repeat(A, len(times), axis=0)
