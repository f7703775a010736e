"""A dual-spin satellite: a wheel keeps upright what friction inside would topple.

Run it anywhere; it writes into ``out/dual_spin``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/dual_spin")
out.mkdir(parents=True, exist_ok=True)

# A slender satellite: it spins about the axis of its least inertia. A wheel turns about the same
# axis, and a ball in a tube, on a spring and in oil, takes energy wherever the axis wobbles.
I1, I2, I3 = 4.0, 4.2, 3.6
scene = cd.Scene("dual_spin", gravity=(0, 0, 0))
momentum = scene.parameter("hs", 0.0, unit="N*m*s")
box = cd.shape.box(1, 1, 1.5)
bus = scene.body("bus", mass=20.0, inertia=(I1, I2 - 0.1, I3 - 0.1), shape=box)
ball = scene.body("ball", mass=0.4)
scene.joint("attitude", cd.Spherical(), scene.ground, bus)
scene.joint("tube", cd.Prismatic("z"), bus.at(0.5, 0, 0), ball)
scene.force("oil", cd.JointSpring("tube", stiffness=0.1, damping=0.1))
scene.force("wheel", cd.Rotor(bus, axis="z", momentum=momentum))
model = cd.compile(scene)

# The rule: with nu the spin, (I3 nu + hs) / nu must exceed the greatest inertia.
NU = 1.2
for hs in (0.0, 3.0):
    rule = (I3 * NU + hs) / NU
    wheel = model.with_parameters(hs=hs)
    motion = wheel.simulate(1000.0, u={"attitude": [0.15, 0, NU]}, rtol=1e-8, atol=1e-10)
    # the angle between the axis and the whole momentum, which stays where it is
    axis = model.pose("bus", motion.q)[:, :3, 2]
    whole = wheel.momentum(motion.q, motion.u)[:, :3] + hs * axis
    across = np.linalg.norm(np.cross(axis, whole), axis=1) / np.linalg.norm(whole, axis=1)
    lean = np.degrees(np.arcsin(across))
    word = "stable" if rule > max(I1, I2) else "unstable"
    print(f"hs = {hs:g} N m s: {rule:.2f} against {max(I1, I2)} kg m^2, {word};", end=" ")
    print(f"the axis leans {lean[0]:.1f} degrees at first, {lean[-1]:.2f} in the end")
    print(f"  oil took {-motion.work['oil'][-1]:.4f} J")
motion.animate(out / "dual_spin.html")

# How the wheel gets its momentum: a motor spins it up, and the satellite slows down.
spinning = cd.Scene("spin_up", gravity=(0, 0, 0))
carrier = spinning.body("bus", mass=20.0, inertia=(I1, I2, I3))
spinning.joint("attitude", cd.Spherical(), spinning.ground, carrier)
torque = spinning.input("torque")
spinning.force("wheel", cd.Rotor(carrier, axis="z", inertia=0.02, torque=torque))
driven = cd.compile(spinning)
motion = driven.simulate(60.0, u={"attitude": [0.0, 0, 2.0]}, inputs={"torque": 0.05})
wheel, spin = motion["wheel.rotor.u"][-1], motion["attitude.u.z"]
print(f"wheel at {wheel:.1f} rad/s against the satellite, which went from {spin[0]:.2f}", end=" ")
print(f"to {spin[-1]:.4f} rad/s; {2.0 - 0.05 * 60 / I3:.4f} by the balance of momentum")
