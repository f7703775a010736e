"""Numbers of the bodies of a tree that its kernels assemble.

A cause is what a change of q or u at a joint does to the bodies outboard of it, besides moving them
as one: it changes their angular velocity by eta and their acceleration at x by a field zeta(x) plus
2 eta x v(x). See :mod:`~cardan.equations.functions.newton_euler_derivatives`.
"""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.derivative import directional
from ...ir.matrix import Matrix
from ...records import dataclass
from ..functions.directions import Direction
from ..functions.newton_euler_derivatives import joint_change
from ..kinematics.accelerations import second_moment_force
from ..kinematics.loads import Loads
from .ground_motion import GroundMotion

XYZ = ("x", "y", "z")
FIELD = ("wx", "wy", "wz", "vx", "vy", "vz")
INERTIA = ("mass", "mx", "my", "mz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")
# names of the numbers of a body and of a speed, in the order of tree_derivatives.h
BODY = (
    *INERTIA,
    *(f"P_{x}" for x in XYZ),
    *(f"K_{x}{y}" for x in XYZ for y in XYZ),
    *(f"n_{x}" for x in XYZ),
    *(f"f_{x}" for x in XYZ),
)
SPEED = (
    *(f"zeta_u_{x}" for x in FIELD),
    *(f"S_{x}" for x in FIELD),
    *(f"eta_q_{x}" for x in XYZ),
    *(f"zeta_q_{x}" for x in FIELD),
    "load",
)
COLUMN = tuple(f"S_{x}" for x in FIELD)


def mass_numbers(motion: GroundMotion, loads: Loads, i: int) -> list[int]:
    """Numbers of a body for ``tree_mass.h``."""
    nodes = motion.inertia_at_base(i, motion.inertia(i))
    for _, column in motion.k.joints[i].columns:
        nodes += _column(motion, i, column).nodes
    return nodes + rotor_numbers(loads, i)


def rotor_numbers(loads: Loads, i: int) -> list[int]:
    """Inertia of rotors along the speeds of a joint: the lower triangle."""
    if i not in loads.rotors:
        return []
    rotor = loads.rotors[i]
    return [rotor[row, column].node for row in range(rotor.rows) for column in range(row + 1)]


def _column(motion: GroundMotion, i: int, column: Matrix) -> Matrix:
    """A column of S about the origin of the tree (6, 1)."""
    with motion.k.graph.made_by(motion.k.system.joints[i].name, "S"):
        return motion.at_base(i, motion.in_ground_axes(i, column))


@dataclass(frozen=True)
class Cause:
    """Effect of one direction at one joint, in ground axes about the origin of the tree.

    Attributes:
        eta: Change of angular velocity (3, 1).
        zeta: Change of acceleration at udot = 0 (6, 1).
        modes: slot of u -> change of the column of S (6, 1) besides turning with the body.
    """

    eta: Matrix
    zeta: Matrix
    modes: dict[int, Matrix]


