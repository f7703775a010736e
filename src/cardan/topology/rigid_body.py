"""A rigid body of the system while it is assembled from bodies of the user."""

from __future__ import annotations

from dataclasses import field

from ..ir.graph import ZERO, Graph
from ..records import dataclass
from .conversion import ORIGIN
from .system import Body, Part

ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")


@dataclass
class Rigid:
    """A rigid body being assembled.

    Attributes:
        name: Of its first part.
        parent: Number of the body it is jointed to.
        parts: The bodies of the user in it; none where it only stands for a joint's far side.
        index: Name of a part -> its number.
    """

    name: str
    parent: int
    parts: list[Part] = field(default_factory=list)
    index: dict[str, int] = field(default_factory=dict)

    def body(self, g: Graph) -> Body:
        """The finished body: sums over the parts.

        ``whole_mass = sum m``, ``first_moment = sum m c`` and
        ``origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ))``.
        """
        g.describe(Rigid.body)
        if not self.parts:
            return Body(self.name, self.parent, ZERO, ORIGIN, (ZERO,) * 9, ())
        first = self.parts[0]
        mass, moment, inertia = first.mass, first.first_moment, first.inertia
        with g.made_by(self.name, "mass"):
            for part in self.parts[1:]:
                mass = g.add(mass, part.mass)
                moment = tuple(map(g.add, moment, part.first_moment))
                inertia = tuple(map(g.add, inertia, part.inertia))
        g.label(mass, self.name, "whole_mass")
        for axis, node in zip("xyz", moment, strict=True):
            g.label(node, self.name, f"first_moment_{axis}")
        for key, node in zip(ENTRIES, (inertia[k] for k in (0, 1, 2, 4, 5, 8)), strict=True):
            g.label(node, self.name, f"origin_inertia_{key}")
        return Body(self.name, self.parent, mass, moment, inertia, tuple(self.parts))
