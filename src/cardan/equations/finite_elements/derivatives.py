"""Derivatives of what elements give by everything that they read: in reverse, forward, and both.

Of forces, of constraints on all levels and of internal states together, of what impulses obey, of
energies, momenta, powers, outputs, reactions, forces by name and motions of bodies, of events and
what they change: gradients of weighted sums, changes along a direction, and changes of those
gradients.

Source: Griewank and Walther, Evaluating Derivatives (2008), sections 3.1, 3.2 and 5.1.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice

from ...arrays import Integers
from ...ir.derivative import forward, gradient
from ...ir.function import Block, Function, Output
from ...ir.graph import ZERO, Graph
from ...ir.matrix import Matrix, inner
from ...ir.rewrite import rebuild
from ...ir.routine import Routine
from ...schema.blocks import ORDER
from ...schema.finite_elements import DERIVATIVES, EVENT_DERIVATIVES, requested_name
from .record import BlockKind, Group, Kind
from .superelement_derivatives import superelement_derivative

ABOUT = {
    "gradient": "gradient of a weighted sum of results",
    "change": "change along a direction",
    "curvature": "change of the gradient of a weighted sum along a direction",
}


def derivative_of(kind: Kind, form: str, group: Group, inputs: int) -> Function:
    """A gradient, a change or a curvature of a kind of element.

    Args:
        kind: The kind.
        form: One of ``DERIVATIVES``.
        group: Elements of that kind.
        inputs: How many the scene has.

    Returns:
        What is multiplied by the derivative is the block v. Of a gradient it has weights: of
        ``dynamics_gradient`` those of the balance (nu), of g (mp), of the rates (m), of
        G udot - H lam - gamma (m) and of its own internal states, of ``impulse_gradient`` those of
        M udot - Gᵀ lam (nu) and G udot - H lam (m), else those of the results of the function. The
        results are derivatives by q as it is stored, u, udot, lam, z, s, r, t, of events by du and
        tau too, then by the data that parameters change. Of a change v and the results are the
        other way round. Of a curvature v has the weights, then a direction; the results are those
        of the gradient.
    """
    graph = Graph()
    read = {name: kind.functions[name] for name in DERIVATIVES[form] if name in kind.functions}
    if any(isinstance(function, Routine) for function in read.values()):
        return superelement_derivative(kind, form, inputs)
    make = ROOTS.get(form.rpartition("_")[0])
    roots = _all(graph, read) if make is None else make(graph, kind, read)
    fixed = 0 if group.attributes is None else group.attributes.shape[1]
    sizes = {
        **{"q": kind.nq, "u": kind.nu, "udot": kind.nu, "lam": kind.m},
        **{"z": _width(group.z), "s": _width(group.s), "r": inputs, "t": 1},
    }
    blocks = {block.name: block for f in read.values() for block in f.inputs}
    if form in EVENT_DERIVATIVES:
        sizes |= {"du": kind.nu, "tau": len(blocks["tau"].entries)}
    sizes["p"] = len(kind.data) - fixed
    owners = next((f.owners for f in read.values()), ())
    return _derivative(kind.c_name(form), graph, roots, blocks, sizes, owners)


def rates_derivative_of(kind: BlockKind, form: str) -> Function:
    """Gradient, change or curvature of the rates of the coordinates of a place: by its q and u."""
    rates, graph = kind.functions["qdot"], Graph()
    blocks = {block.name: block for block in rates.inputs}
    roots = _all(graph, {"qdot": rates})
    sizes = {"q": kind.nq, "u": kind.nu}
    name = requested_name(form, kind.name)
    return _derivative(name, graph, roots, blocks, sizes, rates.owners)


def _derivative(
    name: str,
    graph: Graph,
    roots: Sequence[int],
    blocks: Mapping[str, Block],
    sizes: Mapping[str, int],
    owners: tuple[str, ...],
) -> Function:
    """Derivatives of a weighted sum of the roots by blocks of known sizes, or their changes."""
    mode = name.rpartition("_")[2]
    leaves = [graph.var(letter, k) for letter, n in sizes.items() for k in range(n)]
    counts = {"weight": len(roots), "direction": len(leaves)}
    if mode != "curvature":
        del counts["direction" if mode == "gradient" else "weight"]
    entries = tuple(f"{word}{k + 1}" for word, count in counts.items() for k in range(count))
    v = [graph.var("v", k) for k in range(len(entries))]
    along = dict(zip(leaves, v[-len(leaves) :], strict=True)) if "direction" in counts else {}
    if mode == "change":
        changes = forward(graph, roots, along)
        outputs: tuple[Output, ...] = (Output("change", (len(roots),), tuple(changes)),)
    else:
        slopes = gradient(graph, inner(graph, v[: len(roots)], roots), leaves)
        nodes = iter(forward(graph, slopes, along) if mode == "curvature" else slopes)
        outputs = tuple(
            Output(f"d_{letter}", (n,), tuple(islice(nodes, n))) for letter, n in sizes.items() if n
        )
    read = {**blocks, "v": Block("v", entries, ("",) * len(entries))}
    inputs = tuple(read[letter] for letter in ORDER if letter in read)
    return Function(name, graph, inputs, outputs, owners, ABOUT[mode])


def _width(table: Integers | None) -> int:
    return 0 if table is None else table.shape[1]


def _copied(graph: Graph, function: Function | None) -> dict[str, Sequence[int]]:
    """Results of a function in another graph, by name."""
    if function is None:
        return {}
    # functions of a kind have the tables of one graph
    graph.tables = max(graph.tables, function.graph.tables.copy(), key=len)
    nodes = iter(rebuild(function.graph, function.roots, into=graph)[1])
    return {output.name: [next(nodes) for _ in output.nodes] for output in function.outputs}


def _all(graph: Graph, read: Mapping[str, Function]) -> list[int]:
    """All results of some functions."""
    return [n for f in read.values() for some in _copied(graph, f).values() for n in some]


def _dynamics(graph: Graph, kind: Kind, read: Mapping[str, Function]) -> list[int]:
    """The balance, g, the rates, what accelerations miss of constraints, and rates of z."""
    m, levels = kind.m, kind.nu + kind.mp + kind.m
    results = {name: _copied(graph, read.get(name)) for name in DERIVATIVES["dynamics_gradient"]}
    balance, gamma, zdot = (
        [node for some in results[name].values() for node in some]
        for name in ("balance", "gamma", "zdot")
    )
    tangent = results["balance_tangent"]
    udot, lam = (
        Matrix(graph, n, 1, [graph.var(letter, k) for k in range(n)])
        for letter, n in (("udot", kind.nu), ("lam", m))
    )
    missed = Matrix.zeros(graph, m)
    if "G" in tangent:
        missed = Matrix(graph, m, kind.nu, tangent["G"]) @ udot
    if "H" in tangent:
        missed = missed - Matrix(graph, m, m, tangent["H"]) @ lam
    if gamma:
        missed = missed - Matrix(graph, m, 1, gamma)
    return [*balance, *[ZERO] * (levels - len(balance)), *missed.nodes, *zdot]


def _impulse(graph: Graph, kind: Kind, read: Mapping[str, Function]) -> list[int]:
    """M udot - Gᵀ lam and G udot - H lam: without forces, which would round beside masses."""
    nu, m = kind.nu, kind.m
    tangent = _copied(graph, read["balance_tangent"])
    udot, lam = (
        Matrix(graph, n, 1, [graph.var(letter, k) for k in range(n)])
        for letter, n in (("udot", nu), ("lam", m))
    )
    balance, missed = Matrix.zeros(graph, nu), Matrix.zeros(graph, m)
    if "M" in tangent:
        balance = Matrix(graph, nu, nu, tangent["M"]) @ udot
    if "G" in tangent:
        G = Matrix(graph, m, nu, tangent["G"])
        balance, missed = balance - G.T @ lam, G @ udot
    if "H" in tangent:
        missed = missed - Matrix(graph, m, m, tangent["H"]) @ lam
    return [*balance.nodes, *missed.nodes]


# what is differentiated where it is not the results of functions as they are
ROOTS = {"dynamics": _dynamics, "impulse": _impulse}
