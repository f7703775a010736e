"""Independent closing conditions of a loop, whatever its motion.

The motions of one end of a loop against the other lie in the group that its joints generate:
the plane for parallel axes, the rotations about a point for axes that meet there. Conditions that
hold all over the group are left out, so that planar and spherical loops close by the two or
three conditions of their own geometry. The group is found by its algebra: the twists of the joints
and all their products [a, b], as many as are independent.

Source: Hervé, Analyse structurelle des mécanismes par groupe des déplacements, Mech. Mach. Theory
13 (1978); Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 8.
"""

from __future__ import annotations

import dataclasses
from collections import deque
from collections.abc import Mapping, Sequence

import numpy as np

from ...arrays import Array
from ...elements.closing import closed
from ...elements.joints.joint import Joint as JointElement
from ...ir.matrix import Matrix
from ...records import dataclass
from ..conversion import Converter
from ..system import Cut, Frame, Joint, Nodes

# what is left of a twist of length 1 that depends on others
DEPENDENT = 1e-9
# joint positions at which twists and gradients are taken: the default one, and one beside it
SAMPLES = 2
Data = Mapping[str, tuple[int, int, Nodes]]


@dataclass(frozen=True)
class Pose:
    """R (3, 3) and p (3)."""

    rotation: Array
    position: Array

    def then(self, inner: Pose) -> Pose:
        return Pose(self.rotation @ inner.rotation, self.position + self.rotation @ inner.position)

    def inverse(self) -> Pose:
        return Pose(self.rotation.T, -self.rotation.T @ self.position)

    def transformed(self, twists: Array) -> Array:
        """Twists (6, n) about the inner origin in inner axes, about the outer one in outer axes."""
        angular, moving = self.rotation @ twists[:3], self.rotation @ twists[3:]
        return np.concatenate([angular, moving + cross_matrix(self.position) @ angular])


def cross_matrix(a: Array) -> Array:
    """The matrix (3, 3) of a x b."""
    x, y, z = a.tolist()
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


HERE = Pose(np.eye(3), np.zeros(3))


def circuit(
    parents: Sequence[int], parent: int, child: int
) -> tuple[int, tuple[tuple[int, int], ...]]:
    """Joints of a loop from where the branches to two bodies part, with their signs.

    Args:
        parents: Parent of every body, -1 for the ground.
        parent, child: The bodies.

    Returns:
        The body from which both branches start, and (joint, sign): 1 on the branch of the child.
    """
    path: list[tuple[int, int]] = []
    one, other = parent, child
    while one != other:
        # bodies are numbered regularly: the higher number cannot be inboard of the other
        if one > other:
            path.append((one, -1))
            one = parents[one]
        else:
            path.append((other, 1))
            other = parents[other]
    return one, tuple(sorted(path))


def independent(
    cuts: Sequence[Cut],
    joints: Sequence[Joint],
    parents: Sequence[int],
    frames: Sequence[Frame],
    convert: Converter,
) -> tuple[Cut, ...]:
    """The cuts with the rows that are independent on the group of their loop.

    Args:
        cuts: With all rows.
        joints, parents: The tree joints and the body inboard of each.
        frames: Of the system.
        convert: Knows the default parameters, at which this is found.
    """
    numbers = Numbers(convert)
    return tuple([_independent(cut, joints, parents, frames, numbers) for cut in cuts])


def _independent(
    cut: Cut,
    joints: Sequence[Joint],
    parents: Sequence[int],
    frames: Sequence[Frame],
    numbers: Numbers,
) -> Cut:
    at, twists = {cut.base: HERE}, list[Array]()
    for i, _ in cut.path:
        joint = joints[i]
        seat = at[parents[i]].then(numbers.pose(joint.rotation, joint.position))
        for sample in range(SAMPLES):
            pose, modes = numbers.motion(joint.element, joint.data, sample)
            moved = seat.then(pose)
            twists += list(moved.transformed(modes).T)
            if sample == 0:
                at[i] = moved
    algebra = closure(twists)
    if len(algebra) == 6 or not cut.rows:
        return cut
    # the group as the cut joint sees it: about the origin and in the axes of its child frame
    frame = frames[cut.parent_frame]
    seat = at[frame.body].then(numbers.pose(frame.rotation, frame.position))
    blocks = []
    for sample in range(SAMPLES):
        pose, _ = numbers.motion(cut.element, cut.data, sample)
        back = seat.then(pose).inverse()
        blocks.append(numbers.gradient(cut, pose) @ back.transformed(algebra.T))
    rank = int(np.linalg.matrix_rank(blocks[-1], tol=DEPENDENT * max(1.0, abs(blocks[-1]).max())))
    rows = _leading(np.hstack(blocks), rank)
    return dataclasses.replace(cut, rows=rows, group=_group(algebra))


