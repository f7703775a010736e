"""Computed torque: an arm that carries its own equations follows a path.

Run it anywhere; it writes into ``out/computed_torque``.
"""

from functools import partial
from pathlib import Path

import numpy as np
import sympy as sp

import cardan as cd

out = Path("out/computed_torque")
out.mkdir(parents=True, exist_ok=True)
JOINTS = ("shoulder", "elbow")
PATH = (0.8 * sp.sin(1.3 * cd.t), -0.6 * sp.sin(2.1 * cd.t))
KP, KD = 36.0, 12.0


def arm() -> cd.Scene:
    """Two links under gravity."""
    scene = cd.Scene("arm_on_path", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=3.0, com=(0.25, 0, 0), inertia=(0.01, 0.07, 0.07))
    lower = scene.body("lower", mass=1.5, com=(0.2, 0, 0), inertia=(0.005, 0.03, 0.03))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0.5, 0, 0), lower)
    return scene


# What the law asks for: e'' + kd e' + kp e = 0 for the error e of the path.
alone, scene = cd.derive(arm()), arm()
wished = []
for name, path in zip(JOINTS, PATH, strict=True):
    error, rate = path - scene.q(name), path.diff(cd.t) - scene.u(name)
    wished.append(path.diff(cd.t, 2) + KD * rate + KP * error)

# Exactly: torques M wished + h from the equations themselves, as expressions in the scene.
numbers = {sp.Symbol(entry.name): entry.value for entry in alone.system.parameters}
torques = (alone.mass_matrix * sp.Matrix(wished) + alone.bias).subs(numbers)
for name, torque in zip(JOINTS, torques, strict=True):
    scene.force(f"{name}_motor", cd.JointForce(name, torque))
start = {"q": {"shoulder": -0.3, "elbow": 0.2}, "u": {"shoulder": 1.04, "elbow": -1.26}}
times = np.linspace(0, 3, 301)
motion = cd.compile(scene).simulate(times, **start, rtol=1e-11, atol=1e-12)

# kd^2 = 4 kp: the error is e0 (1 + w t) exp(-w t), w = kd / 2.
lag = np.exp(-KD / 2 * times) * (1 + KD / 2 * times)
path = sp.lambdify(cd.t, PATH)
error = np.array([path(t) for t in times]) - motion.q
print(f"error at first {error[0]}, after 1 s {error[100]}")
print(f"differs from the closed form by {np.abs(error - np.outer(lag, [0.3, -0.2])).max():.0e} rad")
assert np.abs(error - np.outer(lag, [0.3, -0.2])).max() < 1e-8

# As a computer does it: inverse dynamics of the model, called every 2 ms, torques held between.
sampled = arm()
for name in JOINTS:
    sampled.force(f"{name}_motor", cd.JointForce(name, sampled.input(f"{name}_torque")))
robot, inverse = cd.compile(sampled), cd.compile(arm())
names = [alone.symbols["q", k] for k in range(2)] + [alone.symbols["u", k] for k in range(2)]
law = sp.lambdify([cd.t, *names], wished)


def torque_of(t: float, x: np.ndarray, k: int) -> float:
    """Torque of motor k."""
    return float(inverse.inverse_dynamics(x[:2], x[2:], law(t, *x))[k])


inputs = {f"{name}_torque": partial(torque_of, k=k) for k, name in enumerate(JOINTS)}
held = robot.simulate(times, **start, inputs=inputs, sample=0.002)
error = np.array([path(t) for t in times]) - held.q
print(
    f"with samples of 2 ms it differs by {np.abs(error - np.outer(lag, [0.3, -0.2])).max():.0e} rad"
)
held.animate(out / "arm.html")
