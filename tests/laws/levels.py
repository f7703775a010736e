"""The constraints of systems at three levels, differentiated by complex steps: no C is compiled."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

import cardan as cd
from cardan.equations.constraints.constraints import POSITION, rows
from cardan.equations.functions.blocks import blocks
from cardan.equations.functions.dynamics import Dynamics
from cardan.equations.kinematics.kinematics import Kinematics
from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from cardan.ir.serialize import from_dict
from cardan.runtime.calls.code import Code
from cardan.runtime.calls.interpreted import Interpreted
from cardan.runtime.models.finite_elements.elements import State
from cardan.runtime.models.finite_elements.mesh import Mesh
from cardan.runtime.models.finite_elements.table_loading import data_of, tables_of
from cardan.runtime.verification.differences import input_rates
from cardan.schema.blocks import ABI_ORDER

H = 1e-30
TIME = 0.3
SEED = 11
# rows of a sum of some hundred products, each a few roundings off
ROUNDING = 1e-12


def apart(exact: Any, claimed: Any, terms: Any) -> float:
    """The largest difference of rows over the largest term of the row."""
    exact, claimed, terms = (np.atleast_1d(np.asarray(x, float)) for x in (exact, claimed, terms))
    assert np.isfinite(exact).all()
    size = np.maximum(np.maximum(np.abs(exact), terms), 1e-3)
    return float((np.abs(exact - claimed) / size).max(initial=0.0))


def compared(now: Mapping[str, Any], later: Mapping[str, Any], u: Any, udot: Any) -> float:
    """How far the levels of some rows are from being derivatives of each other.

    Args:
        now: g, rates, G and gamma at a state; ``still``, the rates where u is 0.
        later: g and rates a complex step later.
        u, udot: Speeds and their rates there.
    """
    G = np.asarray(now["G"], float).reshape(len(now["rates"]), len(u))
    rates, mp = np.asarray(now["rates"], float), len(now["g"])
    change = {name: np.imag(np.asarray(later[name], complex)) / H for name in ("g", "rates")}
    moved, turned = (np.abs(G * x).max(axis=1, initial=0.0) for x in (u, udot))
    return max(
        apart(change["g"], rates[:mp], moved[:mp]),
        apart(rates - np.asarray(now["still"], float), G @ u, moved),
        apart(change["rates"], G @ udot - np.asarray(now["gamma"], float), turned),
    )


# joint coordinates


def of_tree(scene: cd.Scene, states: int = 2) -> tuple[int, float]:
    """Number of rows of a scene in joint coordinates and the largest error of all levels."""
    # any formalism has the kinematics; this one takes every system
    equations = cd.derive(scene, method="newton_euler", coordinates="relative")
    system = equations.system
    made = rows(system)
    if not made:
        return 0, 0.0
    c = Dynamics(Kinematics(system), "newton_euler").constraints
    parts = {"g": c.position, "rates": c.rates, "G": c.jacobian, "gamma": c.gamma}
    listed = blocks(system)
    levels = Function(
        "levels",
        c.k.graph,
        tuple(listed[letter] for letter in ABI_ORDER if letter in listed),
        tuple(Output(name, (len(x.nodes),), x.nodes) for name, x in parts.items()),
    )
    assert sum(row.level == POSITION for row in made) == len(c.position.nodes)
    rng, worst = np.random.default_rng(SEED), 0.0
    start = np.array([entry for j in system.joints if j.q >= 0 for entry in _defaults(j)])
    p = [parameter.value for parameter in system.parameters]
    fixed = {"p": p, "s": _start(listed, "s"), "z": _start(listed, "z"), "tau": [0] * system.nu}
    for _ in range(states):
        u, udot, du = rng.uniform(-1, 1, (3, system.nu))
        r = rng.uniform(-0.3, 0.3, len(system.inputs))
        at = {**fixed, "t": [TIME], "r": r, "u": u}
        q = _one(equations, "integrate", {**at, "q": start, "du": 0.4 * du})
        at["q"] = q
        qdot = _one(equations, "qdot", at)
        rdot = input_rates([entry.name for entry in system.inputs], r)
        steps = {"t": [1.0], "r": rdot, "u": udot, "q": qdot}
        later = at | {k: np.asarray(at[k]) + 1j * H * np.asarray(x) for k, x in steps.items()}
        now = evaluate(levels, at, "complex")
        now["still"] = evaluate(levels, at | {"u": 0 * u}, "complex")["rates"]
        now = {name: np.real(x) for name, x in now.items()}
        worst = max(worst, compared(now, evaluate(levels, later, "complex"), u, udot))
    return len(made), worst


def _defaults(joint: Any) -> list[float]:
    return [c.default for c in joint.element.coordinates]


def _start(listed: Mapping[str, Any], letter: str) -> list[float]:
    return [0.0] * len(listed[letter]) if letter in listed else []


def _one(equations: Any, name: str, given: Mapping[str, Any]) -> Any:
    function = equations.function(name)
    (value,) = evaluate(function, given, "numpy").values()
    return np.broadcast_to(value, given["q"].shape)


# finite-element coordinates


def of_elements(scene: cd.Scene, states: int = 2) -> tuple[int, float]:
    """The same in absolute coordinates, element by element."""
    model = cd.compile(scene, coordinates="absolute")
    tables, saved = tables_of(model), model._objects.saved()

    def load(symbols: Any) -> dict[str, Code]:
        known = {s: Interpreted(from_dict(saved[s])) for s in symbols}
        return {s: Code(s, entries[s], False, f.address, interpreted=f) for s, f in known.items()}

    data, entries = [data_of(model, group) for group in tables.groups], model.manifest["functions"]
    library, lock = model._kernels(), model._objects.lock
    elements = Mesh(tables, entries, load, data, 1, library, lock, lambda *_: None)
    rng, worst, count = np.random.default_rng(SEED), 0.0, 0
    start, modes = model.split(model.initial())[0], model._layout.start("s")
    for _ in range(states):
        u, udot, du = rng.uniform(-1, 1, (3, model.nu))
        r = rng.uniform(-0.3, 0.3, model.nr)
        q = elements.move(start, 0.4 * du)
        at = State(q=q, u=u, udot=udot, t=TIME, r=r, s=modes)
        qdot, rdot = elements.rates(q, u), input_rates(model.inputs, r)
        count = 0
        for number, group in enumerate(tables.groups):
            if group.kind.m:
                count += len(group) * group.kind.m
                places = tables.places_of(group)
                steps = {"q": qdot[places], "r": rdot, "t": np.ones(1)}
                worst = max(worst, _group(elements, saved, number, at, steps))
    return count, worst


def _group(elements: Mesh, saved: Any, number: int, at: State, steps: Mapping[str, Any]) -> float:
    """The largest error of the elements of a group."""
    group, worst = elements.tables.groups[number], 0.0
    names = group.kind.functions
    forms = {
        form: from_dict(saved[names[form]])
        for form in ("balance", "balance_tangent", "gamma")
        if form in names
    }
    given, nu, mp = elements.read(number, at), group.kind.nu, group.kind.mp
    for member in range(len(group)):
        own = {k: x if x.ndim == 1 else x[member] for k, x in given.items()}
        moves = {k: x if x.ndim == 1 else x[member] for k, x in steps.items()}
        moves["u"] = own["udot"]
        later = own | {k: own[k] + 1j * H * x for k, x in moves.items()}
        now, then = (_levels(forms["balance"], x, nu, mp) for x in (own, later))
        now["still"] = _levels(forms["balance"], own | {"u": 0 * own["u"]}, nu, mp)["rates"]
        tangent = evaluate(forms["balance_tangent"], own, "complex") if len(forms) > 1 else {}
        now["G"] = tangent.get("G", np.zeros(group.kind.m * nu))
        gamma = np.zeros(group.kind.m)
        if "gamma" in forms:
            (gamma,) = evaluate(forms["gamma"], own, "complex").values()
        now["gamma"] = gamma
        now = {name: np.real(x) for name, x in now.items()}
        worst = max(worst, compared(now, then, own["u"], own["udot"]))
    return worst


def _levels(function: Function, given: Mapping[str, Any], nu: int, mp: int) -> dict[str, Any]:
    values = evaluate(function, given, "complex")
    flat = np.concatenate([np.ravel(values[o.name]) for o in function.outputs])
    return {"g": flat[nu : nu + mp], "rates": flat[nu + mp :]}
