"""DOP853 as a Lie group method of Munthe-Kaas: quaternions by their increments."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="RKMK853",
    kernel="dop853",
    order=8,
    dense_order=7,
    adaptive=True,
    charted=True,
    applies="as DOP853, for spins that are steady in body axes: those are exact",
    source="H. Munthe-Kaas, Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999) 115",
)
