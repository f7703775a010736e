"""The model of written equations. Loads SymPy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import sympy
from sympy.physics.mechanics import dynamicsymbols

from ...arrays import Array
from ...elements.external_equations import Written, WrittenForces
from ...elements.quantity import Ready
from ...errors import ModelError, near
from ...ir.derivative import forward
from ...ir.forms.sympy_bridge import all_from_sympy
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...ir.solve import solve
from ..scene import SceneRecord
from .constraints import Bound, bound_of, plain
from .leaves import leaves
from .names import Names, names_of, scalars
from .reference import State, samples, states
from .sources import Source, source_of

# the block of coordinates, the body it does not move, and what acts on it
BLOCK = "equations"
# of its largest entry: rounding in a matrix of numbers
ROUNDING = 1e-10
UNTOLD = "give from_sympy(..., potential=) an expression: then M is taken for the mass matrix"


def build_scene(
    equations: object,
    outputs: Mapping[str, sympy.Expr],
    parameters: Mapping[sympy.Expr, float],
    inputs: Mapping[sympy.Expr, float],
    potential: sympy.Expr | None,
    name: str,
) -> SceneRecord:
    """Same as :func:`cardan.from_sympy`."""
    source = source_of(equations)
    output_expressions = {key: sympy.sympify(e, strict=True) for key, e in outputs.items()}
    scalar_expressions = [source.lagrangian] if source.lagrangian is not None else []
    scalar_expressions += [] if potential is None else [sympy.sympify(potential, strict=True)]
    names = names_of(
        source,
        [*scalars(source), *output_expressions.values(), *scalar_expressions],
        parameters,
        source.inputs,
    )
    replaced = plain(names, source)
    bound = bound_of(names, source, replaced)
    reference_states = states(source, names, bound)
    if not reference_states:
        raise ModelError(
            "from_sympy: no state was found at which M, f, the kinematics and the constraints are "
            "all finite and the constraints hold; are the parameters' values possible ones?"
        )
    if source.implied and bound.positions:
        independent = bound.independent(reference_states[0].G)
        bound = replace(bound, speeds={key: bound.speeds[key] for key in independent})
        reference_states = [
            replace(state, G=bound.matrix(state.values)) for state in reference_states
        ]
    return _model(
        source,
        names,
        bound,
        reference_states,
        output_expressions,
        replaced,
        inputs,
        potential,
        name,
    )


def _model(
    source: Source,
    names: Names,
    bound: Bound,
    reference_states: Sequence[State],
    outputs: Mapping[str, sympy.Expr],
    replaced: Mapping[sympy.Expr, sympy.Expr],
    inputs: Mapping[sympy.Expr, float],
    potential: sympy.Expr | None,
    name: str,
) -> SceneRecord:
    """The scene: parameters, inputs, the block of coordinates, constraints and outputs."""
    scene = SceneRecord(name, gravity=(0, 0, 0))
    for parameter, value in names.parameters.items():
        scene.parameter(parameter, value)
    _declare_inputs(scene, names, bound, inputs)
    solved = not all(_symmetric(state.M) for state in reference_states)
    if solved and any(_singular(state.M) for state in reference_states):
        raise ModelError(
            "from_sympy: M is singular: some speed has no inertia, or M's rows are not those of "
            "all equations. Every acceleration must follow from M u' = f"
        )
    graph, symbols = Graph(), dict[Any, int]()
    kinematics = _kinematics(graph, symbols, source, names)
    inertia, forces = _motion(graph, symbols, source, reference_states, solved)
    moved = None if solved else (kinematics, inertia, forces)
    energy = _energy(graph, symbols, source, names, potential, moved)
    joint = Written(
        names.q,
        names.u,
        kinematics,
        samples(source, names, bound, reference_states, solved),
        _without(len(energy), kinematics, names),
    )
    body = scene.body(BLOCK)
    scene.joint(BLOCK, joint, scene.ground, body)
    scene.force("written", WrittenForces(BLOCK, inertia, forces, *energy))
    for key, expression in {**bound.positions, **bound.speeds}.items():
        scene.constraint(key, expression)
    for key, expression in outputs.items():
        scene.output(key, expression.xreplace(replaced))
    if solved:
        scene.notes.append(
            "M is not symmetric and positive definite: the equations are solved for the "
            "accelerations first, so that the model's own mass matrix is the identity"
        )
    return scene


def _declare_inputs(
    scene: SceneRecord, names: Names, bound: Bound, values: Mapping[sympy.Expr, float]
) -> None:
    """All inputs but those that the constraints of others bring along."""
    named = {names.names.get(key, str(key)): float(value) for key, value in values.items()}
    brought = {x.name for x in bound.input_rates.values()}
    declared = [name for name in names.inputs.values() if name not in brought]
    for key in named:
        if key not in declared:
            raise ModelError(f"from_sympy: inputs: there is no input '{key}'.{near(key, declared)}")
    for key in declared:
        scene.input(key, named.get(key, 0.0))


def _kinematics(
    graph: Graph, symbols: dict[sympy.Expr, int], source: Source, names: Names
) -> Ready:
    """q' as expressions; fills in what all other expressions may speak of.

    Raises:
        ModelError: they depend on inputs, or not linearly on the speeds.
    """
    t = dynamicsymbols._t
    symbols |= {x: graph.atom(name) for x, name in names.names.items()}
    symbols |= {d: ZERO for x in source.zero for d in (x, x.diff(t))}
    nodes = all_from_sympy(graph, source.rates, symbols)
    symbols |= {
        x.diff(t): node for x, node in zip(source.q, nodes, strict=True) if x.diff(t) not in symbols
    }
    moving = set(leaves(source.rates)) & set(names.inputs)
    if moving:
        raise ModelError(
            f"from_sympy: the kinematics q' depend on the input {moving.pop()}; let a speed have "
            "its place, or write it as a function of the time"
        )
    for x in source.u:
        for rate in source.rates:
            if x in leaves([rate]) and x in leaves([sympy.diff(rate, x)]):
                raise ModelError(f"from_sympy: the kinematics q' = {rate} are not linear in {x}")
    return Ready(graph, len(nodes), 1, tuple(nodes))


def _motion(
    graph: Graph,
    symbols: Mapping[sympy.Expr, int],
    source: Source,
    reference_states: Sequence[State],
    solved: bool,
) -> tuple[Ready, Ready]:
    """M and f; the identity and u' where M is not a mass matrix."""
    nu = len(source.u)
    nodes = all_from_sympy(graph, [*source.M, *source.f], symbols)
    M, f = Matrix(graph, nu, nu, nodes[: nu * nu]), Matrix(graph, nu, 1, nodes[nu * nu :])
    if solved:
        if source.positions or source.speeds:
            raise ModelError(
                "from_sympy: M is not symmetric and positive definite, so that it is not known how "
                "forces of constraint act. Give M and f before multipliers or dependent speeds are "
                "eliminated, or leave the constraints out if M has their rows"
            )
        M, f = Matrix.identity(graph, nu), solve("rank_revealing", M, f)
    # the two triangles agree; the lower one stands for both
    lower = [M.nodes[max(i, j) * nu + min(i, j)] for i in range(nu) for j in range(nu)]
    return Ready(graph, nu, nu, tuple(lower)), Ready(graph, nu, 1, f.nodes)


