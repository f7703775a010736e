"""Surroundings of the equations of motion: kinematics, internal states, outputs, to first order."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...errors import DerivationError
from ...ir.derivative import forward
from ...ir.function import live
from ...ir.matrix import Matrix
from ..functions import event_functions, outputs
from ..functions.directions import Direction, directions
from .reference import Reference

Columns = Callable[[Reference, Matrix, Sequence[Direction]], Matrix]


def outward(at: Reference, columns: Columns) -> dict[str, Matrix]:
    """The parts of :class:`.FullMatrices` without dynamics, at the reference."""
    _refuse_driven(at)
    wrt = {letter: directions(at.k, letter, at.names) for letter in ("q", "u", "z", "r", "udot")}
    matrices = observer(at, wrt["q"])
    rates = event_functions.rates(at.d) if at.system.nz else Matrix.zeros(at.graph, 0)
    matrices["edot"] = Matrix(at.graph, at.system.nu, 1, _speeds(at, list(at.k.rates.nodes)))
    matrices["zdot"] = rates
    for name, letter in (("Ze", "q"), ("Zv", "u"), ("Zz", "z"), ("Zr", "r")):
        matrices[name] = columns(at, rates, wrt[letter])
    declared_outputs = declared(at)
    for name, letter in (("ye", "q"), ("yv", "u"), ("yz", "z"), ("yr", "r"), ("ya", "udot")):
        matrices[name] = columns(at, declared_outputs, wrt[letter])
    return {name: at.put(x) for name, x in matrices.items()}


def _refuse_driven(at: Reference) -> None:
    """Inputs that move what constraints hold would be independent increments of their own."""
    constraints = at.d.constraints
    nodes = set(live(at.graph, [*constraints.position.nodes, *constraints.rates.nodes]))
    if nodes & set(at.block("r")):
        raise DerivationError(
            "linearize: inputs prescribe motions inside closed loops: give these as "
            "expressions in t, or drive by a force"
        )


def declared(at: Reference) -> Matrix:
    """The outputs of the scene; accelerations in them are those of the block udot."""
    udot = Matrix(at.graph, at.system.nu, 1, at.block("udot"))
    if any(atom.quantity == "acceleration" for atom in at.system.atoms.values()):
        acc = outputs.system_accelerations(at.d, udot)
        at.k.acceleration = lambda frame: outputs.acceleration(at.d, acc, frame)
    nodes = at.k.resolve([o.node for o in at.system.outputs])
    return Matrix(at.graph, len(nodes), 1, nodes)


def observer(at: Reference, along: Sequence[Direction]) -> dict[str, Matrix]:
    """N, E and its rate: N E = d(qdot) along N less the rate of N, joint by joint."""
    g, nu, k = at.graph, at.system.nu, at.k
    nodes = [at.graph.var("q", m) for m in range(at.system.nq)]
    N = [[d.seeds.get(q, 0) for q in nodes] for d in along]
    E = [[0] * nu for _ in range(nu)]
    if not _plain(at):
        seeds = dict(k.time_seeds)
        seeds |= dict(zip(at.block("u"), at.block("udot"), strict=True))
        for n, direction in enumerate(along):
            change = forward(g, k.rates.nodes, direction.seeds)
            rate_change = forward(g, N[n], seeds)
            left = [g.sub(a, b) for a, b in zip(change, rate_change, strict=True)]
            for slot, node in enumerate(_speeds(at, left)):
                E[slot][n] = node
    by_rows = Matrix(g, nu, nu, [x for row in E for x in row])
    return {
        "N": Matrix(g, nu, len(nodes), [x for row in N for x in row]).T,
        "E": by_rows,
        "Edot": _rate(at, by_rows),
    }


def _rate(at: Reference, x: Matrix) -> Matrix:
    seeds = dict(at.k.time_seeds)
    seeds |= dict(zip(at.block("u"), at.block("udot"), strict=True))
    return Matrix(at.graph, x.rows, x.columns, forward(at.graph, x.nodes, seeds))


def _plain(at: Reference) -> bool:
    """True when speeds are the rates of coordinates, one by one."""
    return list(at.k.rates.nodes) == at.block("u")


def _speeds(at: Reference, rates: list[int]) -> list[int]:
    """Speeds (nu) that belong to rates of the coordinates."""
    g, speeds = at.graph, [0] * at.system.nu
    for i, joint in enumerate(at.system.joints):
        if joint.q < 0:
            continue
        q = at.k.coordinates[i]
        rates_of_joint = Matrix(g, q.rows, 1, rates[joint.q : joint.q + q.rows])
        if not rates_of_joint.is_zero:
            u = joint.element.speeds_of(q, rates_of_joint, **at.k.data[i])
            speeds[joint.u : joint.u + u.rows] = u.nodes
    if not at.equations.chosen:
        return speeds
    # these are speeds of the joints, those of the user follow from them: Y(q) u_joint
    joint_speeds = Matrix(g, len(speeds), 1, speeds)
    return list((at.k.chosen_by_joints @ joint_speeds).nodes)
