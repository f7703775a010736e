"""Expressions of a graph as SymPy expressions. Loads SymPy: import it where it is needed only."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import chain, count, islice

import sympy

from ..arithmetic import Scalar
from ..exact import exact, is_fraction
from ..function import Function, live, operands
from ..graph import ZERO, Graph
from ..matrix import Matrix
from ..ops import LEAVES
from ..rewrite import rebuild
from ..solve import Factor, unrolled

Names = Mapping[tuple[str, int], sympy.Expr]
What = Function | Matrix | Scalar


def to_sympy(what: What, names: Names | None = None) -> sympy.Expr | sympy.Matrix:
    """Expressions written out in full as a SymPy matrix, or an expression for a Scalar.

    Args:
        what: A Function with one result gives it in its shape, with several a column of all.
        names: (block, k) -> SymPy symbol; by default a Function's names of entries.
    """
    graph, roots, rows, columns = written_out(what)
    expressions: dict[int, sympy.Expr] = {}
    leaves = Leaves(graph, what, names)
    for i in live(graph, roots):
        expressions[i] = expression_of(graph, i, expressions, leaves)
    return shaped(what, rows, columns, [expressions[i] for i in roots])


def to_sympy_shared(
    what: What, names: Names | None = None, named: bool = False
) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
    """Expressions with what is used several times named, like :func:`sympy.cse`.

    Args:
        what, names: As for :func:`to_sympy`.
        named: Call what is named after its owner and quantity, as the graph's labels say; else,
            and without a label, it is x0, x1, ...

    Returns:
        (replacements, matrix): the replacements (symbol, expression), each in terms of the ones
        before it.
    """
    graph, roots, rows, columns = written_out(what)
    expressions: dict[int, sympy.Expr] = {}
    leaves = Leaves(graph, what, names)
    order = live(graph, roots)
    uses = dict.fromkeys(order, 0)
    for i in order:
        for k in operands(graph.nodes[i]):
            uses[k] += 1
    symbols = leaves.fresh(order, named)
    replacements: list[tuple[sympy.Expr, sympy.Expr]] = []
    for i in order:
        expressions[i] = expression_of(graph, i, expressions, leaves)
        if uses[i] > 1 and graph.nodes[i][0] not in (*LEAVES, "neg", "solve"):
            replacements.append((symbols(i), expressions[i]))
            expressions[i] = replacements[-1][0]
    return replacements, shaped(what, rows, columns, [expressions[i] for i in roots])


def written_out(what: What) -> tuple[Graph, list[int], int, int]:
    """Graph, roots and shape, with positive definite systems written out."""
    if isinstance(what, Scalar):
        roots, rows, columns = [what.node], 1, 1
    elif isinstance(what, Matrix):
        roots, rows, columns = list(what.nodes), what.rows, what.columns
    else:
        roots, columns = list(what.roots), 1
        if len(what.outputs) == 1 and len(what.outputs[0].shape) == 2:
            columns = what.outputs[0].shape[1]
        rows = len(roots) // columns if columns else 0
    nodes = what.graph.nodes
    solutions: dict[int, list[int]] = {}
    factors: dict[tuple[int, ...], Factor] = {}

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        node = nodes[i]
        if node[0] == "solve" and node[1] == "spd":
            entries = [copies[k] for k in node[4:]]
            solutions[i] = unrolled(target, node[2], node[3], entries, factors)
            return ZERO
        return solutions[node[1]][node[2]] if node[0] == "item" and node[1] in solutions else None

    graph, roots = rebuild(what.graph, roots, rule)
    return graph, roots, rows, columns


def shaped(what: What, rows: int, columns: int, entries: Sequence[sympy.Expr]) -> sympy.Matrix:
    return entries[0] if isinstance(what, Scalar) else sympy.Matrix(rows, columns, list(entries))


class Leaves:
    """Symbols of input entries and placeholders."""

    def __init__(self, graph: Graph, what: What, names: Names | None) -> None:
        self.graph = graph
        self.names: dict[tuple[str, int], sympy.Expr] = dict(names or {})
        if isinstance(what, Function):
            for block in what.inputs:
                for k, entry in enumerate(block.entries):
                    self.names.setdefault((block.name, k), sympy.Symbol(entry))

    def symbol(self, i: int) -> sympy.Expr:
        op, name, *indices = self.graph.nodes[i]
        if op == "atom":
            return sympy.Symbol(name)
        return self.names.get((name, indices[0])) or sympy.Symbol(f"{name}{indices[0]}")

    def fresh(self, order: Sequence[int], named: bool) -> Callable[[int], sympy.Expr]:
        """Gives nodes symbols that no leaf has: by label, else x0, x1, ..."""
        nodes = self.graph.nodes
        taken = {self.symbol(i).name for i in order if nodes[i][0] in ("var", "atom")}

        def symbol(i: int) -> sympy.Expr:
            owner, quantity = self.graph.labels.get(i, ("", "")) if named else ("", "")
            op, *read = nodes[i]
            if named and op in ("sin", "cos") and nodes[read[0]][0] == "var":
                owner, quantity = self.symbol(read[0]).name, op
            base = ".".join(filter(None, (owner, quantity)))
            forms = (f"{base}_{n}" for n in count(2)) if base else (f"x{n}" for n in count())
            name = next(name for name in chain([base], forms) if name and name not in taken)
            taken.add(name)
            return sympy.Symbol(name)

        return symbol


def sympy_number(value: float) -> sympy.Expr:
    """Fractions and multiples of pi as such, other numbers as floats."""
    if abs(value) < 1e15:
        for divisor in (1, 2, 3, 4, 6):
            if abs(value) == math.pi / divisor:
                return sympy.pi / divisor if value > 0 else -sympy.pi / divisor
        fraction = exact(value)
        if is_fraction(fraction):
            return sympy.Rational(fraction.numerator, fraction.denominator)
    return sympy.Float(value)


def expression_of(
    graph: Graph, i: int, expressions: Mapping[int, sympy.Expr], leaves: Leaves
) -> sympy.Expr:
    """A node in terms of its operands' expressions; solve nodes give matrices."""
    node = graph.nodes[i]
    op = node[0]
    if op == "const":
        return sympy_number(node[1])
    if op in LEAVES:
        return leaves.symbol(i)
    if op == "solve":
        return _solution(node[2], node[3], [expressions[k] for k in node[4:]])
    if op == "item":
        return expressions[node[1]][node[2]]
    if op == "select":
        condition = _condition(graph, node[1], expressions)
        return sympy.Piecewise((expressions[node[2]], condition), (expressions[node[3]], True))
    if op in RELATIONS or op in LOGIC:
        return sympy.Piecewise((1, _condition(graph, i, expressions)), (0, True))
    if op == "table":
        number, derivative = (int(graph.nodes[k][1]) for k in node[1:3])
        return _table(graph, number, derivative)(expressions[node[3]])
    return applied(op, *[expressions[k] for k in node[1:]])


