"""A slider-crank at 1430 revolutions per minute whose rod bends.

Run it anywhere; it writes into ``out/slider_crank``.

Source: B. Simeon, Math. Modelling of Systems 2 (1996), 1-18 (the mechanism).
"""

from pathlib import Path

import numpy as np
import sympy

import cardan as cd

out = Path("out/slider_crank")
out.mkdir(parents=True, exist_ok=True)

# A rigid crank that is driven up to 150 rad/s, an elastic rod with pins at both ends, a slider.
scene = cd.Scene("flexible_slider_crank", gravity=(0, 0, 0))
crank = scene.body("crank", mass=0.36, com=(0.075, 0, 0), inertia=(0, 0.002727, 0.002727))
slider = scene.body("slider", mass=0.075552, pose=(0.45, 0, 0))
angle = sympy.Piecewise((750 * cd.t**2, cd.t < 0.1), (150 * cd.t - 7.5, True))
scene.joint("drive", cd.Revolute("z"), scene.ground, crank, prescribed=angle)
scene.joint("guide", cd.Prismatic("x"), scene.ground, slider)
steel = cd.material(E=2e11, nu=0.3, rho=7870, damping=1e-5)
rod = scene.beam(
    "rod",
    crank.at(0.15, 0, 0),
    slider,
    cd.section.rectangle(0.008, 0.008),
    steel,
    elements=4,
    release_start="rz",
    release_end="rz",
)
model = cd.compile(scene)

# Up to speed in a tenth of a second. Beams are stiff: by default they run with Radau.
motion = model.simulate(0.16)
print(motion)

# How far the middle of the rod leaves the straight line between its pins.
line = motion.line("rod")
start, middle, end = line[:, 0], line[:, line.shape[1] // 2], line[:, -1]
along = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
beside = middle - start
bow = along[:, 0] * beside[:, 1] - along[:, 1] * beside[:, 0]
print(f"the rod bows out by up to {np.abs(bow).max() * 1000:.2f} mm")
stress = motion.beam("rod").extreme.max()
print(f"and carries {stress / 1e6:.0f} MPa at most")
assert 1e-3 < np.abs(bow).max() < 6e-3
motion.animate(out / "slider_crank.html")
