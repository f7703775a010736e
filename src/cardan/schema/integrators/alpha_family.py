"""Common data of the methods of the generalized-alpha family."""

from __future__ import annotations

from .integrator import Integrator

# behind the coefficients am, af, beta, gamma: constraints hold for positions and velocities, and a
# tangent serves as many corrections and steps as it can
STABILIZED, MODIFIED = 2.0, 0.0

FAMILY = Integrator(
    name="",
    kernel="alpha",
    order=2,
    dense_order=3,
    adaptive=True,
    applies="constraints, stiff forces at moderate accuracy; damps what steps do not resolve",
    source="J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993); M. Arnold, O. Brüls, "
    "A. Cardona, Numer. Math. 129 (2015)",
    needs=("balance", "balance_tangent", "internal_rates", "move", "qdot"),
    differenced=("balance_tangent",),
    multipliers=True,
    fixed_step_on_request=True,
    conditions=("assembled", "joint_speeds", "own_constraints", "damped"),
)
