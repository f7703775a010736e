"""Rosenbrock method Rodas5P."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="Rosenbrock",
    kernel="rosenbrock",
    order=5,
    dense_order=4,
    adaptive=True,
    applies="stiff springs, dampers and contacts, from rough to some nine digits",
    source="G. Steinebach, BIT Numerical Mathematics 63 (2023), 27 (Rodas5P)",
    needs=("rhs_jacobian",),
    differenced=("rhs_jacobian",),
    conditions=("assembled",),
)
