"""Campbell diagrams: frequencies of a rotor over its speed, which way they whirl, critical speeds.

A motion whirls forward where points go round as the rotor turns: of a complex displacement d with
components x, y across the axis, |x + i y| is the part that goes forward and |x - i y| that which
goes backward. Displacements and tilts of the bodies that spin count. Where coordinates turn along
with the rotor, a forward whirl at w is one at speed + w seen from the ground, a backward one at
speed - w: forward where that is positive. What does not go round, such as the vibration of a blade,
has no one frequency there: it keeps that of the axes that turn along.

Source: G. Genta, Dynamics of Rotating Systems (2005), chapters 1 and 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from ...arguments import Count, LockedValues, checked
from ...arrays import Array
from ...errors import ModelError, SolveWarning, brief, warn
from ...records import dataclass
from .family import Member, family
from .root_locus import END, LocusRecord, locus

Complex = NDArray[np.complex128]
OSCILLATES = 1e-6  # of the largest modulus: imaginary parts of what does
SYNCHRONOUS = 1e-7  # of the largest speed: frequencies this near to a line lie on it
ROUND = 0.1  # whirl of motions that go round
MAX_PRINTED = 8


@dataclass(frozen=True, repr=False, eq=False)
class CampbellRecord:
    """Frequencies of a rotor over its speed.

    Attributes:
        locus: The eigenvalues behind it.
        speed: Of the rotor (n,) [rad/s]; its name is ``label``.
        label: As it was given.
        corotating: Whether coordinates turn along; frequencies are as seen from the ground.
        frequencies: (n, k) [rad/s], a column for every motion; NaN where it does not oscillate.
        whirl: As seen from there (n, k): from -1, backward, over 0, along a line, to 1, forward.
    """

    locus: LocusRecord
    speed: Array
    label: str
    corotating: bool
    frequencies: Array
    whirl: Array
    columns: NDArray[np.intp] = field(repr=False)

    @property
    def values(self) -> Complex:
        """Eigenvalues (n, k) [1/s] of the columns, in the axes of the coordinates."""
        return np.asarray(self.locus.eigenvalues[:, self.columns])

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Mask of the speeds at which no small motion grows exponentially (n,)."""
        return self.locus.stable

    @checked
    def critical(self, order: int = 1) -> list[float]:
        """Speeds at which a frequency is a multiple of the speed, in their order.

        Args:
            order: The multiple: 1 for unbalance.

        Raises:
            ModelError: it is not a whole number above 0.
        """
        if not isinstance(order, int | np.integer) or order < 1:
            raise ModelError(f"critical({brief(order)}): a multiple of the speed, 1, 2, ...")
        speeds = list[float]()
        off = self.frequencies - order * np.abs(self.speed)[:, None]
        # a motion that keeps to the line, as turns of the whole do in axes at rest, is not a
        # crossing
        nonzero = np.abs(off) > SYNCHRONOUS * order * np.abs(self.speed).max()
        for k in range(off.shape[1]):
            for i in np.flatnonzero(
                (off[:-1, k] * off[1:, k] <= 0) & (nonzero[:-1, k] | nonzero[1:, k])
            ):
                # both at the end and at the next begin it is one
                if off[i, k] == 0 and (i > 0 or self.speed[i] == 0):
                    continue
                speeds.append(self._crossing(int(i), k, int(order)))
        return sorted(speeds)

    def _crossing(self, i: int, k: int, order: int) -> float:
        """A critical speed between two rows."""
        members = self.locus.family
        low, high = (self.locus.members[j].s for j in (i, i + 1))

        def off(s: float) -> float:
            # the motion is the one next to the line between the rows
            share = (s - low) / (high - low)
            value = (1 - share) * self.values[i, k] + share * self.values[i + 1, k]
            member = members.at(s, self.locus.members[i])
            speed = members.values_at(s)[self.label]
            return _frequency_and_whirl(self, member, _place(member, value), speed)[
                0
            ] - order * abs(speed)

        s = brentq(off, low, high, xtol=1e-14, rtol=1e-14)
        return members.values_at(float(s))[self.label]

    @cached_property
    def rotor(self) -> tuple[Array, tuple[str, ...]]:
        """The axis (3,) in ground axes, and the bodies that turn about it, at the fastest row."""
        return _rotor(self.locus.members[int(np.abs(self.speed).argmax())])

    def __repr__(self) -> str:
        first, last = self.speed[0] + 0.0, self.speed[-1]
        lines = [
            f"'{self.locus.name}', {self.label} = {first:.6g} ... {last:.6g} rad/s: "
            f"{len(self.speed)} linear models, {self.locus.message}",
            "  frequencies [rad/s] at the ends; whirl at the last (1 forward, -1 backward)",
        ]
        for k in range(min(MAX_PRINTED, self.frequencies.shape[1])):
            ends = "".join(f"{f:14.6g}" for f in self.frequencies[[0, -1], k])
            lines.append(f"  {ends}{self.whirl[-1, k]:9.2f}")
        more = self.frequencies.shape[1] - MAX_PRINTED
        lines += [f"  ... {more} more"] if more > 0 else []
        critical = ", ".join(f"{speed:.9g}" for speed in self.critical())
        lines.append(f"  critical speeds: {critical or 'none'}")
        for change in self.locus.changes:
            word = "begins" if change.lost else "ends"
            lines.append(f"  {change.kind} {word} at {change.values[self.label]:.9g}")
        return "\n".join(lines)


