"""The integrators: one record here and one C file in ``kernels`` each."""

from __future__ import annotations

from ..integrator import Integrator
from . import dop853, generalized_alpha, hht, newmark, radau, rk4, rosenbrock

INTEGRATORS: dict[str, Integrator] = {
    m.METHOD.name: m.METHOD
    for m in (dop853, rk4, radau, rosenbrock, generalized_alpha, hht, newmark)
}

__all__ = ["INTEGRATORS", "Integrator"]
