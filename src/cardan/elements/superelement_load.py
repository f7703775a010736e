"""A load of a superelement: forces along its coordinates times a factor."""

from __future__ import annotations

from typing import ClassVar

from ..ir.matrix import Matrix
from ..records import dataclass
from .forces.force import Action, ForceElement, JointLoad, Load, Places
from .formulas import Lines
from .quantity import Place, Units, Value


@dataclass(frozen=True)
class SuperelementLoad(ForceElement):
    """A load of a superelement, such as the forces of a rise of temperature, times a factor.

    Forces act where the nodes are without deformation and turn with the frame.

    Args:
        frame: Axes of the superelement.
        factor: Multiplies the load.
        torque, force: Resultant about the origin of the frame, in its axes (3,), (3,) [N m, N].
        members: Names of the joints whose coordinates are those of the superelement.
        forces: Along the speeds of each of these joints [N, N m, and those of modal coordinates].

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 8.5.
    """

    kind: ClassVar[str] = "superelement_load"
    units: ClassVar[Units] = {"factor": ""}
    frame: Place
    factor: Value
    torque: tuple[float, ...]
    force: tuple[float, ...]
    members: tuple[str, ...]
    forces: tuple[tuple[float, ...], ...]

    def joints(self) -> dict[str, str]:
        return {f"part{k + 1}": name for k, name in enumerate(self.members)}

    def acts_on(self) -> tuple[str, str]:
        # it acts on all coordinates at once: there is no single force or torque to name
        return "", ""

    def act(self, at: Places) -> tuple[Action, ...]:
        graph, factor = at.motion.graph, at.data["factor"][0]
        frame = at.frames["frame"]
        loads: tuple[Load, ...] = ()
        if any((*self.torque, *self.force)):
            torque, force = (
                Matrix.vector(graph, [*values]) * factor for values in (self.torque, self.force)
            )
            loads = (Load(frame, torque, force, frame),)
        joint_loads = tuple(
            JointLoad(at.joints[role], Matrix.vector(graph, [*values]) * factor)
            for role, values in zip(self.joints(), self.forces, strict=True)
        )
        return (Action(loads, joint_loads),)

    def formulas(self, at: Places) -> Lines:
        roles = [*self.joints()]
        names = [f"_{role}" if len(roles) > 1 else "" for role in roles]
        about = "load f along coordinates of the superelement, times the factor s"
        return tuple((about * (k == 0), f"tau{n} = s * f{n}") for k, n in enumerate(names))
