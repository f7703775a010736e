"""Superelements in a scene: a record, where its frame is, and what its interfaces are fixed to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace

import numpy as np

from ..arrays import Array
from ..elements.quantity import Value
from ..elements.superelement_joints import ROTATIONS, TRANSLATIONS
from ..records import dataclass
from ..superelements.inertia import ProjectedInertia, of_interfaces
from ..superelements.record import SuperelementRecord

MEAN, CHORD = "mean", "chord"
NODAL, PROJECTED, COROTATED = "nodal", "projected", "corotated"


@dataclass(frozen=True)
class PlacedSuperelement:
    """A reduced component in a scene.

    Attributes:
        name: Its name.
        record: Its matrices.
        joined: Names of the frames that interfaces are fixed to, by the name of the interface.
        frame: ``"mean"``, ``"chord"`` or the interface that its frame is fixed to.
        weights: Of the interfaces in a mean frame, of sum 1.
        stiffening: Whether its geometric stiffness by rotation counts.
        inertia: Form of its inertia, by name in :data:`INERTIAS`.
        loads: Factors of loads of the record, by name.
    """

    name: str
    record: SuperelementRecord = field(repr=False)
    joined: Mapping[str, str]
    frame: str
    weights: tuple[float, ...]
    stiffening: bool = False
    inertia: str = "nodal"
    loads: Mapping[str, Value] = field(default_factory=dict)

    def place_name(self, interface: str) -> str:
        """Name of the frame of an interface."""
        return f"{self.name}.{interface}"

    @property
    def constants(self) -> ProjectedInertia:
        """Constants of the inertia in its form."""
        return INERTIAS[self.inertia](self.record)

    @property
    def carrier(self) -> str:
        """Name of the body that its frame is fixed to."""
        return self.place_name("frame" if self.frame in (MEAN, CHORD) else self.frame)

    @property
    def modes_body(self) -> str:
        """Name of the body whose joint has the modal coordinates."""
        return self.place_name("modes")

    @property
    def places(self) -> tuple[str, ...]:
        """Names of its bodies: the one with the frame, then the interfaces."""
        names = (self.place_name(one.name) for one in self.record.interfaces)
        return tuple(dict.fromkeys([self.carrier, *names]))


def _nodal(record: SuperelementRecord) -> ProjectedInertia:
    """All nodes, none of whose inertia depends on the velocity of the frame."""
    inertia = record.inertia
    turned = [np.cross(axis, inertia.momentum, axisb=0).T for axis in np.eye(3)]
    return replace(inertia, spin_momentum=np.array(turned))


def _corotated(record: SuperelementRecord) -> ProjectedInertia:
    """Velocities of interfaces and modal rates."""
    rows, at = [], 0
    for one in record.interfaces:
        places = {motion: at + k for k, motion in enumerate(one.components)}
        rows.append([places.get(name, -1) for name in TRANSLATIONS])
        at += len(one.components)
    return of_interfaces(record.M, record.rigid_motions(), np.array(rows))


# form of the inertia -> its constants
INERTIAS: dict[str, Callable[[SuperelementRecord], ProjectedInertia]] = {
    NODAL: _nodal,
    PROJECTED: lambda record: record.inertia,
    COROTATED: _corotated,
}


def frame_condition(superelement: PlacedSuperelement) -> Array:
    """Rows (6, motions of all interfaces) that are 0 in a frame that goes along with them.

    sum a_i u_i = 0 and sum a_i ((X_i - X) x u_i + W th_i) = 0, with X the mean of X_i and W the
    square of a length: that of the spread of the interfaces, for a chord along it alone.
    """
    frames, weights = superelement.record.interfaces, np.array(superelement.weights)
    places = np.array([one.position for one in frames])
    arms = places - weights @ places
    radius = float(weights @ (arms**2).sum(axis=1)) or 1.0
    lever = radius * np.eye(3)
    if superelement.frame == CHORD:
        along = places[-1] - places[0]
        lever = np.outer(along, along)
    columns = []
    for weight, arm, one in zip(weights, arms, frames, strict=True):
        for motion in one.components:
            if motion in TRANSLATIONS:
                e = np.eye(3)[TRANSLATIONS.index(motion)]
                columns.append(weight * np.concatenate([e, np.cross(arm, e)]))
            else:
                e = lever[:, ROTATIONS.index(motion)]
                columns.append(weight * np.concatenate([np.zeros(3), e]))
    return np.stack(columns, axis=1)
