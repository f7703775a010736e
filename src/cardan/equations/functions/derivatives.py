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
from ...records import dataclass
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

# blocks that accelerations are found under, or that others read in their place
FOREIGN = ("tau", "udot")


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


@dataclass(frozen=True)
class Columns:
    """Columns of a derivative along one block, or one parameter or input.

    Attributes:
        wrt: Which.
        along: Directions to differentiate along.
        shares: What columns are made of those along the directions; None where they are the same.
        labels: Names of the columns.
    """

    wrt: str
    along: list[Direction]
    shares: list[Shares] | None
    labels: tuple[str, ...]


@dataclass(frozen=True)
class Problem:
    """A function that is to be differentiated.

    Attributes:
        c: Context, by a formalism that has M.
        function: Name of the function.
        outputs: Its results.
        parts: What it is differentiated by, in order.
    """

    c: Context
    function: str
    outputs: tuple[Output, ...]
    parts: list[Columns]

    @property
    def along(self) -> list[Direction]:
        """Directions of all parts."""
        return [d for part in self.parts for d in part.along]

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the result; of several one after the other."""
        outputs = self.outputs
        return outputs[0].shape if len(outputs) == 1 else (sum(o.size for o in outputs),)

    @property
    def rows(self) -> tuple[str, ...]:
        """Names of the entries of the result."""
        return tuple(name for output in self.outputs for name in _entries(output))

    @property
    def nodes(self) -> list[int]:
        """The entries of the result."""
        return [node for output in self.outputs for node in output.nodes]


def problem_of(c: Context) -> Problem:
    """What the text ``c.of`` asks for.

    Raises:
        DerivationError: it cannot be read, or what it names does not exist.
    """
    request = request_of(c.of or "")
    kind = FUNCTIONS[request.function].of
    if bool(kind) != (request.of is not None):
        expected = f"needs a {kind}" if kind else "takes no frame or joint"
        raise DerivationError(f"derivative: '{request.function}' {expected}: '{request}'")
    c = with_mass_matrix(c)
    parts = [_columns(c, wrt) for wrt in request.wrt]
    outputs = settled(c, RECIPES[request.function](replace(c, of=request.of)))
    return Problem(c, request.function, outputs, parts)


@recipe
def derivative(c: Context) -> tuple[Output, ...]:
    """Results of a derivative: one per block or name, the axis of columns last."""
    problem = problem_of(c)
    columns = columns_of(problem.c, problem.function, problem.outputs, problem.along)
    results, start = [], 0
    for part in problem.parts:
        block = columns[start : start + len(part.along)]
        start += len(part.along)
        if part.shares is not None:
            block = combined(c.k.graph, block, part.shares)
        shape = problem.shape if is_single(part.wrt) else (*problem.shape, len(part.labels))
        nodes = tuple(column[i] for i in range(prod(problem.shape)) for column in block)
        names = tuple(f"{row},{label}" for row in problem.rows for label in part.labels)
        results.append(Output(f"d_{part.wrt}", shape, nodes, names))
    return tuple(results)


def _columns(c: Context, wrt: str) -> Columns:
    if wrt == COORDINATES:
        return Columns(wrt, *along_coordinates(c), c.names["q"])
    along = directions(c.k, wrt, c.names)
    return Columns(wrt, along, None, tuple(d.name for d in along))


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
    within = [_within(c, d) for d in along]
    inner = inverse_columns(c, [d for d in within if d is not None])
    # at the accelerations of the solution
    flat = [node for column in inner for node in column]
    there = dict(zip(c.udot.nodes, udot.nodes, strict=True))
    flat = list(rebuild(g, flat, there, into=g)[1])
    needed, columns = iter(range(0, len(flat), nu)), []
    for d, force in zip(within, forces, strict=True):
        start = None if d is None else next(needed)
        initial = [ZERO] * nu if start is None else flat[start : start + nu]
        columns.append([g.sub(a, b) for a, b in zip(force, initial, strict=True)])
    if multipliers.rows:
        right = Matrix(g, nu, len(columns), [column[i] for i in range(nu) for column in columns])
        return _bound_columns(c, udot, multipliers, right, along) if columns else columns
    # what moves nothing, such as the place along a rail, stays known to be 0
    moving = [n for n, column in enumerate(columns) if any(node != ZERO for node in column)]
    if moving:
        nodes = [columns[n][i] for i in range(nu) for n in moving]
        with g.made_by("M", "factor"):
            solution = solve("spd", c.d.mass_matrix, Matrix(g, nu, len(moving), nodes))
        for k, n in enumerate(moving):
            columns[n] = list(solution.column(k).nodes)
    return columns


def _within(c: Context, d: Direction) -> Direction | None:
    """A direction as inverse dynamics at the udot of the solution knows it; None where not at all.

    udot is an argument of others, and tau none of inverse dynamics.
    """
    if d.block in FOREIGN:
        return None
    foreign = {*c.udot.nodes, *c.d.tau.nodes}
    if foreign.isdisjoint(d.seeds):
        return d
    seeds = {leaf: change for leaf, change in d.seeds.items() if leaf not in foreign}
    return replace(d, seeds=seeds) if seeds else None


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
    within = [_within(c, d) for d in along]
    seeds = [{} if d is None else d.seeds for d in within]
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
