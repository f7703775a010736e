"""RK45 as a Lie group method of Munthe-Kaas: quaternions by their increments."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="RKMK45",
    kernel="rk45",
    order=5,
    dense_order=4,
    adaptive=True,
    charted=True,
    applies="as RK45, for spins that are steady in body axes: those are exact",
    source="H. Munthe-Kaas, Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999) 115",
)
