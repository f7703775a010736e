"""Rows of the manifest that say which values parameters may have."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from ..elements.limits import Limit
from ..schema.entries import LimitRow
from ..topology.number_limits import Multiple, NumberLimits, multiple
from ..topology.system import System


def limit_rows(system: System) -> list[LimitRow]:
    """Limits of the parameters that are numbers of elements, each once."""
    rows: dict[tuple[object, ...], LimitRow] = {}
    for one in system.number_limits:
        for limit in one.limits:
            for row in _rows(system, one, limit):
                rows.setdefault(_key(row), row)
    return list(rows.values())


def _key(row: LimitRow) -> tuple[object, ...]:
    """What limits that say the same of a parameter have in common."""
    least = row.times / row.scale if isinstance(row.least, str) else (row.least or 0.0) / row.scale
    other = row.least if isinstance(row.least, str) else row.least is None
    return (row.parameter, row.message, other, least, (row.most or 0.0) / row.scale, row.scale > 0)


def _rows(system: System, one: NumberLimits, limit: Limit) -> Iterator[LimitRow]:
    """Rows of one limit: of each entry of its quantity that is a multiple of a parameter."""
    least = Multiple(limit.least)
    if limit.other:
        other = [multiple(system.graph, node) for node in one.data.get(limit.other, ())]
        if len(other) != 1 or other[0] is None:
            return
        least = Multiple(limit.times * other[0].factor, other[0].parameter)
    names = [parameter.name for parameter in system.parameters]
    for node in one.data.get(limit.name, ()):
        entry = multiple(system.graph, node)
        if entry is None:
            continue
        if entry.parameter is not None:
            bound = least.factor if isfinite(least.factor) else None
            yield LimitRow(
                parameter=names[entry.parameter],
                element=one.owner,
                message=limit.message,
                least=bound if least.parameter is None else names[least.parameter],
                most=limit.most if isfinite(limit.most) else None,
                open=limit.open,
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
