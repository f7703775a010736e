"""Mass matrix by composite bodies, rigid with all that their joint carries.

Source: Walker and Orin, J. Dyn. Sys. Meas. Control 104 (1982); Featherstone, Rigid Body Dynamics
Algorithms (2008), section 6.2.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...spatial.moments import Inertia, moved, turn_symmetric
from ..recursion.recursion_boundary import CELLS
from .inertia import of_body
from .kinematics import Kinematics
from .loads import Loads

COMPONENTS = ("mx", "my", "mz", "fx", "fy", "fz")


def composites(k: Kinematics) -> list[Inertia]:
    """Inertia of every body with all bodies outboard of it, about its origin in its axes.

    ``composite = own + sum R composite_child Rᵀ moved by p``: of first moments and of inertias.
    """
    k.graph.describe(composites)
    result = [of_body(k, i) for i in range(len(k.system.bodies))]
    for i in range(len(result) - 1, -1, -1):
        parent, name = k.system.bodies[i].parent, k.owner(i)
        result[i].moment.label(name, "composite_moment")
        result[i].tensor.label(name, "composite_inertia", CELLS)
        if parent >= 0 and not result[i].is_zero:
            with k.graph.made_by(k.owner(parent), "inertia"):
                result[parent] = result[parent] + on_parent(k, i, result[i])
    return result


def on_parent(k: Kinematics, i: int, inertia: Inertia) -> Inertia:
    """An inertia of body i about the origin and in the axes of its parent."""
    joint = k.joints[i]
    tensor = inertia.tensor
    for turn in reversed(joint.turns):
        tensor = turn_symmetric(turn, tensor)
    rotated = Inertia(inertia.mass, joint.rotation @ inertia.moment, tensor)
    return moved(rotated, joint.position)


def projected(k: Kinematics, inertias: Sequence[Inertia], loads: Loads) -> Matrix:
    """M (nu, nu) of composite inertias, with the structural zeros of the branches of the tree.

    ``momentum = composite inertia S`` of a column of S, moved inward from body to body;
    ``M = S . momentum`` for all joints on the way.
    """
    k.graph.describe(projected)
    nu, g = k.system.nu, k.graph
    entries = [[ZERO] * nu for _ in range(nu)]
    for i in range(len(k.joints) - 1, -1, -1):
        for row, column in k.joints[i].columns:
            with g.made_by(k.system.joints[i].name, "M"):
                momentum = inertias[i].momentum(column)
                momentum.label("momentum", k.speed_names[row], COMPONENTS)
                _add(k, entries, row, i, momentum)
        _add_rotor(k, entries, i, loads)
    lower = [[entries[max(i, j)][min(i, j)] for j in range(nu)] for i in range(nu)]
    for i in range(nu):
        for j in range(i + 1):
            g.label(lower[i][j], "M", f"{k.speed_names[i]}_{k.speed_names[j]}")
    return Matrix(g, nu, nu, [x for row in lower for x in row])


def _add(k: Kinematics, entries: list[list[int]], row: int, i: int, momentum: Matrix) -> None:
    """Project the momentum that one column of S gives on all columns from its joint inward.

    Between two joints both products enter, within one joint each pair enters once.
    """
    here, body = True, i
    while body >= 0:
        for column, s in k.joints[body].columns:
            _enter(k, entries, row, column, s.dot(momentum).node, here)
        momentum = inward(k, body, momentum)
        body, here = k.system.bodies[body].parent, False
        about = k.owner(body) if body >= 0 else "ground"
        momentum.hint("momentum", f"{k.speed_names[row]}_about_{about}", COMPONENTS)


def _enter(
    k: Kinematics, entries: list[list[int]], row: int, column: int, value: int, here: bool
) -> None:
    """Add one projection to the lower triangle of M."""
    g = k.graph
    high, low = max(row, column), min(row, column)
    if here:
        if row >= column:
            entries[high][low] = g.add(entries[high][low], value)
    else:
        # a coupled joint can share its slot with the joint inboard: both products are the diagonal
        twice = g.add(value, value) if row == column else value
        entries[high][low] = g.add(entries[high][low], twice)


def inward(k: Kinematics, body: int, momentum: Matrix) -> Matrix:
    """A 6-vector of moment and force about the origin and in the axes of the parent."""
    joint = k.joints[body]
    with k.graph.made_by(k.owner(body), "momentum"):
        force = joint.rotation @ momentum.block(slice(3, 6))
        moment = joint.rotation @ momentum.block(slice(0, 3)) + joint.position.cross(force)
    return Matrix.vstack(moment, force)


def _add_rotor(k: Kinematics, entries: list[list[int]], i: int, loads: Loads) -> None:
    if i not in loads.rotors:
        return
    rotor, shares = loads.rotors[i], k.shares(i)
    if shares is None:
        first, unit = k.system.joints[i].u, Matrix.identity(k.graph, loads.rotors[i].rows)
        shares = {first + n: unit.column(n) for n in range(unit.columns)}
    for row, share in shares.items():
        for column, other in shares.items():
            if column <= row:
                added = share.dot(rotor @ other).node
                entries[row][column] = k.graph.add(entries[row][column], added)
