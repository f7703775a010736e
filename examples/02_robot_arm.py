"""A robot arm from its URDF: inverse dynamics as a controller, checked by simulating it.

Run it anywhere; it writes into ``out/robot_arm``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/robot_arm")
out.mkdir(parents=True, exist_ok=True)

# Loading keeps every number of the file as a parameter and says what it does not yet act on.
scene = cd.load(Path(__file__).parent / "arm.urdf")
print(scene)
model = cd.compile(scene)
print("coordinates:", *model.coordinates)

# Torques that hold the arm still, and the mass it feels there.
rest = np.array([0.3, -0.6, 0.9])
zero = np.zeros(model.nu)
hold = model.inverse_dynamics(rest, zero, zero)
print("holding torques:", hold)
assert np.allclose(model.forward_dynamics(rest, zero, tau=hold), 0, atol=1e-9)

# Where the hand is, and how it moves with the joints.
print("hand at", model.pose("hand", rest)[:3, 3])
jacobian = model.frame_jacobian("hand", rest)

# A weight hanging on the hand: the wrench acts at the frame's origin in ground axes.
weight = np.array([0, 0, 0, 0, 0, -20.0])
sagging = model.forward_dynamics(rest, zero, tau=hold, wrenches={"hand": weight})
mass = model.mass_matrix(rest)
assert np.allclose(mass @ sagging, jacobian.T @ weight)
print("accelerations under 20 N:", sagging)

# Without torques it falls; a thousand states at once are one call.
motion = model.simulate(5.0, q=dict(zip(model.coordinates, rest, strict=True)), rtol=1e-9)
power = model.power(motion.q, motion.u)
print(f"{len(motion.t)} steps; damping took up to {-power.sum(axis=-1).min():.3f} W")
motion.animate(out / "arm.html")

# A picture needs Matplotlib: pip install 'cardan[plot]'.
motion.plot(out / "arm.png")
