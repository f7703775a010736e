"""Derivatives of the functions of a system.

What follows from expressions alone is differentiated as it stands. Inverse dynamics has a recursion
of its own. Accelerations are never differentiated through their algorithm: along any direction,
M dudot = dtau - d(inverse dynamics) at the udot of the solution.

Source: Carpentier and Mansard, Robotics: Science and Systems (2018), section III.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import prod

from ...errors import DerivationError, near
from ...ir.derivative import directional
from ...ir.function import Output
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...ir.solve import solve
from ...schema.blocks import COORDINATES
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS
from ...schema.request import Request
from ..constraints.reaction_friction import friction_forces
from ..constraints.treatments import Bound
from ..constraints.treatments.treatment import by_multipliers
from .context import RECIPES, Context, recipe, settled
from .coordinate_columns import Shares, along_coordinates, combined
from .directions import Direction, directions, is_single
from .dynamics import Dynamics
from .newton_euler_derivatives import Derivatives


def request_of(text: str) -> Request:
    """A derivative by its line of text.

    Raises:
        DerivationError: it cannot be read, or there is no such function.
    """
    try:
        request = Request.read(text)
    except ValueError as problem:
        raise DerivationError(f"derivative: {problem}") from problem
    if request.function not in DIFFERENTIABLE:
        raise DerivationError(
            f"derivative of '{request.function}' does not exist."
            f"{near(request.function, DIFFERENTIABLE)}"
        )
    return request


@recipe
def derivative(c: Context) -> tuple[Output, ...]:
    """Results of a derivative: one per block or name, the axis of columns last."""
    request = request_of(c.of or "")
    kind = FUNCTIONS[request.function].of
    if bool(kind) != (request.of is not None):
        expected = f"needs a {kind}" if kind else "takes no frame or joint"
        raise DerivationError(f"derivative: '{request.function}' {expected}: '{request}'")
    c = with_mass_matrix(c)
    parts = {wrt: _columns(c, wrt) for wrt in request.wrt}
    flat = [d for along, _ in parts.values() for d in along]
    outputs = settled(c, RECIPES[request.function](replace(c, of=request.of)))
    columns = columns_of(c, request.function, outputs, flat)
    shape = outputs[0].shape if len(outputs) == 1 else (sum(o.size for o in outputs),)
    rows, outputs_by_block, start = [name for o in outputs for name in _entries(o)], [], 0
    for wrt, (along, shares) in parts.items():
        block_columns = columns[start : start + len(along)]
        start += len(along)
        labels = [d.name for d in along]
        if shares is not None:
            block_columns, labels = combined(c.k.graph, block_columns, shares), [*c.names["q"]]
        full_shape = shape if is_single(wrt) else (*shape, len(labels))
        nodes = tuple(column[i] for i in range(prod(shape)) for column in block_columns)
        names = tuple(f"{row},{label}" for row in rows for label in labels)
        outputs_by_block.append(Output(f"d_{wrt}", full_shape, nodes, names))
    return tuple(outputs_by_block)


def _columns(c: Context, wrt: str) -> tuple[list[Direction], list[Shares] | None]:
    """Directions to differentiate along, and what columns are made of them if not the same."""
    return along_coordinates(c) if wrt == COORDINATES else (directions(c.k, wrt, c.names), None)


def with_mass_matrix(c: Context) -> Context:
    """The same by a formalism that has M: it is needed, and with it udot is one column more."""
    return c if c.d.formalism.forward is None else replace(c, d=Dynamics(c.k, "composite"))


def _entries(output: Output) -> list[str]:
    if len(output.entries) == output.size:
        return list(output.entries)
    return [f"{output.name}[{k}]" for k in range(output.size)]


def columns_of(
    c: Context, function: str, outputs: Sequence[Output], along: Sequence[Direction]
) -> list[list[int]]:
    """Changes of all entries of the outputs, direction by direction."""
    # friction that follows from reactions moves with everything they depend on
    if function == "inverse_dynamics" and not friction_forces(c.k.system):
        return inverse_columns(c, along)
    seeds = [dict(d.seeds) for d in along]
    for tau, udot, multipliers in c.d.solutions:
        solved_nodes = (*udot.nodes, *multipliers.nodes)
        columns = forward_columns(c, tau, udot, multipliers, along)
        for seeds_of_column, column in zip(seeds, columns, strict=True):
            pairs = zip(solved_nodes, column, strict=True)
            seeds_of_column |= {
                node: change for node, change in pairs if c.k.graph.value(node) is None
            }
    roots = [node for output in outputs for node in output.nodes]
    return directional(c.k.graph, roots, seeds)


def forward_columns(
    c: Context, tau: Matrix, udot: Matrix, multipliers: Matrix, along: Sequence[Direction]
) -> list[list[int]]:
    """Changes of udot under tau, and of the multipliers."""
    g, nu = c.k.graph, c.k.system.nu
    if not nu:
        return [[] for _ in along]
    forces = directional(g, tau.nodes, [d.seeds for d in along])
    # udot is an argument of others, and tau none of inverse dynamics
    foreign = ("tau", "udot")
    inner = inverse_columns(c, [d for d in along if d.block not in foreign])
    # at the accelerations of the solution
    flat = [node for column in inner for node in column]
    there = dict(zip(c.udot.nodes, udot.nodes, strict=True))
    flat = list(rebuild(g, flat, there, into=g)[1])
    needed, columns = iter(range(0, len(flat), nu)), []
    for d, force in zip(along, forces, strict=True):
        start = None if d.block in foreign else next(needed)
        initial = [ZERO] * nu if start is None else flat[start : start + nu]
        columns.append([g.sub(a, b) for a, b in zip(force, initial, strict=True)])
    if not columns:
        return columns
    right = Matrix(g, nu, len(columns), [column[i] for i in range(nu) for column in columns])
    if multipliers.rows:
        return _bound_columns(c, udot, multipliers, right, along)
    with g.made_by("M", "factor"):
        solution = solve("spd", c.d.mass_matrix, right)
    return [list(solution.column(n).nodes) for n in range(len(columns))]


def _bound_columns(
    c: Context, udot: Matrix, multipliers: Matrix, right: Matrix, along: Sequence[Direction]
) -> list[list[int]]:
    """Changes of udot and the multipliers of a system with constraints.

    M udot' - Gᵀ lam' = right + (Gᵀ)' lam and G udot' = gamma' - G' udot.
    """
    g, constraints = c.k.graph, c.d.constraints
    count, G = len(along), constraints.jacobian
    multiplier_atoms = Matrix(g, G.rows, 1, [g.atom(f"multiplier {i}") for i in range(G.rows)])
    # udot and multipliers are leaves while the rest is differentiated
    force, missing = G.T @ multiplier_atoms, constraints.gamma - G @ c.udot
    seeds = [d.seeds if d.block not in ("tau", "udot") else {} for d in along]
    changes = directional(g, (*force.nodes, *missing.nodes), seeds)
    flat = [changes[n][i] for i in range(force.rows + missing.rows) for n in range(count)]
    values = zip(
        (*c.udot.nodes, *multiplier_atoms.nodes), (*udot.nodes, *multipliers.nodes), strict=True
    )
    flat = list(rebuild(g, flat, dict(values), into=g)[1])
    size = force.rows * count
    drive = right + Matrix(g, force.rows, count, flat[:size])
    gamma = Matrix(g, missing.rows, count, flat[size:])
    nothing = Matrix.zeros(g, 0)
    with g.made_by("constraints", "derivative"):
        problem = Bound(c.d.mass_matrix, drive, G, gamma, nothing, nothing)
        solution = Matrix.vstack(*by_multipliers(problem, gamma))
    return [list(solution.column(n).nodes) for n in range(count)]


def inverse_columns(c: Context, along: Sequence[Direction]) -> list[list[int]]:
    """Changes of inverse dynamics: q and u by the recursion, udot by M, the rest as it stands."""
    result: dict[int, list[int]] = {}
    recursive = [] if c.k.chosen else [n for n, d in enumerate(along) if d.block in ("q", "u")]
    if recursive:
        picked = [along[n] for n in recursive]
        columns = Derivatives(c.k, c.udot, c.d.loads, c.d.gravity, picked).columns()
        result |= dict(zip(recursive, columns, strict=True))
    for n, d in enumerate(along):
        if d.block == "udot":
            result[n] = list(c.d.mass_matrix.column(d.index).nodes)
    remaining = [n for n in range(len(along)) if n not in result]
    if remaining:
        roots = c.d.inverse(c.udot).nodes
        columns = directional(c.k.graph, roots, [along[n].seeds for n in remaining])
        result |= dict(zip(remaining, columns, strict=True))
    return [result[n] for n in range(len(along))]
