"""Radau IIA method of order 5."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="Radau",
    kernel="radau",
    order=5,
    dense_order=3,
    adaptive=True,
    applies="stiff springs, dampers and contacts, to many digits",
    source="E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8",
    needs=("rhs_jacobian",),
    differenced=("rhs_jacobian",),
)
