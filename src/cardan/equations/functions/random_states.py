"""States drawn by chance that a system can be in, and what it does there, without compiled code."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arrays import Array
from ...ir.function import Function, Output
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...records import dataclass
from ..constraints.feasibility import CLOSED, search
from ..kinematics.kinematics import Kinematics
from . import blocks
from .context import Context, settled
from .dynamics import Dynamics

if TYPE_CHECKING:
    from ..record import EquationRecord

# equations of constraint that follow from others
DEPENDENT = 1e-9


@dataclass(frozen=True)
class States:
    """Places where expressions are looked at: block -> (n, entries), consistent with what binds.

    ``count`` is n; it may be smaller than asked for, where loops do not close everywhere.
    """

    values: dict[str, Array]
    count: int

    def of(self, function: Function) -> dict[str, Array]:
        """Output -> (n, *shape); places where it is not finite give NaN."""
        results = evaluate(function, self.values, "numpy")
        return {
            output.name: np.broadcast_to(
                np.asarray(results[output.name], dtype=np.float64), (self.count, *output.shape)
            )
            for output in function.outputs
        }


def context_of(equations: EquationRecord) -> Context:
    """Fresh expressions of the equations, by the formalism that takes every system."""
    method = "kane" if equations.chosen else "composite"
    names = {b.name: b.entries for b in equations.blocks.values()}
    units = {b.name: b.units for b in equations.blocks.values()}
    k = Kinematics(equations.system, equations.chosen)
    return Context(Dynamics(k, method), names, units)


def function_of(
    equations: EquationRecord, c: Context, named: dict[str, Matrix], friction: bool = True
) -> Function:
    """Matrices as one function of all blocks."""
    results = tuple(Output(n, (m.rows, m.columns), m.nodes) for n, m in named.items())
    results = settled(c, results) if friction else results
    return Function("values", c.k.graph, tuple(equations.blocks.values()), results)


def drawn(
    equations: EquationRecord, count: int, rng: np.random.Generator, base: dict[str, Array]
) -> States:
    """States with coordinates anywhere, speeds that the constraints allow, and accelerations.

    Args:
        equations: Of the system.
        count: How many.
        rng: Says which.
        base: Blocks ``p r z s`` and ``t``, each (entries) or (count, entries).
    """
    system = equations.system
    values: dict[str, Any] = {**base}
    q = np.array([default for _, _, default in blocks.coordinates(system)])
    for joint in system.joints:
        if joint.q >= 0 and joint.q0 is not None:
            q[joint.q : joint.q + len(joint.q0)] = joint.q0
    step = rng.normal(0.0, 0.8, (count, system.nu))
    plain = type(equations)(system, equations.method, treatment=equations.treatment)
    moved = evaluate(plain.function("integrate"), {**values, "q": q, "du": step}, "numpy")["q"]
    values["q"] = np.broadcast_to(moved, (count, len(q))).astype(np.float64)
    values["u"] = rng.normal(0.0, 1.0, (count, system.nu))
    c = context_of(equations)
    if system.closed:
        values, count = _closed(plain, values, count)
    states = States(values, count)
    if count:
        _consistent(equations, c, states)
    return states


def _closed(
    plain: EquationRecord, values: dict[str, Any], count: int
) -> tuple[dict[str, Any], int]:
    """The states moved onto the constraints; those that do not get there are left out."""
    functions = {n: plain.function(n) for n in ("constraints", "constraint_jacobian", "integrate")}
    with np.errstate(all="ignore"):
        values["q"] = search(functions, values, values["q"])
    g = np.asarray(evaluate(functions["constraints"], values, "numpy")["g"], dtype=np.float64)
    g = np.broadcast_to(g, (count, g.shape[-1]))
    closed = (np.abs(g) < CLOSED * 1e-3).all(axis=-1) & np.isfinite(values["q"]).all(axis=-1)
    chosen = {
        name: x[closed] if np.ndim(x) == 2 and len(x) == count else x for name, x in values.items()
    }
    return chosen, int(closed.sum())


def _consistent(equations: EquationRecord, c: Context, states: States) -> None:
    """Speeds that the constraints allow, then accelerations under the model's own forces."""
    d, closed = c.d, equations.system.closed
    named = {"M": d.mass_matrix, "drive": d.forces() - d.bias()}
    if closed:
        constraints = d.constraints
        expressions = {"G": constraints.jacobian, "rates": constraints.rates}
        results = states.of(function_of(equations, c, expressions, friction=False))
        with np.errstate(all="ignore"):
            jacobian = np.nan_to_num(results["G"])
            step = np.linalg.pinv(jacobian, rcond=DEPENDENT) @ np.nan_to_num(results["rates"])
        states.values["u"] = states.values["u"] - step[..., 0]
        named |= {"G": constraints.jacobian, "gamma": constraints.gamma}
    results = {n: np.nan_to_num(x) for n, x in states.of(function_of(equations, c, named)).items()}
    # in units in which every speed has mass 1 and every constraint length 1
    units = 1.0 / np.sqrt(divisors(np.diagonal(results["M"], axis1=1, axis2=2)))[..., np.newaxis]
    mass, right = units * results["M"] * np.swapaxes(units, 1, 2), units * results["drive"]
    if closed:
        G, n, m = results["G"] * np.swapaxes(units, 1, 2), mass.shape[-1], results["G"].shape[-2]
        sizes = divisors(np.linalg.norm(G, axis=-1, keepdims=True))
        rows, G = np.zeros((states.count, n + m, n + m)), G / sizes
        rows[:, :n, :n], rows[:, :n, n:], rows[:, n:, :n] = mass, np.swapaxes(G, 1, 2), G
        mass, right = rows, np.concatenate([right, results["gamma"] / sizes], axis=1)
    solved = np.linalg.pinv(mass, rcond=1e-12, hermitian=True) @ right
    states.values["udot"] = (units * solved[:, : equations.system.nu])[..., 0]


def divisors(sizes: Array) -> Array:
    """Sizes to divide by: 1 for what has none."""
    return np.where(sizes > 0.0, sizes, 1.0)
