"""Modes of vibration as a record: frequencies, damping, shapes, pictures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import Count, checked
from ...arrays import Array, Booleans, Complex
from ...errors import ArgumentError, ModelError, near
from ...records import dataclass
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ..statics.static_path import MAX_PRINTED
from ..systems import dynamic_system_of
from ..systems.dynamic_system import Moment

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...runtime.models.loaded_model import LoadedModel
    from ...view.page import Page

FULL = 0.25  # of a shape that is played: of the size of the mechanism, or radians
ROUNDED = 1e-13  # damping ratios below this are none
PICTURES = 120  # per play
MOST_PERIODS = 1000  # of a play
AXES = ("about x", "about y", "about z", "x", "y", "z")
PRINTED_PART = 0.15  # entries below this part of the largest are not printed


@dataclass(frozen=True, repr=False, eq=False)
class ModesRecord:
    """Modes about a state, from the lowest frequency.

    Attributes:
        model: The model.
        at: The state they stand about.
        values: Eigenvalues (k,) [1/s]: decay, and angular frequency as imaginary part.
        shapes: Increments along the speeds (nu, k), of modal mass 1; complex where phases differ.
        increments, owners: Names of the increments, and joint or node of each.
        momentum: Momentum about the ground origin by speeds (6, nu), angular part first;
            (0, nu) of equations without bodies.
        size: Of the mechanism [m].
    """

    model: LoadedModel
    at: Moment
    values: Complex
    shapes: Any
    increments: tuple[str, ...]
    owners: tuple[str, ...]
    momentum: Array = field(repr=False)
    size: float

    def __len__(self) -> int:
        return len(self.values)

    @checked
    def __getitem__(self, k: int) -> Mode:
        """A single mode, at which a family of cycles may start."""
        number = self._number(k)
        return Mode(self, number if number >= 0 else number + len(self))

    @property
    def frequencies(self) -> Array:
        """Frequencies of the oscillations (k,) [Hz]; 0 for motions that do not oscillate."""
        return self.values.imag / (2 * np.pi)

    @property
    def angular(self) -> Array:
        """The same (k,) [rad/s]."""
        return np.asarray(self.values.imag)

    @property
    def damping(self) -> Array:
        """Damping ratios (k,): negative of what grows; NaN of rigid-body modes."""
        size = np.abs(self.values)
        ratio = np.divide(-self.values.real, size, out=np.full(len(size), np.nan), where=size > 0)
        return np.where(np.abs(ratio) < ROUNDED, 0.0, ratio)

    @property
    def rigid(self) -> Booleans:
        """Mask of the free motions (k,)."""
        return np.asarray(self.values == 0)

    @property
    def participation(self) -> Array:
        """Momentum of every mode at unit modal speed (6, k), angular part first.

        Its square is the effective mass that the mode lends a support shaken that way.
        """
        momenta: Array = self.momentum @ self.shapes
        return momenta

    @property
    def effective_mass(self) -> Array:
        """Effective modal inertia (6, k) [kg m^2, kg]: the sum over all modes is that of the system
        along what its joints allow."""
        return np.asarray(np.abs(self.participation) ** 2)

    @checked
    def shape(self, k: int) -> dict[str, complex]:
        """Shape of a mode by name: coordinates, or increments ``along`` speeds."""
        values = self.shapes[:, self._number(k)]
        return dict(zip(self.increments, values.tolist(), strict=True))

    @checked
    def twist(self, k: int, frame: str) -> Any:
        """Motion of a frame in a mode (6,): rotation, then displacement, in ground axes."""
        J = self.model.frame_jacobian(frame, self.at.q, t=self.at.t, r=self.at.r)
        return J @ self.shapes[:, self._number(k)]

    def _number(self, k: int) -> int:
        if not isinstance(k, int | np.integer) or not -len(self) <= k < len(self):
            numbers = [str(n) for n in range(len(self))]
            raise ModelError(f"there is no mode {k!r}.{near(k, numbers)}")
        return int(k)

    def __repr__(self) -> str:
        lines = [
            f"'{self.model.name}': {len(self)} mode{'s' if len(self) != 1 else ''}",
            "        frequency [Hz]  damping ratio  shape",
        ]
        for k in range(min(len(self), MAX_PRINTED)):
            ratio = "rigid" if self.rigid[k] else f"{self.damping[k]:.5g}"
            lines.append(
                f"  {k:>3} {self.frequencies[k]:>17.8g} {ratio:>14}  {self._shape_text(k)}"
            )
        lines += [f"  ... {len(self) - MAX_PRINTED} more"] if len(self) > MAX_PRINTED else []
        return "\n".join(lines)

    def _shape_text(self, k: int) -> str:
        """The largest entries of a shape."""
        shape = self.shapes[:, k]
        size = np.abs(shape)
        largest = [
            int(i) for i in np.argsort(-size)[:4] if size[i] >= PRINTED_PART * size.max() > 0
        ]
        entries = []
        for i in largest:
            # half a turn is one angle, and so is none
            angle = round(float(np.degrees(np.angle(shape[i])))) % 360
            phase = "" if np.isrealobj(shape) else f" at {angle - 360 * (angle > 180)} deg"
            value = shape[i] if np.isrealobj(shape) else size[i]
            entries.append(f"{self.increments[i]} {value:.3g}{phase}")
        return ", ".join(entries)


@dataclass(frozen=True, eq=False)
class Mode:
    """One of several modes.

    Attributes:
        modes: All of them.
        number: Which.
    """

    modes: ModesRecord
    number: int

    @property
    def shape(self) -> dict[str, complex]:
        """See :meth:`ModesRecord.shape`."""
        return self.modes.shape(self.number)

    def __repr__(self) -> str:
        frequency = self.modes.frequencies[self.number]
        return f"mode {self.number} of '{self.modes.model.name}', {frequency:.8g} Hz"


@checked
def plot(modes: ModesRecord, path: str | Path | None = None, count: Count = 6) -> Figure:
    """Shapes of the first modes over the numbers of their entries as a Matplotlib figure.

    Raises:
        ModelError: a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.plot import plot_over

    over = np.arange(len(modes.increments), dtype=np.float64)
    curves = {
        f"{modes.frequencies[k]:.5g} Hz": np.real(modes.shapes[:, k])
        for k in range(min(count, len(modes)))
    }
    return plot_over(f"modes of {modes.model.name}", "entry", over, curves, path)


