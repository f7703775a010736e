"""The energy-momentum method for systems of elements."""

from __future__ import annotations

from .integrator import Integrator

METHOD = Integrator(
    name="EnergyMomentum",
    kernel="conserving",
    order=2,
    dense_order=2,
    adaptive=False,
    applies="very many steps of conservative systems in absolute coordinates: energy and momenta",
    source="J. C. Simo, K. K. Wong, Int. J. Numer. Meth. Eng. 31 (1991) 19-52; O. Gonzalez, "
    "J. Nonlinear Sci. 6 (1996) 449-467",
    needs=("balance", "energy", "move", "qdot"),
    multipliers=True,
    conditions=("in_elements", "nothing_discrete", "conservative"),
    elements=True,
)
