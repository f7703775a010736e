"""A superelement in the system graph."""

from __future__ import annotations

from dataclasses import field

from ...records import dataclass
from ...superelements.inertia import ProjectedInertia
from ...superelements.record import SuperelementRecord


@dataclass(frozen=True)
class PartOfSystem:
    """A superelement in the system graph.

    Attributes:
        name: Its own.
        record: Its matrices.
        frame_choice: ``"mean"``, ``"chord"`` or the interface that its frame is fixed to.
        frame: Index in ``System.frames`` of its axes and origin, where they are without
            deformation.
        joints: Numbers of the joints whose coordinates are its own, interface by interface, then
            that of the modes.
        rows: Which of the coordinates of the record these are.
        stiffening: Whether its geometric stiffness by rotation counts.
        inertia: Constants of its inertia.
        loads: Names of loads of its record that act.
        bodies: Names of those without mass that stand for its interfaces, frame and modes.
        undeformed: Names of frames that stand where it is without deformation.
    """

    name: str
    record: SuperelementRecord = field(repr=False)
    frame_choice: str
    frame: int
    joints: tuple[int, ...]
    rows: tuple[int, ...]
    stiffening: bool
    inertia: ProjectedInertia = field(repr=False)
    loads: tuple[str, ...]
    bodies: tuple[str, ...]
    undeformed: tuple[str, ...]
