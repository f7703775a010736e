"""Formulas of elements for readers, as Python that tests evaluate.

A formula is ``left = right`` with the operators of NumPy; vectors are columns (3, 1), I and O are
the unit and the zero matrix (3, 3), and i = (1, 0, 0).
"""

from __future__ import annotations

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