def _symmetric(M: Array) -> bool:
    """True when M is symmetric and positive definite, but for rounding."""
    largest = np.abs(M).max(initial=0.0)
    if np.abs(M - M.T).max(initial=0.0) > ROUNDING * largest:
        return False
    return bool(np.all(np.linalg.eigvalsh(M) > ROUNDING * largest))


def _singular(M: Array) -> bool:
    """True when M has no inverse, in units of its own rows and columns."""
    size = np.abs(M).max(axis=1, initial=0.0)
    if not size.all():
        return True
    rows = M / size[:, None]
    across = np.abs(rows).max(axis=0)
    return not across.all() or bool(np.linalg.cond(rows / across) > 1 / ROUNDING)


def _energy(
    graph: Graph,
    symbols: Mapping[sympy.Expr, int],
    source: Source,
    names: Names,
    potential: sympy.Expr | None,
    moved: tuple[Ready, Ready, Ready] | None,
) -> tuple[Ready, ...]:
    """The potential, and the forces beside it; () where no potential is known.

    Of a Lagrangian, -L at rest: with 1/2 uᵀ M u it makes the integral of Jacobi.

    Args:
        moved: q', M and f; None where M is not a mass matrix.

    Raises:
        ModelError: a potential that is not one of coordinates.
    """
    expression = source.lagrangian if potential is None else sympy.sympify(potential, strict=True)
    if expression is None or (moved is None and potential is None):
        return ()
    if moved is None:
        raise ModelError(
            "from_sympy: potential= goes with the mass matrix, but M is not symmetric and positive "
            "definite: multiply the equations so that 1/2 uᵀ M u is the kinetic energy"
        )
    node = all_from_sympy(graph, [expression], symbols)[0]
    moving = {dynamicsymbols._t, *names.inputs} | (
        set(source.u) if potential is not None else set()
    )
    if moving & set(leaves([expression])):
        if potential is None:
            return ()
        raise ModelError("from_sympy: potential= depends on coordinates and parameters alone")
    speeds = [symbols[x] for x in source.u]
    if potential is not None:
        return Ready(graph, 1, 1, (node,)), *_spent(node, speeds, names, moved)
    node = graph.neg(rebuild(graph, [node], dict.fromkeys(speeds, ZERO), into=graph)[1][0])
    applied = all_from_sympy(graph, source.applied, symbols)
    return Ready(graph, 1, 1, (node,)), Ready(graph, len(applied), 1, tuple(applied))


