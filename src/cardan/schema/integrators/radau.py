"""Radau IIA method of order 5."""

from __future__ import annotations

from .integrator import Integrator

ROOT = 6**0.5
LAST = ((16 - ROOT) / 36, (16 + ROOT) / 36, 1 / 9)

METHOD = Integrator(
    name="Radau",
    kernel="radau",
    order=5,
    dense_order=3,
    adaptive=True,
    applies="stiff springs, dampers and contacts, beams, to many digits",
    source="E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8 "
    "and VII.4 to VII.7",
    needs=("rhs_jacobian",),
    differenced=("rhs_jacobian",),
    conditions=("assembled", "increments"),
    tableau=(
        ((88 - 7 * ROOT) / 360, (296 - 169 * ROOT) / 1800, (3 * ROOT - 2) / 225),
        ((296 + 169 * ROOT) / 1800, (88 + 7 * ROOT) / 360, -(3 * ROOT + 2) / 225),
        LAST,
        LAST,
    ),
)