@checked
def campbell(
    model: Any,
    swept: Mapping[str, object] | None = None,
    *,
    count: Count | None = None,
    corotating: bool | None = None,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, object] | None = None,
    locked: LockedValues | None = None,
    targets: Mapping[str, object] | None = None,
    free: Iterable[str] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    check: bool = False,
    **named: Any,
) -> CampbellRecord:
    """Frequencies of a rotor over its speed: ``model.campbell(spin=(0, 300))``.

    Args:
        model: The compiled model.
        swept, named: Joint, parameter or input that is the speed -> (start, end) or values (n,)
            [rad/s]. The first is the speed, others go together with it.
        count: Members of a range; 31 if left out.
        corotating: Whether coordinates turn along with the rotor; by default those of scenes with
            beams do, others do not.
        q, u, locked, targets, free, inputs, parameters, t: As ``root_locus`` takes them.
        check: Raise where the end is not reached, instead of warning.

    Raises:
        As ``root_locus``.
    """
    arguments = {"q": q, "u": u, "locked": locked, "targets": targets, "free": free,
                 "inputs": inputs,
             "parameters": parameters, "t": t}  # fmt: skip
    members = family(model, {**(swept or {}), **named}, arguments, count)
    loci = locus(members, check)
    if loci.message != END:
        warn(loci.message, SolveWarning)
    label = next(iter(members.columns))
    along = model.manifest.absolute if corotating is None else bool(corotating)
    return _record(loci, label, along)


def _record(loci: LocusRecord, label: str, rotating: bool) -> CampbellRecord:
    """Frequencies and whirl of all motions that oscillate somewhere."""
    size = np.array([member.spectrum.size for member in loci.members])[:, None]
    upper = (loci.eigenvalues.imag > OSCILLATES * size).sum(axis=0) * 2 > len(loci)
    columns = np.flatnonzero(upper & loci.moving)
    order = np.nanmean(loci.eigenvalues.imag[:, columns], axis=0).argsort()
    columns = columns[order]
    shape = len(loci), len(columns)
    bare = CampbellRecord(
        loci, loci[label], label, rotating, np.zeros(shape), np.zeros(shape), columns
    )
    whirling = [
        [_frequency_and_whirl(bare, member, _place(member, value), loci[label][i]) for value in row]
        for i, (member, row) in enumerate(zip(loci.members, bare.values, strict=True))
    ]
    table = np.array(whirling).reshape(*shape, 2)
    return CampbellRecord(loci, loci[label], label, rotating, table[..., 0], table[..., 1], columns)


