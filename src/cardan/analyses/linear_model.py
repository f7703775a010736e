"""A linear model with names."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ModelError

Array = NDArray[np.float64]
RESTS = 1e-9  # accelerations below this are none
SHOWN = 10
ROUNDED = 1e-13  # real parts below this part of the modulus are printed as 0
GROWING = 1e-7  # real parts, over the largest modulus, that are more than rounding


@final
@dataclass(frozen=True, repr=False, eq=False)
class LinearModel:
    """x' = A x + B r, y = C x + D r: distances from a motion.

    Attributes:
        name: Of the model.
        A, B, C, D: (nx, nx), (nx, nr), (ny, nx), (ny, nr).
        states: Names of x: independent increments, independent speeds, internal states.
            ``along base.u.x`` is an increment along a speed that is no rate of a coordinate.
        inputs, outputs: Names of r and y.
        n: Number of independent increments.
        z: Number of internal states.
        mass: M of the independent increments, see :attr:`M`.
        x: The state about which it stands (of the whole model).
        acceleration: Largest acceleration there: 0 at equilibria and in steady motions.
        increments: Increments along all speeds by x (nu, nx).
    """

    name: str
    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    n: int
    z: int
    mass: Array | None = field(repr=False)
    x: Array = field(repr=False)
    acceleration: float
    increments: Array = field(repr=False)

    @cached_property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """Of A (nx,) [1/s], those that grow fastest first, of pairs that above the axis first."""
        values = np.linalg.eigvals(self.A).astype(np.complex128)
        size = max(float(np.abs(values).max(initial=0.0)), 1e-300)
        order = np.lexsort((-values.imag, np.abs(values.imag), -np.round(values.real / size, 9)))
        return np.asarray(values[order])

    @property
    def stable(self) -> bool:
        """Whether no small motion grows exponentially."""
        values = self.eigenvalues
        size = float(np.abs(values).max(initial=0.0))
        return bool(values.real.max(initial=0.0) <= GROWING * size)

    @property
    def M(self) -> Array:
        """Mass matrix (n, n) of M y'' + damping y' + K y = forces, y the independent increments.

        Raises:
            ModelError: rolling without slipping allows fewer speeds than positions.
        """
        return self._second[0]

    @property
    def damping(self) -> Array:
        """What multiplies y' (n, n): damping and gyroscopic forces; see :attr:`M`."""
        return self._second[1]

    @property
    def K(self) -> Array:
        """Stiffness (n, n); see :attr:`M`."""
        return self._second[2]

    @property
    def forces(self) -> Array:
        """What multiplies the inputs (n, nr) in the equations of :attr:`M`."""
        return self._second[0] @ self.B[self.n : 2 * self.n]

    @cached_property
    def _second(self) -> tuple[Array, Array, Array]:
        """M, damping and K: y' = A11 y + w, w' = A21 y + A22 w."""
        if self.mass is None:
            raise ModelError(
                f"'{self.name}' has {self.n} positions for {len(self.states) - self.n - self.z} "
                "speeds: rolling has no equations of second order alone. Take A and B"
            )
        n, M = self.n, self.mass
        turn, stiff, damp = self.A[:n, :n], self.A[n : 2 * n, :n], self.A[n : 2 * n, n : 2 * n]
        return M, -M @ (turn + damp), -M @ (stiff - damp @ turn)

    def frequency_response(self, omega: ArrayLike) -> NDArray[np.complex128]:
        """y by r at angular frequencies (...) [rad/s]: (..., ny, nr)."""
        s = 1j * np.asarray(omega, dtype=np.float64)[..., None, None]
        inner = np.linalg.solve(s * np.eye(len(self.A)) - self.A, self.B.astype(np.complex128))
        return np.asarray(self.C @ inner + self.D)

    def to_control(self) -> Any:
        """The same as ``control.StateSpace`` with names.

        Raises:
            ModuleNotFoundError: python-control is not installed.
        """
        try:
            from control import StateSpace
        except ModuleNotFoundError as missing:
            raise ModuleNotFoundError(
                "to_control needs python-control: pip install control"
            ) from missing
        names = {
            "states": list(self.states),
            "inputs": list(self.inputs),
            "outputs": list(self.outputs),
        }
        return StateSpace(self.A, self.B, self.C, self.D, name=self.name, **names)

    def __repr__(self) -> str:
        about = "an equilibrium or steady motion"
        if self.acceleration > RESTS:
            about = f"a motion that accelerates by {self.acceleration:.3g}, at this instant"
        kind = "no small motion grows" if self.stable else "unstable"
        lines = [
            f"'{self.name}' linearized about {about}: {kind}",
            f"  states  {_listed(self.states)}",
            f"  inputs  {_listed(self.inputs)}",
            f"  outputs {_listed(self.outputs)}",
            "  eigenvalue [1/s]               frequency [Hz]   damping ratio",
        ]
        shown = [v for v in self.eigenvalues if v.imag >= 0][:SHOWN]
        for value in shown:
            size = abs(value)
            value = complex(0.0 if abs(value.real) < ROUNDED * size else value.real, value.imag)
            ratio = f"{0.0 - value.real / size:14.5g}" if size > 0 else f"{'-':>14}"
            text = f"{value.real:.6g}"
            text += f" +- {value.imag:.6g} i" if value.imag > 0 else ""
            lines.append(f"  {text:<30} {value.imag / (2 * np.pi):14.6g} {ratio}")
        rest = sum(v.imag >= 0 for v in self.eigenvalues) - len(shown)
        lines += [f"  ... {rest} more"] if rest else []
        return "\n".join(lines)


def _listed(names: tuple[str, ...]) -> str:
    more = ", ..." if len(names) > SHOWN else ""
    return (", ".join(names[:SHOWN]) or "none") + more
