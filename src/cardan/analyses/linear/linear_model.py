"""A linear model with names."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import checked
from ...arrays import Array, Complex
from ...errors import ArgumentError, ModelError, counted, listed, near
from ...records import dataclass
from .first_order import Choice
from .second_order import SecondOrder, reduced
from .spectrum import Spectrum, spectrum

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RESTS = 1e-9  # accelerations below this are none
MAX_PRINTED = 10
POINTS = 600  # of a plot
ROUNDED = 1e-13  # real parts below this part of the modulus are printed as 0
DRIFTING = 1e-7  # real parts, over the largest modulus, that are rounding where none decays
CLOSED = 1e-9  # of what accelerates coordinates: parts that others have in it
SINGULAR = 1e13  # condition of the mobility of coordinates that depend on each other


@dataclass(frozen=True, repr=False, eq=False)
class LinearModelRecord:
    """x' = A x + B r, y = C x + D r: distances from a motion.

    Attributes:
        name: Of the model.
        A, B, C, D: (nx, nx), (nx, nr), (ny, nx), (ny, nr).
        states: Names of x: independent increments, independent speeds, internal states.
            ``along base.u.x`` is an increment along a speed that is not a rate of a coordinate.
        inputs, outputs: Names of r and y.
        n, z: Numbers of independent increments and of internal states.
        mass: M of the independent speeds (nv, nv).
        x: The state about which it stands (of the whole model).
        xdot: Rates of the states along the motion (nx,), the constant part of the model: speeds of
            the independent increments, accelerations, rates of internal states. Distances from
            the state itself, which stays where it is, obey x' = xdot + A x + B r where speeds are
            rates of coordinates; increments ``along`` others are seen in axes that move with the
            motion. NaN in files of earlier versions.
        acceleration: Largest acceleration there: 0 at equilibria and in steady motions.
        choice: Which increments and speeds are independent, as places of speeds.
        units: Of x (nx,): the size of the system for lengths, 1 else.
        along: Names of the increments along all speeds (nu,).
        increments: Increments along all speeds by x (nu, nx).
        speeds: Changes of all speeds by x (nu, nx).
        state_units, input_units, output_units: SI units of x, r and y; "" where none is stated.
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
    mass: Array = field(repr=False)
    x: Array = field(repr=False)
    xdot: Array = field(repr=False)
    acceleration: float
    choice: Choice = field(repr=False)
    units: Array = field(repr=False)
    along: tuple[str, ...] = field(repr=False)
    increments: Array = field(repr=False)
    speeds: Array = field(repr=False)
    state_units: tuple[str, ...] = field(repr=False)
    input_units: tuple[str, ...] = field(repr=False)
    output_units: tuple[str, ...] = field(repr=False)

    @cached_property
    def spectrum(self) -> Spectrum:
        """Eigenvalues of A with right and left vectors, and which of them are defective."""
        rate = max(float(np.abs(np.linalg.eigvals(self.A)).max(initial=0.0)), 1e-300)
        units = self.units.copy()
        units[self.n : len(units) - self.z] *= rate
        return spectrum(self.A, units)

    @property
    def eigenvalues(self) -> Complex:
        """Eigenvalues of A (nx,) [1/s], fastest growth first, of pairs the one above the axis
        first.
        """
        return self.spectrum.values

    @property
    def participation(self) -> Complex:
        """Share of every state in every eigenvalue (nx, nx): columns add up to 1.

        NaN where eigenvalues are defective: such motions have no shares.
        """
        return self.spectrum.right * self.spectrum.left.conj()

    @checked
    def shape(self, k: int) -> dict[str, complex]:
        """Right eigenvector of eigenvalue k by name, its largest entry 1."""
        return dict(zip(self.states, self.spectrum.right[:, self._number(k)].tolist(), strict=True))

    @checked
    def adjoint(self, k: int) -> dict[str, complex]:
        """Left eigenvector of eigenvalue k by name: how much a start there excites it.

        NaN where it is defective.
        """
        return dict(zip(self.states, self.spectrum.left[:, self._number(k)].tolist(), strict=True))

    def _number(self, k: int) -> int:
        count = len(self.states)
        if not isinstance(k, int | np.integer) or not -count <= k < count:
            raise ModelError(
                f"'{self.name}' has {counted(count, 'eigenvalue')}: there is no number {k!r}"
            )
        return int(k)

    @property
    def stable(self) -> bool:
        """True when no small motion grows exponentially."""
        return not self.spectrum.unstable.any()

    @property
    def drifts(self) -> bool:
        """True when some small motion grows with time, as one at constant speed does."""
        spectrum = self.spectrum
        return bool(
            np.any(spectrum.defective & (spectrum.values.real >= -DRIFTING * spectrum.size))
        )

    @property
    def M(self) -> Array:
        """Mass matrix (n, n) of M y'' + damping y' + K y = forces, y the independent increments.

        Raises:
            ModelError: rolling without slipping allows fewer speeds than positions; then
                :meth:`second_order` with the names of some.
        """
        return self._second.M

    @property
    def damping(self) -> Array:
        """Factor of y' (n, n): damping and gyroscopic forces; see :attr:`M`."""
        return self._second.damping

    @property
    def dissipative(self) -> Array:
        """Damping (n, n), symmetric; see :attr:`M`."""
        return self._second.dissipative

    @property
    def gyroscopic(self) -> Array:
        """Gyroscopic forces by y' (n, n), skew; see :attr:`M`."""
        return self._second.gyroscopic

    @property
    def K(self) -> Array:
        """Factor of y (n, n): stiffness and circulatory forces; see :attr:`M`."""
        return self._second.K

    @property
    def conservative(self) -> Array:
        """Stiffness (n, n), symmetric; see :attr:`M`."""
        return self._second.conservative

    @property
    def circulatory(self) -> Array:
        """Circulatory forces by y (n, n), skew; see :attr:`M`."""
        return self._second.circulatory

    @property
    def forces(self) -> Array:
        """Factor of the inputs (n, nr) in the equations of :attr:`M`."""
        return self._second.forces

    @cached_property
    def _second(self) -> SecondOrder:
        return self.second_order()

    @checked
    def second_order(self, coordinates: Iterable[str] | None = None) -> SecondOrder:
        """Equations of second order of some coordinates, if theirs are closed.

        Args:
            coordinates: Names of coordinates, or increments ``along`` speeds; all that are
                independent if left out. Those of a rolling wheel that others do not depend on
                are left out: ``["lean", "steer"]`` of a bicycle.

        Returns:
            M, damping, K and their parts. Forces along the coordinates belong to M.

        Raises:
            ModelError: unknown names; coordinates that depend on others, or on each other.
        """
        nv = len(self.states) - self.n - self.z
        if coordinates is None and list(self.choice[0]) != list(self.choice[1]):
            raise ModelError(
                f"'{self.name}' has {counted(self.n, 'position')} for {nv} speeds: rolling has no "
                "equations of second order of all. Name those that others do not change: "
                "second_order(['...']); or take A and B"
            )
        names = self.states[: self.n]
        if coordinates is not None:
            names = tuple(dict.fromkeys(listed("coordinates", coordinates, "steer")))
        if not names:
            raise ModelError("second_order: coordinates=: name at least one")
        places = self._along(names)
        rows = self.increments[places]
        by_y, by_rate, left = reduced(rows, self.A, self.z)
        # inverse mass of the named coordinates: J M^-1 J^T, singular where they are dependent
        reach = rows @ self.A[:, self.n : self.n + nv]
        lighter = reach @ np.linalg.solve(self.mass, self.speeds[places, self.n : self.n + nv].T)
        if np.linalg.cond(lighter) > SINGULAR:
            raise ModelError(f"second_order: {', '.join(names)} depend on each other; name fewer")
        self._closed(names, rows, left)
        M = np.linalg.inv(lighter)
        # M of the independent ones is known as it stands
        M = self.mass if coordinates is None else 0.5 * (M + M.T)
        rate = rows @ self.A
        inner = M @ left[:, len(self.A) - self.z :]
        return SecondOrder(self.name, names, M, -M @ by_rate, -M @ by_y, M @ (rate @ self.B), inner)

    def _along(self, names: tuple[str, ...]) -> list[int]:
        """Places of increments along speeds."""
        for name in names:
            if name not in self.along:
                raise ModelError(
                    f"second_order: there is no increment '{name}'.{near(name, self.along)}"
                )
        return [self.along.index(name) for name in names]

    def _closed(self, names: tuple[str, ...], rows: Array, left: Array) -> None:
        """Refuse coordinates whose equations others enter."""
        inside = len(self.A) - self.z
        total = np.abs(rows @ self.A @ self.A)[:, :inside]
        off = np.abs(left[:, :inside])
        if off.max(initial=0.0) > CLOSED * max(float(total.max(initial=0.0)), 1e-300):
            row, column = np.unravel_index(int(off.argmax()), off.shape)
            raise ModelError(
                f"second_order: '{names[row]}' depends on '{self.states[column]}' too: its "
                "equations are not closed. Name more coordinates, or take A and B"
            )

    @checked
    def frequency_response(self, omega: ArrayLike) -> Complex:
        """y by r at angular frequencies (...) [rad/s]: (..., ny, nr)."""
        s = 1j * np.asarray(omega, dtype=np.float64)[..., None, None]
        inner = np.linalg.solve(s * np.eye(len(self.A)) - self.A, self.B.astype(np.complex128))
        return np.asarray(self.C @ inner + self.D)

    def _around(self) -> Array:
        """Angular frequencies a decade around what moves (n,)."""
        sizes = np.abs(self.eigenvalues)
        moving = sizes[sizes > DRIFTING * sizes.max(initial=0.0)]
        low, high = (float(moving.min()), float(moving.max())) if len(moving) else (1.0, 1.0)
        return np.geomspace(low / 10, high * 10, POINTS)

    def to_control(self) -> ForControl:
        """The same as ``control.StateSpace`` of python-control, with its names.

        python-control takes no dots in names: ``base.px`` becomes ``base_px``, blanks become
        underscores too, and names that would be equal then get a number behind.

        Returns:
            ``system, names = linear.to_control()``: the system, and its names by those of cardan.

        Raises:
            ModuleNotFoundError: python-control is not installed (extra ``control``).
            ModelError: a system with one output and no input, which python-control does not take.
        """
        try:
            from control import StateSpace
        except ModuleNotFoundError as missing:
            raise ModuleNotFoundError(
                "to_control needs python-control: pip install 'cardan[control]'"
            ) from missing
        if not self.inputs and len(self.outputs) == 1:
            raise ModelError(
                "to_control: python-control takes no system with one output and no input. Add an "
                "input to the scene, or name more outputs"
            )
        rows = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        # what is a state and an output has one name in both
        new_names = _plain(tuple(dict.fromkeys(name for names in rows.values() for name in names)))
        title = _plain((self.name,))[self.name]
        signals = {sort: [new_names[name] for name in names] for sort, names in rows.items()}
        system = StateSpace(self.A, self.B, self.C, self.D, name=title, **signals)
        return ForControl(system, new_names)

    def __repr__(self) -> str:
        about = "an equilibrium or steady motion"
        if self.acceleration > RESTS:
            about = f"a motion that accelerates by {self.acceleration:.3g}, at this instant"
        kind = "no small motion grows" if self.stable else "unstable"
        kind += ", but some drift" if self.stable and self.drifts else ""
        lines = [
            f"'{self.name}' linearized about {about}: {kind}",
            f"  states  {_listed(self.states)}",
            f"  inputs  {_listed(self.inputs)}",
            f"  outputs {_listed(self.outputs)}",
            "  eigenvalue [1/s]               frequency [Hz]   damping ratio",
        ]
        printed = [v for v in self.eigenvalues if v.imag >= 0][:MAX_PRINTED]
        for value in printed:
            size = abs(value)
            value = complex(0.0 if abs(value.real) < ROUNDED * size else value.real, value.imag)
            ratio = f"{0.0 - value.real / size:14.5g}" if size > 0 else f"{'-':>14}"
            text = f"{value.real:.6g}"
            text += f" +- {value.imag:.6g} i" if value.imag > 0 else ""
            lines.append(f"  {text:<30} {value.imag / (2 * np.pi):14.6g} {ratio}")
        hidden = sum(v.imag >= 0 for v in self.eigenvalues) - len(printed)
        lines += [f"  ... {hidden} more"] if hidden else []
        return "\n".join(lines)


