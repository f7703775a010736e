"""Constraint of one joint between two nodes, as expressions in their relative pose.

With R_A, x_A and R_B, x_B of the nodes, D = R_Aᵀ R_B and d = R_Aᵀ (x_B - x_A) change by
D' = D [w_B] - [w_A] D and d' = R_Aᵀ (v_B - v_A) - w_A x d along speeds in body axes (w) and ground
axes (v). Everything is differentiated by D, d and R_A as they stand, never through quaternions.

Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 7.
"""

from __future__ import annotations

from functools import cached_property

from ...elements.closing import closed
from ...elements.joints.free import Free
from ...ir.arithmetic import Scalar
from ...ir.derivative import directional, forward, gradient
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...topology.prescribed_motion import input_rates
from ...topology.system import GROUND
from ..constraints.cut_joint_frames import frame_pose
from ..constraints.loop_loads import Closing
from ..kinematics.kinematics import Kinematics

Seeds = dict[int, int]

# leaves that stand for D, d and R_A while they are differentiated
LEAVES = tuple(f"pose of a joint between nodes [{k}]" for k in range(21))


def increments(k: Kinematics) -> list[Seeds]:
    """Changes of the poses of nodes and of joint coordinates along every speed of a small system.

    Rotations change as they stand, R' = R [w], not through quaternions; these change as well, for
    expressions that read them.
    """
    g, seeds = k.graph, list[Seeds]()
    for i, joint in enumerate(k.system.joints):
        if joint.u < 0:
            continue
        moved = _by_coordinates(k, i)
        if joint.element == Free() and k.system.bodies[i].parent == GROUND:
            R, p = k.ground_rotation[i], k.ground_position[i]
            for at, axis in zip(moved, _axes(g), strict=False):
                at.update(zip(R.nodes, (R @ axis.skew).nodes, strict=True))
            for at, node in zip(moved[3:], p.nodes, strict=True):
                at[node] = ONE
        seeds += moved
    return seeds


def _by_coordinates(k: Kinematics, i: int) -> list[Seeds]:
    """Changes of the coordinates of a joint along its speeds."""
    g, joint, seeds = k.graph, k.system.joints[i], list[Seeds]()
    for n in range(len(joint.element.speeds)):
        column = forward(g, k.rates.nodes, {g.var("u", joint.u + n): ONE})
        seeds.append({g.var("q", m): node for m, node in enumerate(column) if node})
    return seeds


def _axes(graph: Graph) -> list[Matrix]:
    return [Matrix.identity(graph, 3).column(n) for n in range(3)]


