"""The integrators: one record here and one C file in ``kernels`` each."""

from __future__ import annotations

from ..integrator import Integrator
from . import (
    dop853,
    energy_momentum,
    generalized_alpha,
    hht,
    midpoint,
    newmark,
    radau,
    rk4,
    rk45,
    rkmk4,
    rkmk45,
    rkmk853,
    rosenbrock,
)

EXPLICIT = (dop853, rk45, rk4, rkmk853, rkmk45, rkmk4)
IMPLICIT = (radau, rosenbrock, generalized_alpha, hht, newmark, midpoint, energy_momentum)
INTEGRATORS: dict[str, Integrator] = {m.METHOD.name: m.METHOD for m in (*EXPLICIT, *IMPLICIT)}

__all__ = ["INTEGRATORS", "Integrator"]
