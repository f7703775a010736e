"""Steady motions in absolute coordinates: beams go along rigidly with what carries them.

A beam whose strains stay as they are moves as a rigid body: its nodes, and bodies clamped to it,
share one twist V = (omega, v) of what is at the origin of the ground. With joints as constraints

    u = T(q) V,   G u + g_t = 0,   udot = T V' + (0, omega x v of every node),   G udot = gamma

determine speeds and their rates from those that are given: speeds of other joints are 0, and stay.
An observer who turns along sees all of it at rest. In his axes displacements d and rotations e
(those in axes of the bodies) obey d' = dv - omega x d and e' = dw - w x e, and dv' + omega x dv
has the place of accelerations; tangent matrices, which no rigid motion changes, are constant.

Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapters 2 and 11; G. Genta,
Dynamics of Rotating Systems (2005), chapter 2 (rotating observer).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csr_array
from scipy.spatial.transform import Rotation

from ...arrays import Array
from ...records import dataclass
from ...runtime.models.finite_elements.frames import rotation
from ...runtime.models.finite_elements.tables import Integers, Tables
from ...runtime.verification.rotations import cross_matrix
from ..statics.static_problem import scaled
from .carried_beams import TreeEnds, clusters
from .saddle_point import fit

ALIKE = 1e-9  # twists that differ by less, of the largest, are one


@dataclass(frozen=True, eq=False)
class _Nodes:
    """Nodes of one sort, in space or in a plane.

    Attributes:
        places: Their places (n,).
        columns: Their speeds (n, k).
        to_space: Speeds in space by their own (n, 6, k).
    """

    places: Integers
    columns: Integers
    to_space: Array


@dataclass(frozen=True, eq=False)
class Motion:
    """Poses and velocities of all nodes, in the order of :attr:`CorotatingMotion.names`.

    Attributes:
        R, p: Rotations (n, 3, 3) and positions (n, 3).
        w, omega, v: Angular velocities in axes of the nodes and of the ground, velocities (n, 3).
    """

    R: Array
    p: Array
    w: Array
    omega: Array
    v: Array

    @property
    def twists(self) -> Array:
        """Angular velocities, and velocities of what is at the origin (n, 6), ground axes."""
        return np.concatenate([self.omega, self.v - np.cross(self.omega, self.p)], axis=1)


@final
class CorotatingMotion:
    """The rotating part of the steady motions of a model.

    Args:
        tables: Its places.
        beams: Name of the beam of every line of the tables.
        leading: Whether a speed is that of a joint (nu,): those are told, the others follow.
        columns, rows: Units of speeds (nu,) and of constraints (m,).
        size: That of displacements.
        tree_ends: Motion of the bodies of rigid trees that beams end at.
    """

    def __init__(
        self,
        tables: Tables,
        beams: Sequence[str],
        leading: NDArray[np.bool_],
        columns: Array,
        rows: Array,
        size: float,
        tree_ends: TreeEnds,
    ) -> None:
        self.tables, self.leading, self._tree_ends = tables, leading, tree_ends
        self._columns, self._rows = columns, rows
        self._size = size
        self.cluster, self.names, self._fixed_names, ends = clusters(tables, beams)
        # the first body of a tree in a cluster says how it moves, others have to go along
        self._first_end = {c: k for k, c in reversed(list(enumerate(ends)))}
        self._other_ends = [(k, c) for k, c in enumerate(ends) if self._first_end[c] != k]

    @cached_property
    def _sorts(self) -> tuple[_Nodes, ...]:
        tables, groups = self.tables, []
        for flat, count in ((False, 6), (True, 3)):
            places = tables.nodes(flat)
            columns = tables.u[places][:, None] + np.arange(count)
            basis = np.broadcast_to(np.eye(6), (len(places), 6, 6))
            if flat:
                planes = [tables.plane(k) for k in places]
                bases = [plane.to_space for plane in planes if plane is not None]
                basis = np.array(bases).reshape(-1, 6, 3)
            groups.append(_Nodes(places, columns, basis))
        return tuple(groups)

    @property
    def nodes(self) -> Integers:
        """Places that are nodes: those in space, then those of a plane."""
        return np.concatenate([sort.places for sort in self._sorts])

    def motion(self, q: Array, u: Array) -> Motion:
        """Motion of the nodes."""
        space, plane = self._sorts
        poses = q[self.tables.q[space.places][:, None] + np.arange(7)]
        flat = [self.tables.pose(q, int(k)) for k in plane.places]
        poses = np.concatenate([poses, np.array(flat).reshape(-1, 7)])
        R = rotation(poses[:, :4]).reshape(-1, 3, 3)
        twists = [np.einsum("nik,nk->ni", s.to_space, u[s.columns]) for s in self._sorts]
        w, v = np.split(np.concatenate(twists), 2, axis=1)
        return Motion(R, poses[:, 4:], w, np.einsum("nij,nj->ni", R, w), v)

    # speeds that belong to given ones

    def rigid_modes(self, q: Array) -> csr_array:
        """T (nu, k) without units: speeds by those that are told alone, and twists of clusters.

        Clusters that a body of a rigid tree belongs to move as its joints say.
        """
        T = self._modes_of_twists(q)
        return csr_array(T @ self._twists_by_trees(q)) if self._first_end else T

    def _end_twists(self, q: Array) -> Array:
        """Twists of the bodies of trees without units by all speeds without units (n, 6, nu)."""
        twists = self._tree_ends.jacobians(q) * self._columns
        twists[:, 3:] /= self._size
        return twists

    def _alone(self) -> Integers:
        """Speeds that are told alone."""
        return np.flatnonzero(np.repeat(self.cluster, np.diff(self.tables.u)) < 0)

    def _twists_by_trees(self, q: Array) -> csr_array:
        """P: speeds told alone and twists of all clusters by those that are left."""
        alone, count = self._alone(), len(self.names)
        by_trees = self._end_twists(q)
        left = [c for c in range(count) if c not in self._first_end]
        P = np.zeros((len(alone) + 6 * count, len(alone) + 6 * len(left)))
        P[: len(alone), : len(alone)] = np.eye(len(alone))
        for c in range(count):
            rows = slice(len(alone) + 6 * c, len(alone) + 6 * c + 6)
            if c in self._first_end:
                P[rows, : len(alone)] = by_trees[self._first_end[c]][:, alone]
            else:
                first = len(alone) + 6 * left.index(c)
                P[rows, first : first + 6] = np.eye(6)
        return csr_array(P)

    def _missed_twists(self, q: Array) -> Array:
        """By which twists other bodies of trees in a cluster miss the first one's (n, k)."""
        if not self._other_ends:
            return np.zeros((0, 1))
        alone, by_trees = self._alone(), self._end_twists(q)
        rows = [
            by_trees[k][:, alone] - by_trees[self._first_end[c]][:, alone]
            for k, c in self._other_ends
        ]
        width = self._twists_by_trees(q).shape[1]
        return np.hstack([np.vstack(rows), np.zeros((6 * len(rows), width - len(alone)))])

    def _modes_of_twists(self, q: Array) -> csr_array:
        """T with a twist of its own for every cluster."""
        tables, moved = self.tables, self.motion(q, np.zeros(self.tables.nu))
        alone = self._alone()
        i, j, values = [alone], [np.arange(len(alone))], [np.ones(len(alone))]
        # speeds of a node from the twist of its cluster: rotation of axes and lever arms
        blocks = _blocks(len(moved.p))
        blocks[:, :3, :3] = moved.R.transpose(0, 2, 1)
        blocks[:, 3:, :3] = -cross_matrix(moved.p) / self._size
        blocks[:, 3:, 3:] = np.eye(3)
        start = 0
        for sort in self._sorts:
            # scatter the blocks of nodes of one kind at once, as triplets of a sparse matrix
            many = len(sort.places)
            which = self.cluster[sort.places]
            in_cluster = np.flatnonzero(which >= 0)
            part = np.einsum("nik,nij->nkj", sort.to_space, blocks[start : start + many])[
                in_cluster
            ]
            part[self._fixed_names[which[in_cluster]]] = 0.0
            rows = np.broadcast_to(sort.columns[in_cluster][:, :, None], part.shape)
            first = len(alone) + 6 * which[in_cluster]
            i.append(rows.ravel())
            j.append(np.broadcast_to((first[:, None] + np.arange(6))[:, None], part.shape).ravel())
            values.append(part.ravel())
            start += many
        # twists of the origin count in sizes, as displacements do
        shape = (tables.nu, len(alone) + 6 * len(self.names))
        entries = (np.concatenate(values), (np.concatenate(i), np.concatenate(j)))
        return csr_array(coo_array(entries, shape))

    def speeds(
        self, q: Array, G: object, drift: Array, rows: Integers, values: Array
    ) -> tuple[Array, Array]:
        """Speeds (nu,) that constraints allow, and what is left open of them and of given ones.

        Args:
            q: Coordinates (nq,).
            G, drift: G (m, nu) and g_t (m,) of the constraints.
            rows, values: Given speeds: places and values.
        """
        T = self.rigid_modes(q)
        hard = np.concatenate([(self._plain(G) @ T).toarray(), T[rows].toarray()])
        right = np.concatenate([-drift / self._rows, values / self._columns[rows]])
        if self._other_ends:
            missed = self._missed_twists(q)
            hard = np.concatenate([hard, missed])
            right = np.concatenate([right, np.zeros(len(missed))])
        joint_rows = T[self.leading].toarray()
        solution = fit(hard, right, joint_rows, np.zeros(len(joint_rows)))
        return (T @ solution) * self._columns, hard @ solution - right

    def rates(self, q: Array, u: Array, G: Any, gamma: Array) -> Array:
        """udot (nu,) of the steady motion with these speeds: those of joints stay as they are."""
        T, moved = self.rigid_modes(q), self.motion(q, u)
        centripetal = np.zeros((len(moved.p), 6))
        centripetal[self._clustered, 3:] = np.cross(moved.omega, moved.v)[self._clustered]
        centripetal_speeds = self._gathered(centripetal) + self._tree_rates(q, u)
        joint_rows = T[self.leading].toarray()
        right = (gamma - G @ centripetal_speeds) / self._rows
        solution = fit(joint_rows, np.zeros(len(joint_rows)), (self._plain(G) @ T).toarray(), right)
        return np.asarray(centripetal_speeds + (T @ solution) * self._columns)

    def _tree_rates(self, q: Array, u: Array) -> Array:
        """Rates (nu,) of the speeds of nodes as the twists of bodies of trees change."""
        if not self._first_end:
            return np.zeros(self.tables.nu)
        rates = self._tree_ends.rates(q, u)
        rates[:, 3:] /= self._size
        twists = np.zeros((len(self.names), 6))
        for c, k in self._first_end.items():
            twists[c] = rates[k]
        full = np.concatenate([np.zeros(len(self._alone())), twists.ravel()])
        return np.asarray((self._modes_of_twists(q) @ full) * self._columns)

    def _plain(self, G: object) -> Any:
        """G without units."""
        return scaled(csr_array(G), 1.0 / self._rows, self._columns)

    # what moves with what

    def relative_motion(self, q: Array, u: Array) -> tuple[str, str] | None:
        """Names of two beams that do not share one twist, None where all do."""
        # the first node of every cluster; beams from ground to ground may have none
        clusters, first = np.unique(self.cluster[self.nodes], return_index=True)
        clusters, first = clusters[clusters >= 0], first[clusters >= 0]
        if len(clusters) < 2:
            return None
        twists = self._twists(self.motion(q, u))[first]
        off = np.abs(twists - twists[0]).max(axis=1) > ALIKE * np.abs(twists).max()
        worst = clusters[int(np.argmax(off))]
        return (self.names[clusters[0]], self.names[worst]) if off.any() else None

    def shares_one_twist(self, q: Array, u: Array) -> bool:
        """True when all nodes share one twist."""
        twists = self._twists(self.motion(q, u))
        if not len(twists):
            return False
        return bool(np.abs(twists - twists[0]).max() <= ALIKE * np.abs(twists).max())

    def _twists(self, moved: Motion) -> Array:
        """Twists without units (n, 6)."""
        scaled: Array = moved.twists / np.repeat([1.0, self._size], 3)
        return scaled

    def steady_step(
        self, q: Array, u: Array, udot: Array
    ) -> tuple[Array, Array, Array, float] | None:
        """The motion a radian further: increments, speeds, their rates, and after what time.

        None where not all nodes share one twist, or it changes, or nothing turns.
        """
        moved = self.motion(q, u)
        centripetal = np.zeros((len(moved.p), 6))
        centripetal[:, 3:] = np.cross(moved.omega, moved.v)
        largest = float(np.abs(moved.omega).max(initial=0.0))
        missed = np.abs((self._gathered(centripetal) - udot) / self._columns).max(initial=0.0)
        if largest == 0 or not self.shares_one_twist(q, u) or missed > ALIKE * largest**2:
            return None
        tau = 1.0 / float(np.linalg.norm(moved.omega[0]))
        turn = Rotation.from_rotvec(tau * moved.omega[0])
        # a motion on a helix: along the axis, and around it
        axis = tau * moved.omega[0]
        along = np.outer(moved.v @ axis, axis)
        around = np.cross(axis, turn.apply(moved.v) - moved.v)
        steps = np.concatenate([tau * moved.w, tau * (along - around)], axis=1)
        speeds = np.concatenate([moved.w, turn.apply(moved.v)], axis=1)
        centripetal[:, 3:] = np.cross(moved.omega, speeds[:, 3:])
        alone = np.ones(self.tables.nu)
        alone[self._independent] = 0.0
        return (
            self._gathered(steps) + tau * u * alone,
            self._gathered(speeds) + u * alone,
            self._gathered(centripetal),
            tau,
        )

    @cached_property
    def _independent(self) -> Integers:
        """Speeds of nodes."""
        return np.concatenate([sort.columns.ravel() for sort in self._sorts])

    @property
    def _clustered(self) -> NDArray[np.bool_]:
        """Mask of the nodes that belong to a cluster (n,)."""
        return np.asarray(self.cluster[self.nodes] >= 0)

    # tangents

    def tangents(self, q: Array, u: Array, udot: Array) -> tuple[csr_array, csr_array]:
        """Derivatives of speeds and their rates along increments where all share one twist."""
        moved = self.motion(q, u)
        alpha = np.einsum("nij,nj->ni", moved.R, self.motion(q, udot).w)
        first, second = _blocks(len(moved.p)), _blocks(len(moved.p))
        turn = cross_matrix(moved.omega)
        first[:, :3, :3], first[:, 3:, 3:] = cross_matrix(moved.w), turn
        second[:, :3, :3] = cross_matrix(self.motion(q, udot).w)
        second[:, 3:, 3:] = cross_matrix(alpha) + turn @ turn
        return self._matrix(first), self._matrix(second)

    def observer(self, q: Array, u: Array) -> tuple[csr_array, csr_array]:
        """E and W (nu, nu): increments change at E e + v, and rates of speeds are v' + W v.

        Displacements of nodes that go along with beams are those that one sees who turns along,
        of all others those in ground axes.
        """
        moved = self.motion(q, u)
        twists = self._twists(moved)
        along = np.zeros(len(twists), dtype=bool)
        if len(self.names):
            lead = twists[np.argmax(self._clustered)]
            along = np.abs(twists - lead).max(axis=1) <= ALIKE * np.abs(twists).max(initial=0.0)
            along |= self._clustered
        E, W = _blocks(len(moved.p)), _blocks(len(moved.p))
        W[along, 3:, 3:] = cross_matrix(moved.omega)[along]
        E[:, 3:, 3:] = -W[:, 3:, 3:]
        # rotation vectors are along axes that turn with their nodes and joints
        rows, shape = self.tables.rotational_speeds, (self.tables.nu, self.tables.nu)
        turns = -cross_matrix(u[rows])
        i, j = (np.broadcast_to(x, turns.shape).ravel() for x in (rows[:, :, None], rows[:, None]))
        axis_turns = csr_array(coo_array((turns.ravel(), (i, j)), shape))
        return self._matrix(E) + axis_turns, self._matrix(W)

    # nodes in the places of the model

    def _gathered(self, node_speeds: Array) -> Array:
        """Speeds (nu,) of the model from those of nodes in space (n, 6)."""
        speeds, start = np.zeros(self.tables.nu), 0
        for sort in self._sorts:
            part = node_speeds[start : start + len(sort.places)]
            speeds[sort.columns] = np.einsum("nik,ni->nk", sort.to_space, part)
            start += len(sort.places)
        return speeds

    def _matrix(self, blocks: Array) -> csr_array:
        """A matrix (nu, nu) of the model from those of nodes in space (n, 6, 6)."""
        i, j, values, start = list[Any](), list[Any](), list[Array](), 0
        for sort in self._sorts:
            part = blocks[start : start + len(sort.places)]
            part = np.einsum("nik,nij,njl->nkl", sort.to_space, part, sort.to_space)
            i.append(np.broadcast_to(sort.columns[:, :, None], part.shape).ravel())
            j.append(np.broadcast_to(sort.columns[:, None], part.shape).ravel())
            values.append(part.ravel())
            start += len(sort.places)
        entries = (np.concatenate(values), (np.concatenate(i), np.concatenate(j)))
        matrix = csr_array(coo_array(entries, (self.tables.nu, self.tables.nu)))
        matrix.eliminate_zeros()
        return matrix


def _blocks(n: int) -> Array:
    return np.zeros((n, 6, 6))
