"""Functions as text and as DOT drawings, for people."""

from __future__ import annotations

from .function import Function, operands
from .graph import NO_ORIGIN, Graph, Node

INFIX = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
RELATIONS = {"lt": "<", "le": "<=", "eq": "=="}


def text(function: Function) -> str:
    """One line per operation, with the owner of each; inputs and results by their names.

    Such as ``n12 = n5 * q[0]    # upper.velocity``.
    """
    graph = function.graph
    read = ", ".join(f"{b.name}({len(b)})" for b in function.inputs)
    lines = [f"{function.name}({read})" + (f": {function.about}" if function.about else "")]
    for i in function.live():
        node = graph.nodes[i]
        if node[0] not in ("const", "var", "atom"):
            line = f"  n{i} = {_formula(graph, node)}"
            owner = _owner(graph, i)
            lines.append(f"{line:40}  # {owner}" if owner else line)
    for output in function.outputs:
        for k, i in enumerate(output.nodes):
            name = output.entries[k] if output.entries else str(k)
            unit = output.units[k] if output.units else ""
            unit = f"  [{unit}]" if unit else ""
            lines.append(f"  {output.name}[{k}] = {_leaf(graph, i)}  # {name}{unit}")
    return "\n".join(lines) + "\n"


def _leaf(graph: Graph, i: int) -> str:
    """Text of a leaf where it is read."""
    node = graph.nodes[i]
    if node[0] == "const":
        return f"{node[1]:g}" if float(f"{node[1]:g}") == node[1] else repr(node[1])
    if node[0] == "var":
        return f"{node[1]}[{node[2]}]"
    return str(node[1]) if node[0] == "atom" else f"n{i}"


def _formula(graph: Graph, node: Node) -> str:
    op = node[0]
    if op == "item":
        return f"n{node[1]}[{node[2]}]"
    read = [_leaf(graph, k) for k in operands(node)]
    if op in INFIX or op in RELATIONS:
        return f"{read[0]} {INFIX.get(op) or RELATIONS[op]} {read[1]}"
    if op == "neg":
        return f"-{read[0]}"
    if op == "solve":
        kind, n, m = node[1:4]
        return f"solve {kind} {n}x{n} for {m}: A = {', '.join(read[: n * n])}; B = " + ", ".join(
            read[n * n :]
        )
    return f"{op}({', '.join(read)})"


def _owner(graph: Graph, i: int) -> str:
    owner, quantity = graph.labels.get(i, graph.origins[i])
    return ".".join(filter(None, (owner, quantity)))


def dot(function: Function) -> str:
    """The function as a drawing for Graphviz: boxes are results, operations grouped by owner."""
    graph = function.graph
    groups: dict[str, list[str]] = {}
    edges: list[str] = []
    for i in function.live():
        node = graph.nodes[i]
        named = node[0] in ("const", "var", "atom")
        title = _leaf(graph, i) if named else _title(node)
        origin = graph.origins[i]
        group = "" if named or origin == NO_ORIGIN else origin[0]
        groups.setdefault(group, []).append(f"n{i} [label={quoted(title)}];")
        edges += [f"  n{k} -> n{i};" for k in operands(node)]
    for output in function.outputs:
        for k, i in enumerate(output.nodes):
            name = f"{output.name}[{k}]"
            groups.setdefault("", []).append(f"{quoted(name)} [shape=box];")
            edges.append(f"  n{i} -> {quoted(name)};")
    lines = [f"digraph {quoted(function.name)} {{", "  rankdir=LR;"]
    for number, (group, members) in enumerate(groups.items()):
        if group:
            lines += [f"  subgraph cluster_{number} {{", f"    label={quoted(group)};"]
            lines += [f"    {member}" for member in members] + ["  }"]
        else:
            lines += [f"  {member}" for member in members]
    return "\n".join([*lines, *edges, "}"]) + "\n"


def _title(node: Node) -> str:
    if node[0] == "item":
        return f"[{node[2]}]"
    return INFIX.get(node[0]) or RELATIONS.get(node[0]) or str(node[0])


def quoted(name: str) -> str:
    """A text in quotes as Graphviz reads it."""
    escaped = name.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ")
    return f'"{escaped}"'
