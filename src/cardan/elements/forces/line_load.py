"""A load along a beam."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError, brief
from ...records import dataclass
from ..quantity import BeamName, Units, Vector
from .force import Action, ForceElement, Places


@dataclass(frozen=True)
class LineLoad(ForceElement):
    """A force and a moment per length of a beam in its reference configuration.

    Args:
        beam: The beam, or its name.
        force: Three components [N/m]: numbers, parameters or expressions, the same all along.
        moment: Three components [N m/m].
        follower: The components are those along the section axes e1, e2, e3 and turn with the
            section; else along the axes of the ground.

    Raises:
        ModelError: neither force nor moment, or not three finite components; no beam.

    Source: J. C. Simo and L. Vu-Quoc, A three-dimensional finite-strain rod model II, 1986.
    """

    kind: ClassVar[str] = "line_load"
    units: ClassVar[Units] = {"force": "N/m", "moment": "N"}
    beam: BeamName
    force: Vector = None
    moment: Vector = None
    follower: bool = False

    def __post_init__(self) -> None:
        if self.force is None and self.moment is None:
            raise ModelError("line_load: give force=, moment= or both, three components each")
        super().__post_init__()
        if not isinstance(self.beam, str) and not hasattr(self.beam, "section"):
            raise ModelError(
                f"line_load: {brief(self.beam)} is not a beam: give a beam or its name. "
                "Bodies and frames "
                "take cd.Force and cd.Torque"
            )

    def act(self, at: Places) -> tuple[Action, ...]:
        # the elements of the beam carry it
        return ()
