"""Functions of the table that a system has, and their names in C."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence

from ...errors import DerivationError, near
from ...schema.blocks import DIRECTIONS
from ...schema.functions import FUNCTIONS
from ...topology.system import System

# to import them is to know their recipes
from ..constraints import constraint_functions  # noqa: F401
from ..constraints.reaction_friction import friction_forces
from . import blocks, canonical, expression, functions, products, regressor, residuals, rhs_jacobian  # noqa: F401  # noqa: F401
from .context import RECIPES as RECIPES
from .derivatives import request_of
from .element_forces import named_forces

# characters of a C name before it is cut
LONGEST = 80


def c_name(system: System, name: str, of: str | None) -> str:
    """C name of a function.

    Raises:
        DerivationError: ``of`` names no derivative.
    """
    if not of:
        return name
    if FUNCTIONS[name].of == "function":
        return _derivative_name(name, of)
    if FUNCTIONS[name].of == "formula":
        return f"{name}__{hashlib.sha256(of.encode()).hexdigest()[:12]}"
    if FUNCTIONS[name].of == "joint":
        names = [*system.moving_joints, *system.fixed]
    else:
        names = [f.name for f in system.frames]
    return blocks.c_name(name, of, names)


def _derivative_name(name: str, of: str) -> str:
    """``derivative__forward_dynamics_q_u``; with a mark where that alone would be ambiguous."""
    request = request_of(of)
    parts = (request.function, *([request.of] if request.of else []), *request.wrt)
    plain = "_".join(blocks.identifier(word) for word in parts)
    if request.of or not set(request.wrt) <= set(DIRECTIONS) or len(plain) > LONGEST:
        plain = f"{plain[:LONGEST]}_{hashlib.sha256(str(request).encode()).hexdigest()[:8]}"
    return f"{name}__{re.sub('_+', '_', plain)}"


def is_rewritable(name: str, of: str | None) -> bool:
    """True when a function is the same however the bodies are described."""
    if FUNCTIONS[name].of == "function":
        name = request_of(of or "").function
    return FUNCTIONS[name].rewritable


def about(name: str, of: str | None) -> str:
    """One line for the reader of the C."""
    row = FUNCTIONS[name]
    return f"{row.about} {of}" if row.of == "function" else row.about


def blocks_of(wrt: str | Sequence[str]) -> tuple[str, ...]:
    """Blocks by which a function is differentiated.

    Raises:
        DerivationError: nothing.
    """
    if not len(wrt):
        raise DerivationError("derivative: wrt is empty; name a block such as 'q'")
    return (wrt,) if isinstance(wrt, str) else tuple(wrt)


def check(name: str, of: str | None) -> None:
    """Check the request for a function.

    Raises:
        DerivationError: there is none of that name, or it takes a frame or joint and has none.
    """
    if name not in FUNCTIONS:
        raise DerivationError(f"function '{name}' does not exist.{near(name, FUNCTIONS)}")
    kind = FUNCTIONS[name].of
    if bool(kind) != (of is not None):
        if kind:
            raise DerivationError(f"function '{name}' needs a {kind}: name it with of=")
        raise DerivationError(f"function '{name}' takes no frame or joint: leave out of='{of}'")


def missing(system: System, name: str) -> str:
    """Why a system has no function of a name, "" where it has one."""
    for joint in system.joints:
        if name in joint.element.lacks:
            return f"'{system.name}' has no function '{name}': {joint.element.lacks[name]}"
    unmet = (_unmet(system, name, need) for need in FUNCTIONS[name].needs)
    return next(filter(None, unmet), "")


def _unmet(system: System, name: str, need: str) -> str:
    """Why a system has not what a function needs, "" where it has."""
    if need == "constraints" and not system.closed:
        return (
            f"function '{name}' is one of systems with constraints; nothing binds the speeds of "
            f"'{system.name}'"
        )
    pulls = [force for force in system.forces if force.element.masses() is not None]
    if need == "linear" and pulls:
        return (
            f"'{system.name}' has no function '{name}': force '{pulls[0].name}' "
            f"({pulls[0].element.kind}) acts on masses where their centers are, and is not linear "
            "in first moments and inertias. Take the force out to identify the bodies"
        )
    friction = friction_forces(system) if system.cuts or system.constraints else []
    if need == "known friction" and friction:
        return (
            f"'{system.name}' has no function '{name}': the friction of '{friction[0].name}' "
            "follows from reactions, which accelerations alone do not determine in closed loops"
        )
    if need == "element forces" and not any(named_forces(system)):
        return f"function '{name}' is one of systems with force elements; '{system.name}' has none"
    if need == "internal states" and not system.nz:
        return (
            f"function '{name}' is one of systems with internal states; nothing in "
            f"'{system.name}' has any"
        )
    if need == "events" and not system.events:
        return (
            f"function '{name}' is one of systems with events; nothing in '{system.name}' has any"
        )
    if need == "closed form" and not system.closures:
        return (
            f"function '{name}' is one of systems with loops in closed form, as "
            f"derive(constraints='closed_form') makes them; '{system.name}' has none"
        )
    return ""
