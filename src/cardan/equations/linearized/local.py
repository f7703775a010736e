"""Forces and constraints by what bodies do at their own place, for expansion to first order.

Bodies stand here as leaves: pose, velocity and acceleration of every body are symbols, so that a
law is expanded in what it reads and nowhere along the tree.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy

from ...elements.closing import closed
from ...elements.internal_states import ModeConstraint
from ...ir.derivative import forward, gradient
from ...ir.function import live
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...topology.system import Cut
from ..constraints.constraints import POSITION, VELOCITY
from ..kinematics.joint_forces import along_joint
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, along_speeds, applied, places
from .gross import Gross, halves
from .reference_input import substituted

# quantities of a body: rotation and place in ground axes, twist and its rate in its own
SIZES = {"rotation": 9, "position": 3, "omega": 3, "v": 3, "alpha": 3, "a": 3}
PER_BODY = sum(SIZES.values())
BLOCK = "body"


class Local:
    """Laws of a system in terms of the motion of its bodies.

    Args:
        gross: The reference motion, which gives leaves their values.

    Attributes:
        wrenches: Body -> (torque, force) at its origin in its axes, constraint forces included.
        along: Forces along the speeds of the system (nu, 1), those of rotors included.
        rates: What constraints say of velocities, and ``accelerated`` of accelerations (m, 1).
    """

    def __init__(self, gross: Gross) -> None:
        self.gross, self.at, self.graph = gross, gross.at, gross.at.graph
        self._poses = self._relative_poses()
        self.k = self._kinematics()
        self._values = dict(self.at.values)
        for i in range(len(gross.bodies)):
            self._set_values(i)
        loads = applied(self.k)
        self.rates = self._rates()
        self.accelerated = self._time(self.rates)
        self.wrenches = dict(loads.wrenches)
        nodes = self._forces_along(loads)
        if self.rates.rows:
            self._add_constraint_forces(nodes)
        self.along = Matrix(self.graph, len(nodes), 1, nodes)

    # bodies as leaves

    def leaves(self, i: int) -> dict[str, Matrix]:
        """The quantities of a body as leaves."""
        leaves, start = {}, PER_BODY * i
        for name, size in SIZES.items():
            nodes = [self.graph.var(BLOCK, start + n) for n in range(size)]
            start += size
            leaves[name] = Matrix(self.graph, 3, size // 3, nodes)
        return leaves

    def _kinematics(self) -> Kinematics:
        """The same system with its bodies as leaves."""
        kinematics = copy(self.at.k)
        bodies = [self.leaves(i) for i in range(len(self.gross.bodies))]
        kinematics.ground_rotation = [body["rotation"] for body in bodies]
        kinematics.ground_position = [body["position"] for body in bodies]
        kinematics.omega = [body["omega"] for body in bodies]
        kinematics.v = [body["v"] for body in bodies]
        return kinematics

    def _relative_poses(self) -> list[tuple[Matrix, Matrix]]:
        """R from body to ground axes and the origin in ground axes, of every body."""
        poses: list[tuple[Matrix, Matrix]] = []
        for i, body in enumerate(self.gross.bodies):
            rotation, position = self.gross.rotation[i], self.gross.position[i]
            if body.parent >= 0:
                inner, at = poses[body.parent]
                rotation, position = inner @ rotation, at + inner @ position
            poses.append((rotation, position))
        return poses

    def _set_values(self, i: int) -> None:
        outer, v = self.gross.outer[i], self.velocity(i)
        a = outer.a + self.down(i) - outer.omega.cross(v)
        values = (*self._poses[i], outer.omega, v, outer.alpha, a)
        for leaves, value in zip(self.leaves(i).values(), values, strict=True):
            self._values.update(zip(leaves.nodes, value.nodes, strict=True))

    def velocity(self, i: int) -> Matrix:
        """Velocity of the origin of a body, told on it (3, 1)."""
        return self.at.put(self.at.k.v[i])

    def down(self, i: int) -> Matrix:
        """Gravity told on a body (3, 1)."""
        return self._poses[i][0].T @ self.at.put(self.at.d.gravity)

    def true(self, i: int, J: Matrix, change: Matrix, zeta: Matrix) -> tuple[Matrix, ...]:
        """Motion by a joint: velocities against the ground and accelerations with gravity.

        Everything that is moved stays under gravity, which is not a part of its acceleration.
        """
        (theta, _), (eta, slid), (zeta_w, zeta_v) = halves(J), halves(change), halves(zeta)
        root = self.velocity(i) - self.gross.outer[i].v
        slid = slid + root.cross(theta)
        zeta_v = zeta_v + root.cross(eta) * 2 + self.down(i).cross(theta)
        return J, Matrix.vstack(eta, slid), Matrix.vstack(zeta_w, zeta_v)

    def put(self, x: Matrix) -> Matrix:
        """Expressions at the reference."""
        return Matrix(self.graph, x.rows, x.columns, substituted(self.graph, x.nodes, self._values))

    def seeds(self, i: int, moved: Matrix, change: Matrix, zeta: Matrix) -> dict[int, int]:
        """Changes of the leaves of a body, told on it.

        Args:
            i: The body.
            moved: Its small displacement (6, 1).
            change: Of its twist, apart from being moved (6, 1).
            zeta: What changes its accelerations besides 2 eta x v (6, 1).
        """
        rotation, omega, v = self._poses[i][0], self.gross.outer[i].omega, self.velocity(i)
        (theta, shift), (eta, slid), (zeta_w, zeta_v) = halves(moved), halves(change), halves(zeta)
        # the rates of what is told on a body are seen by who turns with it
        rate = zeta_w + eta.cross(omega), zeta_v + eta.cross(v) + slid.cross(omega)
        changes = (rotation @ theta.skew, rotation @ shift, eta, slid, *rate)
        leaves = [leaf for x in self.leaves(i).values() for leaf in x.nodes]
        return dict(zip(leaves, [node for x in changes for node in x.nodes], strict=True))

    def read(self) -> set[int]:
        """Bodies whose motion the laws read."""
        g, laws = self.graph, [self.along, self.rates, self.accelerated]
        laws += [x for wrench in self.wrenches.values() for x in wrench]
        nodes = live(g, [node for x in laws for node in x.nodes])
        leaves = (g.nodes[n] for n in nodes)
        return {node[2] // PER_BODY for node in leaves if node[:2] == ("var", BLOCK)}

    def change(self, x: Matrix, seeds: Mapping[int, int]) -> Matrix:
        """Change of expressions along one direction, at the reference."""
        return self.put(Matrix(self.graph, x.rows, x.columns, forward(self.graph, x.nodes, seeds)))

    # laws

    def _forces_along(self, loads: Loads) -> list[int]:
        """Forces along the speeds less those that rotors take, slot by slot."""
        at, nodes = self.at, [ZERO] * self.at.system.nu
        udot = Matrix(self.graph, at.system.nu, 1, at.block("udot"))
        for i, force in loads.joints.items():
            for slot, node in along_speeds(self.k, i, force).items():
                nodes[slot] = self.graph.add(nodes[slot], node)
        for i, rotor in loads.rotors.items():
            rate, prescribed = along_joint(at.k, i, udot), at.k.prescribed_acceleration(i)
            rate = rate if prescribed is None else rate + prescribed
            for slot, node in along_speeds(self.k, i, rotor @ rate).items():
                nodes[slot] = self.graph.sub(nodes[slot], node)
        return nodes

    def _add_constraint_forces(self, nodes: list[int]) -> None:
        """Multipliers act along the velocities that their rows keep at 0."""
        g = self.graph
        lam = Matrix(g, self.rates.rows, 1, self.at.block("lam"))
        power = lam.dot(self.rates).node
        speeds = self.at.block("u")
        bodies = [self.leaves(i) for i in range(len(self.gross.bodies))]
        twists = [leaf for body in bodies for x in ("omega", "v") for leaf in body[x].nodes]
        slopes = gradient(g, power, [*speeds, *twists])
        for slot in range(len(speeds)):
            nodes[slot] = g.add(nodes[slot], slopes[slot])
        for i in range(len(bodies)):
            wrench = slopes[len(speeds) + 6 * i : len(speeds) + 6 * i + 6]
            if any(wrench):
                torque, force = Matrix(g, 3, 1, wrench[:3]), Matrix(g, 3, 1, wrench[3:])
                if i in self.wrenches:
                    torque, force = self.wrenches[i][0] + torque, self.wrenches[i][1] + force
                self.wrenches[i] = (torque, force)

    def _rates(self) -> Matrix:
        """G u + g_t in the order of the rows of the system."""
        k, constraints = self.k, self.at.d.constraints
        position_rates, slipping = list[int](), list[int]()
        for cut in k.system.cuts:
            rotation, position, twist = self._ends(cut)
            data = {name: k.matrix(*entry) for name, entry in cut.data.items()}
            slope = closed(cut.element, rotation, position, data)[1]
            position_rates += [slope.block(slice(i, i + 1)).T.dot(twist).node for i in cut.rows]
            slip = cut.element.slip(rotation, position, twist, **data)
            slipping += [] if slip is None else slip.nodes
        for i, joint in enumerate(k.system.joints):
            if joint.element.slips:
                sliding = joint.element.sliding(k.coordinates[i], k.speeds[i], **k.data[i])
                slipping += [] if sliding is None else sliding.nodes
        slipping += [(constraint.velocity * constraint.active).node for constraint in self._holds()]
        levels = {row.owner: row.level for row in constraints.rows}
        for entry in k.system.constraints:
            node = k.resolve([entry.node])[0]
            if levels[entry.name] == POSITION:
                position_rates += self._time(Matrix(self.graph, 1, 1, [node])).nodes
            elif levels[entry.name] == VELOCITY:
                slipping.append(node)
        return Matrix(
            self.graph, len(position_rates) + len(slipping), 1, [*position_rates, *slipping]
        )

    def _holds(self) -> Sequence[ModeConstraint]:
        return [
            constraint
            for force in self.k.system.forces
            if force.element.locked_velocities()
            for constraint in force.element.holds(places(self.k, force))
        ]

    def _ends(self, cut: Cut) -> tuple[Matrix, Matrix, Matrix]:
        """Pose and twist of the child frame of a cut joint against its parent frame."""
        k, parent, child = self.k, cut.parent_frame, cut.child_frame
        r_p, r_c = k.rotation(parent), k.rotation(child)
        x_p, x_c = k.position(parent), k.position(child)
        omega = k.angular_velocity(child) - k.angular_velocity(parent)
        moving = k.velocity(child) - k.velocity(parent)
        moving = moving - k.angular_velocity(parent).cross(x_c - x_p)
        twist = Matrix.vstack(r_c.T @ omega, r_c.T @ moving)
        return r_p.T @ r_c, r_p.T @ (x_c - x_p), twist

    def _time(self, x: Matrix) -> Matrix:
        """Derivative along the motion."""
        seeds = dict(self.at.k.time_seeds)
        seeds |= dict(zip(self.at.block("u"), self.at.block("udot"), strict=True))
        for i in range(len(self.gross.bodies)):
            pose = self.leaves(i)
            rotation_rate = pose["rotation"] @ pose["omega"].skew
            moved = pose["rotation"] @ pose["v"]
            for leaves, rate in (
                (pose["rotation"], rotation_rate), (pose["position"], moved),
                (pose["omega"], pose["alpha"]), (pose["v"], pose["a"]),
            ):  # fmt: skip
                seeds |= dict(zip(leaves.nodes, rate.nodes, strict=True))
        return Matrix(self.graph, x.rows, 1, forward(self.graph, x.nodes, seeds))
