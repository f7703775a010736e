"""Motion of a tree: what every formalism shares.

All per-body lists follow the regular numbering of the system graph. Vectors of a body are in its
own axes (or those its ``turn`` leads to) unless they are named ``ground_...``; 6-vectors have the
angular part first.

Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapters 3 and 4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

from ...ir.arithmetic import Scalar
from ...ir.derivative import forward
from ...ir.graph import ONE, ZERO, Graph
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...topology.prescribed_motion import input_rates
from ...topology.system import Joint, Named, System
from ..constraints.closures import Closures
from ..constraints.kinematic_coefficients import KinematicCoefficients
from ..recursion.recursion_boundary import CELLS, XYZ, Cuts
from . import paths
from .chosen_speeds import by_speeds, speeds_of_joints
from .joint_motion import JointMotion, JointPose, joint_motion, joint_pose, turn
from .lazy_list import Memo
from .placeholders import resolved


class Kinematics:
    """Positions and velocities of all bodies of a system, in a graph of their own.

    Args:
        system: The system graph; its expressions are copied, not changed.
        speeds: User-chosen generalized speeds, each linear in the joint speeds ``("var", "u", k)``;
            the system's u are then these.
        cut: How values that bodies hand on become leaves, so that steps of a recursion can be
            told apart; None where they do not. Nothing may be differentiated through them.
        following: Gives names to what closed loops determine, for people to read.
    """

    def __init__(
        self, system: System, speeds: Sequence[Named] = (),
        cut: Callable[[Graph], Cuts] | None = None,
        coefficients: KinematicCoefficients | None = None,
    ) -> None:  # fmt: skip
        self.system, self.coefficients = system, coefficients
        self.graph = system.graph.fork().describe(Kinematics)
        self.cuts = cut(self.graph) if cut is not None else None
        # angular acceleration and acceleration of a frame (6, 1), where udot is known
        self.acceleration: Callable[[int], Matrix] | None = None
        self.chosen = tuple(speeds)
        self.speed_names = tuple(speed.name for speed in speeds) or system.speed_names
        # derivatives of the chosen speeds by those of the joints
        self.chosen_by_joints = Matrix.identity(self.graph, 0)
        self._replace: dict[int, int] = {}
        if speeds:
            # motions of frames among them are those by the speeds of the joints
            plain, speed_nodes = Kinematics(system), [speed.node for speed in speeds]
            speed_nodes = rebuild(plain.graph, plain.resolve(speed_nodes), into=self.graph)[1]
            names, slots = [speed.name for speed in speeds], self.block("u", 0, system.nu)
            self.chosen_by_joints, joint_speeds = speeds_of_joints(self.graph, speed_nodes, names)
            self._replace = dict(zip(slots.nodes, joint_speeds.nodes, strict=True))

    def matrix(self, rows: int, columns: int, nodes: Sequence[int]) -> Matrix:
        """Expressions of the system graph as a matrix of this graph, placeholders resolved."""
        return Matrix(self.graph, rows, columns, self.resolve(nodes))

    def vector(self, nodes: Sequence[int]) -> Matrix:
        return self.matrix(len(nodes), 1, nodes)

    def owner(self, body: int) -> str:
        """Name under which the quantities of a body are printed."""
        return self.system.bodies[body].name

    # values that are handed on

    def carry(
        self, i: int, quantity: str, x: Matrix, components: Sequence[str] = XYZ, owner: str = ""
    ) -> Matrix:
        """A value of body i that is used again elsewhere, under a name."""
        x.label(owner or self.owner(i), quantity, components)
        if self.cuts is None:
            return x
        return Matrix(self.graph, x.rows, x.columns, self.cuts.cut(i, quantity, x.nodes))

    # speeds

    @property
    def time(self) -> Scalar:
        return Scalar(self.graph, self.graph.var("t", 0))

    def block(self, name: str, start: int, count: int) -> Matrix:
        """Entries of an input block as a vector (count, 1)."""
        return Matrix(self.graph, count, 1, [self.graph.var(name, start + k) for k in range(count)])

    def _slots(self, block: str, start: int, count: int) -> list[int]:
        nodes = [self.graph.var(block, start + k) for k in range(count)]
        return [self._replace.get(n, n) for n in nodes]

    # joints

    def _data(self, joint: Joint) -> dict[str, Matrix]:
        return {name: self.matrix(*entry) for name, entry in joint.data.items()}

    @cached_property
    def data(self) -> list[dict[str, Matrix]]:
        """Quantities of every joint element."""
        return [self._data(joint) for joint in self.system.joints]

    @cached_property
    def closures(self) -> Closures:
        """The loops that are solved in closed form."""
        return Closures(self)

    @cached_property
    def coordinates(self) -> Memo[Matrix]:
        """q of every joint."""
        return Memo(len(self.system.joints), lambda i: self._joint_values(i, "q"))

    @cached_property
    def speeds(self) -> Memo[Matrix]:
        """u of every joint."""
        return Memo(len(self.system.joints), self.joint_speeds)

    def joint_speeds(self, i: int) -> Matrix:
        """u of a joint."""
        return self._joint_values(i, "u")

    def prescribed_acceleration(self, i: int) -> Matrix | None:
        """Acceleration of a joint where udot of the system is 0, None for 0."""
        joint = self.system.joints[i]
        if joint.closure >= 0:
            return self.closures.velocity(joint.closure).bias[i]
        if joint.motion is not None:
            return self.vector([joint.motion.acceleration])
        # loops ask for this before their rates are known
        return self._changing(self.speeds[i], self.slot_seeds) if self.chosen else None

    def shares(self, i: int) -> dict[int, Matrix] | None:
        """Slot -> share of its speed in the speeds (n, 1) of a joint that has no slots of its own.

        None for a joint with slots. Where speeds are chosen all joints have shares in them.
        """
        joint = self.system.joints[i]
        if joint.motion is not None:
            return {}
        if self.chosen:
            return self._shares_of_chosen[i]
        if joint.closure >= 0:
            return self.closures.velocity(joint.closure).shares[i]
        if joint.coupling is not None:
            leader, ratio, _ = self.leader(i)
            return {self.system.joints[leader].u: Matrix.vector(self.graph, [ratio])}
        return None

    @cached_property
    def _shares_of_chosen(self) -> Memo[dict[int, Matrix]]:
        return Memo(len(self.system.joints), lambda i: self.partials_of(self.speeds[i]))

    def partials_of(self, x: Matrix) -> dict[int, Matrix]:
        """Slot -> derivative of a velocity by the speed in it, where there is any."""
        return by_speeds(x, self.system.nu)

    def settled(self, i: int, x: Matrix) -> Matrix:
        """Expressions in the coordinates of a joint, with what is known of their sines."""
        closure = self.system.joints[i].closure
        return x if closure < 0 else self.closures.position(closure).settled(x)

    def _joint_values(self, i: int, block: str) -> Matrix:
        g, joint = self.graph, self.system.joints[i]
        if joint.closure >= 0:
            if block == "q":
                return self.closures.position(joint.closure).q[i]
            return self.closures.velocity(joint.closure).rates[i]
        if joint.motion is not None:
            return self.vector([joint.motion.value if block == "q" else joint.motion.rate])
        if joint.coupling is not None:
            leader, ratio, offset = self.leader(i)
            start = self.system.joints[leader].q if block == "q" else self.system.joints[leader].u
            value = Scalar(g, self._slots(block, start, 1)[0]) * ratio
            return Matrix.vector(g, [value + offset if block == "q" else value])
        element = joint.element
        count = len(element.coordinates) if block == "q" else len(element.speeds)
        nodes = self._slots(block, joint.q if block == "q" else joint.u, count)
        return Matrix(g, count, 1, nodes)

    def leader(self, i: int) -> tuple[int, Scalar, Scalar]:
        """Joint with slots that a coupled joint follows, with the total ratio and offset."""
        g = self.graph
        ratio, offset = Scalar(g, ONE), Scalar(g, ZERO)
        coupling = self.system.joints[i].coupling
        while coupling is not None:
            offset = offset + ratio * Scalar(g, coupling.offset)
            ratio = ratio * Scalar(g, coupling.ratio)
            i = coupling.leader
            coupling = self.system.joints[i].coupling
        return i, ratio, offset

    @cached_property
    def rates(self) -> Matrix:
        """qdot of the system (nq, 1)."""
        rows = [ZERO] * self.system.nq
        for i, joint in enumerate(self.system.joints):
            if joint.q >= 0:
                with self.graph.made_by(joint.name, "qdot"):
                    rate = joint.element.rates(self.coordinates[i], self.speeds[i], **self.data[i])
                names = [c.name for c in joint.element.coordinates]
                rows[joint.q : joint.q + rate.rows] = rate.hint(joint.name, "qdot", names).nodes
        return Matrix(self.graph, len(rows), 1, rows)

    @cached_property
    def time_seeds(self) -> dict[int, int]:
        """Leaf -> its time derivative at udot = 0: t, q and inputs that prescribe a motion."""
        seeds = self.slot_seeds
        for n in range(len(self.system.closures)):
            seeds = seeds | self.closures.seeds(n)
        return seeds

    @cached_property
    def slot_seeds(self) -> dict[int, int]:
        """The same without what closed loops determine."""
        g = self.graph
        coordinates = {g.var("q", k): node for k, node in enumerate(self.rates.nodes)}
        return {g.var("t", 0): ONE} | input_rates(g, self.system.inputs) | coordinates

    def derivative(self, x: Matrix) -> Matrix:
        """Entry by entry time derivative at udot = 0."""
        return self._changing(x, self.time_seeds, "rate")

    def _changing(self, x: Matrix, seeds: dict[int, int], word: str = "") -> Matrix:
        return Matrix(self.graph, x.rows, x.columns, forward(self.graph, x.nodes, seeds, word))

    @cached_property
    def joints(self) -> Memo[JointMotion]:
        """Motion of every body against its parent."""
        return Memo(len(self.system.joints), lambda i: joint_motion(self, i))

    @cached_property
    def _poses(self) -> Memo[JointPose]:
        return Memo(len(self.system.joints), lambda i: joint_pose(self, i))

    def pose_of(self, i: int) -> JointPose:
        """Place of a body against its parent."""
        return self._poses[i]

    # bodies

    @cached_property
    def omega(self) -> list[Matrix]:
        """Angular velocity of every body, ``omega = Rᵀ omega_parent + S_w u``."""
        result: list[Matrix] = []
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.joints, strict=True)):
            with self.graph.made_by(self.owner(i), "omega"):
                omega = joint.velocity.block(slice(0, 3))
                if body.parent >= 0:
                    omega = joint.rotation.T @ result[body.parent] + omega
                result.append(self.carry(i, "omega", omega))
        return result

    @cached_property
    def v(self) -> list[Matrix]:
        """Velocity of all origins, ``v = Rᵀ (v_parent + omega_parent x p) + S_v u``."""
        return self._origin_velocities("v", from_root=False)

    @cached_property
    def v_from_root(self) -> list[Matrix]:
        """The same, ``v_from_root = v - v of the first body of the tree``."""
        return self._origin_velocities("v_from_root", from_root=True)

    def _origin_velocities(self, quantity: str, from_root: bool) -> list[Matrix]:
        result: list[Matrix] = []
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.joints, strict=True)):
            with self.graph.made_by(self.owner(i), quantity):
                v = joint.velocity.block(slice(3, 6))
                if body.parent >= 0:
                    at_joint = result[body.parent] + self.omega[body.parent].cross(joint.position)
                    v = joint.rotation.T @ at_joint + v
                elif from_root:
                    v = Matrix.zeros(self.graph, 3)
                result.append(self.carry(i, quantity, v))
        return result

    @cached_property
    def ground_rotation(self) -> list[Matrix]:
        """R from body axes to ground axes, ``orientation = orientation_parent R``."""
        result: list[Matrix] = []
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.joints, strict=True)):
            with self.graph.made_by(self.owner(i), "orientation"):
                r = joint.rotation
                if body.parent >= 0:
                    r = result[body.parent] @ r
                r.hint(self.owner(i), "orientation", CELLS)
                result.append(self.carry(i, "orientation", r, ()))
        return result

    @cached_property
    def ground_position(self) -> list[Matrix]:
        """Origins in ground axes, ``position = position_parent + orientation_parent p``."""
        result: list[Matrix] = []
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.joints, strict=True)):
            with self.graph.made_by(self.owner(i), "position"):
                p = joint.position
                if body.parent >= 0:
                    p = result[body.parent] + self.ground_rotation[body.parent] @ p
                p.hint(self.owner(i), "position")
                result.append(self.carry(i, "position", p, ()))
        return result

    def convective(self, i: int) -> Matrix:
        """Velocity products that joint i adds to the acceleration of its body (6, 1), body axes.

        With angular accelerations alpha and accelerations a of the origins,
        alpha_i = Rᵀ alpha_p + S_w udot + convective_w and
        a_i = Rᵀ (a_p + alpha_p x p + omega_p x (omega_p x p)) + S_v udot + convective_v.
        """
        parent, joint = self.system.bodies[i].parent, self.joints[i]
        if parent < 0:
            return joint.drift
        w_rel, v_rel = joint.velocity.block(slice(0, 3)), joint.velocity.block(slice(3, 6))
        parent_omega = (joint.rotation.T @ self.omega[parent]).note("parent_omega")
        return joint.drift + Matrix.vstack(parent_omega.cross(w_rel), parent_omega.cross(v_rel) * 2)

    # what is fixed to a body

    @cached_property
    def turns(self) -> list[Matrix | None]:
        """R from the axes of every body to those its vectors are told in; None: the same."""
        return [turn(self, body.turn) for body in self.system.bodies]

    def fixed_to(self, body: int, x: Matrix) -> Matrix:
        """Vectors in the axes of a body, (3, n), told as those of its motion are."""
        rotation = self.turns[body] if body >= 0 else None
        return x if rotation is None else rotation @ x

    def place(self, frame: int) -> Matrix:
        """Origin of a frame from that of its body."""
        f = self.system.frames[frame]
        return self.fixed_to(f.body, self.vector(f.position))

    # frames, in ground axes

    def body_rotation(self, body: int) -> Matrix:
        return self.ground_rotation[body] if body >= 0 else Matrix.identity(self.graph, 3)

    def position(self, frame: int) -> Matrix:
        """Origin of a frame."""
        f = self.system.frames[frame]
        at = self.place(frame)
        return at if f.body < 0 else self.ground_position[f.body] + self.body_rotation(f.body) @ at

    def rotation(self, frame: int) -> Matrix:
        """R from frame axes to ground axes."""
        f = self.system.frames[frame]
        axes = self.fixed_to(f.body, self.matrix(3, 3, f.rotation))
        return self.body_rotation(f.body) @ axes

    def angular_velocity(self, frame: int) -> Matrix:
        body = self.system.frames[frame].body
        if body < 0:
            return Matrix.zeros(self.graph, 3)
        return self.ground_rotation[body] @ self.omega[body]

    def velocity(self, frame: int) -> Matrix:
        """Velocity of the origin of a frame."""
        f = self.system.frames[frame]
        if f.body < 0:
            return Matrix.zeros(self.graph, 3)
        at = self.place(frame)
        return self.ground_rotation[f.body] @ (self.v[f.body] + self.omega[f.body].cross(at))

    def spin(self, frame: int) -> Matrix:
        f = self.system.frames[frame]
        if f.body < 0:
            return Matrix.zeros(self.graph, 3)
        return paths.frame_axes(self, frame).T @ self.omega[f.body]

    def arm(self, start: int, end: int) -> Matrix:
        return paths.arm(self, start, end)

    def in_frame(self, x: Matrix, start: int, end: int) -> Matrix:
        return paths.in_frame(self, x, start, end)

    def q(self, joint: int) -> Matrix:
        return self.coordinates[joint]

    def u(self, joint: int) -> Matrix:
        return self.speeds[joint]

    # placeholders

    def resolve(self, nodes: Sequence[int]) -> tuple[int, ...]:
        """Nodes with placeholders (and replaced speeds) put in.

        Raises:
            DerivationError: an expression divides by what is always 0 in this scene, or the like.
        """
        return resolved(self, self._replace, nodes)
