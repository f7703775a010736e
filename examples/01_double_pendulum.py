"""A double pendulum: from a scene to its equations, to C, to a motion.

Run it anywhere; it writes into ``out/double_pendulum``.
"""

from pathlib import Path

import cardan as cd

out = Path("out/double_pendulum")
out.mkdir(parents=True, exist_ok=True)

# A scene has bodies and joints. Parameters are SymPy symbols with a value; units are converted.
scene = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
m = scene.parameter("m", 1.0, unit="kg")
l = scene.parameter("l", 500, unit="mm")

# A body has its center of mass and inertia in its own axes. A uniform rod hangs along -z.
rod = {"mass": m, "com": (0, 0, -l / 2), "inertia": cd.inertia.rod(m, l, axis="z")}
upper = scene.body("upper", **rod)
lower = scene.body("lower", **rod)

# A joint holds a frame of its child to a frame of its parent.
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -l), lower)

# The equations can be read: M udot + h = f + tau, with u the rates of the angles.
equations = cd.derive(scene)
print(equations)
print("M =", equations.mass_matrix)

# Compiled, they are functions of arrays; leading axes are a batch.
model = cd.compile(equations)
print("udot at rest, bent:", model.forward_dynamics([0.5, 1.0], [0.0, 0.0]))

# The compiled functions drive a compiled integrator.
motion = model.simulate(10.0, q={"shoulder": 1.0}, rtol=1e-10, atol=1e-12)
print(motion)
energy = motion.energy.total
print(f"energy residual {abs(energy - energy[0]).max():.1e} J")

# New numbers need no new compilation.
longer = model.with_parameters(l=0.7)
print("udot with longer rods:", longer.forward_dynamics([0.5, 1.0], [0.0, 0.0]))

# A page that plays in any browser, and the numbers.
motion.animate(out / "motion.html")
motion.save(out / "motion.nc")
