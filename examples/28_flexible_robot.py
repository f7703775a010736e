"""A robot with elastic links: motors with PID controllers turn it, the tip swings and sags.

Run it anywhere; it writes into ``out/flexible_robot``.
"""

from pathlib import Path

import numpy as np
import sympy as sp

import cardan as cd

out = Path("out/flexible_robot")
out.mkdir(parents=True, exist_ok=True)
TARGET, LENGTH = {"shoulder": -0.7, "elbow": 1.1}, {"shoulder": 0.6, "elbow": 0.5}
GAINS = {"shoulder": (60.0, 120.0, 12.0), "elbow": (25.0, 60.0, 4.0)}


def robot(sample: float | None = None) -> cd.Scene:
    """Two hubs that motors turn, a tube on each of them, a load at the tip."""
    scene = cd.Scene("flexible_robot", gravity=(0, 0, -9.81))
    dural = cd.material(E=7e10, nu=0.3, rho=2700, damping=2e-4)
    tube, place, reach = cd.section.tube(outer=0.008, inner=0.007), scene.ground, 0.0
    for name, length in LENGTH.items():
        hub = scene.body(f"{name}_hub", mass=0.4, inertia=(1e-3, 1e-3, 1e-3))
        scene.joint(name, cd.Revolute("y"), place, hub)
        reach += length
        link = scene.beam(f"{name}_link", hub, (reach, 0, 0), tube, dural, elements=2)
        place = link.end
        kp, ki, kd = GAINS[name]
        total, error = sp.Symbol(f"{name}_total"), TARGET[name] - scene.q(name)
        torque = kp * error + ki * total
        change = error if sample is None else total + sample * error
        pid = cd.Controller(name, (total,), (change,), torque, sample=sample)
        scene.force(f"{name}_pid", pid)
        # the motor damps by itself: held over a sample, this would shake the light hub
        scene.force(f"{name}_motor", cd.JointDamper(name, kd))
    load = scene.body("load", mass=0.5, inertia=(2e-4, 2e-4, 2e-4))
    scene.joint("grip", cd.Fixed(), place, load)
    for axis, name in ((0, "x"), (2, "z")):
        scene.output(name, load.position()[axis], unit="m")
    return scene


# The hubs are in joint coordinates, the links in nodes; the integral is a state of the controller.
scene = robot()
model = cd.compile(scene)
times = np.linspace(0, 6, 601)
motion = model.simulate(times)
print(motion)
for name, target in TARGET.items():
    print(f"{name} misses its target by {abs(motion[name][-1] - target):.1e} rad at the end")

# The motors cannot see that the links sag: the tip is below where a rigid robot would have it.
a, b = TARGET["shoulder"], TARGET["shoulder"] + TARGET["elbow"]
rigid = -LENGTH["shoulder"] * np.sin(a) - LENGTH["elbow"] * np.sin(b)
print(f"the tip hangs {1000 * (rigid - motion['z'][-1]):.1f} mm lower than that of a rigid robot")
rest = model.equilibrium(q=TARGET)
left = abs(motion["elbow_link.end.pz"][-1] - rest["elbow_link.end.pz"])
print(f"and is within {left:.0e} m of the equilibrium of the controlled robot")
assert rest.stable
assert left < 1e-4

# As a computer does it, with samples of 5 ms.
sampled = cd.compile(robot(0.005)).simulate(times)
print(f"{sampled.statistics['steps']} steps with samples, {motion.statistics['steps']} without")
apart = 1000 * np.abs(sampled["z"] - motion["z"]).max()
print(f"with samples the tip differs by up to {apart:.2f} mm")
motion.animate(out / "robot.html")
