"""Closed mechanisms in the coordinates of all their bodies: an independent road to accelerations.

Newton's and Euler's equations of free bodies, joints as equations between their poses written
here, their Jacobian by complex steps, one linear system for accelerations and multipliers. Of the
package only what the user wrote is used: the scene.

Source: E. J. Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, chapter 11.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

import cardan as cd

Array = np.ndarray
Poses = Mapping[str, tuple[Array, Array]]
COMPLEX = 1e-30
# weights of the central difference of sixth order
DIFFERENCE = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
STEP = 1e-2


def unit(axis: Any) -> Array:
    """A direction as written."""
    if isinstance(axis, str):
        sign = -1.0 if axis.startswith("-") else 1.0
        return sign * np.eye(3)["xyz".index(axis[-1])]
    vector = np.asarray(axis, float)
    return vector / np.linalg.norm(vector)


def across(axis: Array) -> tuple[Array, Array]:
    """Two directions perpendicular to an axis and to each other."""
    first = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)


def skew(v: Array) -> Array:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


class Edge:
    """The piece of a spline that a place is next to, as cubic polynomials, and its foot there."""

    def __init__(self, kind: Any, place: Array) -> None:
        points = np.array([*kind.points, kind.points[0]] if kind.closed else kind.points, float)
        at = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        spline = CubicSpline(at, points, bc_type="periodic" if kind.closed else "not-a-knot")
        fine = np.linspace(0, at[-1], 4001)
        best = fine[np.linalg.norm(spline(fine) - place, axis=1).argmin()]
        piece = int(np.searchsorted(at, best)) - 1
        self.foot = best - at[piece]
        # powers (highest first) by component, and their derivatives
        self.orders = [
            [np.polyder(np.poly1d(c), n) for c in spline.c[:, piece].T] for n in range(3)
        ]
        self.normals = across(unit(self.at(self._next(place), 1).real))

    def at(self, s: Any, order: int) -> Array:
        return np.array([polynomial(s) for polynomial in self.orders[order]])

    def _next(self, place: Array) -> Any:
        """Newton's steps to the foot of the normal, complex ones too."""
        s = self.foot
        for _ in range(20):
            away, slope = place - self.at(s, 0), self.at(s, 1)
            s = s + (away @ slope) / (slope @ slope - away @ self.at(s, 2))
        return s

    def beside(self, place: Array) -> list[Any]:
        away = place - self.at(self._next(place), 0)
        return [away @ normal for normal in self.normals]


