"""The functions of what binds the speeds of a system."""

from __future__ import annotations

from ...elements.joints.joint import entries
from ...ir.function import Output
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ..functions.context import Context, recipe
from .constraints import VELOCITY


def _rows(c: Context, positions: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the residuals at position level, or at velocity level of all."""
    rows = c.d.constraints.rows
    if positions:
        rows = rows[: c.d.constraints.positions]
        return tuple(r.name for r in rows), tuple(r.unit for r in rows)
    units = (r.unit if r.level == VELOCITY else f"{r.unit or '1'}/s" for r in rows)
    return tuple(r.name for r in rows), tuple(units)


@recipe
def dependents(c: Context) -> tuple[Output, ...]:
    system, by_block = c.k.system, dict[str, tuple[list[str], list[int], list[str]]]()
    for block, values in (("q", c.k.coordinates), ("u", c.k.speeds)):
        names, nodes, units = by_block[block] = [], [], []
        for i, joint in enumerate(system.joints):
            if joint.closure >= 0:
                parts = joint.element.coordinates if block == "q" else joint.element.speeds
                head = joint.name if block == "q" else f"{joint.name}.u"
                names += entries(head, parts)
                nodes += values[i].nodes
                units += [part.unit for part in parts]
    return tuple(
        Output(block, (len(nodes),), tuple(nodes), tuple(names), tuple(units))
        for block, (names, nodes, units) in by_block.items()
    )


@recipe
def constraints(c: Context) -> tuple[Output, ...]:
    g = c.d.constraints.position
    return (Output("g", (g.rows,), g.nodes, *_rows(c, True)),)


@recipe
def constraint_rates(c: Context) -> tuple[Output, ...]:
    rates = c.d.constraints.rates
    return (Output("rates", (rates.rows,), rates.nodes, *_rows(c, False)),)


@recipe
def constraint_jacobian(c: Context) -> tuple[Output, ...]:
    G = c.d.constraints.jacobian
    names = tuple(f"{r.name},{u}" for r in c.d.constraints.rows for u in c.names["u"])
    return (Output("G", (G.rows, G.columns), G.nodes, names),)


@recipe
def constraint_bias(c: Context) -> tuple[Output, ...]:
    gamma, rows = c.d.constraints.gamma, c.d.constraints.rows
    # a row of positions is differentiated twice, one of velocities once
    units = tuple(f"{r.unit or '1'}/s{'' if r.level == VELOCITY else '^2'}" for r in rows)
    return (Output("gamma", (gamma.rows,), gamma.nodes, tuple(r.name for r in rows), units),)


@recipe
def closure(c: Context) -> tuple[Output, ...]:
    cuts = c.k.system.cuts
    names = tuple(f"{cut.name}.{h.name}" for cut in cuts for h in cut.element.locked)
    units = tuple(h.unit for cut in cuts for h in cut.element.locked)
    return (Output("closure", (len(names),), c.d.constraints.closure.nodes, names, units),)


@recipe
def assembly_signs(c: Context) -> tuple[Output, ...]:
    owners, numbers = c.d.constraints.assembly_signs
    names = tuple(f"{owner}.assembly_sign{k}" for k, owner in enumerate(owners))
    return (Output("assembly_signs", (len(names),), numbers.nodes, names),)


@recipe
def multipliers(c: Context) -> tuple[Output, ...]:
    _, lam = c.d.bound(c.d.tau)
    rows = c.d.constraints.rows
    names, units = tuple(r.name for r in rows), tuple(r.force_unit for r in rows)
    return (Output("lam", (lam.rows,), lam.nodes, names, units),)


@recipe
def close_position(c: Context) -> tuple[Output, ...]:
    constraints, g = c.d.constraints, c.d.constraints.position
    jacobian = constraints.jacobian.block(slice(0, constraints.positions))
    step = c.d.projected(c.d.mass_matrix, jacobian, g)
    nodes = [ZERO] * c.k.system.nq
    for i, joint in enumerate(c.k.system.joints):
        if joint.q >= 0:
            du = step.block(slice(joint.u, joint.u + len(joint.element.speeds)))
            moved = joint.element.integrate(c.k.coordinates[i], du, **c.k.data[i])
            nodes[joint.q : joint.q + moved.rows] = moved.nodes
    moved = Matrix(c.k.graph, len(nodes), 1, nodes)
    return (*c.vector("q", moved, "q"), Output("g", (g.rows,), g.nodes, *_rows(c, True)))


@recipe
def close_velocity(c: Context) -> tuple[Output, ...]:
    constraints = c.d.constraints
    speeds = c.d.block("u", c.k.system.nu)
    moved = speeds + c.d.projected(c.d.mass_matrix, constraints.jacobian, constraints.rates)
    rates = Output("rates", (constraints.rates.rows,), constraints.rates.nodes, *_rows(c, False))
    return (*c.vector("u", moved, "u"), rates)
