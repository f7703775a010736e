"""The bodies and beams that a force element acts on by their mass."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import ModelError
from .beam import Beam
from .body import Body
from .checks import is_number

if TYPE_CHECKING:
    from .connections import Force
    from .scene import SceneRecord


def pulled(model: SceneRecord, force: Force) -> tuple[Body | Beam, ...]:
    """The bodies and beams whose mass a force element acts on.

    Raises:
        ModelError: the ground, a frame or a body of the element's own frames among them, or nothing
            at all.
    """
    element = force.element
    who, named_bodies = f"force '{force.name}' ({element.kind})", element.masses()
    ends = {model.place(who, place, role).body for role, place in element.frames().items()}
    if named_bodies:
        return tuple(_named(model, who, body, ends) for body in named_bodies)
    attracted = tuple(b for b in model.bodies.values() if has_mass(b) and b not in ends)
    if model.beams:
        return (*attracted, *model.beams.values())
    if not attracted:
        raise ModelError(f"{who}: no body but that of its frame has mass; give one a mass")
    return attracted


def _named(model: SceneRecord, who: str, body_named: Any, ends: set[Body]) -> Body | Beam:
    """One body or beam that the user named."""
    beam = model.beams.get(getattr(body_named, "name", body_named))
    if beam is not None and isinstance(body_named, (str, Beam)):
        return beam
    body = model.place(who, body_named, "body")
    if not isinstance(body, Body):
        raise ModelError(f"{who}: '{body.name}' is a frame; give its body, '{body.body.name}'")
    if body is model.ground:
        raise ModelError(f"{who}: the ground does not move; leave it out of bodies")
    if body in ends:
        raise ModelError(f"{who}: '{body.name}' carries its center; no body pulls itself")
    return body


def has_mass(body: Body) -> bool:
    """True when a body has mass or inertia; expressions count."""
    return not all(is_number(x) and x == 0 for x in (body.mass, *body.inertia))