class Maximal:
    """A scene of rigid bodies, joints, gravity, springs and joint forces as one linear system."""

    def __init__(self, scene: cd.Scene) -> None:
        self.scene = scene
        self.bodies = list(scene.bodies.values())
        self.edges: dict[str, Edge] = {}
        self.slot = {body.name: 6 * k for k, body in enumerate(self.bodies)}

    def frame(self, poses: Poses, place: Any) -> tuple[Array, Array]:
        """R and p of a frame or body in the ground."""
        fixed = (np.eye(3), np.zeros(3))
        R, p = poses.get(place.body.name, fixed)
        if place is place.body:
            return R, p
        turn = place.orientation
        if turn is None:
            own = np.eye(3)
        elif isinstance(turn[0], str):
            own = Rotation.from_euler(turn[0], turn[1:]).as_matrix()
        else:
            own = np.asarray(turn, float)
        return R @ own, p + R @ np.asarray(place.coordinates, float)

    def residuals(self, poses: Poses) -> Array:
        """What vanishes where all joints hold together."""
        found: list[Any] = []
        for joint in self.scene.joints.values():
            kind = joint.kind
            (R_P, p_P), (R_C, p_C) = (self.frame(poses, x) for x in (joint.parent, joint.child))
            if kind.kind == "point_on_curve":
                found += self.beside(joint, R_P.T @ (p_C - p_P))
                continue
            if kind.kind == "prismatic":
                axis = unit(kind.axis)
                found += [(R_P @ b) @ (p_C - p_P) for b in across(axis)]
                x, y, z = np.eye(3)
                found += [(R_P @ a) @ (R_C @ b) for a, b in ((x, y), (y, z), (z, x))]
                continue
            found += list(p_C - p_P)
            if kind.kind in ("revolute", "gear"):
                axis = unit(kind.axis)
                found += [(R_P @ b) @ (R_C @ axis) for b in across(axis)]
                if kind.kind == "gear":
                    found.append(self.mesh(poses, joint))
            elif kind.kind == "universal":
                found.append((R_P @ unit(kind.axis1)) @ (R_C @ unit(kind.axis2)))
            else:
                assert kind.kind == "spherical"
        return np.array(found)

    def mesh(self, poses: Poses, wheel: Any) -> Any:
        """Sine of what is missing from the angle of a wheel that turns against another."""
        lead = self.scene.joints[wheel.kind.leader]
        assert wheel.kind.ratio == -1
        c, s = math.cos(wheel.kind.offset), math.sin(wheel.kind.offset)
        x, y = across(unit("z"))
        for joint in (lead, wheel):
            assert np.array_equal(unit(joint.kind.axis), unit("z"))
            turned = [self.frame(poses, end)[0] for end in (joint.parent, joint.child)]
            cosine, sine = ((turned[0] @ b) @ (turned[1] @ x) for b in (x, y))
            c, s = c * cosine + s * sine, s * cosine - c * sine
        return s

    def beside(self, joint: Any, place: Array) -> list[Any]:
        """How far a place is off a curve, in two directions across it where it is next."""
        edge = self.edges.get(joint.name)
        if edge is None:
            edge = self.edges[joint.name] = Edge(joint.kind, place.real)
        return edge.beside(place)

    def moved(self, poses: Poses, twists: Array) -> dict[str, tuple[Array, Array]]:
        """Poses after twists (6 n): angular in ground axes, velocity of the center of mass."""
        found = {}
        for body in self.bodies:
            w, v = np.split(twists[self.slot[body.name] : self.slot[body.name] + 6], 2)
            R, p = poses[body.name]
            c = np.asarray(body.com, float)
            # Cayley's map: exact in the first two orders, which is all that is differentiated
            W = skew(w / 2)
            turn = np.linalg.solve(np.eye(3) - W, np.eye(3) + W)
            found[body.name] = turn @ R, p + R @ c + v - turn @ (R @ c)
        return found

    def jacobian(self, poses: Poses) -> Array:
        """Of the residuals along the twists (m, 6 n)."""
        columns = []
        for k in range(6 * len(self.bodies)):
            step = np.zeros(6 * len(self.bodies), complex)
            step[k] = 1j * COMPLEX
            columns.append(self.residuals(self.moved(poses, step)).imag / COMPLEX)
        return np.stack(columns, axis=1)

    def bent(self, poses: Poses, twists: Array) -> Array:
        """Second derivative of the residuals along a motion with constant twists (m)."""

        def rate(t: float) -> Array:
            step = twists * (t + 1j * COMPLEX)
            return self.residuals(self.moved(poses, step)).imag / COMPLEX

        return sum(w * (rate(k * STEP) - rate(-k * STEP)) for k, w in DIFFERENCE.items()) / STEP

    def loads(self, poses: Poses, twists: Array) -> tuple[Array, Array]:
        """Mass matrix (6 n, 6 n) and what it is balanced by (6 n), gravity included."""
        n = 6 * len(self.bodies)
        mass, load = np.zeros((n, n)), np.zeros(n)
        for body in self.bodies:
            at = slice(self.slot[body.name], self.slot[body.name] + 3)
            by = slice(at.stop, at.stop + 3)
            R, w = poses[body.name][0], twists[at]
            xx, xy, xz, yy, yz, zz = map(float, body.inertia)
            J = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
            mass[at, at], mass[by, by] = J, float(body.mass) * np.eye(3)
            load[at] = -np.cross(w, J @ w)
            load[by] = float(body.mass) * np.asarray(self.scene.gravity, float)
        for force in self.scene.forces.values():
            self._add(load, force.element, poses)
        return mass, load

    def _add(self, load: Array, element: Any, poses: Poses) -> None:
        if element.kind == "spring_damper":
            a, b = element.frame_a, element.frame_b
            p_a, p_b = (self.frame(poses, x)[1] for x in (a, b))
            length = np.linalg.norm(p_b - p_a)
            assert element.damping == 0
            pull = element.stiffness * (length - element.rest_length) * (p_b - p_a) / length
            for place, point, force in ((a, p_a, pull), (b, p_b, -pull)):
                self.push(load, place, poses, np.zeros(3), point, force)
            return
        assert element.kind == "joint_force"
        joint = self.scene.joints[element.joint]
        assert joint.kind.kind == "revolute"
        R, point = self.frame(poses, joint.parent)
        moment = R @ unit(joint.kind.axis) * element.force
        self.push(load, joint.parent, poses, -moment, point, np.zeros(3))
        self.push(load, joint.child, poses, moment, point, np.zeros(3))

    def push(
        self, load: Array, place: Any, poses: Poses, moment: Array, point: Array, force: Array
    ) -> None:
        body = place.body
        if body.name not in self.slot:
            return
        R, p = poses[body.name]
        k, center = self.slot[body.name], p + R @ np.asarray(body.com, float)
        load[k : k + 3] += moment + np.cross(point - center, force)
        load[k + 3 : k + 6] += force

    def accelerations(self, poses: Poses, twists: Array) -> dict[str, Array]:
        """Angular and linear acceleration of the center of mass (6,) by body, in ground axes.

        Args:
            poses: R (3, 3) and p (3) of every body, on the constraints.
            twists: Of every body (6 n), angular first; of the center of mass.
        """
        self.edges.clear()
        G = self.jacobian(poses)
        mass, load = self.loads(poses, twists)
        # redundant rows and needles without inertia about their axis: least squares, scaled
        scale = np.abs(mass).max()
        system = np.block([[mass / scale, G.T], [G, np.zeros((len(G), len(G)))]])
        right = np.concatenate([load / scale, -self.bent(poses, twists)])
        solution = np.linalg.lstsq(system, right, rcond=1e-13)[0]
        assert np.abs(system @ solution - right).max() < 1e-9 * max(1.0, np.abs(right).max())
        return {body.name: solution[self.slot[body.name] :][:6] for body in self.bodies}

    def centers(self, poses: Poses) -> dict[str, Array]:
        """Center of mass of every body from its origin (3), in ground axes."""
        return {
            body.name: poses[body.name][0] @ np.asarray(body.com, float) for body in self.bodies
        }

    def origins(
        self, poses: Poses, twists: Array, of_centers: Mapping[str, Array]
    ) -> dict[str, Array]:
        """Accelerations (6,) of the origins of the bodies from those of their centers of mass."""
        found = {}
        for name, back in self.centers(poses).items():
            angular, linear = np.split(of_centers[name], 2)
            w = twists[self.slot[name] :][:3]
            turned = np.cross(angular, -back) + np.cross(w, np.cross(w, -back))
            found[name] = np.concatenate([angular, linear + turned])
        return found
