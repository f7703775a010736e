"""Motion as methods for differential-algebraic equations take it: residuals, their exact tangents,
and the way coordinates move.

M udot + h - f - Gᵀ lam = 0, g = 0, G u + g_t = 0; nothing is solved for. Coordinates move along the
speeds by finite increments, rotations through the exponential.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), section 4.6 (tangent operator) and
chapter 12.
"""

from __future__ import annotations

from ...ir.derivative import directional
from ...ir.function import Output
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ..constraints.constraint_functions import constraint_rates, constraints
from ..constraints.reaction_friction import friction_forces
from ..kinematics.increments import integrated
from ..kinematics.loads import strained
from ..kinematics.partial_velocities import generalized_forces
from .context import Context, recipe, settled
from .derivatives import columns_of, inverse_columns
from .directions import Direction, directions


def _constraint_forces(c: Context) -> Matrix:
    """Gᵀ lam (nu, 1)."""
    jacobian = c.d.constraints.jacobian
    return jacobian.T @ c.d.block("lam", jacobian.rows)


@recipe
def balance(c: Context) -> tuple[Output, ...]:
    """M udot + h - f - Gᵀ lam, then g and G u + g_t."""
    force = c.d.inverse(c.udot)
    if not c.k.system.closed:
        return c.vector("balance", force, "tau")
    moved = c.vector("balance", force - _constraint_forces(c), "tau")
    return (*moved, *constraints(c), *constraint_rates(c))


@recipe
def balance_tangent(c: Context) -> tuple[Output, ...]:
    """Derivatives of the balance along q, u and udot, those of the rates along q, and G."""
    g, nu = c.k.graph, c.k.system.nu
    along = {wrt: directions(c.k, wrt, c.names) for wrt in ("q", "u")}
    flat = [*along["q"], *along["u"]]
    columns = _force_columns(c, flat)
    speeds, rows = c.names["u"], tuple(row.name for row in c.d.constraints.rows)
    bound: tuple[Output, ...] = ()
    if c.k.system.closed:
        constraints = c.d.constraints
        seeds = [d.seeds for d in flat]
        forces = directional(g, _constraint_forces(c).nodes, seeds)
        pairs = zip(columns, forces, strict=True)
        columns = [[g.sub(a, b) for a, b in zip(*pair, strict=True)] for pair in pairs]
        rate_slopes = directional(g, constraints.rates.nodes, seeds[:nu])
        bound = (
            _square("R", rows, speeds, rate_slopes),
            Output("G", (len(rows), nu), constraints.jacobian.nodes, _named(rows, speeds)),
        )
    mass = c.d.mass_matrix
    return (
        _square("K", speeds, speeds, columns[:nu]),
        _square("C", speeds, speeds, columns[nu:]),
        Output("M", (nu, nu), mass.nodes, _named(speeds, speeds)),
        *bound,
    )


@recipe
def strain_energy(c: Context) -> tuple[Output, ...]:
    """Energy of all strains."""
    value = strained(c.k)[1]
    return (Output("strain_energy", (), (value.node,), ("strain_energy",), ("J",)),)


@recipe
def strain_balance(c: Context) -> tuple[Output, ...]:
    """Forces that strains withstand, less those of the constraints, then g."""
    force = -generalized_forces(c.k, strained(c.k)[0])
    if not c.k.system.closed:
        return c.vector("balance", force, "tau")
    return (*c.vector("balance", force - _constraint_forces(c), "tau"), *constraints(c))


def _force_columns(c: Context, along: list[Direction]) -> list[list[int]]:
    """Changes of M udot + h - f; friction that follows from reactions is that of the model's own
    motion, as in the balance, and changes as that does."""
    if not friction_forces(c.k.system):
        return inverse_columns(c, along)
    force = settled(c, c.vector("balance", c.d.inverse(c.udot), "tau"))
    return columns_of(c, "balance", force, along)


def _named(rows: tuple[str, ...], columns: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(f"{a},{b}" for a in rows for b in columns)


def _square(
    name: str, rows: tuple[str, ...], names: tuple[str, ...], columns: list[list[int]]
) -> Output:
    """A matrix from its columns."""
    nodes = tuple(column[i] for i in range(len(rows)) for column in columns)
    return Output(name, (len(rows), len(names)), nodes, _named(rows, names))


@recipe
def move(c: Context) -> tuple[Output, ...]:
    """q moved by du, and T: a change of du moves the result along the speeds by T times it."""
    system = c.k.system
    step, nodes = c.d.block("du", system.nu), [ZERO] * system.nu**2
    for joint in system.joints:
        if joint.u >= 0:
            size = len(joint.element.speeds)
            tangent_map = joint.element.tangent(step.block(slice(joint.u, joint.u + size)))
            for i in range(size):
                start = (joint.u + i) * system.nu + joint.u
                nodes[start : start + size] = tangent_map.row(i)
    speeds = c.names["u"]
    tangent = Output("T", (system.nu, system.nu), tuple(nodes), _named(speeds, speeds))
    return (*c.vector("q", integrated(c.d), "q"), tangent)
