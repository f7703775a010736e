"""Placeholders in user expressions: positions, velocities and so on of named frames."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from ...elements.forces.force import Motion
from ...errors import DerivationError
from ...ir.function import live
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...topology.system import Atom, System


class Moving(Motion, Protocol):
    """Quantities that placeholders read:

    the motion, names, and accelerations where udot is known.
    """

    system: System
    acceleration: Callable[[int], Matrix] | None


def resolved(k: Moving, replacements: Mapping[int, int], nodes: Sequence[int]) -> tuple[int, ...]:
    """Nodes with placeholders put in.

    Args:
        k: The motion.
        replacements: Other nodes that are replaced, with what stands for them.
        nodes: The expressions.

    Raises:
        DerivationError: an expression divides by what is always 0 in this scene, or the like.
    """
    if not k.system.atoms and not replacements:
        return tuple(nodes)
    g = k.graph
    replace = {n: r for n, r in replacements.items() if n < len(k.system.graph)}
    for i in live(g, nodes):
        # symbols of a joint's own are not atoms of the system: the joint resolves them
        if g.nodes[i][0] == "atom" and g.nodes[i][1] in k.system.atoms:
            replace[i] = placeholder(k, k.system.atoms[g.nodes[i][1]])
    if not replace:
        return tuple(nodes)
    try:
        return tuple(rebuild(g, nodes, replace, into=g)[1])
    except (ZeroDivisionError, ValueError) as problem:
        atoms = [(g.nodes[i][1], g.value(n)) for i, n in replace.items() if g.nodes[i][0] == "atom"]
        listed = ", ".join(f"'{name}' is {v:g}" for name, v in atoms if v is not None)
        raise DerivationError(
            f"{problem}: in this scene {listed} at all times. Rewrite the expression without it"
        ) from problem


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
    base, acceleration = of(atom.wrt), of(atom.frame)
    alpha, omega = base.block(slice(0, 3)), k.angular_velocity(atom.wrt)
    offset = k.position(atom.frame) - k.position(atom.wrt)
    transport = alpha.cross(offset) + omega.cross(omega.cross(offset))
    coriolis = omega.cross(_relative_velocity(k, atom)) * 2
    return acceleration.block(slice(3, 6)) - base.block(slice(3, 6)) - transport - coriolis
