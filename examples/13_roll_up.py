"""A strip of steel is rolled up to a ring by a moment at its end.

Run it anywhere; it writes into ``out/roll_up``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/roll_up")
out.mkdir(parents=True, exist_ok=True)
LENGTH = 1.0

# A strip of 20 mm by 0.5 mm, clamped at the left; M turns its other end about y.
scene = cd.Scene("roll_up", gravity=(0, 0, 0))
M = scene.parameter("M", 0.0, unit="N*m")
steel = cd.material(E=2.1e11, nu=0.3, rho=7850)
strip = cd.section.rectangle(0.02, 0.0005)
beam = scene.beam("strip", scene.ground, (LENGTH, 0, 0), strip, steel, elements=6)
scene.force("turn", cd.Torque(beam.end, (0, -M, 0)))
model = cd.compile(scene)

# EI / L turns the end by one radian: 2 pi of it close the circle.
EI = 2.1e11 * 0.02 * 0.0005**3 / 12
full = 2 * np.pi * EI / LENGTH
path = model.statics(M=(0.0, full))
print(f"{path.success=}, {len(path)} equilibria up to {full:.3f} N m")
end = np.array([path["strip.end.px"][-1], path["strip.end.pz"][-1]])
print(f"the end comes back to the clamp within {np.abs(end).max():.1e} m")
assert np.abs(end).max() < 1e-9

# Bending is the same all along, and what it asks of the steel is large.
ring = model.beam("strip", path[-1].q)
print(ring)
print(f"radius {1 / -ring.curvature[:, 1].mean() * 1000:.1f} mm")
print(f"stress at the surface {ring.extreme.max() / 1e6:.0f} MPa")
path.plot(out / "roll_up.png", ["strip.end.px", "strip.end.pz"])
