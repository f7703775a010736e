"""Check before any code is written that the loops of a system can close at all.

Residuals and Jacobian are evaluated as expressions, for several starts at once; every start goes
towards the constraints by steps of least length (Gauss and Newton).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...ir.function import Function
from ...ir.interpreter import evaluate
from ...records import dataclass
from ..functions import blocks

if TYPE_CHECKING:
    from ..record import EquationRecord

STARTS, STEPS = 12, 60
LONGEST = 0.5  # of a step [rad, m]
# residuals that are sought, and those that count as closed: rounded lengths leave as much
SOUGHT, CLOSED = 1e-11, 1e-6


@dataclass(frozen=True)
class Feasibility:
    """Smallest gaps of the loops of a system at its default parameters.

    Attributes:
        q: The coordinates that come nearest (nq,).
        gaps: Joint or relation -> the largest residual that is left there, and its unit.
        relations: Those of the gaps that the user wrote.
    """

    q: Array
    gaps: dict[str, tuple[float, str]]
    relations: tuple[str, ...] = ()

    @property
    def closes(self) -> bool:
        """True when everything closes."""
        return all(gap <= CLOSED for gap, _ in self.gaps.values())

    def __str__(self) -> str:
        if self.closes:
            return "all loops close"
        worst = max(self.gaps, key=lambda name: self.gaps[name][0])
        gap, unit = self.gaps[worst]
        written = worst in self.relations
        who = f"constraint '{worst}'" if written else f"the loop that '{worst}' closes"
        other_relations = [f"'{name}'" for name in self.relations if name != worst]
        note = (
            f", or at constraint {', '.join(other_relations)}, which must hold as well"
            if other_relations
            else ""
        )
        look = "its expression and numbers" if written else "the lengths and axes of its joints"
        return (
            f"{who} stays open: the least residual found is {f'{gap:.2g} {unit}'.strip()}, from "
            f"{STARTS} starts. Look at {look}{note}"
        )


def feasibility(equations: EquationRecord, seed: int = 1) -> Feasibility:
    """Try to close all loops at the default parameters.

    Args:
        equations: Of a system with constraints.
        seed: Of the starts beside the initial values.
    """
    system = equations.system
    # coordinates are moved along the speeds of the joints, whatever speeds are chosen
    if equations.chosen:
        equations = type(equations)(system, equations.method, treatment=equations.treatment)
    functions = {
        name: equations.function(name)
        for name in ("constraints", "constraint_jacobian", "integrate", "closure")
    }
    start = np.array([default for _, _, default in blocks.coordinates(system)])
    for joint in system.joints:
        if joint.q >= 0 and joint.q0 is not None:
            start[joint.q : joint.q + len(joint.q0)] = joint.q0
    defaults = blocks.defaults(system)
    first = search(functions, defaults, start[np.newaxis])
    closing = _gaps(equations, functions, defaults, first)
    if closing.closes or not system.nu:
        return closing
    offsets = np.random.default_rng(seed).normal(0.0, 1.0, (STARTS - 1, system.nu))
    moved = evaluate(functions["integrate"], {**defaults, "q": start, "du": offsets}, "numpy")["q"]
    attempts = search(functions, defaults, np.atleast_2d(moved))
    tried = [_gaps(equations, functions, defaults, q[np.newaxis]) for q in (*attempts, first[0])]
    # the first that closes, whatever rounding leaves of its residuals
    closed = [one for one in tried if one.closes]
    return closed[0] if closed else min(tried, key=lambda one: max(g for g, _ in one.gaps.values()))


def search(functions: dict[str, Function], defaults: dict[str, Any], q: Array) -> Array:
    """Coordinates (n, nq) after steps towards the constraints."""
    for _ in range(STEPS):
        values = {**defaults, "q": q}
        g = value(functions["constraints"], values, len(q))
        if g.shape[-1] == 0 or np.abs(g).max() <= SOUGHT:
            break
        G = value(functions["constraint_jacobian"], values, len(q))[:, : g.shape[-1]]
        step = -(np.linalg.pinv(G, rcond=1e-5) @ g[..., np.newaxis])[..., 0]
        size = np.abs(step).max(axis=-1, keepdims=True)
        step *= np.minimum(1.0, LONGEST / np.maximum(size, LONGEST))
        moved = evaluate(functions["integrate"], {**defaults, "q": q, "du": step}, "numpy")["q"]
        q = np.broadcast_to(moved, q.shape).astype(np.float64)
    return q


def value(function: Function, values: dict[str, Any], count: int) -> Array:
    """The only result of a function for all starts."""
    (result,) = evaluate(function, values, "numpy").values()
    shape = function.outputs[0].shape
    return np.broadcast_to(np.asarray(result, dtype=np.float64), (count, *shape))


def _gaps(
    equations: EquationRecord, functions: dict[str, Function], defaults: dict[str, Any], q: Array
) -> Feasibility:
    """Gaps left at one place; conditions that follow from others are checked too."""
    values, gaps = {**defaults, "q": q}, dict[str, tuple[float, str]]()
    for name in ("closure", "constraints"):
        output = functions[name].outputs[0]
        residuals = value(functions[name], values, 1)[0]
        for entry, unit, residual in zip(output.entries, output.units, residuals, strict=True):
            owner = _owner(equations, entry)
            size = abs(float(residual)) if np.isfinite(residual) else np.inf
            if size >= gaps.get(owner, (0.0, ""))[0]:
                gaps[owner] = (size, unit or "")
    written = tuple(entry.name for entry in equations.system.constraints)
    return Feasibility(q[0].copy(), gaps, written)


def _owner(equations: EquationRecord, entry: str) -> str:
    """The cut joint or relation that a residual belongs to."""
    cuts = [cut.name for cut in equations.system.cuts]
    return next((name for name in cuts if entry.startswith(f"{name}.")), entry)
