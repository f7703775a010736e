"""RK4 as a Lie group method of Munthe-Kaas: quaternions by their increments."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="RKMK4",
    kernel="rk4",
    order=4,
    dense_order=3,
    adaptive=False,
    charted=True,
    applies="as RK4, for spins that are steady in body axes: those are exact",
    source="H. Munthe-Kaas, Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999) 115",
)
