"""A slender blade is spun up: it lags behind while the hub gains speed, and stretches at the end.

Run it anywhere; it writes into ``out/spin_up``.

Source: J. C. Simo, L. Vu-Quoc, J. Sound Vib. 119 (1987), 487-508.
"""

from pathlib import Path

import numpy as np
import sympy

import cardan as cd

out = Path("out/spin_up")
out.mkdir(parents=True, exist_ok=True)

# The hub turns by a given angle: at rest at first, 6 rad/s from t = 15 s on.
scene = cd.Scene("spin_up", gravity=(0, 0, 0))
t = cd.t
wave = (15 / (2 * sympy.pi)) ** 2 * (sympy.cos(2 * sympy.pi * t / 15) - 1)
angle = sympy.Piecewise((6 * (t**2 / 2 + wave) / 15, t < 15), (6 * t - 45, True))
hub = scene.body("hub", mass=1, inertia=(1, 1, 1), shape=cd.shape.cylinder(0.3, 0.2))
scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=angle)
section = cd.section.general(EA=2.8e7, GA=1e7, GJ=1.4e4, EI=1.4e4, rhoA=1.2, rhoI=6e-4)
blade = scene.beam("blade", hub, (10, 0, 0), section, elements=6)
for axis, name in enumerate(("along", "across")):
    seen = blade.end.position(in_=hub)[axis] - (10, 0)[axis]
    scene.output(name, seen, unit="m")
model = cd.compile(scene)

motion = model.simulate(np.linspace(0, 20, 401))
lag = motion["across"].min()
print(f"the tip lags behind by {-lag:.3f} m")
stretch = motion["along"][motion.t > 16].mean()
print(f"and is {stretch * 1000:.3f} mm farther out at full speed")
# rho A omega^2 L^3 / (3 EA), and what is left of the swinging
assert abs(stretch - 1.2 * 36 * 1000 / (3 * 2.8e7)) < 2e-5
force = motion.beam("blade").force[-1, 0, 0]
print(f"the root carries {force:.0f} N")
motion.animate(out / "spin_up.html")
