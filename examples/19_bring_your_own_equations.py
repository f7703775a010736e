"""Bring your own equations: what SymPy's mechanics package derived is compiled and analysed.

Run it anywhere; it writes into ``out/own_equations``.
"""

from pathlib import Path

import numpy as np
import sympy as sm
from scipy.linalg import solve_continuous_are
from sympy.physics import mechanics as me

import cardan as cd

out = Path("out/own_equations")
out.mkdir(parents=True, exist_ok=True)

# Two rods on a cart that a force F pushes, as SymPy's users write it; angles from upright.
x, q1, q2 = q = me.dynamicsymbols("x q1 q2")
v, u1, u2 = u = me.dynamicsymbols("v u1 u2")
F = me.dynamicsymbols("F")
m_cart, m, length, g = sm.symbols("m_cart m l g")

ground, origin = me.ReferenceFrame("N"), me.Point("O")
origin.set_vel(ground, 0)
cart = origin.locatenew("C", x * ground.x)
cart.set_vel(ground, v * ground.x)
bodies, loads, hinge = [me.Particle("cart", cart, m_cart)], [(cart, F * ground.x)], cart
for name, angle, speed in (("lower", q1, u1), ("upper", q2, u2)):
    rod = ground.orientnew(name, "Axis", [angle, ground.z])
    rod.set_ang_vel(ground, speed * ground.z)
    center = hinge.locatenew(f"{name}_center", length / 2 * rod.y)
    tip = hinge.locatenew(f"{name}_tip", length * rod.y)
    for point in (center, tip):
        point.v2pt_theory(hinge, ground, rod)
    inertia = me.inertia(rod, 0, 0, m * length**2 / 12)
    bodies.append(me.RigidBody(name, center, rod, m, (inertia, center)))
    loads.append((center, -m * g * ground.y))
    hinge = tip

kane = me.KanesMethod(ground, q, u, [a.diff() - b for a, b in zip(q, u, strict=True)])
kane.kanes_equations(bodies, loads)

# From here on it is a model like any other. Symbols become parameters, F an input; what is to be
# seen is an output, and a potential gives the energy, which only bodies would tell by themselves.
scene = cd.from_sympy(
    kane,
    parameters={m_cart: 2.0, m: 0.5, length: 0.8, g: 9.81},
    outputs={"tip": hinge.pos_from(origin).dot(ground.x)},
    potential=m * g * length * (sm.cos(q1) * sm.Rational(3, 2) + sm.cos(q2) / 2),
    name="own_equations",
)
model = cd.compile(scene)

# Falling freely: the compiled equations are judged by SymPy's numbers, the run by its energy.
free = model.simulate(3.0, q={"q1": 0.2}, rtol=1e-9)
print(free)
print(model.verify())
assert np.abs(free.energy_residual).max() < 1e-6

# Upright it falls; a linear-quadratic regulator of the linearized equations holds it.
upright = model.linearize(q=dict.fromkeys(("x", "q1", "q2"), 0.0))
print("upright:", np.round(np.sort(upright.eigenvalues.real), 3))
weights = np.diag([1.0, 10.0, 10.0, 1.0, 1.0, 1.0])
P = solve_continuous_are(upright.A, upright.B, weights, np.eye(1))
gains = upright.B.T @ P
held = model.simulate(
    20.0, q={"q1": 0.15, "q2": -0.05}, inputs={"F": lambda t, state: (-gains @ state)[0]}
)
print(f"held: tip from {held['tip'][0]:.3f} m to {held['tip'][-1]:.4f} m")
print(f"      force up to {np.abs(held['F']).max():.1f} N")
assert abs(held["tip"][-1]) < 1e-2

# Many falls at once, and C for elsewhere.
angles = np.linspace(0.01, 0.3, 64)
falls = model.ensemble(2.0, q={"q1": angles})
print(falls)
print("exported to", cd.derive(scene).export(out / "c"))
