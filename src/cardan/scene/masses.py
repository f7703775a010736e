"""The bodies and beams that a force element acts on by their mass."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import ModelError
from .beam import Beam
from .body import Body
from .checks import is_number
from .frame import Place

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


def member(model: SceneRecord, who: str, named: Place | Beam | str) -> Place | Beam:
    """A body or beam of this model, itself or by its name.

    Raises:
        ModelError: it belongs to another model or does not exist.
    """
    if isinstance(named, str) and named in model.beams and named not in model.bodies:
        return model.beams[named]
    if not isinstance(named, Beam):
        return model.place(who, named, "body or beam" if model.beams else "body")
    if model.beams.get(named.name) is None or named.model.original is not model.original:
        raise ModelError(
            f"{who}: beam '{named.name}' belongs to model '{named.model.name}', not to "
            f"'{model.name}'; include that model"
        )
    return model.beams[named.name]


def _named(
    model: SceneRecord, who: str, body_named: Place | Beam | str, ends: set[Body]
) -> Body | Beam:
    """One body or beam that the user named."""
    body = member(model, who, body_named)
    if isinstance(body, Beam):
        return body
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
