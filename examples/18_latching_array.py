"""A folded solar array of flexible panels opens, latches, and shakes the satellite.

Run it anywhere; it writes into ``out/latching``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/latching")
out.mkdir(parents=True, exist_ok=True)
PANELS, LENGTH = 3, 1.2

# A free satellite; every panel is an elastic strip on a fitting that a spring turns.
scene = cd.Scene("latching_array", gravity=(0, 0, 0))
hub = scene.body("hub", mass=60.0, inertia=(5.0, 6.0, 5.0), shape=cd.shape.box(0.6, 0.6, 0.6))
scene.joint("drift", cd.Free(), scene.ground, hub)
carbon = cd.material(E=6e10, nu=0.3, rho=1600, damping=5e-4)
strip = cd.section.rectangle(0.5, 0.004)
place = hub.at(0.3, 0, 0)
for k in range(PANELS):
    fitting = scene.body(f"fitting{k}", mass=0.2, inertia=(2e-3, 2e-3, 2e-3))
    scene.joint(f"hinge{k}", cd.Revolute("y"), place, fitting)
    scene.force(f"spring{k}", cd.JointSpring(f"hinge{k}", stiffness=1.5, damping=0.1))
    # The latch falls in where the hinge is straight, and stays.
    angle = scene.q(f"hinge{k}")
    scene.force(f"latch{k}", cd.Lock(f"hinge{k}", when=angle if k % 2 else -angle))
    end = (0.3 + LENGTH * (k + 1), 0, 0)
    place = scene.beam(f"panel{k}", fitting, end, strip, carbon, elements=2).end
scene.output("tip", place.position(wrt=hub, in_=hub)[2], unit="m")
model = cd.compile(scene)

# Folded in a zigzag. One scene does it all: opening, latching, what swings afterwards.
folded = {"hinge0": -1.4, "hinge1": 2.7, "hinge2": -2.7}
motion = model.simulate(12.0, q=folded)
print(motion)
for event in motion.events:
    print(f"{event.name} at {event.t:.3f} s")

# Momentum comes from nowhere: what the latches stop, they stop by impulses inside the system.
momentum = model.momentum(motion.q, motion.u)
print(f"momentum gained: {np.abs(momentum).max():.1e}")
assert np.abs(momentum).max() < 1e-4

# From the last latch on the hinges are straight, and the array swings as one beam.
closed = motion.t >= motion.events[-1].t
for k in range(PANELS):
    assert np.abs(motion[f"hinge{k}"][closed]).max() < 1e-6
tip, t = motion["tip"][closed], motion.t[closed]
first, last = np.ptp(tip) / 2, np.ptp(tip[t > 11]) / 2
print(f"the tip swings by {first:.3f} m, by {last:.3f} m in the last second")
moment = np.abs(motion.beam("panel0").moment[..., 0, 1])
before, after = moment[~closed].max(), moment[closed].max()
print(f"the root bends with {before:.1f} N m before the last latch, with {after:.1f} N m after it")
motion.animate(out / "latching.html")
