"""Inverse dynamics along motions: forces and powers by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import Count, checked
from ...arrays import Array
from ...errors import ArgumentError, counted, near
from ...records import dataclass
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...schema.blocks import of_rate
from ..mechanisms.actuation import actuation, named_speeds
from .base_parameters import circuits
from .data import Data, columns, measured, named_columns, write

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...runtime.models.loaded_model import LoadedModel

UNITS = {"rad/s": "N m", "m/s": "N"}


@dataclass(frozen=True, repr=False, eq=False)
class TorquesRecord:
    """Forces of actuators along a motion: M udot + h = f + tau + Gᵀ lam.

    ``torques["elbow"]`` is the history (nt,) of one.

    Attributes:
        model: Whose forces they are.
        t: Times (nt,) [s].
        q, u, udot: The motion (nt, nq), (nt, nu), (nt, nu).
        actuators: Names of the speeds along which actuators act (na,).
        units: Of their forces (na,).
        forces: (nt, na).
        unique: Whether no other forces of these actuators make the motion.
    """

    model: LoadedModel
    t: Array
    q: Array
    u: Array
    udot: Array
    actuators: tuple[str, ...]
    units: tuple[str, ...]
    forces: Array
    unique: bool

    def _place(self, name: str) -> int:
        names = [*self.actuators, *(of_rate(a) for a in self.actuators)]
        if name not in names:
            raise ArgumentError(f"'{name}' is not an actuator here.{near(name, names)}")
        return names.index(name) % len(self.actuators)

    def __getitem__(self, name: str) -> Array:
        """Force of one actuator (nt,) [N m], [N].

        Raises:
            ArgumentError: there is none of that name.
        """
        return np.asarray(self.forces[:, self._place(name)])

    @property
    def tau(self) -> Array:
        """Generalized forces (nt, nu) as ``forward_dynamics(tau=)`` takes them."""
        tau = np.zeros_like(self.u)
        tau[:, named_speeds(self.model, self.actuators)] = self.forces
        return tau

    @property
    def power(self) -> Array:
        """Power that every actuator supplies (nt, na) [W]."""
        return np.asarray(self.forces * self.u[:, named_speeds(self.model, self.actuators)])

    @property
    def work(self) -> Array:
        """Work that every actuator has supplied over the motion (na,) [J]."""
        from scipy.integrate import trapezoid

        return np.asarray(trapezoid(self.power, self.t, axis=0))

    @property
    def peak(self) -> Array:
        """Largest size of every force (na,)."""
        return np.asarray(np.abs(self.forces).max(axis=0, initial=0.0))

    @property
    def rms(self) -> Array:
        """Root mean square of every force over the samples (na,)."""
        return np.asarray(np.sqrt(np.mean(self.forces**2, axis=0)))

    def table(self) -> dict[str, Array]:
        """``t``, then ``elbow``, ``elbow.u``, ``elbow.udot``, ``elbow.tau`` as data has them."""
        blocks = {"q": self.q, "u": self.u, "udot": self.udot, "tau": self.tau}
        return named_columns(self.model, self.t, blocks)

    @checked
    def save(self, path: str | Path) -> Path:
        """Write the table as comma-separated values. Returns the path."""
        return write(Path(path), self.table())

    def __repr__(self) -> str:
        first, last = (self.t[0], self.t[-1]) if len(self.t) else (0.0, 0.0)
        span = f"{counted(len(self.t), 'sample')}, {first:g} ... {last:g} s"
        lines = [f"'{self.model.name}': forces along {span}"]
        width = max((len(name) for name in self.actuators), default=0)
        most = np.abs(self.power).max(axis=0, initial=0.0)
        for name, unit, peak, rms, power in zip(
            self.actuators, self.units, self.peak, self.rms, most, strict=True
        ):
            lines.append(
                f"  {name:{width}}  to {peak:10.4g} {unit:3}  rms {rms:10.4g}   to {power:10.4g} W"
            )
        if not self.unique:
            lines.append("  more actuators than freedoms: the forces of least norm")
        return "\n".join(lines)


@checked
def torques(
    model: LoadedModel,
    motion: Any,
    *,
    actuators: Sequence[str] | None = None,
    norm: Any = "minimum",
    inputs: Mapping[str, float] | None = None,
    cutoff: float | None = None,
    period: float | None = None,
    harmonics: Count = 5,
) -> TorquesRecord:
    """Forces that make a motion, beside those that the model's own elements supply.

    Args:
        model: With or without loops; other parameters than those of the motion may be its own.
        motion: A Trajectory; or a mapping with ``t`` (nt,) and ``q`` (nt, nq), or a coordinate by
            name, ``{"t": t, "elbow": values}``: an array (nt,), or a spline or table, which is
            called with the times. ``u`` and ``udot`` are found by differentiation where they are
            missing, and from the equations of motion where a run knows them. Of a mechanism with
            loops the motion must keep them closed, as runs and :meth:`sweep` do.
        actuators: Joints or speeds along which they act; by default every speed.
        norm: Where loops leave a choice: ``"minimum"`` or weights, as for ``actuation``.
        inputs: Values of inputs in place of those of the motion: ``{"motor": 0}`` asks what it
            takes without the motor.
        cutoff, period, harmonics: How positions are smoothed; see
            :func:`.identification.data.measured`. A filter leaves out samples at either end; all
            others keep the times given.

    Raises:
        ArgumentError: names or shapes that do not fit.
        SolveError: the constraints do not allow the motion, or the actuators cannot make it.
    """
    data = _motion(model, motion, cutoff, period, harmonics)
    r = data.r.copy()
    for name, value in (inputs or {}).items():
        if name not in model.inputs:
            raise ArgumentError(f"torques: there is no input '{name}'.{near(name, model.inputs)}")
        r[:, model.inputs.index(name)] = value
    arguments: dict[str, Any] = {"t": data.t, "r": r if model.nr else None}
    chosen = named_speeds(model, actuators)
    # loops or passive joints: constraint forces share the load with the actuators
    if circuits(model) or len(chosen) < model.nu:
        shares = actuation(
            model,
            data.q,
            data.u,
            data.udot,
            [model.speeds[k] for k in chosen],
            norm=norm,
            **arguments,
        )
        forces, unique = shares.forces, bool(np.all(shares.unique))
    else:
        z = data.z if model.nz else None
        forces = model.inverse_dynamics(data.q, data.u, data.udot, z=z, **arguments)
        unique = True
    units = [UNITS.get(row.unit, "") for row in model.manifest.speeds]
    return TorquesRecord(
        model,
        data.t,
        data.q,
        data.u,
        data.udot,
        tuple(model.speeds[k] for k in chosen),
        tuple(units[k] for k in chosen),
        forces,
        unique,
    )


def _motion(
    model: LoadedModel, motion: Any, cutoff: float | None, period: float | None, harmonics: int
) -> Data:
    """The samples, with accelerations by the equations of motion where a run has its model."""
    smooth: dict[str, Any] = {"cutoff": cutoff, "period": period, "harmonics": harmonics}
    if isinstance(motion, TrajectoryRecord):
        if motion.model is None or cutoff is not None or period is not None:
            return measured(model, motion, ends=True, **smooth)
        arguments: dict[str, Any] = {"t": motion.t, "r": motion.r if motion.r.shape[1] else None}
        udot = motion.model.forward_dynamics(
            motion.q, motion.u, z=motion.z, s=motion.s, **arguments
        )
        nothing = np.zeros_like(motion.u)
        return Data(motion.t, motion.q, motion.u, udot, nothing, motion.r, motion.z)
    if hasattr(motion, "keys") and "t" in motion:
        t = np.asarray(motion["t"], dtype=float)
        coordinates = {*columns(model)["q"]}
        motion = {key: _values(motion[key], t, key in coordinates) for key in motion.keys()}  # noqa: SIM118
    return measured(model, motion, ends=True, **smooth)


def _values(samples: object, t: Array, coordinate: bool) -> Any:
    """Samples of a coordinate that may be a spline or table."""
    if coordinate and callable(samples):
        return np.asarray(samples(t), dtype=float)
    return samples


@checked
def torques_of_run(
    motion: TrajectoryRecord,
    *,
    actuators: Sequence[str] | None = None,
    norm: Any = "minimum",
    inputs: Mapping[str, float] | None = None,
    cutoff: float | None = None,
    period: float | None = None,
    harmonics: Count = 5,
) -> TorquesRecord:
    """Forces that actuators add to make this motion, as :meth:`CompiledModel.torques` has them."""
    return torques(
        motion._model("torques"), motion, actuators=actuators, norm=norm, inputs=inputs,
        cutoff=cutoff, period=period, harmonics=harmonics,
    )  # fmt: skip


@checked
def plot(torques: TorquesRecord, path: str | Path | None = None) -> Figure:
    """Forces and powers as a Matplotlib figure, written to ``path`` if given."""
    from ...view.plot import plot_over

    curves = {"force [N m, N]": torques.forces, "power [W]": torques.power}
    return plot_over(f"forces of {torques.model.name}", "t [s]", torques.t, curves, path)
