"""A riderless bicycle: two wheels that roll without sliding, stable at some speeds.

The scene is ``cd.examples["bicycle"]``. Run it anywhere; it writes into ``out/bicycle``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/bicycle")
out.mkdir(parents=True, exist_ok=True)

scene = cd.examples["bicycle"]
equations = cd.derive(scene)
print(equations)
model = cd.compile(equations)

# The rear wheel carries the bicycle; the contact of the front wheel closes the loop over the
# ground. Eight speeds, five constraints: roll, steer and the forward speed remain.
print("held:", *model.multipliers_of)

# Pushed with 0.05 rad/s of roll at several speeds: between 4.3 and 6.0 m/s it rights itself.
for v in (3.5, 4.0, 5.0, 5.8):
    spin = {"rear_contact": (v, 0, 0, 0.05, v / 0.3), "rear_hub": -v / 0.3, "front_hub": v / 0.35}
    motion = model.simulate(np.linspace(0, 4, 401), u=spin, rtol=1e-8)
    lean = np.abs(motion["rear_contact.lean"])
    first, last = lean[:100].max(), lean[300:].max()
    print(f"{v} m/s: leans {first:.4f} rad in the first second, {last:.4f} rad in the fourth")
    assert (last < first) == (v > 4.3)

# The ground pushes sideways on the front wheel by its multiplier, and carries it.
motion = model.simulate(**scene.settings)
print(motion)
lam = model.multipliers(motion.q, motion.u)
for name, values in zip(model.multipliers_of, lam.T, strict=True):
    print(f"{name:28s} {values.min():8.2f} to {values.max():8.2f} N")
motion.animate(out / "bicycle.html")
