"""A component in large motion, in NumPy: an independent route that shares no code with cardan.

Interfaces have poses: unit quaternions (w, x, y, z) and positions in ground axes; speeds are their
angular velocities in their own axes and their velocities in ground axes. Modal coordinates follow.
A frame (R0, x0) goes along with them; in it the component deforms by small

    u_i = R0^T (x_i - x0) - X_i,  th_i = log(R0^T R_i),  z = (u_1, th_1, u_2, ..., eta).

The frame is implicit, with weights a_i of sum 1 and a matrix W of rotations:

    x0 = sum a_i x_i - R0 X,  X = sum a_i X_i,  sum a_i [(X_i - X) x u_i + W th_i] = 0.

Kinetic energy is c^T G c / 2 with c = (v, w, w_x z, w_y z, w_z z, z') = A(q) u by the speeds u.
A is written out; its derivatives come from complex steps, so equations of motion are exact.

Sources: Geradin and Cardona, Flexible Multibody Dynamics (2001), section 8.7; Zwoelfer and
Gerstmayr, Acta Mechanica 232 (2021) for the inertia of all nodes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.linalg import eigh

from superelements.rotations import (
    conjugate,
    cross,
    exponential,
    left_inverse,
    logarithm,
    product,
    rotation,
    skew,
)

Array = Any
STEP = 1e-40  # imaginary: errors are of its square
CLOSE = 1e-13  # of a rotation of the frame in the iteration [rad]
COMPONENTS = ("x", "y", "z", "rx", "ry", "rz")
EYE = np.eye(3)


@dataclass(frozen=True)
class Hub:
    """A rigid body fixed to an interface.

    Attributes:
        mass: [kg].
        inertia: About its center of mass, in axes of the interface (3, 3) [kg m^2].
        center: Of mass, from the interface (3,) [m].
    """

    mass: float
    inertia: Array
    center: Array

    @property
    def matrix(self) -> Array:
        """Kinetic energy by angular velocity and velocity, both in its axes (6, 6)."""
        arm = self.mass * skew(self.center)
        turn = np.asarray(self.inertia) - arm @ skew(self.center)
        return np.block([[turn, arm], [arm.T, self.mass * EYE]])


@dataclass(frozen=True)
class Kinematics:
    """What the equations need of a configuration, with leading dimensions of it.

    Attributes:
        turn, origin: Of the frame: R0 (..., 3, 3), x0 (..., 3).
        z: Local coordinates (..., n).
        rates: v and w of the frame in its axes and z' by speeds (..., 6 + n, speeds).
        A: What kinetic energy is a constant form of, by speeds (..., rows, speeds).
    """

    turn: Array
    origin: Array
    z: Array
    rates: Array
    A: Array


@dataclass(frozen=True)
class Corotational:
    """A component between interfaces that move far.

    Attributes:
        stiffness: K (n, n).
        inertia: G (6 + 4 n, 6 + 4 n), in the order of c.
        places: X_i (interfaces, 3) [m].
        pick: Which of six motions of all interfaces, and of modal coordinates, z has (n,).
        weights: a_i (interfaces,).
        turning: W (3, 3) [m^2]; L^2 for a mean frame, L^2 e e^T for a chord along e.
        book: Kinetic energy by velocities of interfaces, in axes of the frame, and eta' alone, the
            simpler form of section 8.7.
        stiffening: Geometric stiffness by products of angular velocities of the frame
            (3, 3, n, n): what it adds to the energy is w_k w_l z^T K_kl z / 2.
        hubs: Rigid bodies by the number of the interface.
        gravity: Acceleration in ground axes (3,) [m/s^2].
    """

    stiffness: Array
    inertia: Array
    places: Array
    pick: Array
    weights: Array
    turning: Array
    book: bool = False
    stiffening: Array | None = None
    hubs: Mapping[int, Hub] = field(default_factory=dict)
    gravity: Array = field(default_factory=lambda: np.zeros(3))

    @staticmethod
    def of(record: Any, frame: str = "mean", node: int = 0, **options: Any) -> Corotational:
        """A reduced component with a frame: ``"mean"``, ``"node"`` or ``"chord"``."""
        places = np.array([one.position for one in record.interfaces], float)
        motions = [one.components for one in record.interfaces]
        count = len(places)
        boundary = [6 * i + COMPONENTS.index(m) for i in range(count) for m in motions[i]]
        modes = 6 * count + np.arange(record.n - len(boundary))
        along = places[-1] - places[0]
        length = np.linalg.norm(along)
        weights, turning = np.full(count, 1 / count), (length / 3) ** 2 * EYE
        if frame == "node":
            weights = np.eye(count)[node]
        if frame == "chord":
            turning = np.outer(along, along)
        made = Corotational(
            stiffness=record.K,
            inertia=record.inertia.matrix(),
            places=places,
            pick=np.array([*boundary, *modes], dtype=int),
            weights=weights,
            turning=turning,
        )
        return replace(made, **options)

    @property
    def n(self) -> int:
        return len(self.stiffness)

    @property
    def n_modes(self) -> int:
        return int((self.pick >= 6 * len(self.places)).sum())

    @property
    def n_speeds(self) -> int:
        return 6 * len(self.places) + self.n_modes

    @property
    def form(self) -> Array:
        """The constant matrix of the kinetic energy, geometric stiffness and hubs in it."""
        n, G = self.n, self.inertia
        if self.book:
            G = G[-n:, -n:]
        elif self.stiffening is not None:
            G = G.copy()
            for k in range(3):
                for m in range(3):
                    a, b = 6 + k * n, 6 + m * n
                    G[a : a + n, b : b + n] -= self.stiffening[k, m]
        return block_diagonal(G, *(self.hubs[i].matrix for i in sorted(self.hubs)))

    def start(self, turn: Array | None = None, origin: Array | None = None) -> Array:
        """Configuration without deformation, with the frame there: a quaternion and a position."""
        turn = np.array([1.0, 0, 0, 0]) if turn is None else np.asarray(turn)
        at = np.zeros(3) if origin is None else np.asarray(origin)
        R = rotation(turn)
        poses = [np.concatenate([turn, at + R @ X]) for X in self.places]
        return np.concatenate([*poses, np.zeros(self.n_modes)])

    def rigid(self, q: Array, omega: Array, velocity: Array) -> Array:
        """Speeds of a rigid motion: angular velocity and velocity at the origin, ground axes."""
        p, x, _ = self.split(q)
        parts = [
            np.concatenate([rotation(a).T @ omega, velocity + np.cross(omega, b)])
            for a, b in zip(p, x, strict=True)
        ]
        return np.concatenate([*parts, np.zeros(self.n_modes)])

    def split(self, q: Array) -> tuple[Array, Array, Array]:
        """Quaternions of unit length, positions, and modal coordinates."""
        count = len(self.places)
        poses = q[..., : 7 * count].reshape(*q.shape[:-1], count, 7)
        p = poses[..., :4]
        return p / np.sqrt((p * p).sum(-1, keepdims=True)), poses[..., 4:], q[..., 7 * count :]

    def moved(self, q: Array, step: Array) -> Array:
        """Configuration after increments along the speeds, (..., speeds), complex ones too."""
        count = len(self.places)
        p, x, eta = self.split(q)
        each = step[..., : 6 * count].reshape(*step.shape[:-1], count, 6)
        poses = np.concatenate([product(p, exponential(each[..., :3])), x + each[..., 3:]], -1)
        flat = poses.reshape(*poses.shape[:-2], 7 * count)
        return np.concatenate([flat, eta + step[..., 6 * count :]], -1)

    def frame(self, q: Array) -> tuple[Array, Array, Array, Array]:
        """Frame quaternion, origin, u_i and th_i, by Newton's method.

        Raises:
            RuntimeError: it does not converge.
        """
        p, x, _ = self.split(q)
        a, X = self.weights, self.places
        center = a @ X
        p0 = p[..., int(np.argmax(a)), :]
        if np.iscomplexobj(q):  # complex steps start from the frame of the first one without
            p0 = np.broadcast_to(self.frame(q.real[(0,) * (q.ndim - 1)])[0], p0.shape) + 0j
        for _ in range(50):
            R0 = rotation(p0)
            x0 = (a[:, None] * x).sum(-2) - R0 @ center
            u = np.einsum("...ba,...ib->...ia", R0, x - x0[..., None, :]) - X
            th = logarithm(product(conjugate(p0)[..., None, :], p))
            gap = (a[:, None] * (cross(X - center, u) + th @ self.turning)).sum(-2)
            step = np.linalg.solve(self._lever(u, th), gap[..., None])[..., 0]
            # in complex steps the parts are of very different size
            done = np.abs(step.real).max() < CLOSE and np.abs(step.imag).max() < CLOSE * STEP
            if done:
                return p0, x0, u, th
            p0 = product(p0, exponential(step))
        raise RuntimeError("the frame does not converge")

    def _lever(self, u: Array, th: Array) -> Array:
        """H: how the condition of the frame changes as it turns (..., 3, 3)."""
        arms = -skew(self.places - self.weights @ self.places) @ skew(self.places + u)
        return np.einsum("i,...iab->...ab", self.weights, arms + self.turning @ left_inverse(th))

    def kinematics(self, q: Array) -> Kinematics:
        """Local coordinates and the maps from speeds."""
        count, N = len(self.places), self.n_speeds
        p, _, eta = self.split(q)
        p0, x0, u, th = self.frame(q)
        R0, lead = rotation(p0), q.shape[:-1]
        back, center = np.swapaxes(R0, -1, -2), self.weights @ self.places
        kind = q.dtype
        right, left = left_inverse(-th), left_inverse(th)
        condition, mean = np.zeros((*lead, 3, N), kind), np.zeros((*lead, 3, N), kind)
        for i, (a, X) in enumerate(zip(self.weights, self.places, strict=True)):
            turn, move = slice(6 * i, 6 * i + 3), slice(6 * i + 3, 6 * i + 6)
            condition[..., turn] = a * self.turning @ right[..., i, :, :]
            condition[..., move] = a * skew(X - center) @ back
            mean[..., move] = a * back
        w = np.linalg.solve(self._lever(u, th), condition)
        v = mean + skew(center) @ w
        local = np.zeros((*lead, N, N), kind)
        for i, X in enumerate(self.places):
            turn, move = slice(6 * i, 6 * i + 3), slice(6 * i + 3, 6 * i + 6)
            # motions of z come first, then rotations; speeds the other way around
            local[..., turn, :] = skew(X + u[..., i, :]) @ w - v
            local[..., turn, move] += back
            local[..., move, :] = -left[..., i, :, :] @ w
            local[..., move, turn] += right[..., i, :, :]
        local[..., 6 * count :, 6 * count :] = np.eye(self.n_modes)
        all_z = np.concatenate([u, th], -1).reshape(*lead, 6 * count)
        z = np.concatenate([all_z, eta], -1)[..., self.pick]
        rates = np.concatenate([v, w, local[..., self.pick, :]], -2)
        rows = [self._corotated(R0, p)] if self.book else [v, w]
        if not self.book:
            rows += [w[..., k, None, :] * z[..., :, None] for k in range(3)]
            rows += [rates[..., 6:, :]]
        rows += [self._of_hub(i, rotation(p[..., i, :])) for i in sorted(self.hubs)]
        return Kinematics(R0, x0, z, rates, np.concatenate(rows, -2))

    def _corotated(self, R0: Array, p: Array) -> Array:
        """Velocities of interfaces in axes of the frame and rates of modal coordinates."""
        count, N = len(self.places), self.n_speeds
        rows = np.zeros((*R0.shape[:-2], N, N), R0.dtype)
        back = np.swapaxes(R0, -1, -2)
        for i in range(count):
            turn, move = slice(6 * i, 6 * i + 3), slice(6 * i + 3, 6 * i + 6)
            rows[..., turn, move] = back
            rows[..., move, turn] = back @ rotation(p[..., i, :])
        rows[..., 6 * count :, 6 * count :] = np.eye(self.n_modes)
        return rows[..., self.pick, :]

    def _of_hub(self, i: int, R: Array) -> Array:
        """Angular velocity and velocity of an interface in its axes."""
        rows = np.zeros((*R.shape[:-2], 6, self.n_speeds), R.dtype)
        rows[..., :3, 6 * i : 6 * i + 3] = EYE
        rows[..., 3:, 6 * i + 3 : 6 * i + 6] = np.swapaxes(R, -1, -2)
        return rows

    # energies and momenta

    def potential(self, q: Array, k: Kinematics | None = None) -> Array:
        """Strain energy, and that of gravity."""
        k = k or self.kinematics(q)
        n = self.n
        strain = 0.5 * np.einsum("...i,ij,...j->...", k.z, self.stiffness, k.z)
        mass, first, shapes = self.inertia[0, 0], self.inertia[:3, 3:6], self.inertia[:3, -n:]
        moment = np.array([first[1, 2], -first[0, 2], first[0, 1]])  # m times the center of mass
        lever = moment + k.z @ shapes.T
        fall = mass * k.origin + np.einsum("...ab,...b->...a", k.turn, lever)
        p, x, _ = self.split(q)
        for i, hub in self.hubs.items():
            fall = fall + hub.mass * (x[..., i, :] + rotation(p[..., i, :]) @ hub.center)
        return strain - fall @ self.gravity

    def mass(self, q: Array) -> Array:
        """Of the speeds (speeds, speeds)."""
        A = self.kinematics(q).A
        return A.T @ self.form @ A

    def kinetic(self, q: Array, u: Array) -> float:
        c = self.kinematics(q).A @ u
        return float(0.5 * c @ self.form @ c)

    def energy(self, q: Array, u: Array) -> float:
        return self.kinetic(q, u) + float(self.potential(q))

    def momentum(self, q: Array, u: Array) -> Array:
        """Linear and angular momentum about the ground's origin, by rigid motions (6,)."""
        impulse = self.mass(q) @ u
        zero = np.zeros(3)
        straight = [impulse @ self.rigid(q, zero, e) for e in EYE]
        turning = [impulse @ self.rigid(q, e, zero) for e in EYE]
        return np.array([*straight, *turning])

    # of the strain alone

    def strain_forces(self, q: Array) -> Array:
        """Derivatives of the strain energy along the speeds, written out (..., speeds)."""
        k = self.kinematics(q)
        return np.einsum("...ia,ij,...j->...a", k.rates[..., 6:, :], self.stiffness, k.z)

    def strain_tangent(self, q: Array) -> Array:
        """Their changes by increments along the speeds, in columns (speeds, speeds)."""
        steps = self.moved(q.astype(complex), 1j * STEP * np.eye(self.n_speeds))
        return self.strain_forces(steps).imag.T / STEP


def block_diagonal(*blocks: Array) -> Array:
    size = sum(len(block) for block in blocks)
    result, at = np.zeros((size, size)), 0
    for block in blocks:
        result[at : at + len(block), at : at + len(block)] = block
        at += len(block)
    return result


def frequencies_at_rest(element: Corotational) -> Array:
    """Of small motions of the undeformed component, zeros left out."""
    q = element.start()
    P = element.kinematics(q).rates[6:]
    squares = eigh(P.T @ element.stiffness @ P, element.mass(q), eigvals_only=True)
    return np.sqrt(np.maximum(squares, 0.0))[6:]