class ForControl(NamedTuple):
    """A system of python-control, and its names by those of cardan."""

    system: Any
    names: dict[str, str]


def _plain(names: tuple[str, ...]) -> dict[str, str]:
    """Names without dots and blanks, each another one."""
    plain_names: dict[str, str] = {}
    for name in names:
        bare = plain = re.sub(r"[.\s]", "_", name)
        count = 1
        while plain in plain_names.values():
            count += 1
            plain = f"{bare}_{count}"
        plain_names[name] = plain
    return plain_names


def _listed(names: tuple[str, ...]) -> str:
    more = ", ..." if len(names) > MAX_PRINTED else ""
    return (", ".join(names[:MAX_PRINTED]) or "none") + more


@checked
def plot(
    linear_model: LinearModelRecord,
    path: str | Path | None = None,
    omega: ArrayLike | None = None,
    inputs: Iterable[str] | None = None,
    outputs: Iterable[str] | None = None,
) -> Figure:
    """Sizes and phases of the frequency response (Bode) as a Matplotlib figure.

    Args:
        path: Picture file, or None.
        omega: Angular frequencies (n,) [rad/s]; a decade around the eigenvalues if left out.
        inputs, outputs: Of which; all if left out.

    Raises:
        ModelError: unknown names, nothing to draw, or a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.loci import plot_response

    chosen = [
        list(declared) if names is None else listed(word, names, declared[0] if declared else "tip")
        for word, names, declared in (
            ("inputs", inputs, linear_model.inputs),
            ("outputs", outputs, linear_model.outputs),
        )
    ]
    both = (("inputs", linear_model.inputs), ("outputs", linear_model.outputs))
    for names, (word, declared) in zip(chosen, both, strict=True):
        missing = next((name for name in names if name not in declared), None)
        if missing is not None or not names:
            name = missing or ""
            raise ModelError(
                f"plot: {word}: no such {word.removesuffix('s')}: '{name}'.{near(name, declared)}"
            )
    over = linear_model._around() if omega is None else np.asarray(omega, dtype=np.float64)
    if over.ndim != 1 or not len(over):
        raise ArgumentError(
            f"plot: omega has the shape {over.shape}; give a row of angular frequencies [rad/s]"
        )
    response = linear_model.frequency_response(over)
    # one curve for each pair of output and input
    curves = {
        f"{y} by {r}": response[:, linear_model.outputs.index(y), linear_model.inputs.index(r)]
        for y in chosen[1]
        for r in chosen[0]
    }
    return plot_response(linear_model.name, over, curves, path)
