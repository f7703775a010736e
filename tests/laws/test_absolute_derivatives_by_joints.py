"""Derivatives over elements, along motions of the joints, are those in joint coordinates.

On the constraints the state of all nodes follows from that of the joints, x = phi(q, u). Along a
motion without accelerations of joints q changes by u; speeds of nodes then change by their
accelerations, so that both models have the same changes of every function. Matrices are changed by
nodes in place of joints: M = Tᵀ M_nodes T, J = J_nodes T and 0 = G T, with T the speeds of places
per speed of a joint, whose change follows from the Jacobians of the bodies.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

import cardan as cd
from mechanisms import ZOO
from table import each

NAMES = ("double_pendulum", "universal", "springs", "damped")
ROUNDING = 1e-10


class Pair:
    """A mechanism in joint coordinates and with nodes, at the same state."""

    def __init__(self, name: str) -> None:
        scene = ZOO[name].build
        self.joints = cd.compile(scene(), coordinates="relative")
        self.nodes = cd.compile(scene(), coordinates="absolute")
        rng = np.random.default_rng(4)
        start, _ = self.joints.split(self.joints.initial())
        self.q = self.joints.integrate(start, 0.3 * rng.uniform(-1, 1, self.joints.nu))
        self.u = rng.uniform(-1, 1, self.joints.nu)
        self.still = np.zeros(self.joints.nu)
        self.T = self._per_speed()
        self.T_change = self._per_speed_change()
        self.q_nodes = self._coordinates()
        self.u_nodes = self.T @ self.u
        # along the motion the speeds of joints stay
        self.u_change = self.T_change @ self.u

    def _places(self) -> Any:
        """Rows of the places of all nodes, and whether they are joints."""
        by_name = {row.name: row for row in self.joints.manifest.joints}
        return [(row, by_name.get(row.name)) for row in self.nodes.manifest.joints]

    def _coordinates(self) -> Any:
        q = np.zeros(self.nodes.nq)
        for row, joint in self._places():
            first, count = row.slot("q")
            if joint is None:
                T = self.joints.pose(row.name, self.q)
                value = np.concatenate([quaternion(T[:3, :3]), T[:3, 3]])
            else:
                start, size = joint.slot("q")
                value = self.q[start : start + size]
            q[first : first + count] = value
        return q

    def _per_speed(self) -> Any:
        """Speeds of all places per speed of a joint (nu of nodes, nu)."""
        T = np.zeros((self.nodes.nu, self.joints.nu))
        for row, joint in self._places():
            first, count = row.slot("u")
            if joint is None:
                J = self.joints.frame_jacobian(row.name, self.q)
                R = self.joints.pose(row.name, self.q)[:3, :3]
                T[first : first + count] = np.vstack([R.T @ J[:3], J[3:]])
            else:
                start, size = joint.slot("u")
                T[first : first + count, start : start + size] = np.eye(size)
        return T

    def _per_speed_change(self) -> Any:
        """Change of that along the motion."""
        change = np.zeros_like(self.T)
        for row, joint in self._places():
            first, count = row.slot("u")
            if joint is None:
                J = self.joints.frame_jacobian(row.name, self.q)
                dJ = self.joints.jvp(("frame_jacobian", row.name), wrt="q")(
                    self.q, direction=self.u
                )
                R = self.joints.pose(row.name, self.q)[:3, :3]
                turning = np.cross(J[:3] @ self.u, J[:3], axisb=0, axisc=0)
                change[first : first + count] = np.vstack([R.T @ (dJ[:3] - turning), dJ[3:]])
        return change

    def changes(self, function: Any) -> tuple[Any, Any]:
        """Of a function of q and u by joints and by nodes, along the motion."""
        of_joints = self.joints.jvp(function, wrt=("q", "u"))(
            self.q, self.u, direction=(self.u, self.still)
        )
        of_nodes = self.nodes.jvp(function, wrt=("q", "u"))(
            self.q_nodes, self.u_nodes, direction=(self.u_nodes, self.u_change)
        )
        return of_joints, of_nodes

    def changes_of_place(self, function: Any) -> tuple[Any, Any]:
        """The same of a function of q."""
        of_joints = self.joints.jvp(function, wrt="q")(self.q, direction=self.u)
        of_nodes = self.nodes.jvp(function, wrt="q")(self.q_nodes, direction=self.u_nodes)
        return of_joints, of_nodes


def quaternion(R: Any) -> Any:
    from scipy.spatial.transform import Rotation

    return np.roll(Rotation.from_matrix(R).as_quat(), 1)


@functools.cache
def pair(name: str) -> Pair:
    return Pair(name)


def same(a: Any, b: Any, size: float = 0.0) -> bool:
    return bool(np.abs(a - b).max() <= ROUNDING * max(np.abs(a).max(), size))


@each("name", NAMES)
def test_frames(name: str) -> None:
    """Poses, velocities, accelerations and Jacobians of all frames that both have."""
    p, moving = pair(name), 0
    for frame in {*p.joints.frames} & {*p.nodes.frames}:
        change, of_nodes = p.changes_of_place(("pose", frame))
        moving += bool(np.abs(change).max() > 0.1)
        assert same(change, of_nodes, 1.0), frame
        assert same(*p.changes(("velocity", frame)), 1.0), frame
        dJ, dJ_nodes = p.changes_of_place(("frame_jacobian", frame))
        J_nodes = p.nodes.frame_jacobian(frame, p.q_nodes)
        assert same(dJ, dJ_nodes @ p.T + J_nodes @ p.T_change, 1.0), frame
        # by accelerations: the Jacobian; by places with those of nodes that joints have
        by_udot = p.nodes.derivative(("acceleration", frame), wrt="udot")(
            p.q_nodes, p.u_nodes, p.u_change
        )
        assert same(by_udot, J_nodes, 1.0), frame
        by_u = p.joints.derivative(("velocity", frame), wrt="u")(p.q, p.u)
        of_nodes = p.nodes.derivative(("velocity", frame), wrt="u")(p.q_nodes, p.u_nodes)
        assert same(by_u, of_nodes @ p.T, 1.0), frame
    assert moving


@each("name", NAMES)
def test_reactions_and_forces(name: str) -> None:
    """Reactions of joints, forces of elements, momenta and powers."""
    p = pair(name)
    joints = [*p.nodes.manifest.elements.reactions]
    for joint in joints:
        of_joints, of_nodes = p.changes(("reaction", joint))
        assert np.abs(of_joints).max() > 0.1, joint
        assert same(of_joints, of_nodes), joint
        # masses and gravity move no node
        names = [n for n in p.joints.parameters if n.endswith(".mass") or n.startswith("gravity")]
        columns = zip(
            p.joints.derivative(("reaction", joint), wrt=names)(p.q, p.u),
            p.nodes.derivative(("reaction", joint), wrt=names)(p.q_nodes, p.u_nodes),
            strict=True,
        )
        assert all(same(a, b, 1.0) for a, b in columns), joint
    functions = ["momentum"]
    functions += ["element_forces"] * bool(p.nodes.manifest.element_forces)
    functions += ["power"] * bool(p.nodes.manifest.elements.power_sources)
    for function in functions:
        assert same(*p.changes(function), 1.0), function
    assert joints


@each("name", NAMES)
def test_matrices(name: str) -> None:
    """The mass matrix along the joints, and rows of constraints, which joints fulfil."""
    p = pair(name)
    M = p.nodes.mass_matrix(p.q_nodes)
    dM, dM_nodes = p.changes_of_place("mass_matrix")
    half = p.T.T @ M @ p.T_change
    assert same(dM, p.T.T @ dM_nodes @ p.T + half + half.T, np.abs(half).max())
    G = p.nodes.constraint_jacobian(p.q_nodes)
    dG = p.nodes.jvp("constraint_jacobian", wrt="q")(p.q_nodes, direction=p.u_nodes)
    assert np.abs(dG @ p.T).max() > 0.1
    assert same(dG @ p.T, -G @ p.T_change)