def _group(algebra: Array) -> str:
    """Name of the group that twists (n, 6) generate."""
    turns = int(np.linalg.matrix_rank(algebra[:, :3], tol=DEPENDENT)) if len(algebra) == 3 else 0
    return {1: "planar", 3: "spherical"}.get(turns, "")


def closure(twists: Sequence[Array]) -> Array:
    """An orthonormal basis (n, 6) of the algebra that twists generate."""
    basis = np.empty((0, 6))
    waiting = deque(twists)
    while waiting and len(basis) < 6:
        new = waiting.popleft()
        size = float(np.linalg.norm(new))
        if size == 0:
            continue
        remainder = new / size
        # twice, so that rounding leaves nothing along the basis
        for _ in range(2):
            remainder = remainder - basis.T @ (basis @ remainder)
        left = float(np.linalg.norm(remainder))
        if left > DEPENDENT:
            remainder = remainder / left
            waiting.extend(basis @ product_matrix(remainder).T)
            basis = np.vstack([basis, remainder])
    return basis


def product_matrix(a: Array) -> Array:
    """The matrix (6, 6) of [a, b]: how twist b changes as its line moves along a."""
    matrix = np.zeros((6, 6))
    matrix[:3, :3] = matrix[3:, 3:] = cross_matrix(a[:3])
    matrix[3:, :3] = cross_matrix(a[3:])
    return matrix


def _leading(rows: Array, rank: int) -> tuple[int, ...]:
    """Leading rows, as many as the rank says, each the least dependent on those before it."""
    remainder, chosen = rows.copy(), list[int]()
    for _ in range(rank):
        sizes = np.linalg.norm(remainder, axis=1)
        # the first of equal ones: the same choice on every machine
        best = int(np.flatnonzero(sizes > 0.999 * sizes.max())[0])
        chosen.append(best)
        along = remainder[best] / sizes[best]
        remainder = remainder - np.outer(remainder @ along, along)
    return tuple(sorted(chosen))


class Numbers:
    """Poses, modes of motion and gradients of joints at the default parameters."""

    def __init__(self, convert: Converter) -> None:
        self.convert = convert
        self.graph = convert.graph.fork()

    def values(self, *nodes: int) -> Array:
        return np.array(self.convert.defaults(nodes, self.graph))

    def pose(self, rotation: Nodes, position: Nodes) -> Pose:
        values = self.values(*rotation, *position)
        return Pose(values[:9].reshape(3, 3), values[9:])

    def _data(self, data: Data) -> dict[str, Matrix]:
        return {name: Matrix(self.graph, *entry) for name, entry in data.items()}

    def motion(self, element: JointElement, data: Data, sample: int) -> tuple[Pose, Array]:
        """Pose and modes S (6, nu) of a joint at its default coordinates, or beside them."""
        g, data_matrices = self.graph, self._data(data)
        start = [g.const(c.default) for c in element.coordinates]
        q = Matrix(g, len(start), 1, start)
        if sample:
            step = [g.const(0.3 + 0.17 * k) for k in range(len(element.speeds))]
            q = element.integrate(q, Matrix(g, len(step), 1, step), **data_matrices)
        rotation, position = element.pose(q, **data_matrices)
        modes = element.motion(q, **data_matrices)
        modes_matrix = self.values(*modes.nodes).reshape(6, modes.columns)
        return self.pose(rotation.nodes, position.nodes), modes_matrix

    def start(self, joint: Joint) -> Pose:
        """Pose of the outer body in axes of the inner one, at the initial values of a joint."""
        g, data_matrices = self.graph, self._data(joint.data)
        start = joint.q0 or [c.default for c in joint.element.coordinates]
        q = Matrix(g, len(start), 1, [g.const(float(x)) for x in start])
        rotation, position = joint.element.pose(q, **data_matrices)
        moved = self.pose(rotation.nodes, position.nodes)
        return self.pose(joint.rotation, joint.position).then(moved)

    def gradient(self, cut: Cut, pose: Pose) -> Array:
        """Gradient of the closing conditions along twists (m, 6)."""
        g = self.graph
        rotation = Matrix(g, 3, 3, [g.const(float(x)) for x in pose.rotation.ravel()])
        position = Matrix(g, 3, 1, [g.const(float(x)) for x in pose.position])
        _, gradient = closed(cut.element, rotation, position, self._data(cut.data))
        return self.values(*gradient.nodes).reshape(gradient.rows, 6)
