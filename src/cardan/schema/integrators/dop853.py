"""Runge-Kutta method of order 8 by Dormand and Prince."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="DOP853",
    kernel="dop853",
    order=8,
    dense_order=7,
    adaptive=True,
    applies="anything that is not stiff, from rough to 14 digits",
    source="E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.10",
    lanes=True,
)
