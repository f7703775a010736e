"""The implicit midpoint rule on which the energy balance is imposed."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="EnergyMidpoint",
    kernel="midpoint",
    order=2,
    dense_order=2,
    adaptive=False,
    charted=True,
    needs=("energy",),
    applies="very many long steps whose energy balance must hold",
    source="O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449-467",
    tableau=((0.5,), (1.0,)),
)
