"""Absolute equations on one screen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from ...errors import counted
from ..reading.typesetting import text_of

if TYPE_CHECKING:
    from .record import FiniteElementRecord

MAX_PRINTED = 10
# energies, stress, constraints and balance among the formulas of a kind
MAIN = ("T", "V", "sigma", "g", "s", "f", "F", "M", "tau", "zdot", "b_m", "b_f", "b")


def overview(scene: FiniteElementRecord) -> str:
    """Sizes, names, and for every kind of element its members, rows and operations."""
    system, places = scene.system, scene.places
    wide = max([20, *(len(group.kind.name) for group in scene.groups)])
    lines = [
        f"equations of '{system.name}' in absolute coordinates"
        + (f" ({scene.reason})" if scene.reason and not system.segments else ""),
        f"  {counted(len(places), 'place')}, {counted(places.nq, 'coordinate')}, "
        f"{counted(places.nu, 'speed')}, "
        f"{sum(len(group) * group.kind.m for group in scene.groups)} multipliers, "
        f"{counted(len(scene.parameters), 'parameter')}, {counted(len(scene.inputs), 'input')}",
        "  places: " + _row(places.names),
        f"  {'element':{wide}} members  unknowns  rows  balance  tangent",
    ]
    for group in scene.groups:
        kind = group.kind
        counts = [
            scene.operations[kind.c_name(name)].total if name in kind.functions else 0
            for name in ("balance", "balance_tangent")
        ]
        row = f"  {kind.name:{wide}} {len(group):7d}  {kind.nu:8d}  {kind.m:4d}"
        lines.append(row + f"  {counts[0]:7d}  {counts[1]:7d}")
    lines += _formulas(scene)
    return "\n".join(lines)


def _formulas(scene: FiniteElementRecord) -> Iterator[str]:
    """Energies and balances of the kinds in symbols, once each."""
    by_formulas: dict[tuple[str, ...], list[str]] = {}
    for kind in scene.kinds:
        main = tuple(line for _, line in kind.formulas if line.partition(" = ")[0] in MAIN)
        if main:
            by_formulas.setdefault(main, []).append(kind.name)
    if by_formulas:
        yield '  in symbols, which equations.explain("page.html") defines:'
    for main, kinds in by_formulas.items():
        yield f"    {_row(kinds)}: " + ", ".join(map(text_of, main))


def _row(names: Sequence[str]) -> str:
    listing = ", ".join(names[:MAX_PRINTED])
    return listing + (f", ... ({len(names)})" if len(names) > MAX_PRINTED else "")
