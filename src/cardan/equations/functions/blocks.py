"""Input blocks of the functions of a system: names and units of every entry."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...elements.internal_states import Mode
from ...elements.joints.joint import entries
from ...elements.quantity import written_unit
from ...ir.function import Block
from ...topology.internal_states import full_name, slides
from ...topology.system import System
from ..constraints.constraints import rows

if TYPE_CHECKING:
    import sympy

FORCE_UNITS = {"rad/s": "N*m", "m/s": "N"}


def coordinates(system: System) -> list[tuple[str, str, float]]:
    """(name, unit, default) of every entry of q."""
    rows: list[tuple[str, str, float]] = []
    for joint in system.joints:
        if joint.q >= 0:
            names = entries(joint.name, joint.element.coordinates)
            parts = zip(names, joint.element.coordinates, strict=True)
            rows += [(name, c.unit, c.default) for name, c in parts]
    return rows


def speeds(system: System) -> list[tuple[str, str]]:
    """(name, unit) of every entry of u: ``elbow.u``, ``ball.u.x``."""
    rows: list[tuple[str, str]] = []
    for joint in system.joints:
        if joint.u >= 0:
            names = entries(f"{joint.name}.u", joint.element.speeds)
            rows += zip(names, (c.unit for c in joint.element.speeds), strict=True)
    return rows


def accelerated(unit: str) -> str:
    """Unit of the time derivative of a speed."""
    return unit + "^2" if unit.endswith("/s") else unit + "/s"


def internals(system: System) -> list[tuple[str, str, float]]:
    """(name, unit, default) of every entry of z."""
    return [
        (
            full_name(force.name, state),
            written_unit(state.unit, slides(system.joints, force.joints.values())),
            state.default,
        )
        for force in system.forces
        for state in force.element.internals()
    ]


def discrete(system: System) -> list[tuple[str, Mode]]:
    """Name and description of every entry of s."""
    return [
        (full_name(force.name, mode), mode)
        for force in system.forces
        for mode in force.element.modes()
    ]


def defaults(system: System) -> dict[str, Array]:
    """Time, parameters, inputs, internal states and modes as a run starts with them."""
    return {
        "t": np.zeros(1),
        "p": np.array([p.value for p in system.parameters]),
        "r": np.array([i.default for i in system.inputs]),
        "z": np.array([default for _, _, default in internals(system)]),
        "s": np.array([mode.default for _, mode in discrete(system)]),
    }


def event_names(system: System) -> list[str]:
    """Name of every event."""
    return [full_name(force.name, event) for force, event in system.events]


def parts(system: System) -> list[str]:
    """Names of the user's bodies that move, in the order of the block ``wrench``."""
    return [part.name for body in system.bodies for part in body.parts]


def parameters(system: System) -> Block:
    """The block of the parameters."""
    names = tuple(p.name for p in system.parameters)
    return Block("p", names, tuple(p.unit for p in system.parameters))


def blocks(system: System, chosen: tuple[str, ...] = ()) -> dict[str, Block]:
    """Every input block of a system by its letter.

    Args:
        chosen: Names of user-chosen generalized speeds; they replace the joint speeds.
    """
    q = coordinates(system)
    u = [(name, "") for name in chosen] or speeds(system)
    names, units = tuple(n for n, _ in u), tuple(unit for _, unit in u)
    rates = tuple(accelerated(unit) if unit else "" for unit in units)
    forces = tuple(FORCE_UNITS.get(unit, "") for unit in units)
    axes = ("mx", "my", "mz", "fx", "fy", "fz")
    moments = ("N*m",) * 3 + ("N",) * 3
    touched, bound = parts(system), rows(system)
    z, modes = internals(system), tuple(name for name, _ in discrete(system))
    event_labels = tuple(event_names(system))
    listed = [
        Block("t", ("t",), ("s",)),
        Block("q", tuple(n for n, _, _ in q), tuple(unit for _, unit, _ in q)),
        Block("u", names, units),
        Block("z", tuple(n for n, _, _ in z), tuple(unit for _, unit, _ in z)),
        Block("s", modes, ("",) * len(modes)),
        Block("r", tuple(i.name for i in system.inputs), tuple(i.unit for i in system.inputs)),
        parameters(system),
        Block("udot", tuple(f"{n}dot" for n in names), rates),
        Block("lam", tuple(row.name for row in bound), tuple(row.force_unit for row in bound)),
        Block("tau", tuple(f"{n}.tau" for n in names), forces),
        Block("wrench", tuple(f"{n}.{a}" for n in touched for a in axes), moments * len(touched)),
        Block("du", tuple(f"{n}.step" for n in names), tuple(u.removesuffix("/s") for u in units)),
        Block("q0", tuple(f"{n}.0" for n, _, _ in q), tuple(unit for _, unit, _ in q)),
        Block("e", event_labels, ("",) * len(event_labels)),
        # functions that read it have entries of their own
        Block("v", (), ()),
    ]
    return {block.name: block for block in listed}


def symbols(listed: Mapping[str, Block]) -> dict[tuple[str, int], sympy.Symbol]:
    """SymPy symbol of every entry of every block."""
    import sympy

    return {
        (block.name, i): sympy.Symbol(entry)
        for block in listed.values()
        for i, entry in enumerate(block.entries)
    }


def labels(
    listed: Mapping[str, Block],
) -> tuple[dict[str, tuple[str, ...]], dict[str, tuple[str, ...]]]:
    """Names and units of the entries of every block, and of the rates of q and z."""
    names = {block.name: block.entries for block in listed.values()}
    units = {block.name: block.units for block in listed.values()}
    for letter in ("q", "z"):
        names[f"{letter}dot"] = tuple(f"{name}dot" for name in names[letter])
        units[f"{letter}dot"] = tuple(f"{unit}/s" if unit else "1/s" for unit in units[letter])
    return names, units


def identifier(name: str) -> str:
    """A user's name as part of a C name."""
    return re.sub(r"[^A-Za-z0-9_]", "_", name)


def c_name(quantity: str, of: str | None, names: list[str]) -> str:
    """C name of a quantity of a frame or joint, unique among the known names."""
    if of is None:
        return quantity
    base = identifier(of)
    clashes = [n for n in names if identifier(n) == base]
    if len(clashes) < 2:
        return f"{quantity}__{base}"
    # numbered by an order of their own, apart from names that look numbered
    while any(identifier(n).startswith(f"{base}_") for n in names):
        base += "_"
    return f"{quantity}__{base}_{clashes.index(of)}"
