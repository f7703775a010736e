"""A rolling coin: constraints on velocities that no positions explain.

Run it anywhere; it writes into ``out/rolling_disk``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/rolling_disk")
out.mkdir(parents=True, exist_ok=True)

# A thin disk on a table. q: point of contact x, y, heading, lean, angle about the axle.
scene = cd.Scene("rolling_disk", gravity=(0, 0, -9.81))
m, r = scene.parameter("m", 1.0, unit="kg"), scene.parameter("r", 100, unit="mm")
coin = scene.body("coin", mass=m, inertia=(m * r**2 / 4, m * r**2 / 2, m * r**2 / 4))
scene.joint("rolling", cd.RollingDisk(r), scene.ground, coin)

# Elimination makes Kane's equations with dependent speeds, multipliers give forces: one motion.
model = cd.compile(cd.derive(scene, constraints="elimination"))
forces = cd.compile(cd.derive(scene, constraints="multipliers"))
print("coordinates:", *model.coordinates)
print("no sliding:", *model.multipliers_of)

# A steady circle: 30 degrees of lean, 3 rad/s of heading; the balance of moments gives the spin.
lean, heading, radius = np.radians(30), 3.0, 0.1
c, s = np.cos(lean), np.sin(lean)
spin = (heading**2 * s * c / 4 - 9.81 * s / radius) / (1.5 * heading * c) - heading * s

q = {"rolling.lean": lean}
u = {"rolling.u.yaw": heading, "rolling.u.spin": spin, "rolling.u.lean": 0.0}
turn = 2 * np.pi / heading
motion = model.simulate(np.linspace(0, turn, 101), q=q, u=u, rtol=1e-10)
path = model.pose("coin", motion.q)[:, :3, 3]
print(f"spin {spin:.4f} rad/s; back after a turn to {np.linalg.norm(path[-1] - path[0]):.1e} m")
assert np.ptp(motion["rolling.lean"]) < 1e-7

# Disturbed, it nods about the steady lean; energy stays, although two of five speeds are not free.
u["rolling.u.lean"] = 0.5
motion = model.simulate(np.linspace(0, 5 * turn, 1001), q=q, u=u, rtol=1e-9)
other = forces.simulate(np.linspace(0, 5 * turn, 1001), q=q, u=u, rtol=1e-9)
print(motion)
print(f"leans {np.degrees(motion['rolling.lean'].min()):.2f} to", end=" ")
print(f"{np.degrees(motion['rolling.lean'].max()):.2f} degrees")
print(f"by multipliers the same to {np.abs(other.q - motion.q).max():.1e}")

# What friction must be able to do: the forces that keep the coin from sliding.
lam = forces.multipliers(motion.q, motion.u)
print(f"friction up to {np.linalg.norm(lam, axis=1).max():.2f} N of 9.81 N")
motion.animate(out / "rolling_disk.html")
