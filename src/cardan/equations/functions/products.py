"""Products with derivatives: weights times a derivative, changes along a direction, and Hessians.

Accelerations are never differentiated through their algorithm. They and the multipliers fulfil
R(x, y) = 0, inverse dynamics and constraints. Of a weighted sum phi(x, y) of results the gradient
is that of phi - mu R with mu held, where mu R_y = phi_y: one solve with the factor at hand and one
sweep in reverse. Its second derivative is that of phi - mu R along x and y together: mu need not be
differentiated, as the gradient along y vanishes.

Columns along the speeds do not commute: the Hessian is that of the function behind ``integrate``,
the mean of both orders.

Source: Griewank and Walther, Evaluating Derivatives (2008), sections 3.2 and 15.3.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ...ir.derivative import forward, gradient
from ...ir.function import Block, Output
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix, inner
from ...ir.rewrite import rebuild
from ...ir.solve import solve
from ...records import dataclass
from ...schema.blocks import COORDINATES
from ..constraints.treatments import Bound
from ..constraints.treatments.treatment import by_multipliers
from .context import Context, recipe
from .coordinate_columns import Shares, combined
from .derivatives import Columns, Problem, columns_of, forward_columns, problem_of
from .directions import Direction, is_single

# leaf -> its change
Seeds = dict[int, int]


@recipe
def vjp(c: Context) -> tuple[Output, ...]:
    """Derivatives of the weighted sum of all results: one result per block or name."""
    problem = problem_of(c)
    by_leaf = _Weighted(problem, _vector(c, problem.rows, "weight")).by_leaf()
    g, results = c.k.graph, []
    for part in problem.parts:
        columns = tuple(_along(g, by_leaf, seeds) for seeds in _fields(g, part))
        shape = () if is_single(part.wrt) else (len(columns),)
        results.append(Output(f"d_{part.wrt}", shape, columns, part.labels))
    return tuple(results)


@recipe
def jvp(c: Context) -> tuple[Output, ...]:
    """Change of the result where all that it is differentiated by changes as v says."""
    problem, g = problem_of(c), c.k.graph
    weights = _vector(c, [label for part in problem.parts for label in part.labels], "change")
    seeds: Seeds = {}
    fields = [field for part in problem.parts for field in _fields(g, part)]
    for weight, field in zip(weights, fields, strict=True):
        for leaf, change in field.items():
            seeds[leaf] = g.add(seeds.get(leaf, ZERO), g.mul(weight, change))
    (column,) = columns_of(
        problem.c, problem.function, problem.outputs, [Direction("v", 0, "v", seeds)]
    )
    return (Output("change", problem.shape, tuple(column), problem.rows),)


@recipe
def hessian(c: Context) -> tuple[Output, ...]:
    """Second derivatives of the weighted sum by all blocks together, (columns, columns)."""
    problem = problem_of(c)
    rows = _Weighted(problem, _vector(c, problem.rows, "weight")).second()
    labels = [label for part in problem.parts for label in part.labels]
    nodes = tuple(node for row in rows for node in row)
    names = tuple(f"{a},{b}" for a in labels for b in labels)
    return (Output("hessian", (len(labels), len(labels)), nodes, names),)


def _vector(c: Context, entries: Sequence[str], word: str) -> list[int]:
    """The block v of a function: the weight, or change, of every entry."""
    c.extra_blocks["v"] = Block(
        "v", tuple(f"{name}.{word}" for name in entries), ("",) * len(entries)
    )
    return [c.k.graph.var("v", n) for n in range(len(entries))]


def _fields(g: Graph, part: Columns) -> list[Seeds]:
    """What changes along every column."""
    if part.shares is None:
        return [dict(d.seeds) for d in part.along]
    return [_shared(g, [d.seeds for d in part.along], share) for share in part.shares]


def _shared(g: Graph, along: Sequence[Mapping[int, int]], share: Shares) -> Seeds:
    seeds: Seeds = {}
    for n, factor in share:
        for leaf, change in along[n].items():
            seeds[leaf] = g.add(seeds.get(leaf, ZERO), g.mul(factor, change))
    return seeds


def _along(g: Graph, by_leaf: Mapping[int, int], seeds: Mapping[int, int]) -> int:
    """Derivative along a direction from those by leaves."""
    moved = [leaf for leaf in seeds if leaf in by_leaf]
    return inner(g, [by_leaf[leaf] for leaf in moved], [seeds[leaf] for leaf in moved])


@dataclass(frozen=True)
class _Part:
    """A part of phi - mu R with its gradient.

    Attributes:
        by: Leaf -> derivative.
        solved: What stands for accelerations and multipliers.
        by_solved: Derivatives by these.
        values: Node -> what is inserted for it once the derivatives are found.
        solution: Number of the solution it belongs to; None of phi, which reads all of them.
    """

    by: dict[int, int]
    solved: tuple[int, ...]
    by_solved: tuple[int, ...]
    values: dict[int, int]
    solution: int | None = None


class _Weighted:
    """The sum of all results of a function, each times its weight."""

    def __init__(self, problem: Problem, weights: Sequence[int]) -> None:
        self.problem, self.c, self.g = problem, problem.c, problem.c.k.graph
        self.leaves = tuple(dict.fromkeys(leaf for d in problem.along for leaf in d.seeds))
        self.wrt = [part.wrt for part in problem.parts for _ in part.labels]
        self.fields = [field for part in problem.parts for field in _fields(self.g, part)]
        self.parts = self._parts(inner(self.g, weights, problem.nodes))

    def by_leaf(self) -> dict[int, int]:
        """Derivatives by all leaves that directions change."""
        total = dict.fromkeys(self.leaves, ZERO)
        for part in self.parts:
            inserted = self._inserted(part, list(part.by.values()))
            for leaf, node in zip(part.by, inserted, strict=True):
                total[leaf] = self.g.add(total[leaf], node)
        return total

    def second(self) -> list[list[int]]:
        """Second derivatives along all columns."""
        g, n = self.g, len(self.fields)
        rows, first = [[ZERO] * n for _ in range(n)], [ZERO] * n
        responses = self._responses()
        for part in self.parts:
            numbers = range(len(responses)) if part.solution is None else [part.solution]
            ways = [[x for k in numbers for x in responses[k][i]] for i in range(n)]
            slopes = [_along(g, part.by, field) for field in self.fields]
            first = [g.add(*pair) for pair in zip(first, self._inserted(part, slopes), strict=True)]
            for j, field in enumerate(self.fields):
                seeds = field | dict(zip(part.solved, ways[j], strict=True))
                needed = [i for i in range(n) if i >= j or self._bent(i, j)]
                roots = [*(slopes[i] for i in needed), *part.by_solved]
                changes = self._inserted(part, forward(g, roots, seeds))
                for i, change in zip(needed, changes, strict=False):
                    more = inner(g, ways[i], changes[len(needed) :])
                    rows[i][j] = g.add(rows[i][j], g.add(change, more))
        return self._mirrored(rows, first)

    def _parts(self, root: int) -> list[_Part]:
        """phi, then -mu R of everything that was solved for."""
        g, parts = self.g, list[_Part]()
        solutions = self.c.d.solutions
        solved = tuple(node for _, udot, lam in solutions for node in (*udot.nodes, *lam.nodes))
        by, by_solved = self._gradient(root, self.leaves, solved)
        parts.append(_Part(by, solved, by_solved, {}))
        start = 0
        for number, (tau, udot, lam) in enumerate(solutions):
            middle, end = start + udot.rows, start + udot.rows + lam.rows
            by_udot = Matrix(g, udot.rows, 1, by_solved[start:middle])
            by_lam = Matrix(g, lam.rows, 1, by_solved[middle:end])
            start = end
            if not (by_udot.is_zero and by_lam.is_zero):
                parts.append(self._balance(number, tau, by_udot, by_lam))
        return parts

    def _gradient(
        self, root: int, leaves: Sequence[int], solved: Sequence[int]
    ) -> tuple[dict[int, int], tuple[int, ...]]:
        """Derivatives of a node by leaves, and by what was solved for; numbers do not change."""
        variable = [node for node in solved if self.g.value(node) is None]
        wrt = list(dict.fromkeys((*leaves, *variable)))
        bars = dict(zip(wrt, gradient(self.g, root, wrt), strict=True))
        return {x: bars[x] for x in leaves}, tuple(bars.get(x, ZERO) for x in solved)

    def _balance(self, number: int, tau: Matrix, by_udot: Matrix, by_lam: Matrix) -> _Part:
        """-mu R with mu R_y = phi_y: of M udot + h - f - tau - Gᵀ lam and of G udot - gamma."""
        c, g, dynamics = self.c, self.g, self.c.d
        _, udot, lam = dynamics.solutions[number]
        mu, nu = self._adjoint(by_udot, by_lam)
        # what is held while the rest is differentiated
        mu_fixed, nu_fixed, lam_fixed = (
            Matrix(g, x.rows, 1, [g.atom(f"{word} {i}") for i in range(x.rows)])
            for word, x in (("adjoint", mu), ("adjoint multiplier", nu), ("multiplier", lam))
        )
        root = mu_fixed.dot(tau - dynamics.inverse(c.udot)).node
        if lam.rows:
            bound = dynamics.constraints
            root = g.add(root, mu_fixed.dot(bound.jacobian.T @ lam_fixed).node)
            root = g.add(root, nu_fixed.dot(bound.jacobian @ c.udot - bound.gamma).node)
        solved = (*c.udot.nodes, *lam_fixed.nodes)
        # an argument udot of the function is another one
        leaves = [leaf for leaf in self.leaves if leaf not in c.udot.nodes]
        by, by_solved = self._gradient(root, leaves, solved)
        values = zip(
            (*solved, *mu_fixed.nodes, *nu_fixed.nodes),
            (*udot.nodes, *lam.nodes, *mu.nodes, *nu.nodes),
            strict=True,
        )
        return _Part(by, solved, by_solved, dict(values), number)

    def _adjoint(self, by_udot: Matrix, by_lam: Matrix) -> tuple[Matrix, Matrix]:
        """mu and nu: M mu - Gᵀ nu = phi_udot and G mu = -phi_lam."""
        dynamics, nothing = self.c.d, Matrix.zeros(self.g, 0)
        if not by_lam.rows:
            with self.g.made_by("M", "adjoint"):
                return solve("spd", dynamics.mass_matrix, by_udot), nothing
        with self.g.made_by("constraints", "adjoint"):
            G, gamma = dynamics.constraints.jacobian, -by_lam
            bound = Bound(dynamics.mass_matrix, by_udot, G, gamma, nothing, nothing)
            return by_multipliers(bound, gamma)

    def _responses(self) -> list[list[list[int]]]:
        """Changes of what was solved for: solution by solution, column by column."""
        return [
            self._by_columns(forward_columns(self.c, *solution, self.problem.along))
            for solution in self.c.d.solutions
        ]

    def _by_columns(self, along: Sequence[list[int]]) -> list[list[int]]:
        """Changes along the columns from those along the directions."""
        columns, start = list[list[int]](), 0
        for part in self.problem.parts:
            block = [*along[start : start + len(part.along)]]
            start += len(part.along)
            columns += block if part.shares is None else combined(self.g, block, part.shares)
        return columns

    def _bent(self, i: int, j: int) -> bool:
        """True where columns along speeds may not commute."""
        if not self.wrt[i] == self.wrt[j] == "q":
            return False
        changes = (*self.fields[i].values(), *self.fields[j].values())
        return any(self.g.value(node) is None for node in changes)

    def _mirrored(self, rows: list[list[int]], first: Sequence[int]) -> list[list[int]]:
        """The symmetric matrix; a quaternion counts by its direction alone."""
        g, half = self.g, self.g.const(0.5)
        for slots in self._quaternions():
            for i in slots:
                for j, entry in slots.items():
                    rows[i][j] = g.sub(rows[i][j], g.mul(entry, first[i]))
        for i, row in enumerate(rows):
            for j in range(i):
                if self._bent(i, j):
                    row[j] = g.mul(half, g.add(row[j], rows[j][i]))
                rows[j][i] = row[j]
        return rows

    def _quaternions(self) -> Iterator[dict[int, int]]:
        """Columns along the entries of every unit quaternion, with the entries."""
        start = 0
        for part in self.problem.parts:
            for joint in self.c.k.system.joints if part.wrt == COORDINATES else ():
                if joint.q >= 0 and joint.element.quaternion is not None:
                    first = joint.q + joint.element.quaternion
                    slots = range(first, first + 4)
                    yield {start + m: self.g.var("q", m) for m in slots}
            start += len(part.labels)

    def _inserted(self, part: _Part, nodes: Sequence[int]) -> list[int]:
        """Nodes of a part with its values in their place."""
        if not part.values:
            return list(nodes)
        return list(rebuild(self.g, nodes, part.values, into=self.g)[1])
