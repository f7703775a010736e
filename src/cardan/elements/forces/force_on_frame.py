"""A force on a frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...ir.matrix import Matrix
from ..quantity import Place, Quantity
from ..written import vector
from .force import Action, ForceElement, Load, Places


@dataclass(frozen=True)
class Force(ForceElement):
    """A force at the origin of a frame.

    Args:
        frame: Body or frame it acts on; ``body.at(x, y, z)`` for a point.
        force: Three components [N]: numbers, parameters or expressions in coordinates, speeds,
            inputs, frames and t.
        in_: Frame in whose axes the components are given; the ground by default.

    Raises:
        ModelError: not three finite components.

    Source: Kane and Levinson, Dynamics: Theory and Applications, section 4.4.
    """

    kind: ClassVar[str] = "force"
    frame: Place
    force: Any
    in_: Place = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "force", vector("force", "force", self.force, 3))

    def quantities(self) -> dict[str, Quantity]:
        return {"force": Quantity(self.force, "N")}

    def frames(self) -> dict[str, Any]:
        return {"frame": self.frame} | ({} if self.in_ is None else {"in_": self.in_})

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, frames = at.motion, at.data, at.frames
        force = data["force"]
        if "in_" in frames:
            force = motion.rotation(frames["in_"]) @ force
        return (Action((Load(frames["frame"], Matrix.zeros(motion.graph, 3), force),)),)
