"""Expressions of a graph as Python that people read: formulas ``left = right``, one a line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ..function import live, operands
from ..graph import Graph
from ..ops import LEAVES

CONDITION, SUM, PRODUCT, POWER, ATOM = range(5)
INFIX = {"add": ("+", SUM), "sub": ("-", SUM), "mul": ("*", PRODUCT), "div": ("/", PRODUCT)}
RELATIONS = {"lt": "<", "le": "<=", "eq": "=="}
# what has no formula that people read
UNREADABLE = frozenset({"solve", "item", "table", "stumpff", "and", "or", "not"})
# operations of an expression that is used several times from which on it has a name
NAMED = 3
# operations of all formulas together that anyone reads
LONGEST = 400
# of numbers
DIGITS = 12

Text = tuple[int, str]


def formulas(
    graph: Graph, roots: Sequence[int], leaf: Callable[[int], str | None], head: str, first: int = 0
) -> tuple[list[str], list[str]] | None:
    """Formulas of what is used several times, then the roots in terms of them.

    Args:
        graph: Where the roots live.
        roots: Expressions.
        leaf: Name of a leaf, None for one that has none.
        head: Letter of what gets a name: ``c`` gives ``c_1 = ...``.
        first: How many have such names already.

    Returns:
        (definitions, expressions of the roots); None where nobody would read them.
    """
    order = live(graph, roots)
    if any(graph.nodes[i][0] in UNREADABLE for i in order) or len(order) > LONGEST:
        return None
    uses, sizes = dict.fromkeys(order, 0), dict.fromkeys(order, 0)
    for i in order:
        if graph.nodes[i][0] in LEAVES:
            continue
        sizes[i] = 1 + sum(sizes[k] for k in operands(graph.nodes[i]))
        for k in operands(graph.nodes[i]):
            uses[k] += 1
    texts: dict[int, Text] = {}
    definitions = list[str]()
    for i in order:
        text = _text(graph, i, texts, leaf)
        if text is None:
            return None
        if uses[i] > 1 and sizes[i] >= NAMED and graph.nodes[i][0] != "neg":
            name = f"{head}_{first + len(definitions) + 1}"
            definitions.append(f"{name} = {text[1]}")
            text = ATOM, name
        texts[i] = text
    return definitions, [texts[i][1] for i in roots]


def _text(
    graph: Graph, i: int, texts: Mapping[int, Text], leaf: Callable[[int], str | None]
) -> Text | None:
    """A node by the texts of its operands."""
    node = graph.nodes[i]
    if node[0] == "const":
        return number(node[1])
    if node[0] in LEAVES:
        name = leaf(i)
        return None if name is None else (ATOM, name)
    inner = [texts[k] for k in operands(node)]
    if node[0] == "mul" and node[1] == node[2]:
        return POWER, f"{_at_least(inner[0], ATOM)} ** 2"
    if node[0] == "mul" and graph.nodes[node[2]][0] == "const":
        inner = inner[::-1]
    if node[0] in INFIX:
        sign, binding = INFIX[node[0]]
        right = binding if node[0] in ("add", "mul") else binding + 1
        return binding, f"{_at_least(inner[0], binding)} {sign} {_at_least(inner[1], right)}"
    if node[0] in RELATIONS:
        sides = [_at_least(x, SUM) for x in inner]
        return CONDITION, f"{sides[0]} {RELATIONS[node[0]]} {sides[1]}"
    if node[0] == "select":
        condition, first, second = inner
        if graph.nodes[node[1]][0] not in RELATIONS:
            return None
        return CONDITION, f"{_at_least(first, SUM)} if {condition[1]} else {_at_least(second, SUM)}"
    if node[0] == "neg":
        # a minus before a product is that of all of it
        return SUM, f"-({inner[0][1]})" if inner[0][0] < POWER else f"-{inner[0][1]}"
    if node[0] == "pow":
        return POWER, f"{_at_least(inner[0], ATOM)} ** {_at_least(inner[1], ATOM)}"
    return ATOM, f"{node[0]}({', '.join(text for _, text in inner)})"


def _at_least(text: Text, binding: int) -> str:
    return text[1] if text[0] >= binding else f"({text[1]})"


def number(value: float) -> Text:
    """A whole number as such, another with the digits that people read."""
    is_integer = value == int(value) and abs(value) < 1e15
    text = str(int(value)) if is_integer else repr(float(f"{value:.{DIGITS}g}"))
    return (SUM if value < 0 else ATOM), text
