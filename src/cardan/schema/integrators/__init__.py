"""The integrators: one record here and one C file in ``kernels`` each; all lists of them follow."""

from __future__ import annotations

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
from .integrator import Integrator

MEMBERS = (
    *(dop853, rk45, rk4, rkmk853, rkmk45, rkmk4),
    *(radau, rosenbrock, generalized_alpha, hht, newmark, midpoint, energy_momentum),
)
INTEGRATORS: dict[str, Integrator] = {member.METHOD.name: member.METHOD for member in MEMBERS}
# one of those that have the same C
KERNELS: dict[str, Integrator] = {m.kernel: m for m in reversed(INTEGRATORS.values())}

__all__ = ["INTEGRATORS", "KERNELS", "Integrator"]
