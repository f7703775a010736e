"""A satellite held upright by gravity: attitude in a given orbit, and the whole motion.

Run it anywhere; it writes into ``out/orbit``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/orbit")
out.mkdir(parents=True, exist_ok=True)

# The earth: its field, its flattening, and an orbit 800 km above it.
MU, RADIUS, J2 = 3.986004418e14, 6378137.0, 1.08262668e-3
HEIGHT = RADIUS + 800e3
INERTIA = (10.0, 12.0, 5.0)
n = np.sqrt(MU / HEIGHT**3)

# Attitude alone: a frame goes along the orbit, the satellite turns against it. z points to the
# earth; yaw about z, then pitch about y, then roll about x are the coordinates.
scene = cd.Scene("satellite", gravity=(0, 0, 0))
mu = scene.parameter("mu", MU, unit="m^3/s^2")
orbit = cd.orbit.circular(scene, "orbit", mu, HEIGHT, inclination=1.2)
sat = scene.body("sat", mass=50.0, inertia=INERTIA)
scene.joint("attitude", cd.Spherical("ZYX"), orbit, sat)
scene.force("gradient", cd.GravityGradient(scene.ground, mu))
model = cd.compile(scene)

# Small motions about rest in the orbit: pitch by itself, roll with yaw.
x, y, z = INERTIA
print(model.linearize())
pitch = n * np.sqrt(3 * (x - z) / y)
print(f"pitch by the textbook: {pitch / (2 * np.pi):.6e} Hz")

# A large swing in pitch, a radian to either side.
turn = 2 * np.pi / n
swing = model.simulate(2 * turn, q={"attitude": [0, 1.0, 0]}, rtol=1e-10)
print(f"swings between {np.degrees(swing['attitude.angle2'].min()):.1f} and", end=" ")
print(f"{np.degrees(swing['attitude.angle2'].max()):.1f} degrees")

# The whole motion: six coordinates about a planet that is not round.
whole = cd.Scene("whole", gravity=(0, 0, 0))
body = whole.body("sat", mass=50.0, inertia=INERTIA)
whole.joint("free", cd.Free(), whole.ground, body)
whole.force("field", cd.CentralGravity(whole.ground, MU))
whole.force("gradient", cd.GravityGradient(whole.ground, MU))
whole.force("bulge", cd.J2(whole.ground, MU, J2, RADIUS))
for name, angle in zip(("roll", "pitch", "yaw"), cd.orbit.attitude(body), strict=True):
    whole.output(name, angle)

# It starts where the other one did, the earth's pull just so that the orbit would be round.
start = model.pose("sat", [0, 1.0, 0], t=0.0)
forward = model.pose("orbit", [0, 0, 0], t=0.0)[:3, 0]
normal = np.cross(start[:3, 3], forward) / HEIGHT
w = np.sqrt((1 + np.trace(start[:3, :3])) / 4)
skew = start[:3, :3] - start[:3, :3].T
quaternion = [w, *(np.array([skew[2, 1], skew[0, 2], skew[1, 0]]) / (4 * w))]
motion = cd.compile(whole).simulate(
    2 * turn,
    q={"free": [*quaternion, *start[:3, 3]]},
    u={"free": [*(n * start[:3, :3].T @ normal), *(n * HEIGHT * forward)]},
    rtol=1e-11,
    atol=1e-9,
)
apart = np.interp(swing.t, motion.t, motion["pitch"]) - swing["attitude.angle2"]
print(f"pitch of the whole motion differs by up to {np.degrees(np.abs(apart).max()):.2f} degrees")
residual = np.abs(motion.energy_residual).max() / motion.energy.kinetic[0]
print(f"energy unaccounted for: {residual:.0e} of the kinetic energy at the start")

# What the flattening does to the orbit: its plane turns.
plane = np.cross(motion.q[:, 4:7], motion.u[:, 3:6])
node = np.unwrap(np.arctan2(plane[:, 0], -plane[:, 1]))
rate = (node[-1] - node[0]) / motion.t[-1]
print(f"node: {np.degrees(rate) * 86400:.3f} degrees per day;", end=" ")
print(
    f"{np.degrees(-1.5 * n * J2 * (RADIUS / HEIGHT) ** 2 * np.cos(1.2)) * 86400:.3f} to first order"
)
motion.save(out / "orbit.nc")
