"""SymPy expressions to expressions of a graph. Loads SymPy: import it where it is needed only."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy

from ...errors import ModelError, near
from ..graph import ONE, ZERO, Graph
from .sympy_out import to_sympy, to_sympy_shared

__all__ = ["all_from_sympy", "from_sympy", "to_sympy", "to_sympy_shared"]

Convert = Callable[[Graph, Sequence[int]], int]


def from_sympy(graph: Graph, expression: sympy.Basic, symbols: Mapping[sympy.Basic, int]) -> int:
    """A SymPy expression as a node; see :func:`all_from_sympy`."""
    return all_from_sympy(graph, [expression], symbols)[0]


def all_from_sympy(
    graph: Graph, expressions: Sequence[sympy.Basic], symbols: Mapping[sympy.Basic, int]
) -> list[int]:
    """SymPy expressions as nodes; what they share is converted once.

    Args:
        graph: Where the nodes are made.
        expressions: What SymPy can take for an expression; elementary functions, ``Piecewise``,
            ``Abs``, ``sign``, ``Min``, ``Max``, ``Heaviside``, relations and logic, and functions
            that carry an interpolation table (attribute ``cardan_table``).
        symbols: SymPy symbol, or any other subexpression, -> the node it stands for.

    Raises:
        ModelError: an unknown symbol, an unsupported function or a value that is not finite and
            real.
    """
    done: dict[sympy.Basic, int] = dict(symbols)
    roots = [sympy.sympify(expression, strict=True) for expression in expressions]
    for root in roots:
        _convert(graph, root, done)
    return [done[root] for root in roots]


def _convert(graph: Graph, root: sympy.Basic, done: dict[sympy.Basic, int]) -> None:
    """Convert an expression and all its parts."""
    stack = [root]
    while stack:
        e = stack[-1]
        if e in done:
            stack.pop()
            continue
        waiting = [x for x in _parts(e) if x not in done]
        if waiting:
            stack.extend(reversed(waiting))
        else:
            done[e] = _node(graph, e, done, root)
            stack.pop()


def _parts(e: sympy.Basic) -> Sequence[sympy.Basic]:
    """Subexpressions to convert before e."""
    if isinstance(e, sympy.Piecewise):
        return [x for branch in e.args for x in branch.args]
    if isinstance(e, sympy.Pow) and e.exp.is_Number:
        return [e.base]
    return () if e.is_Atom else e.args


def _node(graph: Graph, e: sympy.Basic, done: Mapping[sympy.Basic, int], root: sympy.Basic) -> int:
    if e.is_Atom:
        return _atom(graph, e, done, root)
    nodes = [done[x] for x in _parts(e)]
    table = getattr(e, "cardan_table", None)
    if table is not None:
        return graph.interpolate(table, nodes[0], getattr(e, "cardan_derivative", 0))
    if isinstance(e, sympy.Add):
        return _sum(graph, nodes)
    if isinstance(e, sympy.Mul):
        return _product(graph, e, done)
    if isinstance(e, sympy.Pow) and e.exp.is_Number:
        return graph.power(nodes[0], _finite(e.exp, root))
    if isinstance(e, sympy.Piecewise):
        return _piecewise(graph, e, nodes)
    convert = FUNCTIONS.get(e.func)
    if convert is None:
        candidates = sorted(f.__name__ for f in FUNCTIONS)
        raise ModelError(
            f"'{e.func.__name__}' in '{_shortened(root)}' is not a function that C code can be "
            "written "
            f"for.{near(e.func.__name__, candidates)}"
        )
    return convert(graph, nodes)


def _atom(graph: Graph, e: sympy.Basic, done: Mapping[sympy.Basic, int], root: sympy.Basic) -> int:
    """A number or a truth value; symbols that are known never come here."""
    if e.is_Symbol:
        candidates = [x for x in done if getattr(x, "is_Symbol", False)]
        names = [x.name for x in candidates]
        if e.name in names:
            raise ModelError(
                f"symbol '{e.name}' in '{_shortened(root)}' is not the model's own: it was made "
                "with "
                f"other assumptions. Use the symbol that the model returned for '{e.name}'"
            )
        hint = near(e.name, names)
        raise ModelError(f"symbol '{e.name}' in '{_shortened(root)}' is not known.{hint}")
    if e == sympy.true or e == sympy.false:
        return ONE if e == sympy.true else ZERO
    return graph.const(_finite(e, root))


def _finite(e: sympy.Basic, root: sympy.Basic) -> float:
    """A SymPy number as a float."""
    if not (e.is_number and e.is_extended_real and e.is_finite):
        raise ModelError(f"'{e}' in '{_shortened(root)}' is not a finite real number")
    value = float(e)
    if value in (float("inf"), float("-inf")):
        raise ModelError(f"'{e}' in '{_shortened(root)}' is too large for a number of the machine")
    return value


def _shortened(e: sympy.Basic) -> str:
    text = str(e)
    return text if len(text) <= 80 else text[:77] + "..."


def _sum(graph: Graph, nodes: Sequence[int]) -> int:
    total = nodes[0]
    for x in nodes[1:]:
        total = graph.add(total, x)
    return total


def _product(graph: Graph, e: sympy.Basic, done: Mapping[sympy.Basic, int]) -> int:
    """Factors with negative powers are gathered below one fraction line."""
    above, below = ONE, ONE
    for factor in e.args:
        if isinstance(factor, sympy.Pow) and factor.exp.is_Number and factor.exp.is_negative:
            power = graph.power(done[factor.base], -_finite(factor.exp, e))
            below = graph.mul(below, power)
        else:
            above = graph.mul(above, done[factor])
    return graph.div(above, below)


def _piecewise(graph: Graph, e: sympy.Basic, nodes: Sequence[int]) -> int:
    """First piece whose condition holds."""
    if e.args[-1].cond != sympy.true:
        raise ModelError(
            f"'{_shortened(e)}' has no value where none of its conditions holds: end it with the "
            "piece "
            "(value, True)"
        )
    result = nodes[-2]
    for value, condition in zip(nodes[-4::-2], nodes[-3::-2], strict=True):
        result = graph.apply("select", condition, value, result)
    return result


# the functions


def _op(name: str) -> Convert:
    return lambda g, x: g.apply(name, *x)


def _folded(name: str) -> Convert:
    """An operator of two operands, over any number of them."""

    def convert(g: Graph, x: Sequence[int]) -> int:
        result = x[0]
        for other in x[1:]:
            result = g.apply(name, result, other)
        return result

    return convert


def _reciprocal(name: str) -> Convert:
    return lambda g, x: g.div(ONE, g.apply(name, x[0]))


def _of_reciprocal(name: str) -> Convert:
    return lambda g, x: g.apply(name, g.div(ONE, x[0]))


def _swapped(name: str) -> Convert:
    return lambda g, x: g.apply(name, x[1], x[0])


def _heaviside(g: Graph, x: Sequence[int]) -> int:
    at_zero = x[1] if len(x) > 1 else g.const(0.5)
    below = g.apply("select", g.apply("lt", x[0], ZERO), ZERO, at_zero)
    return g.apply("select", g.apply("lt", ZERO, x[0]), ONE, below)


def _modulo(g: Graph, x: Sequence[int]) -> int:
    return g.sub(x[0], g.mul(x[1], g.apply("floor", g.div(x[0], x[1]))))


def _exclusive(g: Graph, x: Sequence[int]) -> int:
    result = g.apply("not", g.apply("not", x[0]))
    for other in x[1:]:
        differs = g.apply("eq", result, g.apply("not", g.apply("not", other)))
        result = g.apply("not", differs)
    return result


def _functions() -> dict[sympy.Basic, Convert]:
    same = "sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp log atan2 sign floor"
    table: dict[sympy.Basic, Convert] = {getattr(sympy, name): _op(name) for name in same.split()}
    table |= {
        sympy.Pow: _op("pow"),
        sympy.Abs: _op("abs"),
        sympy.Min: _folded("min"),
        sympy.Max: _folded("max"),
        sympy.And: _folded("and"),
        sympy.Or: _folded("or"),
        sympy.Xor: _exclusive,
        sympy.Not: _op("not"),
        sympy.ITE: _op("select"),
        sympy.Lt: _op("lt"),
        sympy.Le: _op("le"),
        sympy.Gt: _swapped("lt"),
        sympy.Ge: _swapped("le"),
        sympy.Eq: _op("eq"),
        sympy.Ne: lambda g, x: g.apply("not", g.apply("eq", x[0], x[1])),
        sympy.cot: _reciprocal("tan"),
        sympy.sec: _reciprocal("cos"),
        sympy.csc: _reciprocal("sin"),
        sympy.coth: _reciprocal("tanh"),
        sympy.sech: _reciprocal("cosh"),
        sympy.csch: _reciprocal("sinh"),
        sympy.acot: _of_reciprocal("atan"),
        sympy.asec: _of_reciprocal("acos"),
        sympy.acsc: _of_reciprocal("asin"),
        sympy.acoth: _of_reciprocal("atanh"),
        sympy.asech: _of_reciprocal("acosh"),
        sympy.acsch: _of_reciprocal("asinh"),
        sympy.sinc: lambda g, x: g.apply("stumpff", ONE, g.square(x[0])),
        sympy.ceiling: lambda g, x: g.neg(g.apply("floor", g.neg(x[0]))),
        sympy.frac: lambda g, x: g.sub(x[0], g.apply("floor", x[0])),
        sympy.Mod: _modulo,
        sympy.Heaviside: _heaviside,
    }
    return table


FUNCTIONS = _functions()
