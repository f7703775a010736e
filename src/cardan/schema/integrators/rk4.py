"""The classical Runge-Kutta method."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="RK4",
    kernel="rk4",
    order=4,
    dense_order=3,
    adaptive=False,
    applies="a fixed step: the same cost per second always, such as beside hardware",
    source="E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.1",
    tableau=((), (0.5,), (0.0, 0.5), (0.0, 0.0, 1.0), (1 / 6, 1 / 3, 1 / 3, 1 / 6)),
)
