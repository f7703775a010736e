"""Copying expressions with replacements, through the constructors that simplify."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from .function import Function, Output, live
from .graph import NO_ORIGIN, Graph, Node
from .ops import COMMUTATIVE, LEAVES

# makes the copy of node i in the target, given where its operands went; None: copy it as usual
Rule: TypeAlias = Callable[[Graph, int, Mapping[int, int]], "int | None"]
Replacement: TypeAlias = "Mapping[int, int] | Rule"


def rebuild(
    graph: Graph,
    roots: Sequence[int],
    replace: Replacement | None = None,
    into: Graph | None = None,
    thorough: bool = False,
) -> tuple[Graph, list[int]]:
    """Copy what the roots need, replacing nodes on the way.

    Origins and labels go with the nodes. What no replacement touches is copied as it stands;
    what depends on a replaced node is made anew by the simplifying constructors.

    Args:
        graph: Where the roots live.
        roots: Nodes to copy.
        replace: Node -> node of the target that stands for it, taken as it is; or a function
            ``rule(target, node, copies)``, with ``copies`` the places of the operands' copies,
            that returns a node of the target or None.
        into: Target; a new graph by default. It may be ``graph`` itself.
        thorough: Pass every node through its constructor.

    Returns:
        The target and the copies of the roots.
    """
    target = Graph() if into is None else into
    if into is None:
        target.tables, target.formulas = graph.tables.copy(), graph.formulas.copy()
    if callable(replace):
        rule: Rule | None = replace
        copies: dict[int, int] = {}
    else:
        rule, copies = None, dict(replace or {})
    before = target.origin
    try:
        copy(graph, target, live(graph, roots, copies), copies, rule, thorough)
    finally:
        target.origin = before
    return target, [copies[i] for i in roots]


def rebuild_function(
    function: Function, replace: Replacement | None = None, thorough: bool = False
) -> Function:
    """The function in a graph of its own that holds nothing else; see :func:`rebuild`."""
    graph, roots = rebuild(function.graph, function.roots, replace, thorough=thorough)
    return with_roots(function, graph, roots)


def with_roots(function: Function, graph: Graph, roots: Sequence[int]) -> Function:
    """The function with other nodes for its results, in their order."""
    outputs: list[Output] = []
    at = 0
    for o in function.outputs:
        nodes = tuple(roots[at : at + len(o.nodes)])
        outputs.append(Output(o.name, o.shape, nodes, o.entries, o.units))
        at += len(nodes)
    f = function
    return Function(f.name, graph, f.inputs, tuple(outputs), f.owners, f.about)


def copy(
    graph: Graph,
    target: Graph,
    order: Sequence[int],
    copies: dict[int, int],
    rule: Rule | None = None,
    thorough: bool = False,
) -> None:
    """Copy nodes in topological order, filling ``copies``; see :func:`rebuild`."""
    nodes, origins = graph.nodes, graph.origins
    intern, here = target.intern, graph is target
    # what replaces a placeholder is what it stands for
    faithful = all(nodes[i][0] == "atom" for i in copies)
    # nodes whose copy is not the same operator on copies of the same operands
    changed = set(copies)
    for i in order:
        if i in copies:
            continue
        node = nodes[i]
        op = node[0]
        target.origin = origins[i]
        if rule is not None:
            replacement = rule(target, i, copies)
            if replacement is not None:
                copies[i] = replacement
                changed.add(i)
                continue
        if op in LEAVES:
            copies[i] = i if here else intern(node)
            continue
        touched = thorough or (bool(changed) and not changed.isdisjoint(_read(node)))
        if here and not touched:
            copies[i] = i
            continue
        key = _key(node, copies)
        if touched:
            copies[i] = target.apply(op, *key[1:]) if op not in _STANDALONE else intern(key)
            changed.add(i)
        else:
            copies[i] = intern(key)
        # with other values in place of inputs a node is not what its name says
        if faithful or not (here and touched):
            target.adopt(copies[i], graph, i)
        if i in graph.shared and not here:
            _share(target, copies[i], graph, i)


_STANDALONE = frozenset({"solve", "item", "table"})


def _read(node: Node) -> Node:
    op = node[0]
    return node[4:] if op == "solve" else node[1:2] if op == "item" else node[1:]


def _key(node: Node, copies: Mapping[int, int]) -> Node:
    """The node on the copies of its operands."""
    op = node[0]
    if len(node) == 3 and op != "item":
        a, b = copies[node[1]], copies[node[2]]
        return (op, b, a) if b < a and op in COMMUTATIVE else (op, a, b)
    if op == "item":
        return (op, copies[node[1]], node[2])
    if op == "solve":
        return (*node[:4], *[copies[k] for k in node[4:]])
    return (op, *[copies[k] for k in node[1:]])


def _share(target: Graph, copy: int, graph: Graph, i: int) -> None:
    """Further owners of node i go with its copy."""
    more = graph.shared[i] - {target.origins[copy], NO_ORIGIN}
    if more:
        target.shared.setdefault(copy, set()).update(more)
