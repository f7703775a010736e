"""Limits of the numbers of a scene: checked at its defaults, and written for its parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from ..elements.limits import Limit, judge
from ..ir.function import live
from ..ir.graph import Graph


@dataclass(frozen=True)
class NumberLimits:
    """Limits of the numbers of one owner.

    Attributes:
        owner: Whose they are, for messages.
        limits: Of its quantities.
        data: Quantity -> nodes of its entries.
    """

    owner: str
    limits: tuple[Limit, ...]
    data: Mapping[str, tuple[int, ...]]


@dataclass(frozen=True)
class Multiple:
    """A multiple of an entry of p, or a number alone where ``parameter`` is None."""

    factor: float
    parameter: int | None = None


def multiple(graph: Graph, node: int) -> Multiple | None:
    """The multiple of a parameter that an expression is; None if it is something else."""
    operator, *operands = graph.nodes[node]
    if operator == "const":
        return Multiple(float(operands[0]))
    if operator == "var" and operands[0] == "p":
        return Multiple(1.0, operands[1])
    if operator not in ("mul", "div", "neg"):
        return None
    factors = [multiple(graph, operand) for operand in operands]
    first, second = factors[0], factors[-1]
    if first is None or second is None:
        return None
    if operator == "neg":
        return Multiple(-first.factor, first.parameter)
    if operator == "mul" and None in (first.parameter, second.parameter):
        both = (x for x in (first.parameter, second.parameter) if x is not None)
        return Multiple(first.factor * second.factor, next(both, None))
    if operator == "div" and second.parameter is None and second.factor:
        return Multiple(first.factor / second.factor, first.parameter)
    return None


def check(
    owners: Iterable[NumberLimits], graph: Graph, defaults: Callable[[Sequence[int]], list[float]]
) -> None:
    """Refuse numbers, and expressions at the defaults of the parameters, out of their limits.

    Args:
        owners: Whose numbers they are.
        graph: Where their nodes live.
        defaults: Gives the values of expressions of the parameters at their defaults.

    Raises:
        ModelError: one is.
    """
    owners = list(owners)
    entries = {
        node: None
        for one in owners
        for limit in one.limits
        for name in (limit.name, limit.other)
        for node in one.data.get(name, ())
        if all(_steady(graph, k) for k in live(graph, [node]))
    }
    values = dict(zip(entries, defaults(list(entries)), strict=True))
    for one in owners:
        numbers: dict[str, object] = {}
        for name, nodes in one.data.items():
            known = tuple(values.get(node) for node in nodes)
            numbers[name] = known[0] if len(known) == 1 else known
        judge(one.owner, one.limits, numbers)


def _steady(graph: Graph, node: int) -> bool:
    """True unless a node is a leaf that moves with the system."""
    operator, *operands = graph.nodes[node]
    return operator != "atom" and not (operator == "var" and operands[0] != "p")
