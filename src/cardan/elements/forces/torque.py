"""A torque on a frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...ir.matrix import Matrix
from ..quantity import Place, Quantity
from ..written import vector
from .force import Action, ForceElement, Load, Places


@dataclass(frozen=True)
class Torque(ForceElement):
    """A torque on the body of a frame.

    Args:
        frame: Body or frame it acts on.
        torque: Three components [N m]: numbers, parameters or expressions.
        in_: Frame in whose axes the components are given; the ground by default.

    Raises:
        ModelError: not three finite components.

    Source: Kane and Levinson, Dynamics: Theory and Applications, section 4.4.
    """

    kind: ClassVar[str] = "torque"
    frame: Place
    torque: Any
    in_: Place = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "torque", vector("torque", "torque", self.torque, 3))

    def quantities(self) -> dict[str, Quantity]:
        return {"torque": Quantity(self.torque, "N*m")}

    def frames(self) -> dict[str, Any]:
        return {"frame": self.frame} | ({} if self.in_ is None else {"in_": self.in_})

    def act(self, at: Places) -> tuple[Action, ...]:
        motion, data, frames = at.motion, at.data, at.frames
        torque = data["torque"]
        if "in_" in frames:
            torque = motion.rotation(frames["in_"]) @ torque
        return (Action((Load(frames["frame"], torque, Matrix.zeros(motion.graph, 3)),)),)
