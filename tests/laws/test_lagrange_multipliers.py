"""The four-bar by Lagrange's equations with multipliers, by SymPy alone, in 40 digits.

Coordinates are the angles of the three links against the ground, as in textbooks.
"""

from __future__ import annotations

import pytest
import sympy as sp

from laws.circuits import EXACT, compiled, start
from mechanisms.closed import four_bar
from mechanisms.closed_planar import FOUR_BAR, G

DIGITS = 40


def solved(angles: list[float], rates: list[float]) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Second derivatives of the three angles, and the forces of coupler on rocker at C."""
    q, v = sp.symbols("q:3"), sp.symbols("v:3")
    scene = four_bar()
    size = {name: sp.Rational(str(FOUR_BAR[name])) for name in FOUR_BAR}
    lengths = [size["crank"], size["coupler"], size["rocker"]]
    roots = [
        sp.Matrix([0, 0]),
        lengths[0] * sp.Matrix([sp.cos(q[0]), sp.sin(q[0])]),
        sp.Matrix([size["ground"], 0]),
    ]
    kinetic, potential = sp.Integer(0), sp.Integer(0)
    for k, body in enumerate(scene.bodies.values()):
        center = roots[k] + lengths[k] / 2 * sp.Matrix([sp.cos(q[k]), sp.sin(q[k])])
        velocity = center.jacobian(q) * sp.Matrix(v)
        mass, moment = sp.Float(body.mass, DIGITS), sp.Float(body.inertia[5], DIGITS)
        kinetic += (mass * velocity.dot(velocity) + moment * v[k] ** 2) / 2
        potential += mass * sp.Float(G, DIGITS) * center[1]
    tips = [roots[k] + lengths[k] * sp.Matrix([sp.cos(q[k]), sp.sin(q[k])]) for k in (1, 2)]
    # M a + Mdot v - dT/dq + dV/dq = Gᵀ lam, G a = -Gdot v
    momenta = sp.Matrix([kinetic]).jacobian(v)
    M, jacobian = momenta.jacobian(v), (tips[1] - tips[0]).jacobian(q)
    moved = momenta.T.jacobian(q) * sp.Matrix(v) - sp.Matrix([kinetic - potential]).jacobian(q).T
    bent = (jacobian * sp.Matrix(v)).jacobian(q) * sp.Matrix(v)
    system = sp.BlockMatrix([[M, -jacobian.T], [jacobian, sp.zeros(2)]]).as_explicit()
    at = {x: sp.Float(value, DIGITS) for x, value in zip((*q, *v), (*angles, *rates), strict=True)}
    right = sp.Matrix([*(-moved), *(-bent)])
    answer = list(system.subs(at).evalf(DIGITS).LUsolve(right.subs(at).evalf(DIGITS)))
    return answer[:3], answer[3:]


@pytest.mark.parametrize("treatment", EXACT)
def test_four_bar(treatment: str) -> None:
    model = compiled("four_bar", "C", treatment)
    q, u = start(model, "four_bar", 0.3, 7.0)
    assert model.coordinates == ("A", "B", "D")
    accelerations, forces = solved([q[0], q[0] + q[1], q[2]], [u[0], u[0] + u[1], u[2]])
    udot = model.forward_dynamics(q, u)
    computed = [udot[0], udot[0] + udot[1], udot[2]]
    assert computed == pytest.approx([float(a) for a in accelerations], rel=1e-12)
    # the force of coupler on rocker, in axes of the coupler
    ground = model.pose("coupler", q)[:2, :2] @ model.multipliers(q, u)
    assert ground == pytest.approx([float(f) for f in forces], rel=1e-11)