@dataclass(frozen=True)
class Slopes:
    """Numbers of the bodies for ``tree_derivatives.h``.

    Attributes:
        motion: Of the tree.
        loads: Applied forces.
        along: (block, slot) -> direction along q and u.
        moving_modes: Bodies whose columns of S are not fixed to them.
        changes: Body -> (row among its speeds, direction): forces of elements that change.
    """

    motion: GroundMotion
    loads: Loads
    along: dict[tuple[str, int], Direction]
    moving_modes: frozenset[int]
    changes: dict[int, list[tuple[int, Direction]]]

    def numbers(self, i: int) -> list[int]:
        """Numbers of a body, of its speeds, of its modes, of its rotors and changes."""
        motion, k = self.motion, self.motion.k
        inertia = motion.inertia(i)
        nodes = motion.inertia_at_base(i, inertia)
        second = motion.second_moment(i, inertia)
        with k.graph.made_by(k.owner(i), "flow"):
            omega, v, at = motion.omega[i] * 2, motion.v[i] * 2, motion.position[i]
            momentum = v * inertia.mass + omega.cross(inertia.moment)
            gradient = v.outer(inertia.moment) + omega.skew @ second + momentum.outer(at)
        nodes += [*momentum.nodes, *gradient.nodes]
        with k.graph.made_by(k.owner(i), "inertia_force"):
            moment, force = second_moment_force(inertia, second, motion.a[i], motion.field[i])
            if i in self.loads.wrenches:
                r, (torque, push) = motion.orientation[i], self.loads.wrenches[i]
                moment, force = moment - r @ torque, force - r @ push
            moment = moment + motion.position[i].cross(force)
        nodes += [*moment.nodes, *force.nodes]
        modes: list[dict[int, Matrix]] = []
        loads = self.loads.joints.get(i)
        columns = k.joints[i].columns
        for n, (slot, column) in enumerate(columns):
            with k.graph.made_by(k.system.joints[i].name, "slope"):
                by_u = self._cause(i, slot, column, "u")
                by_q = self._cause(i, slot, column, "q")
            s = _column(motion, i, column)
            nodes += [*by_u.zeta.nodes, *s.nodes, *by_q.eta.nodes, *by_q.zeta.nodes]
            nodes.append(0 if loads is None else loads[n].node)
            modes.append(by_q.modes)
        if i in self.moving_modes:
            for slot, _ in columns:
                for change in modes:
                    nodes += motion.at_base(i, motion.in_ground_axes(i, change[slot])).nodes
        return [*nodes, *rotor_numbers(self.loads, i), *self._changes(i)]

    def _cause(self, i: int, slot: int, column: Matrix, block: str) -> Cause:
        motion, k = self.motion, self.motion.k
        shift = column if block == "q" else None
        still = Matrix.zeros(k.graph, k.joints[i].S.columns)
        change, modes = joint_change(k, i, still, self.along[block, slot].seeds, shift)
        rate, drift = (motion.in_ground_axes(i, change.block(slice(n, n + 6))) for n in (0, 6))
        dw, dv = rate.block(slice(0, 3)), rate.block(slice(3, 6))
        omega, alpha, a, v = motion.inboard(i)
        relative = motion.in_ground_axes(i, k.joints[i].velocity).block(slice(0, 3))
        zeta_w = (omega * 2 + relative).cross(dw) + drift.block(slice(0, 3))
        zeta_v = omega.cross(dv) * 2 + drift.block(slice(3, 6)) - dw.cross(motion.v[i]) * 2
        eta = dw
        if shift is not None:
            moved = motion.in_ground_axes(i, shift)
            xi_w, xi_v = moved.block(slice(0, 3)), moved.block(slice(3, 6))
            swept = omega.cross(xi_w)
            eta = swept + dw
            zeta_w = zeta_w + alpha.cross(xi_w) + omega.cross(swept)
            zeta_v = zeta_v + a.cross(xi_w) - swept.cross(v) * 2
            zeta_v = zeta_v + alpha.cross(xi_v) + omega.cross(omega.cross(xi_v))
        return Cause(eta, motion.at_base(i, Matrix.vstack(zeta_w, zeta_v)), modes)

    def _changes(self, i: int) -> list[int]:
        """Changes of the forces of elements along the speeds of a joint."""
        k, nodes = self.motion.k, list[int]()
        for row, direction in self.changes.get(i, ()):
            load = self.loads.joints[i][row].node
            nodes.append(directional(k.graph, [load], [direction.seeds])[0][0])
        return nodes


def body_names(
    name: str, joint: str, speeds: Sequence[str], body: Sequence[str], speed: Sequence[str]
) -> list[str]:
    """Names of the numbers of a body and of its speeds."""
    names = [f"{name}.{x}" for x in body]
    several = len(speeds) > 1
    for part in speeds:
        names += [f"{joint}.{x}" + (f" of {part}" if several else "") for x in speed]
    return names
