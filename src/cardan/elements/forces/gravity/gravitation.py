"""Common parts of the forces of gravity: a center, the bodies it attracts, and the reaction."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar, TypeAlias

from ....errors import ModelError, brief
from ....ir.matrix import Matrix
from ...formulas import Lines, Shapes
from ..force import FRAME, Action, ForceElement, Load, Places, potential
from .fields import Pull

# a vector in axes of the center -> in those in which a mass is told
Turn: TypeAlias = Callable[[Matrix], Matrix]


class Gravitation(ForceElement):
    """A field about the origin of the frame ``center`` that pulls bodies and beams by their mass.

    What it does to a body it does in turn to the body of the center, equal and opposite. Along a
    beam every section is such a body.
    """

    symbol_shapes: ClassVar[Shapes] = {"c": (3, 1), "I": ("symmetric", 3)}
    strained: ClassVar[bool] = False
    center: Any
    bodies: Any

    def __post_init__(self) -> None:
        object.__setattr__(self, "bodies", several(self.kind, self.bodies))
        super().__post_init__()

    @abstractmethod
    def pull(self, r: Matrix, data: Mapping[str, Matrix], turn: Turn) -> Pull:
        """Action on a body whose center of mass is at r, in the axes of r.

        Args:
            r: From the center of the field (3, 1).
            data: Quantities of the field; ``mass`` and ``inertia`` (3, 3) of the body, the latter
                about its center of mass and in axes of r.
            turn: Tells vectors in axes of the center in those of r.
        """

    @property
    def has_potential(self) -> bool:
        """True if what it does follows from a potential energy."""
        return True

    @property
    def option(self) -> str:
        """Word for what it does other than by default, "" for nothing."""
        return ""

    def torque_about_center(self, r: Matrix, pull: Pull) -> Matrix:
        """Torque of the attraction about the center:

        none where rotating the body about it changes nothing.
        """
        return Matrix.zeros(r.graph, 3)

    def masses(self) -> tuple[Any, ...]:
        return tuple(self.bodies)

    def acts_on(self) -> tuple[str, str]:
        return FRAME, "body"

    def act(self, at: Places) -> tuple[Action, ...]:
        center, body, com = at.frames["center"], at.frames["body"], at.data["com"]
        r = at.motion.arm(center, body) + com
        pull = self.pull(r, at.data, lambda x: at.motion.in_frame(x, center, body))
        loads = (
            Load(body, pull.torque + com.cross(pull.force), pull.force, axes=body),
            Load(center, -self.torque_about_center(r, pull), -pull.force, axes=body),
        )
        if not self.has_potential:
            return (Action(loads),)
        quantities = (at.data[name] for name in self.quantities())
        return (Action(loads, (), *potential(pull.potential, *quantities)),)


REACH: Lines = (
    ("center of mass c of the body from the center", "r = p_body + R_body @ c - p_center"),
    ("distance", "rho = sqrt(dot(r, r))"),
)
ATTRACTION: Lines = (
    ("moment about the origin of the body", "M_body = skew(R_body @ c) @ F_body"),
    ("force on the center", "F_center = -F_body"),
)


def several(who: str, bodies: Any) -> tuple[Any, ...]:
    """Bodies and beams as written: one, several, or () for all of the scene that have mass.

    Raises:
        ModelError: something else, or one twice: it would be pulled twice.
    """
    if bodies is None:
        return ()
    alone = isinstance(bodies, str) or not isinstance(bodies, Sequence)
    listed = (bodies,) if alone else tuple(bodies)
    names = [getattr(body, "name", body) for body in listed]
    for k, (body, name) in enumerate(zip(listed, names, strict=True)):
        if not isinstance(body, str) and not hasattr(body, "mass") and not hasattr(body, "section"):
            raise ModelError(
                f"{who}: {brief(body)} is not a body; give a body or a beam, several of them or "
                "their names, or leave bodies out for all that have mass"
            )
        if name in names[:k]:
            kind = "beam" if hasattr(body, "section") else "body"
            raise ModelError(f"{who}: {kind} '{name}' is named twice; it is pulled once")
    return listed