def _spent(
    potential: int, speeds: Sequence[int], names: Names, moved: tuple[Ready, Ready, Ready]
) -> tuple[Ready, ...]:
    """Forces whose power is the change of 1/2 uᵀ M u and the potential: f + Nᵀ dV/dq + 1/2 M' u.

    () where the coordinates move without speeds.
    """
    kinematics, inertia, forces = moved
    g, nu = kinematics.graph, len(speeds)
    drift = rebuild(g, kinematics.nodes, dict.fromkeys(speeds, ZERO), into=g)[1]
    if any(drift):
        return ()
    along = {g.atom(name): rate for name, rate in zip(names.q, kinematics.nodes, strict=True)}
    mass_rate = Matrix(g, nu, nu, forward(g, inertia.nodes, along))
    # the change of V is linear in the speeds, with the forces that it makes as factors
    (change,) = forward(g, [potential], along)
    pulled = [forward(g, [change], {speed: ONE})[0] for speed in speeds]
    spent = Matrix(g, nu, 1, forces.nodes) + Matrix(g, nu, 1, pulled)
    spent = spent + mass_rate @ Matrix(g, nu, 1, speeds) * 0.5
    return (Ready(g, nu, 1, spent.nodes),)


def _without(level: int, kinematics: Ready, names: Names) -> dict[str, str]:
    """Functions that these equations do not give, and why.

    Args:
        level: 1 with a potential, 2 with the forces beside it.
    """
    reasons = dict[str, str]()
    if level < 1:
        why = f"written equations do not tell potential energy; {UNTOLD}"
        reasons |= dict.fromkeys(("energy", "hamiltonian"), why)
    if level < 2:
        reasons["power"] = "it is not known which forces have a potential"
    graph = kinematics.graph
    if kinematics.nodes != tuple(graph.atom(name) for name in names.u):
        reasons["move"] = "finite motions along the speeds are known where these are q' themselves"
    return reasons
