"""Limits of the numbers of a scene: checked where they are written, and where they change.

Constructors, the defaults of a scene, and new values of parameters go by the same limits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from ..errors import ModelError
from ..ir.function import live
from ..ir.graph import Graph
from ..records import dataclass
from ..schema.entries import LimitRow


@dataclass(frozen=True)
class Limit:
    """Limits of one quantity of a section, a material, a cable or a force element.

    Attributes:
        name: Of the quantity; of several entries each has these limits.
        message: What is said where it is something else; ``{value}`` stands for it, ``{other}`` for
            what it must not be below.
        least, most: Its range.
        open: The least value itself, or that of the other quantity, is not in it.
        other: Name of a quantity of which it must not be below a multiple; "" for none.
        times: Which multiple.
        nonzero: 0 is not in it.
    """

    name: str
    message: str
    least: float = -math.inf
    most: float = math.inf
    open: bool = False
    other: str = ""
    times: float = 1.0
    nonzero: bool = False


def not_negative(*names: str, requirement: str = "0 or more") -> tuple[Limit, ...]:
    """Quantities from 0 on."""
    return tuple(Limit(name, f"{name} is {{value}}; give {requirement}", 0.0) for name in names)


def positive(*names: str, requirement: str = "more than 0") -> tuple[Limit, ...]:
    """Quantities above 0."""
    return tuple(
        Limit(name, f"{name} is {{value}}; give {requirement}", 0.0, open=True) for name in names
    )


def judge(who: str, limits: Sequence[Limit], values: Mapping[str, Any]) -> None:
    """Refuse numbers out of their limits; expressions are judged when they get their numbers.

    Args:
        who: Whose they are, for messages.
        limits: Of the element.
        values: Name -> number, expression or None, or a tuple of such.

    Raises:
        ModelError: one is.
    """
    for limit in limits:
        entries, least = values.get(limit.name), limit.least
        if limit.other:
            other = values.get(limit.other)
            if not isinstance(other, float):
                continue
            least = limit.times * other
        for value in entries if isinstance(entries, tuple) else (entries,):
            if not isinstance(value, float):
                continue
            excluded = (limit.open and value == least) or (limit.nonzero and value == 0)
            if value < least or value > limit.most or excluded:
                message = limit.message.replace("{value}", f"{value:g}")
                raise ModelError(f"{who}: {message.replace('{other}', f'{least:g}')}")


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
            entries_of = tuple(values.get(node) for node in nodes)
            numbers[name] = entries_of[0] if len(entries_of) == 1 else entries_of
        judge(one.owner, one.limits, numbers)


def limit_rows(
    owners: Iterable[NumberLimits], graph: Graph, names: Sequence[str]
) -> list[LimitRow]:
    """Limits of the parameters that are numbers of elements, each once.

    Args:
        owners: Whose numbers they are.
        graph: Where their nodes live.
        names: Of the parameters.
    """
    rows: dict[tuple[object, ...], LimitRow] = {}
    for one in owners:
        for limit in one.limits:
            for row in _rows(graph, names, one, limit):
                rows.setdefault(_key(row), row)
    return list(rows.values())


def _key(row: LimitRow) -> tuple[object, ...]:
    """The common part of limits that say the same of a parameter."""
    least = row.times / row.scale if isinstance(row.least, str) else (row.least or 0.0) / row.scale
    other = row.least if isinstance(row.least, str) else row.least is None
    return (row.parameter, row.message, other, least, (row.most or 0.0) / row.scale, row.scale > 0)


def _rows(
    graph: Graph, names: Sequence[str], one: NumberLimits, limit: Limit
) -> Iterator[LimitRow]:
    """Rows of one limit: of each entry of its quantity that is a multiple of a parameter."""
    least = Multiple(limit.least)
    if limit.other:
        other = [multiple(graph, node) for node in one.data.get(limit.other, ())]
        if len(other) != 1 or other[0] is None:
            return
        least = Multiple(limit.times * other[0].factor, other[0].parameter)
    for node in one.data.get(limit.name, ()):
        entry = multiple(graph, node)
        if entry is None:
            continue
        if entry.parameter is not None:
            bound = least.factor if math.isfinite(least.factor) else None
            yield LimitRow(
                parameter=names[entry.parameter],
                element=one.owner,
                message=limit.message,
                least=bound if least.parameter is None else names[least.parameter],
                most=limit.most if math.isfinite(limit.most) else None,
                open=limit.open,
                nonzero=limit.nonzero,
                scale=entry.factor,
                times=1.0 if least.parameter is None else least.factor,
            )
        elif least.parameter is not None:
            # seen from the other side: the number is the most that the other may be
            message = limit.message.replace("{value}", f"{entry.factor:g}")
            yield LimitRow(
                parameter=names[least.parameter],
                element=one.owner,
                message=message.replace("{other}", "{value}"),
                most=entry.factor,
                below=limit.open,
                scale=least.factor,
            )


def _steady(graph: Graph, node: int) -> bool:
    """True unless a node is a leaf that moves with the system."""
    operator, *operands = graph.nodes[node]
    return operator != "atom" and not (operator == "var" and operands[0] != "p")
