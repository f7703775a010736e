"""Formulas of elements for readers, as Python that tests evaluate.

A formula is ``left = right`` with the operators of NumPy; vectors are columns (3, 1), I and O are
the unit and the zero matrix (3, 3), and i = (1, 0, 0).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

# (what it is, formula), in the order in which one needs the other
Lines: TypeAlias = tuple[tuple[str, str], ...]

RIGID: Lines = (
    ("moment about the origin of the body, in its axes: c first moment, J inertia about the origin",
     "b_m = J @ omegadot + skew(omega) @ J @ omega + skew(c) @ R.T @ (vdot - g)"),
    ("force in ground axes",
     "b_f = m * (vdot - g) + R @ (skew(omegadot) @ c + skew(omega) @ skew(omega) @ c)"),
    ("balance M a + h", "b = column(b_m, b_f)"),
    ("kinetic energy", "T = m * dot(v, v) / 2 + dot(v, R @ skew(omega) @ c)"
     " + dot(omega, J @ omega) / 2"),
    ("potential energy", "V = -dot(g, m * p + R @ c)"),
)  # fmt: skip
MULTIPLIERS: Lines = (
    ("balance: forces of the multipliers lam, along the rows of g", "b = -(G.T @ lam)"),
)

# the strain of two ends that is of neither of them
HALFWAY: Lines = (
    ("axes halfway between the ends: coefficients of U", "beta_1 = -(sin(sqrt(x) / 2) / sqrt(x))"),
    ("", "beta_2 = (1 - cos(sqrt(x) / 2)) / x"),
    ("their derivatives by x",
     "kappa_1 = sin(sqrt(x) / 2) / (2 * x * sqrt(x)) - cos(sqrt(x) / 2) / (4 * x)"),
    ("", "kappa_2 = sin(sqrt(x) / 2) / (4 * x * sqrt(x)) - (1 - cos(sqrt(x) / 2)) / x ** 2"),
)  # fmt: skip
MEASURES: Lines = (
    ("from axes of end 1 to those of the strain",
     "U = I + beta_1 * skew(theta) + beta_2 * skew(theta) @ skew(theta)"),
    ("length and shear of the element", "e = U @ d"),
)  # fmt: skip

# how the strain changes with the relative pose
TANGENT: Lines = (
    ("derivative of theta by the relative rotation",
     "D = I + skew(theta) / 2 + a * skew(theta) @ skew(theta)"),
    ("derivative of e by theta",
     "N = beta_2 * (dot(theta, d) * I + theta * d.T - 2 * d * theta.T)"
     " + 2 * (kappa_1 * skew(theta) @ d + kappa_2 * skew(theta) @ skew(theta) @ d) * theta.T"
     " - beta_1 * skew(d)"),
)  # fmt: skip

# of what formulas read beside numbers and vectors and rotations of ends: rows and columns, or a
# kind of matrix and its size
Shape: TypeAlias = "tuple[int | str, int]"
Shapes: TypeAlias = "Mapping[str, Shape]"
RIGID_SHAPES: Shapes = {"c": (3, 1), "J": ("symmetric", 3)}
