"""Independent values of what names in the generated C say, at a random state.

Bodies, joints and forces by Newton and Euler in NumPy over the flat scene, constraints by
differences of their rates, factors and multipliers by dense matrices, rates by differences.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from cardan.equations.constraints.constraints import rows as constraint_rows
from cardan.ir.function import Block, Function, Output
from cardan.ir.interpreter import evaluate
from cardan.runtime.verification.differences import REACH, central
from cardan.runtime.verification.flat_scene import motion_of, scene_of
from cardan.runtime.verification.newton_euler import (
    Moving,
    Scene,
    inverse_dynamics,
    mass_matrix,
    moving,
)
from cardan.runtime.verification.reference_values import reference_values
from cardan.topology.system import Cut

Array = NDArray[np.float64]
Named = tuple[tuple[str, str], float]
Values = dict[tuple[str, str], float]
CELLS = [i + j for i in "xyz" for j in "xyz"]
TWIST = [letter + axis for letter in "wv" for axis in "xyz"]
WRENCH = [letter + axis for letter in "mf" for axis in "xyz"]
STEP = 1e-3  # its eighth power is rounding


@dataclass(frozen=True)
class Place:
    """A frame: rotation, origin, angular velocity and velocity, in ground axes."""

    R: Array
    x: Array
    w: Array
    v: Array


class Judge:
    """Independent values of the named quantities of a scene, at a random state."""

    def __init__(self, equations: cd.Equations) -> None:
        self.equations, self.system = equations, equations.system
        model = cd.compile(equations)
        self.scene: Scene = scene_of(model)
        truth = reference_values(model, self.scene, 1, 5)
        self.q, self.u, self.tau = truth.q[0], truth.u[0], truth.tau[0]
        start = model._layout.start
        self.blocks = {
            "t": np.array([truth.t]),
            "q": self.q,
            "u": self.u,
            "r": truth.r[0],
            "p": model.parameters.vector,
            "tau": self.tau,
            "z": start("z"),
            "s": start("s"),
            "e": np.zeros(64),
        }
        motion = motion_of(model, truth.t, truth.r)
        self.motion = None if motion is None else np.asarray(motion).reshape(-1, 3)
        none = np.zeros(self.system.nu)
        h = inverse_dynamics(self.scene, self.q, self.u, none, self.motion)
        assert truth.f is not None
        self.drive = self.tau + truth.f[0] - h
        self.M = mass_matrix(self.scene, self.q, self.motion)
        self.loaded = any(force.frames for force in self.system.forces)
        self.parents = [body.parent for body in self.system.bodies]

    def values(self) -> Values:
        """(owner, quantity) -> value."""
        m = moving(self.scene, self.q, self.u, 0 * self.u, self.motion)
        found = dict(self._kinematic(self.q))
        if self.motion is None:
            qdot = np.array(evaluate(self.equations.function("qdot"), self.blocks)["qdot"], float)
            steps = STEP * np.concatenate([REACH, -REACH])
            later = [dict(self._kinematic(self.q + h * qdot)) for h in steps]
            for owner, name in list(found):
                several = np.array([[values[owner, name]] for values in later])
                rate = central(*np.split(several, 2))[0] / STEP
                found[owner, f"{name}_rate"] = float(rate)
        for name, value in (*self._inertias(m), *self._momenta(m), *self._balance()):
            found.setdefault(name, float(value))
        return found

    def _vector(
        self, owner: str, name: str, x: Array, axes: list[str] | str = "xyz"
    ) -> Iterator[Named]:
        for axis, value in zip(axes, np.ravel(x), strict=True):
            yield (owner, f"{name}_{axis}" if name else axis), float(value)

    # what positions and velocities say

    def _kinematic(self, q: Array) -> Iterator[Named]:
        m = moving(self.scene, q, self.u, 0 * self.u, self.motion)
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.system.joints, strict=True)):
            k, p = i + 1, body.parent + 1
            back, inner = m.rotations[k].T, m.rotations[p].T
            yield from self._vector(body.name, "omega", back @ m.omega[k])
            yield from self._vector(body.name, "v", back @ m.velocity[k])
            yield from self._vector(body.name, "alpha_parent_omega", back @ m.omega[p])
            yield from self._vector(body.name, "orientation", m.rotations[k], CELLS)
            yield from self._vector(body.name, "position", m.place[k])
            yield from self._vector(joint.name, "R", inner @ m.rotations[k], CELLS)
            yield from self._vector(joint.name, "p", inner @ (m.place[k] - m.place[p]))
            arm, w = m.place[k] - m.place[p], m.omega[p]
            turning = m.omega[k] - w
            sliding = m.velocity[k] - m.velocity[p] - np.cross(w, arm)
            relative = np.concatenate([back @ turning, back @ sliding])
            yield from self._vector(joint.name, "velocity_relative", relative, TWIST)
        for cut in self.system.cuts:
            yield from self._cut(m, cut, q)

    def _cut(self, m: Moving, cut: Cut, q: Array) -> Iterator[Named]:
        base, names = cut.base + 1, {}
        back, origin = m.rotations[base].T, m.place[base]
        P, C = (self._frame(m, number) for number in (cut.parent_frame, cut.child_frame))
        for i, sign in cut.path:
            names[f"{self.system.bodies[i].name}_"] = (m.rotations[i + 1], m.place[i + 1])
            joint, p = self.system.joints[i].name, self.parents[i] + 1
            arm, turning = C.x - m.place[i + 1], m.omega[i + 1] - m.omega[p]
            sliding = m.velocity[i + 1] - m.velocity[p]
            sliding = sliding - np.cross(m.omega[p], m.place[i + 1] - m.place[p])
            share = np.concatenate([back @ turning, back @ (sliding + np.cross(turning, arm))])
            yield from self._vector(cut.name, f"base_twist_by_{joint}", sign * share, TWIST)
            yield from self._vector(cut.name, f"arm_{joint}", back @ arm)
        names |= {"parent_": (P.R, P.x), "child_": (C.R, C.x)}
        for word, (R, x) in names.items():
            yield from self._vector(cut.name, f"{word}R", back @ R, CELLS)
            yield from self._vector(cut.name, f"{word}p", back @ (x - origin))
        yield from self._vector(cut.name, "R", P.R.T @ C.R, CELLS)
        yield from self._vector(cut.name, "p", P.R.T @ (C.x - P.x))
        yield from self._twist(cut, "", P, C, m)
        if self.motion is None:
            for speed, unit in zip(self.system.speed_names, np.eye(self.system.nu), strict=True):
                alone = moving(self.scene, q, unit, 0 * unit)
                ends = (self._frame(alone, n) for n in (cut.parent_frame, cut.child_frame))
                yield from self._twist(cut, f"_{speed}", *ends, alone)

    def _twist(self, cut: Cut, word: str, P: Place, C: Place, m: Moving) -> Iterator[Named]:
        turning, sliding = C.w - P.w, C.v - P.v - np.cross(P.w, C.x - P.x)
        for name, R in (("twist", C.R), ("base_twist", m.rotations[cut.base + 1])):
            twist = np.concatenate([R.T @ turning, R.T @ sliding])
            yield from self._vector(cut.name, f"{name}{word}", twist, TWIST)

    def _frame(self, m: Moving, number: int) -> Place:
        frame = self.system.frames[number]
        outputs = (Output("R", (3, 3), frame.rotation), Output("p", (3,), frame.position))
        blocks = (Block("p", ("",) * len(self.blocks["p"]), ("",) * len(self.blocks["p"])),)
        given = evaluate(Function("frame", self.system.graph, blocks, outputs), self.blocks)
        R, p = np.reshape(given["R"], (3, 3)).astype(float), np.array(given["p"], dtype=float)
        k = frame.body + 1
        arm = m.rotations[k] @ p
        velocity = m.velocity[k] + np.cross(m.omega[k], arm)
        return Place(m.rotations[k] @ R, m.place[k] + arm, m.omega[k], velocity)

    # inertia, and what it takes to accelerate it

    def _outboard(self, i: int) -> list[int]:
        """Body i and all that its joint carries."""
        found = [i]
        for n in range(i + 1, len(self.parents)):
            if self.parents[n] in found:
                found.append(n)
        return found

    def _inertias(self, m: Moving) -> Iterator[Named]:
        numbers = self.scene.numbers
        one = np.eye(3)
        for i, body in enumerate(self.system.bodies):
            inertia = numbers["inertia"][i]
            second = np.trace(inertia) / 2 * one - inertia
            yield (body.name, "whole_mass"), float(numbers["mass"][i])
            yield from self._vector(body.name, "first_moment", numbers["first_moment"][i])
            yield from self._vector(body.name, "origin_inertia", inertia, CELLS)
            yield from self._vector(body.name, "second_moment", second, CELLS)
            moment, tensor = np.zeros(3), np.zeros((3, 3))
            for n in self._outboard(i):
                R = m.rotations[i + 1].T @ m.rotations[n + 1]
                d = m.rotations[i + 1].T @ (m.place[n + 1] - m.place[i + 1])
                mass, h = numbers["mass"][n], R @ numbers["first_moment"][n]
                moment = moment + h + mass * d
                s = h + mass * d / 2
                shift = 2 * s @ d * one - np.outer(s, d) - np.outer(d, s)
                tensor = tensor + R @ numbers["inertia"][n] @ R.T + shift
            yield from self._vector(body.name, "composite_moment", moment)
            yield from self._vector(body.name, "composite_inertia", tensor, CELLS)

    def _momenta(self, m: Moving) -> Iterator[Named]:
        for i, body in enumerate(self.system.bodies):
            back = m.rotations[i + 1].T
            w, alpha = back @ m.omega[i + 1], back @ m.alpha[i + 1]
            yield from self._vector(body.name, "alpha", alpha)
            yield from self._vector(body.name, "a", back @ m.accel[i + 1])
            spread = skew(alpha) + skew(w) @ skew(w)
            yield from self._vector(body.name, "U", spread, CELLS)
            if not self.loaded:
                rate = self._sum(m, i, i, rates=True)
                yield from self._vector(body.name, "n", rate[:3])
                yield from self._vector(body.name, "f", rate[3:])
        for joint in self.system.joints:
            if self.motion is not None or joint.u < 0 or self.equations.system.closures:
                continue
            i = self.system.joints.index(joint)
            for k in range(joint.u, joint.u + len(joint.element.speeds)):
                unit = np.eye(self.system.nu)[k]
                alone = moving(self.scene, self.q, unit, 0 * unit)
                speed, at = self.system.speed_names[k], i
                yield from self._vector("momentum", speed, self._sum(alone, i, i), WRENCH)
                while self.parents[at] >= 0:
                    at = self.parents[at]
                    about = f"{speed}_about_{self.system.bodies[at].name}"
                    yield from self._vector("momentum", about, self._sum(alone, i, at), WRENCH)

    def _sum(self, m: Moving, i: int, at: int, rates: bool = False) -> Array:
        """Momentum of body i and all outboard about the origin of body ``at`` in its axes (6,).

        Or its rate, weight included.
        """
        numbers, total = self.scene.numbers, np.zeros(6)
        for n in self._outboard(i):
            R = m.rotations[n + 1]
            mass, h = numbers["mass"][n], R @ numbers["first_moment"][n]
            inertia, w = R @ numbers["inertia"][n] @ R.T, m.omega[n + 1]
            if rates:
                alpha, a = m.alpha[n + 1], m.accel[n + 1]
                force = mass * a + np.cross(alpha, h) + np.cross(w, np.cross(w, h))
                moment = inertia @ alpha + np.cross(w, inertia @ w) + np.cross(h, a)
            else:
                force = mass * m.velocity[n + 1] + np.cross(w, h)
                moment = inertia @ w + np.cross(h, m.velocity[n + 1])
            moment = moment + np.cross(m.place[n + 1] - m.place[at + 1], force)
            total += np.concatenate([moment, force])
        back = m.rotations[at + 1].T
        return np.concatenate([back @ total[:3], back @ total[3:]])

    # the equations of motion

    def _constraint_rates(self, t: float, q: Array, u: Array) -> Array:
        function = self.equations.function("constraint_rates")
        given = self.blocks | {"t": np.array([t]), "q": q, "u": u}
        return np.array(next(iter(evaluate(function, given).values())), dtype=float)

    def _constraints(self) -> tuple[Array, Array]:
        """G by unit speeds; gamma is what the rates lose where speeds stay."""
        t, nu = float(self.blocks["t"][0]), self.system.nu
        rest = self._constraint_rates(t, self.q, np.zeros(nu))
        columns = [self._constraint_rates(t, self.q, e) - rest for e in np.eye(nu)]
        qdot = np.array(evaluate(self.equations.function("qdot"), self.blocks)["qdot"], float)
        steps = STEP * np.concatenate([REACH, -REACH])
        later = [self._constraint_rates(t + h, self.q + h * qdot, self.u) for h in steps]
        return np.array(columns).T, -central(*np.split(np.array(later), 2)) / STEP

    def _balance(self) -> Iterator[Named]:
        speeds, nu = self.system.speed_names, self.system.nu
        for i in range(nu):
            for j in range(i + 1):
                yield ("M", f"{speeds[i]}_{speeds[j]}"), self.M[i, j]
        G, gamma, rows = np.zeros((0, nu)), np.zeros(0), []
        if self.system.closed:
            rows = [(row.owner, row.component) for row in constraint_rows(self.system)]
            G, gamma = self._constraints()
        # of redundant constraints the multipliers are those of least size
        both = np.block([[self.M, -G.T], [G, np.zeros((len(rows), len(rows)))]])
        right = np.concatenate([self.drive, gamma])
        solution = np.linalg.lstsq(both, right, rcond=1e-12)[0]
        for k, (owner, component) in enumerate(rows):
            suffix = f"_{component}" if component else ""
            yield (owner, f"gamma{suffix}"), gamma[k]
            yield (owner, f"rate{suffix}_rate"), -gamma[k]
            yield (owner, f"multiplier{suffix}"), solution[nu + k]
            yield from self._vector(owner, f"G{suffix}", G[k], list(speeds))
        for joint in self.system.joints:
            for k, speed in enumerate(joint.element.speeds if joint.u >= 0 else ()):
                suffix = f"_{speed.name}" if speed.name else ""
                slot = joint.u + k
                yield (joint.name, f"udot{suffix}"), solution[slot]
                yield (joint.name, f"drive{suffix}"), self.drive[slot]
                yield (joint.name, f"tau{suffix}"), self.tau[slot] - self.drive[slot]
        if all(np.diag(self.M)):
            names = [f"{owner}_{part}" if part else owner for owner, part in rows]
            yield from self._eliminated(G, gamma, names)

    def _eliminated(self, G: Array, gamma: Array, rows: list[str]) -> Iterator[Named]:
        """M = Lᵀ D L, and what is solved by it."""
        speeds, nu = list(self.system.speed_names), self.system.nu
        found = dict(factors("M", self.M, speeds))
        yield from found.items()
        D = np.array([found["M", f"factor_D_{speed}"] for speed in speeds])
        L = np.eye(nu)
        for k, i in zip(*np.tril_indices(nu, -1), strict=True):
            L[k, i] = found["M", f"factor_L_{speeds[k]}_{speeds[i]}"]
        sides = dict(zip(rows, G, strict=True)) | {"free": self.drive, "M": self.drive}
        for owner, side in sides.items():
            y = np.linalg.solve(L.T, side)
            yield from self._vector(owner, "y", y, speeds)
            yield from self._vector(owner, "z", y / D, speeds)
        free, answers = np.linalg.solve(self.M, self.drive), np.linalg.solve(self.M, G.T)
        yield from self._vector("free_udot", "", free, speeds)
        yield from self._vector("free_gamma", "", gamma - G @ free, rows)
        for k, row in enumerate(rows):
            yield from self._vector(row, "response", answers[:, k], speeds)
            yield from self._vector("circuit", row, (G @ answers)[k], rows)


def factors(owner: str, A: Array, rows: Sequence[str]) -> Iterator[Named]:
    """Entries of A = Lᵀ D L, and of S with L⁻¹ = 1 - S."""
    n = len(A)
    work, L = A.copy(), np.eye(n)
    for k in range(n - 1, -1, -1):
        L[k, :k] = work[k, :k] / work[k, k]
        yield (owner, f"factor_D_{rows[k]}"), work[k, k]
        yield (owner, f"factor_D_inverse_{rows[k]}"), 1 / work[k, k]
        for i in range(k):
            yield (owner, f"factor_DL_{rows[k]}_{rows[i]}"), work[k, i]
            yield (owner, f"factor_L_{rows[k]}_{rows[i]}"), L[k, i]
        work[:k, :k] -= np.outer(L[k, :k], work[k, :k])
    strict = np.eye(n) - np.linalg.inv(L)
    for k, i in zip(*np.tril_indices(n, -1), strict=True):
        yield (owner, f"factor_S_{rows[k]}_{rows[i]}"), strict[k, i]


def skew(x: Array) -> Array:
    """The matrix of x cross."""
    return np.cross(np.eye(3), x)
