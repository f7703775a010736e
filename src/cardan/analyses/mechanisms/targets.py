"""Targets of an assembly: values of coordinates, places and poses of frames."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, listed, miscounted, near
from ...records import dataclass
from ...runtime.models.finite_elements.frames import rotation_vectors
from ...runtime.models.initial import missing
from ...runtime.models.named_rotations import check_units, refuse_components
from .mechanism import Mechanism

FRAMES = {(3,): "position", (4, 4): "pose"}


@dataclass(frozen=True)
class Target:
    """One wanted value.

    Attributes:
        name: Of the coordinate, joint or frame.
        kind: ``"coordinate"``, ``"position"`` or ``"pose"``.
        value: (n,), (3,) or (4, 4).
        place: Of the coordinates in q.
        weight: How much it counts where it cannot be held; None: it must be held.
    """

    name: str
    kind: str
    value: Array
    place: slice = field(default_factory=lambda: slice(0, 0))
    weight: float | None = None

    def entries_of(self, m: Mechanism) -> NDArray[np.intp]:
        """Entries of q that are to have its values."""
        return np.arange(self.place.start, self.place.stop)

    def scales_of(self, m: Mechanism) -> Array:
        """Units in which the residuals count."""
        rows = m.model.manifest.coordinates[self.place]
        return np.array([m.size if row.unit == "m" else 1.0 for row in rows])

    def residual(self, m: Mechanism, q: Array) -> Array:
        """Difference of a frame from its target, without units: rotation vector, then place."""
        pose = m.model.pose(self.name, q, t=m.t, r=m.r)
        away: Array = (pose[:3, 3] - self.goal) / m.size
        if self.kind == "position":
            return away
        return np.concatenate([rotation_vectors(pose[:3, :3] @ self.value[:3, :3].T), away])

    def jacobian(self, m: Mechanism, q: Array) -> Array:
        """Derivative of :meth:`residual` along steps (n, nu)."""
        J = m.frame_jacobian(self.name, q)
        J[3:] /= m.size
        return J[3:] if self.kind == "position" else np.asarray(J)

    @property
    def rows(self) -> int:
        """Number of residuals."""
        return 6 if self.kind == "pose" else len(self.value)

    @property
    def goal(self) -> Array:
        """The place (3,) that it gives a frame."""
        return self.value[:3, 3] if self.kind == "pose" else self.value

    @property
    def description(self) -> str:
        """The wanted value in words."""
        if self.kind == "coordinate":
            return ", ".join(f"{x:.6g}" for x in self.value)
        goal = self.goal
        return f"{self.kind} at ({', '.join(f'{x:.6g}' for x in goal)}) m"


@dataclass(frozen=True)
class Coordinates(Target):
    """Coordinates of several joints that are to have values.

    Attributes:
        entries: Of q (n,).
        scales: What each counts in (n,).
    """

    entries: NDArray[np.intp] = field(default_factory=lambda: np.zeros(0, dtype=np.intp))
    scales: Array = field(default_factory=lambda: np.ones(0))

    def entries_of(self, m: Mechanism) -> NDArray[np.intp]:
        """Same as :meth:`Target.entries_of`."""
        return self.entries

    def scales_of(self, m: Mechanism) -> Array:
        """Same as :meth:`Target.scales_of`."""
        return self.scales

    def distance(self, q: Array) -> float:
        """Distance of a position (nq,) from the targets, in radians and sizes of the scene."""
        return float(np.linalg.norm((q[self.entries] - self.value) / self.scales))


def read(
    m: Mechanism,
    named: Mapping[str, object],
    weights: Mapping[str, float] | None = None,
    locked: Iterable[str] | None = None,
) -> list[Target]:
    """Targets out of what the user wrote.

    Args:
        m: The mechanism.
        named: Coordinate, joint or frame -> value.
        weights: Of those that need not be held.
        locked: Those that must be held; by default all without a weight.

    Raises:
        ModelError: an unknown name, a weight that is not a positive number, weights or names to
            hold that are none.
        ArgumentError: a value of a wrong shape. SolveError: one that is not finite.
    """
    places, frames = m.model._layout.slots["q"] if named else {}, m.model.part_of
    targets = [_target(m, name, value, places, frames) for name, value in named.items()]
    _check_rotations(m, targets)
    names_of_targets = [target.name for target in targets]
    weights, required = (
        _weights(weights),
        None if locked is None else listed("locked", locked, "hand"),
    )
    for word, names in (("weights", [*weights]), ("locked", required or [])):
        for name in names:
            if name not in names_of_targets:
                raise ModelError(f"{word}: '{name}' is not a target.{near(name, names_of_targets)}")
    soft = [
        n for n in names_of_targets if (n in weights if required is None else n not in required)
    ]
    counts = {name: float(weights.get(name, 1.0)) for name in soft}
    return [replace(target, weight=counts.get(target.name)) for target in targets]


def _check_rotations(m: Mechanism, targets: Sequence[Target]) -> None:
    """Refuse single components of quaternions, and quaternions whose length is not 1."""
    manifest, entries = m.model.manifest, dict[int, float]()
    for target in targets:
        if target.kind == "coordinate":
            places = range(target.place.start, target.place.stop)
            entries.update(zip(places, target.value.tolist(), strict=True))
    refuse_components(manifest, "targets", entries)
    q = m.model._layout.start("q").copy()
    q[list(entries)] = list(entries.values())
    check_units(manifest, q, "targets: ")


def _weights(weights: object) -> dict[str, float]:
    """Target -> weight, checked but for the names."""
    if not isinstance(weights, Mapping | None):
        raise ModelError(
            f"weights={brief(weights)}: give targets with weights, such as {{'hand': 1.0}}"
        )
    for name, weight in (weights or {}).items():
        number = float(weight) if isinstance(weight, Real) else np.nan
        if not (np.isfinite(number) and number > 0):
            raise ModelError(f"weights: '{name}' has {brief(weight)}; weights are positive numbers")
    return {name: float(weight) for name, weight in (weights or {}).items()}


def locked_values(m: Mechanism, locked: object) -> dict[str, Any]:
    """Coordinates and frames that keep a value beside what is driven.

    Raises:
        ModelError: names without values.
    """
    if isinstance(locked, Mapping | None):
        return dict(locked or {})
    names = [*m.model._layout.slots["q"], *m.model.frames]
    suggestion = near(locked, names) if isinstance(locked, str) and locked not in names else ""
    raise ModelError(
        f"locked={brief(locked)}: give coordinates or frames with the values they keep, such as "
        f"{{'{locked if isinstance(locked, str) and locked in names else names[0]}': 0.2}}."
        f"{suggestion}"
    )


def _target(
    m: Mechanism,
    name: str,
    value: object,
    places: Mapping[str, slice],
    frames: Mapping[str, str | None],
) -> Target:
    """One target; ``places``: of the coordinates, ``frames``: of the model."""
    where = f"targets: '{name}'"
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise ArgumentError(f"{where}: {brief(value)} is not a number or an array of numbers")
    array = array.astype(np.float64)
    if not np.isfinite(array).all():
        raise SolveError(f"{where} is {brief(value)}; it must be finite")
    place = places.get(name)
    if place is not None and not (name in frames and array.shape == (4, 4)):
        if array.size != place.stop - place.start:
            raise ArgumentError(miscounted(where, array.size, m.model.coordinates[place]))
        return Target(name, "coordinate", array.reshape(-1), place)
    if name in frames:
        kind = FRAMES.get(array.shape)
        if kind is None:
            raise ArgumentError(
                f"{where}: shape {array.shape}; a frame takes its position (3,) or pose (4, 4)"
            )
        if kind == "pose":
            _check_pose(where, array)
        return Target(name, kind, array)
    raise ModelError(f"{where}: {missing(m.model.manifest, 'q', name, [*places, *frames])}")


def _check_pose(where: str, pose: Array) -> None:
    rotation = pose[:3, :3]
    wrong = np.abs(rotation @ rotation.T - np.eye(3)).max()
    if wrong > 1e-6 or np.linalg.det(rotation) < 0 or np.any(pose[3] != (0, 0, 0, 1)):
        raise ArgumentError(
            f"{where}: this is not a pose: a rotation matrix and a position above (0, 0, 0, 1)"
        )
