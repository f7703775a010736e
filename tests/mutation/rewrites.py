"""A fault in a rewrite: one number of the system as it is told anew, and a function made of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from cardan.equations.kinematics.kinematics import Kinematics
from cardan.errors import DerivationError
from cardan.ir.serialize import to_dict
from cardan.runtime.calls.objects import Key

from .faults import Fault
from .scenes import Loaded

BODIES = ("mass", "first_moment", "inertia")
JOINTS = ("rotation", "position")


def harmed(base: Loaded, rng: np.random.Generator) -> tuple[Key, dict[str, Any], Fault] | None:
    """A function of a system with a fault; None where nothing was told anew."""
    equations = base.equations
    told = [k for k in base.keys if k[1] is None and equations.ways(*k)[-1][0]]
    if not told:
        return None
    name, of = told[rng.integers(len(told))]
    names, system = equations.ways(name, of)[-1]
    changed, fault = _changed(system, rng)
    if changed is None:
        return None
    try:
        function = equations._derive(name, equations.c_name(name, of), of, Kinematics(changed, ()))
    except DerivationError:
        return None
    return (name, of), to_dict(function), replace(fault, where=f"{'+'.join(names)}: {fault.where}")


def _changed(system: Any, rng: np.random.Generator) -> tuple[Any, Fault]:
    """One number of one body or joint: its sign, another entry, or nothing."""
    rows = [(i, field, "bodies") for i in range(len(system.bodies)) for field in BODIES]
    rows += [(i, field, "joints") for i in range(len(system.joints)) for field in JOINTS]
    i, field, family = rows[rng.integers(len(rows))]
    owners = list(getattr(system, family))
    value = getattr(owners[i], field)
    nodes = list(value) if isinstance(value, tuple) else [value]
    graph = system.graph
    k, kind = int(rng.integers(len(nodes))), ("sign", "index", "missing term")[rng.integers(3)]
    new = graph.neg(nodes[k]) if kind == "sign" else 0
    if kind == "index":
        new = nodes[int(rng.integers(len(nodes)))]
    if new == nodes[k]:
        return None, Fault("none", "")
    nodes[k] = new
    if field == "inertia":
        # a tensor is symmetric, with or without a fault
        nodes[3 * (k % 3) + k // 3] = new
    owners[i] = replace(
        owners[i], **{field: tuple(nodes) if isinstance(value, tuple) else nodes[0]}
    )
    where = f"{owners[i].name}.{field}[{k}]"
    return replace(system, **{family: tuple(owners)}), Fault(kind, where)
