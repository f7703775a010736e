"""Everything in which one version of FMI differs from another."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field

from ....records import dataclass
from ..units import DISPLAYED
from ..variables import Variable
from ..xml import Element


@dataclass(frozen=True)
class Unknown:
    """A variable that is computed, with the variables it depends on.

    Attributes:
        variable: The variable.
        dependencies: Those it depends on; None: on any.
    """

    variable: Variable
    dependencies: Sequence[Variable] | None = None


@dataclass(frozen=True)
class Structure:
    """Unknowns of a model: outputs, rates, indicators, and what the initialization computes."""

    outputs: Sequence[Unknown]
    rates: Sequence[Unknown]
    indicators: Sequence[Unknown]
    initial: Sequence[Unknown]


@dataclass(frozen=True)
class Version:
    """A version of FMI.

    Attributes:
        name: Such as ``"3.0"``.
        sources: C files of its entry points; headers: those of the standard that they include.
        token: Attribute of the root that a binary is told when it is made.
        platforms: Folder of the binaries of a platform, by its name; not there: none.
        abilities: Attributes of the elements of both kinds.
        exchanging, stepping: Those of model exchange, of co-simulation.
        derivatives: Attributes where there are derivatives.
        variable: A variable as an element.
        structure: The elements of ``ModelStructure``.
        listing: Whether the description of an interface lists the sources.
        root: Further attributes of the root, by the number of event indicators.
    """

    name: str
    sources: tuple[str, ...]
    headers: tuple[str, ...]
    token: str
    platforms: Mapping[str, str]
    abilities: Mapping[str, str]
    exchanging: Mapping[str, str]
    stepping: Mapping[str, str]
    derivatives: Mapping[str, str]
    variable: Callable[[Variable], Element]
    structure: Callable[[Structure], list[Element]]
    listing: bool
    root: Callable[[int], Mapping[str, str]] = field(default=lambda indicators: {})


def common(one: Variable) -> dict[str, str | None]:
    """Attributes that a variable has in all versions."""
    kind = one.kind
    return {
        "name": one.name,
        "valueReference": str(one.reference),
        "description": one.about or None,
        "causality": kind.causality,
        "variability": kind.variability,
        "initial": kind.initial or None,
    }


def value(one: Variable) -> dict[str, str | None]:
    """Attributes about the value of a variable, the same in all versions."""
    return {
        "unit": one.unit or None,
        "displayUnit": DISPLAYED.get(one.unit),
        "min": None if one.least is None else repr(float(one.least)),
        "max": None if one.most is None else repr(float(one.most)),
        "start": None if one.start is None else repr(one.start),
    }
