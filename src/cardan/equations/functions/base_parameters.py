"""Base parameters: what of the masses and inertias the motion depends on.

Source: Gautier and Khalil, Direct Calculation of Minimum Set of Inertial Parameters of Serial
Robots, IEEE Trans. Robotics and Automation 6 (1990).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...arrays import Booleans
from ...ir.arithmetic import Scalar
from ...ir.function import Function, Output, live
from ...ir.graph import ONE, ZERO
from ...ir.interpreter import evaluate
from ...ir.rewrite import rebuild
from ...ir.stage import stage
from ...notebooks import html
from ...records import dataclass

if TYPE_CHECKING:
    from ..record import EquationRecord

# differences of sums of terms of size one that cancel
ROUNDING = 1e-10
STATES = 8  # at which columns are compared
# of every body: mass, first moment, second moment about its origin
ENTRIES = ("mass", *(f"moment_{i}" for i in "xyz"), *("xx", "yy", "zz", "xy", "xz", "yz"))


@dataclass(frozen=True)
class BaseParameters:
    """The parameters of a system by how tau depends on them.

    Attributes:
        combinations: Name such as ``lower.base_xx`` -> SymPy expression of the parameters, for
            every number of a body that tau depends on; those that act in the same way are one, by
            their sum. They determine tau at every motion.
        without_effect: Parameters that tau does not depend on.
        only_combined: Parameters that no combination gives alone: they cannot be told apart by
            motion and driving forces.
    """

    combinations: dict[str, Any]
    without_effect: tuple[str, ...]
    only_combined: tuple[str, ...]

    def __str__(self) -> str:
        lines = [f"{len(self.combinations)} base parameters"]
        lines += [f"  {name} = {expression}" for name, expression in self.combinations.items()]
        lines.append("without effect: " + (", ".join(self.without_effect) or "none"))
        lines.append("only in combination: " + (", ".join(self.only_combined) or "none"))
        return "\n".join(lines)

    _repr_html_ = html


def base_parameters(equations: EquationRecord) -> BaseParameters:
    """The base parameters of inverse dynamics, in the frames of the user's joints."""
    from sympy import expand

    from ...ir.forms.sympy_out import to_sympy

    rewritten = equations.with_rewrites(("base_parameters",))
    function = rewritten.function("inverse_dynamics")
    graph, names = function.graph, equations.parameters
    prepared = list(stage(function).prepare)
    numbers: dict[str, int] = {}
    for body in rewritten.ways("inverse_dynamics", None)[0][1].bodies:
        j = body.second_moment
        if j is None:
            continue
        ten = (body.mass, *body.first_moment, j[0], j[4], j[8], j[1], j[2], j[5])
        for entry, node in zip(ENTRIES, ten, strict=True):
            # signs stand at the sums that take a number
            inner = graph.nodes[node][1] if graph.nodes[node][0] == "neg" else node
            numbers[f"{body.name}.base_{entry}"] = inner
    # those that a call reads, and not only what makes up another one
    read = set(live(graph, prepared, stop=set(numbers.values())))
    nonzero = {name: node for name, node in numbers.items() if node != ZERO and node in read}
    depends = _dependence(function, [*prepared, *nonzero.values()], len(names))
    effect = [set(row.nonzero()[0].tolist()) for row in depends]
    inertial = set[int]().union(*effect[len(prepared) :])
    effect = effect[: len(prepared)]
    alone = set[int]().union(*(row for row in effect if len(row) == 1))
    every = set[int]().union(*effect)
    written = {
        name: to_sympy(Scalar(graph, node), equations.symbols) for name, node in nonzero.items()
    }
    expressions = {
        name: expand(sum(sign * written[other] for other, sign in parts))
        for name, parts in _sums(function, nonzero).items()
    }
    return BaseParameters(
        {name: expression for name, expression in expressions.items() if expression != 0},
        tuple(name for k, name in enumerate(names) if k not in every),
        tuple(name for k, name in enumerate(names) if k in (inertial & every) - alone),
    )


def _sums(function: Function, numbers: dict[str, int]) -> dict[str, list[tuple[str, int]]]:
    """Numbers that tau depends on in the same way up to the sign: first one -> (name, sign).

    Seen at states drawn by chance: tau is linear in the numbers, and has a column for each.
    """
    import numpy as np

    nodes = list(dict.fromkeys(numbers.values()))
    graph, tau = function.graph.fork(), function.outputs[0].nodes
    nothing, columns = dict.fromkeys(nodes, ZERO), list[int]()
    for node in (-1, *nodes):
        # -1: what tau is without any
        columns += rebuild(graph, tau, {**nothing, node: ONE}, into=graph)[1]
    rng = np.random.default_rng(6)
    values = {b.name: rng.uniform(0.5, 1.5, (STATES, len(b))) for b in function.inputs}
    shape = (len(nodes) + 1, len(tau))
    one = Function("columns", graph, function.inputs, (Output("Y", shape, tuple(columns)),))
    Y = np.broadcast_to(evaluate(one, values, arithmetic="numpy")["Y"], (STATES, *shape))
    Y = Y[np.isfinite(Y).all(axis=(1, 2))]
    slopes = dict(zip(nodes, np.moveaxis(Y[:, 1:] - Y[:, :1], 1, 0), strict=True))
    sums: dict[str, list[tuple[str, int]]] = {}
    for name, node in numbers.items():
        place, sign = _alike(slopes[node], {first: slopes[numbers[first]] for first in sums})
        if place:
            sums[place].append((name, sign))
        else:
            sums[name] = [(name, 1)]
    return sums


def _alike(column: object, columns: dict[str, Any]) -> tuple[str, int]:
    """Column that equals a given one, and its sign; "" for none."""
    import numpy as np

    for name, other in columns.items():
        size = np.abs(other).max(initial=0.0)
        for sign in (1, -1):
            if size and np.abs(column - sign * other).max(initial=0.0) < ROUNDING * size:
                return name, sign
    return "", 1


def _dependence(function: Function, nodes: list[int], parameters: int) -> Booleans:
    """Parameters that expressions depend on: (nodes, parameters).

    Whether they do is seen at numbers drawn by chance; what cancels leaves rounding only.
    """
    import numpy as np

    output = Output("values", (len(nodes),), tuple(nodes))
    rng = np.random.default_rng(5)
    p = rng.uniform(0.5, 1.5, parameters)
    changed = p + 0.37 * np.eye(parameters)
    one = Function("values", function.graph, function.inputs, (output,))
    rows = evaluate(one, {"p": np.vstack([p, changed])}, arithmetic="numpy")["values"]
    rows = np.broadcast_to(rows, (parameters + 1, len(nodes)))
    size = np.maximum(1.0, np.abs(rows).max(axis=0))
    return np.asarray((np.abs(rows[1:] - rows[0]) > ROUNDING * size).T)
