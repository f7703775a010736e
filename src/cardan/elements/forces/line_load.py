"""A load along a beam."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...errors import ModelError, shown
from ..quantity import BeamName, Quantity
from ..written import vector
from .force import Action, ForceElement, Places


@dataclass(frozen=True)
class LineLoad(ForceElement):
    """A force and a moment per length of a beam in its reference configuration.

    Args:
        beam: The beam, or its name.
        force: Three components [N/m]: numbers, parameters or expressions of parameters.
        moment: Three components [N m/m].
        follower: The components are those along the section axes e1, e2, e3 and turn with the
            section; else along the axes of the ground.

    Raises:
        ModelError: neither force nor moment, or not three finite components; no beam.

    Source: J. C. Simo and L. Vu-Quoc, A three-dimensional finite-strain rod model II, 1986.
    """

    kind: ClassVar[str] = "line_load"
    beam: BeamName
    force: Any = None
    moment: Any = None
    follower: bool = False

    def __post_init__(self) -> None:
        if self.force is None and self.moment is None:
            raise ModelError("line_load: give force=, moment= or both, three components each")
        for name in ("force", "moment"):
            if getattr(self, name) is not None:
                value = vector("line_load", name, getattr(self, name), 3)
                object.__setattr__(self, name, value)
        if not isinstance(self.beam, str) and not hasattr(self.beam, "section"):
            raise ModelError(
                f"line_load: {shown(self.beam)} is no beam: give a beam or its name. "
                "Bodies and frames "
                "take cd.Force and cd.Torque"
            )
        if not isinstance(self.follower, bool):
            raise ModelError(f"line_load: follower is True or False, not {shown(self.follower)}")

    def quantities(self) -> dict[str, Quantity]:
        units = {"force": "N/m", "moment": "N"}
        given = {name: getattr(self, name) for name in units}
        return {name: Quantity(x, units[name]) for name, x in given.items() if x is not None}

    def act(self, at: Places) -> tuple[Action, ...]:
        # the elements of the beam carry it
        return ()
