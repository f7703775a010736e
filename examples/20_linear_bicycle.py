"""The linear bicycle as formulas: M, C1, K0 and K2 with the speed as a symbol.

The scene is ``cd.examples["bicycle"]``, with two wheels that roll without sliding. Nothing is
compiled until the end, where the nonlinear bicycle is asked for the same. Run it anywhere; it
writes into ``out/linear_bicycle``.
"""

from pathlib import Path

import numpy as np
import sympy as sp

import cardan as cd

out = Path("out/linear_bicycle")
out.mkdir(parents=True, exist_ok=True)

scene = cd.examples["bicycle"]
equations = cd.derive(scene)
v = sp.Symbol("v")

# Straight ahead at v: the wheels, the hubs and the forces at the contacts follow.
straight = equations.linearize(u={"rear_contact.x": v})
print("a motion by itself:", not straight.needed)

# Eight speeds, five of them bound; forward motion does not know of lean and steer.
bicycle = straight.second_order(["rear_contact.lean", "steer"])
M, C1 = bicycle.M, bicycle.damping / v
K2 = bicycle.K.diff(v, 2) / 2
K0 = sp.simplify((bicycle.K - v**2 * K2) / -sp.Symbol("gravity.z"))
print("mass times height of the whole bicycle:", -K0[0, 0])

# The same in numbers, and eigenvalues over the speed: weave becomes stable, capsize unstable.
values = {sp.Symbol(p.name): p.value for p in equations.system.parameters}
lines = [f"{name} = {np.array(matrix.subs(values), dtype=float).tolist()}" for name, matrix in
         (("M", M), ("C1", C1), ("K0", K0), ("K2", K2))]  # fmt: skip
print("\n".join(lines))
(out / "matrices.txt").write_text("\n".join([*lines, str(bicycle)]), encoding="utf-8")
speeds = np.linspace(0.5, 10, 200)
numbers = bicycle.at(v=speeds)
A = np.zeros((len(speeds), 4, 4))
A[:, :2, 2:] = np.eye(2)
A[:, 2:, :2] = -np.linalg.solve(numbers["M"], numbers["K"])
A[:, 2:, 2:] = -np.linalg.solve(numbers["M"], numbers["damping"])
stable = speeds[np.linalg.eigvals(A).real.max(axis=1) < 0]
print(f"stable from {stable[0]:.2f} to {stable[-1]:.2f} m/s")
assert 4.25 < stable[0] < 4.35
assert 5.95 < stable[-1] < 6.05

# The compiled bicycle at 5 m/s has the same eigenvalues.
wheels = {"rear_contact": (5, 0, 0, 0, 5 / 0.3), "rear_hub": -5 / 0.3, "front_hub": 5 / 0.35}
model = cd.compile(equations)
ours = np.linalg.eigvals(straight.at(v=5.0)["A"])
theirs = model.linearize(q={}, u=wheels).eigenvalues
weave = [max(values, key=lambda x: x.imag) for values in (ours, theirs)]
print("weave at 5 m/s:", np.round(weave, 10))
assert abs(weave[0] - weave[1]) < 1e-9
