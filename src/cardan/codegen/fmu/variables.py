"""The one table of the variables of an FMU; C and the descriptions follow from it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from ...records import dataclass
from ...schema.entries import Entry
from ...schema.manifest import Manifest

ENERGIES = ("kinetic", "potential", "total")
# events whose times the importer finds
SIGNED = ("mode", "impact", "end")


class Kind(NamedTuple):
    """Common properties of the variables of a kind.

    Attributes:
        name: In C ``FMU_<NAME>``; put before names that are taken.
        causality, variability, initial: As FMI has them; of states also by the model.
    """

    name: str
    causality: str
    variability: str
    initial: str = ""


# in the order of the value references, which is that of fmu_core.h
KINDS = (
    Kind("time", "independent", "continuous"),
    Kind("state", "output", "continuous", "exact"),
    Kind("rate", "local", "continuous", "calculated"),
    Kind("parameter", "parameter", "tunable", "exact"),
    Kind("input", "input", "continuous"),
    Kind("mode", "local", "discrete", "calculated"),
    Kind("output", "output", "continuous", "calculated"),
    Kind("energy", "output", "continuous", "calculated"),
    Kind("indicator", "local", "continuous", "calculated"),
)


@dataclass(frozen=True)
class Variable:
    """A variable of an FMU.

    Attributes:
        kind: Of the table.
        name: As importers show it.
        unit: SI, "" without one.
        start: Value before the first step; None where it is computed.
        about: One line for people.
        reference: Its value reference, and its place in the description.
        least, most: What a parameter may be.
        state: The state it is the rate of.
    """

    kind: Kind
    name: str
    unit: str = ""
    start: float | None = None
    about: str = ""
    reference: int = 0
    least: float | None = None
    most: float | None = None
    state: Variable | None = None


class Facts(NamedTuple):
    """Facts for the table that the manifest does not hold.

    Attributes:
        start: Values at the start, by block.
        outputs: Names and units of the outputs.
        exchange: Whether it serves model exchange, which sees rates and indicators.
        energies: Whether there are energies.
    """

    start: Mapping[str, Sequence[float]]
    outputs: Sequence[tuple[str, str]]
    exchange: bool
    energies: bool


def table(manifest: Manifest, facts: Facts) -> list[Variable]:
    """All variables, in the order of their value references; every name is there once."""
    taken: set[str] = set()
    listed: list[Variable] = []
    states: dict[str, Variable] = {}
    rows = {kind.name: list(_rows(kind, manifest, facts)) for kind in KINDS}
    for kind in KINDS:
        for row in rows[kind.name]:
            name = _new(row.name, kind.name, taken)
            state = states[row.state.name] if row.state else None
            row = replace(row, name=name, reference=len(listed), state=state)
            if kind.name == "state":
                states[row.name] = row
            listed.append(row)
    return listed


def of_kind(variables: Sequence[Variable], name: str) -> list[Variable]:
    """Variables of a kind, in their order."""
    return [one for one in variables if one.kind.name == name]


def _new(name: str, kind: str, taken: set[str]) -> str:
    """A name that is not taken: the same, else with its kind before it."""
    while name in taken:
        name = f"{kind}.{name}"
    taken.add(name)
    return name


def _rows(kind: Kind, manifest: Manifest, facts: Facts) -> Iterator[Variable]:
    """Variables of a kind, without their references."""
    if kind.name == "time":
        yield Variable(kind, "time", "s", about="time")
    elif kind.name == "state":
        yield from _states(kind, manifest, facts.start)
    elif kind.name == "rate" and facts.exchange:
        for state in _states(kind, manifest, facts.start):
            unit = per_second(state.unit)
            yield Variable(kind, f"der({state.name})", unit, None, "derivative", state=state)
    elif kind.name == "parameter":
        yield from _parameters(kind, manifest)
    elif kind.name == "input":
        for row in manifest.inputs:
            yield Variable(kind, row.name, row.unit, float(row.default), "input")
    elif kind.name == "mode":
        for mode in manifest.s:
            labels = ", ".join(f"{value}: {text}" for value, text in mode.labels.items())
            yield Variable(kind, mode.name, mode.unit, None, labels or "sampled value")
    elif kind.name == "output":
        for name, unit in facts.outputs:
            yield Variable(kind, name, unit, None, "output")
    elif kind.name == "energy" and facts.energies:
        for name in ENERGIES:
            yield Variable(kind, f"energy.{name}", "J", None, f"{name} energy")
    elif kind.name == "indicator" and facts.exchange:
        for event in manifest.events:
            if event.kind in SIGNED:
                about = f"event: {event.about}" if event.about else "event"
                yield Variable(kind, f"event.{event.name}", event.unit, None, about)


def _states(
    kind: Kind, manifest: Manifest, start: Mapping[str, Sequence[float]]
) -> Iterator[Variable]:
    """q, u and z. Loops are closed next to where q and u are said to start."""
    closed = bool(manifest.multipliers) and manifest.projected
    inner = _inner(manifest)
    abouts = {"q": "coordinate", "u": "speed", "z": "internal state"}
    for block, about in abouts.items():
        rows: Sequence[Entry] = manifest.block(block)
        for row, value in zip(rows, start[block], strict=True):
            initial = "approx" if closed and block != "z" else kind.initial
            causality = "local" if getattr(row, "joint", None) in inner else kind.causality
            this = kind._replace(initial=initial, causality=causality)
            yield Variable(this, row.name, row.unit, float(value), about)


def _inner(manifest: Manifest) -> frozenset[str]:
    """Nodes inside beams: they can be read, but are not among the outputs."""
    names = {row.joint for row in manifest.coordinates if getattr(row, "joint", None)}
    beams = tuple(f"{beam.name}.node" for beam in manifest.beams)
    return frozenset(name for name in names if name and beams and name.startswith(beams))


def _parameters(kind: Kind, manifest: Manifest) -> Iterator[Variable]:
    limits = {row.parameter: row for row in manifest.limits if row.scale == 1.0}
    # lengths of beams, and what is prescribed of their nodes, do not follow in a run
    fixed = kind._replace(variability="fixed") if manifest.absolute else kind
    for row in manifest.parameters:
        limit = limits.get(row.name)
        least = limit.least if limit and isinstance(limit.least, float | int) else None
        yield Variable(
            fixed,
            row.name,
            row.unit,
            float(row.default),
            "parameter",
            least=least,
            most=limit.most if limit else None,
        )


def per_second(unit: str) -> str:
    """The unit of a derivative: that of a speed for ``rad``, of an acceleration for ``m/s``."""
    above, _, below = unit.partition("/")
    seconds = re.fullmatch(r"s(?:\^(\d+))?", below)
    if seconds is not None:
        return f"{above}/s^{int(seconds[1] or 1) + 1}"
    return f"{unit or 1}/s"