def _place(member: Member, value: complex) -> int:
    return int(np.abs(member.values - value).argmin())


def _frequency_and_whirl(
    diagram: CampbellRecord, member: Member, place: int, speed: float
) -> tuple[float, float]:
    """Frequency from the ground [rad/s], NaN where it does not oscillate, and whirl of a motion."""
    value = member.values[place]
    if abs(value.imag) <= OSCILLATES * member.spectrum.size:
        return (np.nan, 0.0) if not diagram.corotating else (abs(speed), 0.0)
    shape = member.spectrum.right[:, place]
    way = _whirl(member, shape if value.imag > 0 else shape.conj(), *diagram.rotor)
    if not diagram.corotating or abs(way) < ROUND:
        return abs(value.imag), way
    frequency = abs(value.imag) * np.sign(way) + abs(speed)
    return abs(frequency), float(abs(way) * np.sign(frequency))


def _rotor(member: Member) -> tuple[Array, tuple[str, ...]]:
    """Direction (3,) about which the fastest body turns, and those that turn like it."""
    state, angular_velocities = member.state, dict[str, Array]()
    has_jacobian = "frame_jacobian" not in state.model.manifest.absent
    for body in state.model.bodies if has_jacobian else ():
        J = state.model.frame_jacobian(body, state.q, **_time_and_inputs(member))
        angular_velocities[body] = J[:3] @ state.u
    speeds = {body: float(np.linalg.norm(omega)) for body, omega in angular_velocities.items()}
    fastest = max(speeds, key=lambda body: speeds[body], default="")
    if not speeds.get(fastest):
        return np.array([0.0, 0.0, 1.0]), tuple(angular_velocities)
    spinning = tuple(body for body, speed in speeds.items() if speed > 0.5 * speeds[fastest])
    return angular_velocities[fastest] / speeds[fastest], spinning


def _whirl(member: Member, shape: Complex, axis: Array, bodies: tuple[str, ...]) -> float:
    """From -1, backward, to 1, forward."""
    first = np.linalg.svd(axis[None])[2][1]
    second = np.cross(axis, first)
    moved = member.linear.increments @ shape
    forward, backward, along = 0.0, 0.0, 0.0
    model = member.state.model
    for body in bodies:
        twist = model.frame_jacobian(body, member.state.q, **_time_and_inputs(member)) @ moved
        for part in (twist[:3], twist[3:]):
            x, y = first @ part, second @ part
            forward += abs(x + 1j * y) ** 2
            backward += abs(x - 1j * y) ** 2
            along += 2 * abs(axis @ part) ** 2
    # what turns about the axis, or moves along it, whirls only by rounding
    total = forward + backward + along
    return float((forward - backward) / total) if total > 0 else 0.0


def _time_and_inputs(member: Member) -> dict[str, Any]:
    """Time and inputs, as functions of a model take them."""
    values = np.array(list(member.state.inputs.values()))
    return {"t": member.state.t, **({"r": values} if len(values) else {})}


@checked
def plot(
    campbell: CampbellRecord, path: str | Path | None = None, orders: Sequence[int] = (1,)
) -> Any:
    """The diagram as a Matplotlib figure, written to ``path`` if given.

    Args:
        path: Picture file, or None.
        orders: Multiples of the speed that are drawn, with the critical speeds.

    Raises:
        ModelError: a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.loci import plot_campbell

    unstable = (
        campbell.values.real
        > np.array([m.spectrum.size for m in campbell.locus.members])[:, None] * OSCILLATES
    )
    critical = {int(order): campbell.critical(order) for order in orders}
    return plot_campbell(
        campbell.locus.name, campbell.label, campbell.speed, campbell.frequencies, campbell.whirl,
        unstable, critical, path,
    )  # fmt: skip
