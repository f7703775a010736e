"""Runge-Kutta method of order 5 by Dormand and Prince."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="RK45",
    kernel="rk45",
    order=5,
    dense_order=4,
    adaptive=True,
    applies="many short segments, such as between samples: half the cost of a step",
    source="J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26",
    lanes=True,
)