@checked
def motion(
    modes: ModesRecord, k: int, amplitude: float | None = None, periods: float = 2.0
) -> TrajectoryRecord:
    """A mode as a motion, as large as is good to see, or by an amplitude.

    Args:
        k: Number of the mode, from 0.
        amplitude: Factor of the shape.
        periods: How often it is played; what does not oscillate takes a second.
    """
    if not 0 < periods <= MOST_PERIODS:
        raise ArgumentError(
            f"motion: periods={periods:g}: give a number above 0 and up to {MOST_PERIODS}"
        )
    if amplitude is not None and not math.isfinite(amplitude):
        raise ArgumentError(f"motion: amplitude={amplitude:g}: give a finite number")
    shape, system = modes.shapes[:, modes._number(k)], dynamic_system_of(modes.model)
    largest = float(np.abs(shape / system.columns).max(initial=0.0))
    factor = FULL / max(largest, 1e-300) if amplitude is None else float(amplitude)
    rate = float(modes.angular[k])
    phase = 2 * np.pi * periods * np.linspace(0, 1, int(PICTURES * periods) + 1)
    t = phase / (rate or 2 * np.pi)
    with np.errstate(over="ignore", invalid="ignore"):
        increments = factor * np.exp(1j * phase)[:, None] * shape
        q = np.array([system.integrate(modes.at.q, step) for step in np.real(increments)])
        u = np.real(1j * rate * increments)
    x = np.concatenate([q, u, np.tile(modes.at.z, (len(t), 1))], axis=1)
    if not np.isfinite(x).all():
        raise ArgumentError(
            f"motion: amplitude={factor:g}: states of that size overflow. Give a smaller number"
        )
    r = np.broadcast_to(modes.at.r, (len(t), len(modes.at.r)))
    description = f"mode {k} at {modes.frequencies[k]:.6g} Hz"
    return TrajectoryRecord.of_states(modes.model, t, x, r, description)


@checked
def animate(
    modes: ModesRecord,
    k: int,
    path: str | Path | None = None,
    *,
    amplitude: float | None = None,
    periods: float = 2.0,
    show: str | Sequence[str] | None = (),
    plots: str | Sequence[str] | None = (),
    meshes: str | float | bool = "auto",
    page: str = "3d",
) -> Page:
    """A page that plays a mode in any browser; see :meth:`motion` for amplitude and periods.

    Args:
        path, show, plots, meshes, page: As :meth:`.Trajectory.animate`. By default no histories,
            and no stress: a shape as large as one can see it stretches beams, small ones do not.
    """
    from ...view.page import animate

    title = f"{modes.model.name}, mode {k}: {modes.frequencies[modes._number(k)]:.6g} Hz"
    played = motion(modes, k, amplitude, periods)
    return animate(played, path, show=show, plots=plots, meshes=meshes, page=page, title=title)
