"""Derivatives that an FMU comes with: functions of the model, and what their zeros say."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field

from ...equations.record import EquationRecord
from ...records import dataclass
from ...schema.c_functions import ResultRow
from ...schema.manifest import Manifest
from .variables import Variable, of_kind

# pairs of speeds, as in a chain of 40: more are derived for minutes
LARGE = 1600
# derivatives by a parameter that are still cheap to compile
MANY = 600
# functions that give variables, by their kinds
FUNCTIONS = {"rate": "rhs", "output": "outputs", "energy": "energy"}
DERIVATIVE = "derivative"


@dataclass(frozen=True)
class Slopes:
    """Derivatives of an FMU.

    Attributes:
        requests: Functions to write beside those of every FMU.
        by_state, by_parameters: Names in C by the kind of variable; ``"state"`` is N.
    """

    requests: Sequence[tuple[str, str]] = ()
    by_state: Mapping[str, str] = field(default_factory=dict)
    by_parameters: Mapping[str, str] = field(default_factory=dict)


def available(equations: EquationRecord, rows: Mapping[str, int]) -> Slopes:
    """Derivatives of a model in joint coordinates; none of large ones.

    Args:
        equations: Of the model.
        rows: How many variables there are of each kind of ``FUNCTIONS``.
    """
    system = equations.system
    if system.nu**2 > LARGE or not system.nu:
        return Slopes()
    blocks = ["q", "u", *("z" if system.nz else ""), "t", *("r" if equations.inputs else "")]
    named = {kind: FUNCTIONS[kind] for kind, count in rows.items() if count}
    by_state = {kind: f"{name}: {' '.join(blocks)}" for kind, name in named.items()}
    by_state["state"] = "qdot: u"
    few = 0 < sum(rows.values()) * len(equations.parameters) <= MANY
    by_parameters = {kind: f"{name}: p" for kind, name in named.items()} if few else {}
    lines = [*by_state.values(), *by_parameters.values()]
    return Slopes(
        [(DERIVATIVE, line) for line in lines],
        {kind: equations.c_name(DERIVATIVE, line) for kind, line in by_state.items()},
        {kind: equations.c_name(DERIVATIVE, line) for kind, line in by_parameters.items()},
    )


def dependencies(
    manifest: Manifest, slopes: Slopes, variables: Sequence[Variable]
) -> dict[int, list[int]]:
    """References of the variables that each unknown depends on, where that is known."""
    on: dict[int, list[int]] = {v.reference: [v.reference] for v in of_kind(variables, "state")}
    if not slopes.by_state:
        return on
    coordinates = _coordinates(manifest, slopes)
    for kind, function in slopes.by_state.items():
        unknowns = of_kind(variables, kind)
        if kind == "state" or not unknowns:
            continue
        row = manifest.functions[function]
        named = {result.name: result for result in row.outputs}
        for i, one in enumerate(unknowns):
            places = set(_places(manifest, variables, named, coordinates, i))
            if "t" in row.inputs:
                places.add(0)
            on[one.reference] = sorted(places | set(_drift(manifest, variables, kind, i)))
    return on


def _places(
    manifest: Manifest,
    variables: Sequence[Variable],
    named: Mapping[str, ResultRow],
    coordinates: Mapping[int, list[int]],
    i: int,
) -> Iterator[int]:
    """References on which row i of a function depends."""
    states, inputs = of_kind(variables, "state"), of_kind(variables, "input")
    nq, nu = len(manifest.coordinates), len(manifest.speeds)
    for j in _columns(named["d_q"], i):
        yield from (states[k].reference for k in coordinates[j])
    for j in _columns(named["d_u"], i):
        yield states[nq + j].reference
    for j in _columns(named.get("d_z"), i):
        yield states[nq + nu + j].reference
    for j in _columns(named.get("d_r"), i):
        yield inputs[j].reference


def _columns(result: ResultRow | None, i: int) -> list[int]:
    """Columns of row i that are not always zero."""
    if result is None:
        return []
    # several results one after the other have one shape of rows and columns
    width = result.shape[-1]
    if result.sparsity is None:
        return list(range(width))
    return [entry % width for entry in result.sparsity if entry // width == i]


def _coordinates(manifest: Manifest, slopes: Slopes) -> dict[int, list[int]]:
    """Coordinates that move along each speed."""
    (result,) = manifest.functions[slopes.by_state["state"]].outputs
    rows = {i: _columns(result, i) for i in range(len(manifest.coordinates))}
    speeds = range(len(manifest.speeds))
    return {j: [i for i, columns in rows.items() if j in columns] for j in speeds}


def _drift(manifest: Manifest, variables: Sequence[Variable], kind: str, i: int) -> list[int]:
    """Rates of a quaternion grow with its length."""
    states = of_kind(variables, "state")
    return [
        states[k].reference
        for first in manifest.quaternions
        if kind == "rate" and first <= i < first + 4
        for k in range(first, first + 4)
    ]
