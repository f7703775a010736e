"""All functions of a system: those of :mod:`.functions` and their derivatives."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence

from ..errors import DerivationError, near
from ..topology.system import System
from . import balance, blocks, functions
from .context import Recipe
from .derivatives import derivative, request_of
from .directions import BLOCKS
from .rhs_jacobian import rhs_jacobian

RECIPES: dict[str, Recipe] = functions.RECIPES | {
    "balance": Recipe("M udot + h - f - Gᵀ lam, then g and G u + g_t", balance.balance, told=True),
    "balance_tangent": Recipe(
        "derivatives of the balance along q, u, udot, of the rates along q, and G",
        balance.balance_tangent,
        told=True,
    ),
    "move": Recipe("q moved by the increment du along the speeds, and its tangent", balance.move),
    "derivative": Recipe("derivative, q along the speeds, of", derivative, "function"),
    "rhs_jacobian": Recipe(
        "d rhs / d x, / d t and / d r, x as it is stored", rhs_jacobian, told=True
    ),
}
# functions that displace bodies as a whole
DIFFERENTIATED = ("derivative", "rhs_jacobian", "balance_tangent")
# characters of a C name before it is cut
LONGEST = 80


def c_name(system: System, name: str, of: str | None) -> str:
    """C name of a function.

    Raises:
        DerivationError: ``of`` names no derivative.
    """
    if not of:
        return name
    if RECIPES[name].of == "function":
        return _derivative_name(of)
    if RECIPES[name].of == "joint":
        known = [*system.moving_joints, *system.fixed]
    else:
        known = [f.name for f in system.frames]
    return blocks.c_name(name, of, known)


def _derivative_name(of: str) -> str:
    """``derivative__forward_dynamics_q_u``; with a mark where that alone would be ambiguous."""
    request = request_of(of)
    words = (request.function, *([request.of] if request.of else []), *request.wrt)
    plain = "_".join(blocks.identifier(word) for word in words)
    if request.of or not set(request.wrt) <= set(BLOCKS) or len(plain) > LONGEST:
        plain = f"{plain[:LONGEST]}_{hashlib.sha256(str(request).encode()).hexdigest()[:8]}"
    return f"derivative__{re.sub('_+', '_', plain)}"


def is_told(name: str, of: str | None) -> bool:
    """Whether a function is the same however the bodies are told; see :class:`.Recipe`."""
    if RECIPES[name].of == "function":
        return functions.RECIPES[request_of(of or "").function].told
    return RECIPES[name].told


def about(name: str, of: str | None) -> str:
    """One line for the reader of the C."""
    recipe = RECIPES[name]
    return f"{recipe.about} {of}" if recipe.of == "function" else recipe.about


def blocks_of(wrt: str | Sequence[str]) -> tuple[str, ...]:
    """What a function is differentiated by.

    Raises:
        DerivationError: nothing.
    """
    if not len(wrt):
        raise DerivationError("derivative: wrt is empty; name a block such as 'q'")
    return (wrt,) if isinstance(wrt, str) else tuple(wrt)


def check(name: str, of: str | None) -> None:
    """Whether a function is asked for as it should be.

    Raises:
        DerivationError: there is none of that name, or it takes a frame or joint and has none.
    """
    if name not in RECIPES:
        raise DerivationError(f"function '{name}' does not exist.{near(name, RECIPES)}")
    recipe = RECIPES[name]
    if bool(recipe.of) != (of is not None):
        if recipe.of:
            raise DerivationError(f"function '{name}' needs a {recipe.of}: {name}(?)")
        raise DerivationError(f"function '{name}' takes no frame or joint: leave out of='{of}'")


def missing(system: System, name: str) -> str:
    """Why a system has no function of a name, "" where it has one."""
    for joint in system.joints:
        if name in joint.element.lacks:
            return f"'{system.name}' has no function '{name}': {joint.element.lacks[name]}"
    if RECIPES[name].bound and not system.closed:
        return (
            f"function '{name}' is one of systems with constraints; nothing binds the speeds of "
            f"'{system.name}'"
        )
    pulls = [force for force in system.forces if force.element.masses() is not None]
    if RECIPES[name].linear and pulls:
        return (
            f"'{system.name}' has no function '{name}': force '{pulls[0].name}' "
            f"({pulls[0].element.kind}) acts on masses where their centers are, and is not linear "
            "in first moments and inertias. Take the force out to identify the bodies"
        )
    if RECIPES[name].happens and not system.events:
        return (
            f"function '{name}' is one of systems with events; nothing in '{system.name}' has any"
        )
    if RECIPES[name].solved and not system.closures:
        return (
            f"function '{name}' is one of systems with circuits in closed form, as "
            f"derive(constraints='closed_form') makes them; '{system.name}' has none"
        )
    return ""
