"""A solar array unfolds from a satellite: panels kept in step by cables, a spring, a damper.

Run it anywhere; it writes into ``out/solar_array``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/solar_array")
out.mkdir(parents=True, exist_ok=True)
PANELS, LENGTH = 4, 1.6

# Panels hang on each other in a zigzag; nothing holds the satellite.
scene = cd.Scene("solar_array", gravity=(0, 0, 0))
hub = scene.body("hub", mass=400.0, inertia=(120.0, 150.0, 120.0))
scene.joint("drift", cd.Free(), scene.ground, hub)
place = hub.at(0.8, 0, 0)
for k in range(PANELS):
    plate = cd.inertia.box(9.0, LENGTH, 2.2, 0.03)
    panel = scene.body(
        f"panel{k}",
        mass=9.0,
        com=(LENGTH / 2, 0, 0),
        inertia=plate,
        shape=cd.shape.box(LENGTH, 2.2, 0.03, position=(LENGTH / 2, 0, 0)),
    )
    scene.joint(f"hinge{k}", cd.Revolute("y"), place, panel)
    place = panel.at(LENGTH, 0, 0)

# Cables over pulleys: every hinge opens twice as far as the first, to alternating sides.
for k in range(1, PANELS):
    step = scene.q(f"hinge{k}") - 2 * (-1) ** k * scene.q("hinge0")
    scene.constraint(f"cable{k}", step)

# A spring at the first hinge opens the array, an eddy current brake slows it down.
scene.force("spring", cd.JointSpring("hinge0", stiffness=6.0, damping=25.0))

equations = cd.derive(scene)
print(equations)
model = cd.compile(equations)

# Folded is a quarter turn at the first hinge; the other angles are assembled.
motion = model.simulate(60.0, q={"hinge0": -np.pi / 2}, rtol=1e-8)
print(motion)
open_to = 1 - motion["hinge0"] / motion["hinge0"][0]
print(f"90 % open after {np.interp(0.9, open_to, motion.t):.1f} s")

# The satellite turns against the array: no momentum comes from anywhere.
w, _, y, _ = motion["drift"][:, :4].T
turned = 2 * np.degrees(np.arctan2(y, w))
momentum = model.momentum(motion.q, motion.u)
print(f"the hub turns by up to {np.abs(turned).max():.2f} degrees")
print(f"momentum gained: {np.abs(momentum).max():.1e}")
assert np.abs(momentum).max() < 1e-5

# What the cables carry, as moments about their hinges.
lam = model.multipliers(motion.q, motion.u)
for name, values in zip(model.multipliers_of, lam.T, strict=True):
    print(f"{name} carries up to {np.abs(values).max():.2f} N m")
motion.animate(out / "solar_array.html")
