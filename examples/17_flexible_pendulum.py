"""A bar of rubber falls from the horizontal and whips around its pin.

Run it anywhere; it writes into ``out/pendulum``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/pendulum")
out.mkdir(parents=True, exist_ok=True)

scene = cd.Scene("flexible_pendulum")
rubber = cd.material(E=5e6, nu=0.45, rho=1100)
bar = scene.beam("bar", (0, 0, 0), (1, 0, 0), cd.section.rectangle(0.02, 0.02), rubber, elements=10)
scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
equations = cd.derive(scene)
model = cd.compile(equations)

# Modes about hanging straight down: the first is nearly that of a rigid bar.
hanging = model.equilibrium(q={"pin": np.pi / 2})
modes = model.modes(3, hanging)
print(modes)
rigid = np.sqrt(1.5 * 9.81) / (2 * np.pi)
print(f"a rigid bar swings at {rigid:.3f} Hz")

# The fall, without any damping but that of the method, which is small.
motion = model.simulate(np.linspace(0, 2, 201))
print(motion)
energy = motion.energy.total
moved = np.ptp(motion.energy.potential)
print(f"energy lost to the method: {(energy[0] - energy[-1]) / moved:.1e} of what went around")
assert abs(energy[-1] - energy[0]) < 1e-4 * moved
bend = np.abs(motion.beam("bar").curvature[..., 1]).max()
print(f"bent to a radius of {1 / bend:.2f} m at least")
motion.animate(out / "pendulum.html")

# The same as C that needs neither Python nor cardan: elements, tables, sparse solver, integrator.
folder = equations.export(out / "c", integrators=("alpha",))
print((folder / "example.c").read_text("utf-8").splitlines()[0])