class JointConstraint:
    """Cut joint 0 of a small system.

    What it returns may be differentiated further (:meth:`along`) and is :meth:`settled` at last.

    Args:
        k: Motion of the small system: nodes on free joints from the ground, perhaps a carrier.
    """

    def __init__(self, k: Kinematics) -> None:
        self.k, self.graph = k, k.graph
        self.cut = k.system.cuts[0]
        self.carrier = self.cut.carrier
        frames = k.system.frames
        self._paths = [
            self._path(frames[frame].body)
            for frame in (self.cut.parent_frame, self.cut.child_frame)
        ]
        self.parent, self.child = (path[0] for path in self._paths)

    def _path(self, body: int) -> list[int]:
        """The ground or node that carries a body, and what joints move from there to it."""
        bodies, joints, path = self.k.system.bodies, self.k.system.joints, [body]
        while path[0] != GROUND and (
            path[0] == self.carrier
            or not (joints[path[0]].element == Free() and bodies[path[0]].parent == GROUND)
        ):
            path.insert(0, bodies[path[0]].parent)
        return path

    def _pose_on(self, path: list[int], start: tuple[Matrix, Matrix]) -> tuple[Matrix, Matrix]:
        """Rotation and position at the end of a path from those at its start."""
        rotation, position = start
        for body in path[1:]:
            step = self.k.pose_of(body)
            rotation, position = rotation @ step.rotation, position + rotation @ step.position
        return rotation, position

    # poses, as leaves

    @cached_property
    def _leaves(self) -> list[int]:
        return [self.graph.atom(name) for name in LEAVES]

    @cached_property
    def R(self) -> Matrix:
        """R_A."""
        if self.parent == GROUND:
            return Matrix.identity(self.graph, 3)
        return Matrix(self.graph, 3, 3, self._leaves[12:])

    @cached_property
    def D(self) -> Matrix:
        """R_Aᵀ R_B."""
        if self.parent == self.child:
            return Matrix.identity(self.graph, 3)
        return Matrix(self.graph, 3, 3, self._leaves[:9])

    @cached_property
    def d(self) -> Matrix:
        """R_Aᵀ (x_B - x_A)."""
        if self.parent == self.child:
            return Matrix.zeros(self.graph, 3)
        return Matrix(self.graph, 3, 1, self._leaves[9:12])

    def settled(self, x: Matrix) -> Matrix:
        """Expressions with D, d and R_A of the nodes in place of the leaves."""
        return Matrix(
            x.graph, x.rows, x.columns, rebuild(x.graph, x.nodes, self._poses, into=x.graph)[1]
        )

    @cached_property
    def _poses(self) -> Seeds:
        """Leaf -> what it stands for."""
        R = self.k.body_rotation(self.parent)
        D = R.T @ self.k.body_rotation(self.child)
        d = R.T @ (self._origin(self.child) - self._origin(self.parent))
        return dict(zip(self._leaves, (*D.nodes, *d.nodes, *R.nodes), strict=True))

    def _origin(self, body: int) -> Matrix:
        return Matrix.zeros(self.graph, 3) if body == GROUND else self.k.ground_position[body]

    @cached_property
    def pose(self) -> tuple[Matrix, Matrix]:
        """R_PC and p_PC."""
        here = Matrix.identity(self.graph, 3), Matrix.zeros(self.graph, 3)
        near, far = (
            frame_pose(self.k, frame, self._pose_on(path, start))
            for frame, path, start in zip(
                (self.cut.parent_frame, self.cut.child_frame),
                self._paths,
                (here, (self.D, self.d)),
                strict=True,
            )
        )
        return near[0].T @ far[0], near[0].T @ (far[1] - near[1])

    @cached_property
    def data(self) -> dict[str, Matrix]:
        """Quantities of the joint that is cut."""
        return {name: self.k.matrix(*entry) for name, entry in self.cut.data.items()}

    # how they change

    @cached_property
    def seeds(self) -> list[Seeds]:
        """Changes of D, d, R_A and joint coordinates along every speed."""
        seeds = increments(self.k)
        first = -1 if self.carrier is None else self.k.system.joints[self.carrier].u
        if self.carrier is not None and first >= 0:
            # a free joint from the ground is not a node: its rates are told by its coordinates
            carrier_seeds = _by_coordinates(self.k, self.carrier)
            seeds[first : first + len(carrier_seeds)] = carrier_seeds
        for body in {self.parent, self.child} - {GROUND}:
            first = self.k.system.joints[body].u
            # what moves both ends alike does not change their relative pose
            alike = self.parent == self.child
            seeds[first : first + 6] = [Seeds() for _ in range(6)] if alike else self._moved(body)
        return seeds

    def _moved(self, body: int) -> list[Seeds]:
        """Changes along the speeds of a node."""
        still, axes = Matrix.zeros(self.graph, 3), _axes(self.graph)
        speeds = [(axis, still) for axis in axes] + [(still, axis) for axis in axes]
        if body == self.parent:
            return [self._changes(*unit_twist, still, still) for unit_twist in speeds]
        return [self._changes(still, still, *unit_twist) for unit_twist in speeds]

    def _changes(self, w_a: Matrix, v_a: Matrix, w_b: Matrix, v_b: Matrix) -> Seeds:
        """Changes of D, d and R_A at speeds of both nodes."""
        rotation_rate = self.D @ w_b.skew - w_a.skew @ self.D
        moved = self.R.T @ (v_b - v_a) - w_a.cross(self.d)
        parent_seeds = {} if self.parent == GROUND else self._seeds(self.R, self.R @ w_a.skew)
        return parent_seeds | self._seeds(self.D, rotation_rate) | self._seeds(self.d, moved)

    def _seeds(self, x: Matrix, change: Matrix) -> Seeds:
        return dict(zip(x.nodes, change.nodes, strict=True))

    def _speeds(self, body: int) -> tuple[Matrix, Matrix]:
        """Angular velocity in body axes and velocity in ground axes of a node."""
        if body == GROUND:
            return Matrix.zeros(self.graph, 3), Matrix.zeros(self.graph, 3)
        u = self.k.speeds[body]
        return u.block(slice(0, 3)), u.block(slice(3, 6))

    @cached_property
    def time_seeds(self) -> Seeds:
        """Rates of D, d, R_A, joint coordinates, time and inputs."""
        g = self.graph
        seeds = {g.var("t", 0): ONE} | input_rates(g, self.k.system.inputs)
        for i, joint in enumerate(self.k.system.joints):
            if joint.q >= 0 and i not in (self.parent, self.child):
                for n in range(len(joint.element.coordinates)):
                    seeds[g.var("q", joint.q + n)] = self.k.rates.nodes[joint.q + n]
        if self.parent == self.child:
            return seeds
        return seeds | self._changes(*self._speeds(self.parent), *self._speeds(self.child))

    # what vanishes

    @cached_property
    def position(self) -> Matrix:
        """g (mp, 1)."""
        return self.cut.element.closure(*self.pose, **self.data)

    @cached_property
    def rates(self) -> Matrix:
        """G u + g_t (m, 1): rates of g, then velocities of slipping."""
        position_rates = forward(self.graph, self.position.nodes, self.time_seeds)
        return self._column([*position_rates, *self._slips.nodes])

    @cached_property
    def _slips(self) -> Matrix:
        """Velocities that vanish beyond the rates of g."""
        nodes = list[int]()
        if self.cut.element.slips:
            nodes += self._slip(self._twist).nodes
        for i, joint in enumerate(self.k.system.joints):
            if joint.element.slips:
                q, u = self.k.coordinates[i], self.k.speeds[i]
                slip = joint.element.sliding(q, u, **self.k.data[i])
                nodes += slip.nodes if slip is not None else ()
        return self._column(nodes)

    def _slip(self, twist: Matrix) -> Matrix:
        slip = self.cut.element.slip(*self.pose, twist, **self.data)
        return Matrix.zeros(self.graph, 0) if slip is None else slip

    @property
    def _twist(self) -> Matrix:
        """Velocity of C against P at the origin of C, in C axes."""
        R, p = self.pose
        moved = self._column(forward(self.graph, p.nodes, self.time_seeds))
        if max(map(len, self._paths)) > 1:
            rate = Matrix(self.graph, 3, 3, forward(self.graph, R.nodes, self.time_seeds))
            spin = R.T @ rate
            omega = [spin[2, 1].node, spin[0, 2].node, spin[1, 0].node]
            return Matrix.vstack(self._column(omega), R.T @ moved)
        (w_a, _), (w_b, _) = self._speeds(self.parent), self._speeds(self.child)
        axes = self.k.matrix(3, 3, self.k.system.frames[self.cut.child_frame].rotation)
        return Matrix.vstack(axes.T @ (w_b - self.D.T @ w_a), R.T @ moved)

    @cached_property
    def jacobian(self) -> Matrix:
        """G (m, nu)."""
        g, nu = self.graph, self.k.system.nu
        columns = directional(g, self.position.nodes, self.seeds)
        nodes = [column[i] for i in range(self.position.rows) for column in columns]
        slots = [g.var("u", n) for n in range(nu)]
        slipping = [forward(g, self._slips.nodes, {slot: ONE}) for slot in slots]
        nodes += [column[i] for i in range(self._slips.rows) for column in slipping]
        return Matrix(g, self.position.rows + self._slips.rows, nu, nodes)

    @cached_property
    def gamma(self) -> Matrix:
        """G udot = gamma (m, 1)."""
        return -self._column(forward(self.graph, self.rates.nodes, self.time_seeds))

    def forces(self, lam: Matrix) -> Matrix:
        """Gᵀ lam (nu, 1): the slope of lam g along every speed, and what does not slip."""
        g, position_count, nodes = self.graph, self.position.rows, list[int]()
        work = self.position.dot(lam.block(slice(0, position_count))).node
        leaves = list(dict.fromkeys(node for seeds in self.seeds for node in seeds))
        slopes = dict(zip(leaves, gradient(g, work, leaves), strict=True))
        for n, seeds in enumerate(self.seeds):
            total = Scalar(g, ZERO)
            for node, change in seeds.items():
                total = total + Scalar(g, slopes[node]) * Scalar(g, change)
            for i in range(position_count, lam.rows):
                total = total + self.jacobian[i, n] * lam[i]
            nodes.append(total.node)
        return self._column(nodes)

    def along(self, x: Matrix) -> Matrix:
        """Changes of expressions (n, 1) along every speed (n, nu)."""
        columns = directional(self.graph, x.nodes, self.seeds)
        nodes = [column[i] for i in range(x.rows) for column in columns]
        return Matrix(self.graph, x.rows, len(self.seeds), nodes)

    def wrench(self, lam: Matrix) -> Matrix:
        """Wrench of P on C at the origin of C, in C axes (6, 1), by the first multipliers."""
        gradients = closed(self.cut.element, *self.pose, self.data)[1]
        position_count, slips = gradients.rows, len(self.cut.element.slips)
        total = gradients.T @ lam.block(slice(0, position_count))
        if slips:
            unit = Matrix.identity(self.graph, 6)
            rows = Matrix.hstack(*[self._slip(unit.column(j)) for j in range(6)])
            total = total + rows.T @ lam.block(slice(position_count, position_count + slips))
        return total

    def transmitted(self, lam: Matrix) -> Closing:
        """Wrench that the joint transmits."""
        R, position = (self.settled(x) for x in self.pose)
        return Closing(self.cut, (R, position), self.settled(self.wrench(lam)))

    def _column(self, nodes: list[int]) -> Matrix:
        return Matrix(self.graph, len(nodes), 1, nodes)
