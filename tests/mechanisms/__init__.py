"""The zoo: small scenes that together use every joint, rotation, coupling and force.

A new mechanism is one function and one ``Mechanism`` in the ``MEMBERS`` of its file; the laws
iterate this list.
"""

from . import backwards, forced, guided, joints, pendulums, rotations, space, trees
from .mechanism import METHODS, Mechanism, State

ZOO: dict[str, Mechanism] = {
    member.name: member
    for family in (pendulums, joints, guided, backwards, trees, rotations, forced, space)
    for member in family.MEMBERS
}

__all__ = ["METHODS", "ZOO", "Mechanism", "State"]
