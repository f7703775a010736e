"""Lagrange's equations from poses, by SymPy alone: an independent road to the accelerations.

A system here is a list of rigid bodies, each with the rotation matrix and the position of its
center of mass as SymPy expressions in the coordinates. Nothing of the package is used.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp


@dataclass(frozen=True)
class Rigid:
    """A rigid body: mass, inertia tensor about its center of mass in body axes, and its pose."""

    mass: Any
    inertia: sp.Matrix
    rotation: sp.Matrix
    position: sp.Matrix


def turn(axis: Sequence[float] | str, angle: sp.Expr) -> sp.Matrix:
    """Rotation matrix about an axis (Rodrigues' formula)."""
    unit = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}.get(str(axis), axis)
    n = sp.Matrix(unit) / sp.sqrt(sum(x * x for x in unit))
    cross = sp.Matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return sp.eye(3) + sp.sin(angle) * cross + (1 - sp.cos(angle)) * cross * cross


def rates(bodies: Sequence[Rigid], q: sp.Matrix, qdot: sp.Matrix) -> list[tuple]:
    """(velocity of the center of mass, angular velocity in body axes) of every body."""
    found = []
    for body in bodies:
        velocity = body.position.jacobian(q) * qdot
        change = sum((body.rotation.diff(x) * v for x, v in zip(q, qdot, strict=True)), sp.zeros(3))
        spin = body.rotation.T * change
        found.append((velocity, sp.Matrix([spin[2, 1], spin[0, 2], spin[1, 0]])))
    return found


class Lagrangian:
    """Numeric functions of Lagrange's equations: M(q) qddot = Q - d(p)/dq qdot + dL/dq."""

    def __init__(
        self,
        q: Sequence[sp.Symbol],
        bodies: Sequence[Rigid],
        gravity: Sequence[float],
        potential: sp.Expr | int = 0,
    ) -> None:
        coordinates = sp.Matrix(q)
        qdot = sp.Matrix([sp.Symbol(f"{x.name}_dot") for x in q])
        kinetic = sp.Integer(0)
        for body, (velocity, omega) in zip(bodies, rates(bodies, coordinates, qdot), strict=True):
            turning = (omega.T * body.inertia * omega)[0]
            kinetic += (body.mass * velocity.dot(velocity) + turning) / 2
            potential -= body.mass * sp.Matrix(gravity).dot(body.position)
        momenta = sp.Matrix([kinetic]).jacobian(qdot)
        right = sp.Matrix([kinetic - potential]).jacobian(coordinates).T
        right -= momenta.T.jacobian(coordinates) * qdot
        arguments = [list(q), list(qdot)]
        self.mass: Callable[..., np.ndarray] = self._numeric(arguments, momenta.jacobian(qdot))
        self.right: Callable[..., np.ndarray] = self._numeric(arguments, right)
        self.energy: Callable[..., Any] = sp.lambdify(arguments, (kinetic, potential), cse=True)

    @staticmethod
    def _numeric(arguments: list, matrix: sp.Matrix) -> Callable[..., np.ndarray]:
        function = sp.lambdify(arguments, matrix, "numpy", cse=True)
        return lambda q, qdot: np.asarray(function(q, qdot), dtype=float)

    def accelerations(self, q: Sequence[float], qdot: Sequence[float]) -> np.ndarray:
        """Second derivatives of the coordinates (n) without applied forces."""
        return np.linalg.solve(self.mass(q, qdot), self.right(q, qdot).ravel())