def applied(op: str, *given: sympy.Expr) -> sympy.Expr:
    """An operator of SymPy's; functions of long expressions are left as they are.

    SymPy looks for signs and squares in what it takes a root or an angle of, which takes minutes
    where that is long.
    """
    if op in ARITHMETIC or all(_short(x) for x in given):
        return OPERATIONS[op](*given)
    with sympy.evaluate(False):
        return OPERATIONS[op](*given)


def _short(x: sympy.Expr) -> bool:
    return next(islice(sympy.preorder_traversal(x), EVALUATED, None), None) is None


# parts of an expression that SymPy may look through; operators that it only puts together
EVALUATED = 60
ARITHMETIC = frozenset(["add", "sub", "neg"])
RELATIONS = {"lt": sympy.Lt, "le": sympy.Le, "eq": sympy.Eq}
LOGIC = {"and": sympy.And, "or": sympy.Or, "not": sympy.Not}


def _condition(graph: Graph, i: int, expressions: Mapping[int, sympy.Expr]) -> sympy.Expr:
    """A node as a truth value: it is not 0."""
    node = graph.nodes[i]
    if node[0] in RELATIONS:
        return RELATIONS[node[0]](expressions[node[1]], expressions[node[2]])
    if node[0] in LOGIC:
        return LOGIC[node[0]](*[_condition(graph, k, expressions) for k in node[1:]])
    return sympy.Ne(expressions[i], 0)


def _solution(n: int, m: int, entries: list[sympy.Expr]) -> sympy.Matrix:
    a = sympy.Matrix(n, n, entries[: n * n])
    return a.LUsolve(sympy.Matrix(n, m, entries[n * n :]))


def _table(graph: Graph, number: int, derivative: int) -> sympy.Expr:
    """A SymPy function that :func:`from_sympy` turns into the table again."""
    name = f"table{number}" + (f"_d{derivative}" if derivative else "")
    members = {"cardan_table": graph.tables[number], "cardan_derivative": derivative}
    return type(name, (sympy.Function,), members)


def _stumpff(k: sympy.Integer, x: sympy.Expr) -> sympy.Expr:
    """c_k(x) in closed form, with its limit at 0."""
    k = int(k)
    root = sympy.sqrt(x)
    value = sympy.cos(root) if k % 2 == 0 else sympy.sin(root) / root
    for j in range(k % 2, k, 2):
        value = (1 / sympy.factorial(j) - value) / x
    return (
        value
        if k == 0
        else sympy.Piecewise((1 / sympy.factorial(k), sympy.Eq(x, 0)), (value, True))
    )


def _operations() -> dict[str, Callable[..., sympy.Expr]]:
    same = (
        "sqrt sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp log atan2 sign floor"
    )
    table: dict[str, Callable[..., sympy.Expr]] = {
        name: getattr(sympy, name) for name in same.split()
    }
    return table | {
        "add": lambda a, b: a + b,
        "sub": lambda a, b: a - b,
        "mul": lambda a, b: a * b,
        "div": lambda a, b: a / b,
        "neg": lambda a: -a,
        "pow": lambda a, b: a**b,
        "abs": sympy.Abs,
        "min": sympy.Min,
        "max": sympy.Max,
        "stumpff": _stumpff,
    }


OPERATIONS = _operations()
