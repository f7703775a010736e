"""Elements that do nothing at rest but withstand a strain."""

from __future__ import annotations

from ...ir.graph import ZERO
from ...ir.rewrite import rebuild
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import actions, applied, without_potential
from ..kinematics.partial_velocities import generalized_forces


def strain_of(k: Kinematics) -> str:
    """Kind of the forces of an element as to strains, see :class:`.record.Kind`."""
    forces = [force for force in k.system.forces if force.element.strained]
    acting = [action for force in forces for action in actions(k, force)]
    if all(action.potential is None for action in acting):
        return ""
    # forces at rest besides those of the strain, or of one whose energy time changes
    zero_speeds = {k.graph.var("u", n): ZERO for n in range(k.system.nu)}
    remaining = generalized_forces(k, without_potential(k, applied(k)))
    forces_at_zero_speed = rebuild(k.graph, remaining.nodes, zero_speeds, into=k.graph)[1]
    return "alone" if all(node == ZERO for node in forces_at_zero_speed) else "mixed"
