"""Placeholders in user expressions: positions, velocities and so on of named frames."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from ..elements.forces.force import Motion
from ..errors import DerivationError
from ..ir.matrix import Matrix
from ..topology.system import Atom, System


class Moving(Motion, Protocol):
    """What placeholders need to know: the motion, names, and accelerations where udot is known."""

    system: System
    acceleration: Callable[[int], Matrix] | None


def placeholder(k: Moving, atom: Atom) -> int:
    """The expression that a placeholder stands for.

    Raises:
        DerivationError: an acceleration where forces are not known yet.
    """
    if atom.quantity in ("q", "u"):
        values = k.q(atom.frame) if atom.quantity == "q" else k.u(atom.frame)
        return values.nodes[atom.component]
    axes = k.rotation(atom.in_).T
    if atom.quantity == "position":
        value = axes @ (k.position(atom.frame) - k.position(atom.wrt))
    elif atom.quantity == "rotation":
        value = k.rotation(atom.wrt).T @ k.rotation(atom.frame)
    elif atom.quantity == "angular_velocity":
        value = axes @ (k.angular_velocity(atom.frame) - k.angular_velocity(atom.wrt))
    elif atom.quantity == "velocity":
        value = axes @ _relative_velocity(k, atom)
    elif k.acceleration is not None:
        value = axes @ _relative_acceleration(k, atom, k.acceleration)
    else:
        raise DerivationError(
            f"{atom.quantity} of frame '{k.system.frames[atom.frame].name}' cannot stand "
            "in a force law: it depends on the force. Use position, velocity, rotation or "
            "angular_velocity there; accelerations may stand in outputs"
        )
    return value.nodes[atom.component]


def _relative_velocity(k: Moving, atom: Atom) -> Matrix:
    """Velocity of a frame's origin as seen from another frame, in ground axes."""
    offset = k.position(atom.frame) - k.position(atom.wrt)
    transport = k.angular_velocity(atom.wrt).cross(offset)
    return k.velocity(atom.frame) - k.velocity(atom.wrt) - transport


def _relative_acceleration(k: Moving, atom: Atom, of: Callable[[int], Matrix]) -> Matrix:
    """Acceleration of a frame's origin as seen from another frame, in ground axes."""
    base, own = of(atom.wrt), of(atom.frame)
    alpha, omega = base.block(slice(0, 3)), k.angular_velocity(atom.wrt)
    offset = k.position(atom.frame) - k.position(atom.wrt)
    transport = alpha.cross(offset) + omega.cross(omega.cross(offset))
    coriolis = omega.cross(_relative_velocity(k, atom)) * 2
    return own.block(slice(3, 6)) - base.block(slice(3, 6)) - transport - coriolis
