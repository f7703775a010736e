"""Superelements in a scene: a record, where its frame is, and what its interfaces are fixed to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..arrays import Array
from ..elements.superelement_joints import ROTATIONS, TRANSLATIONS
from ..superelements.record import SuperelementRecord

MEAN, CHORD = "mean", "chord"


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
    """

    name: str
    record: SuperelementRecord = field(repr=False)
    joined: Mapping[str, str]
    frame: str
    weights: tuple[float, ...]
    stiffening: bool = False

    def place_name(self, interface: str) -> str:
        """Name of the frame of an interface."""
        return f"{self.name}.{interface}"

    @property
    def carrier(self) -> str:
        """Name of the body that its frame is fixed to."""
        return self.place_name("frame" if self.frame in (MEAN, CHORD) else self.frame)

    @property
    def places(self) -> tuple[str, ...]:
        """Names of its bodies: the one with the frame, then the interfaces."""
        names = (self.place_name(one.name) for one in self.record.interfaces)
        return tuple(dict.fromkeys([self.carrier, *names]))


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
