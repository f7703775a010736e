"""Parameters from a recorded motion, by derivatives through a simulation in JAX.

The exported C runs inside jax.lax.scan; its exact first derivatives carry those of the whole
motion, here in forward mode for Gauss-Newton's method.

Run it anywhere; it writes into ``out/rollout``. Needs JAX: pip install jax.
"""

import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

jax.config.update("jax_enable_x64", True)
out = Path("out/rollout")
out.mkdir(parents=True, exist_ok=True)

# Two links with a spring and a damper in the elbow.
scene = cd.Scene("links", gravity=(0, 0, -9.81))
m = scene.parameter("m", 0.5, unit="kg")
k, d = scene.parameter("k", 2.0, unit="N*m/rad"), scene.parameter("d", 0.02, unit="N*m*s/rad")
upper = scene.body("upper", mass=1.0, com=(0, 0, -0.5), inertia=cd.inertia.rod(1.0, 1.0, axis="z"))
lower = scene.body("lower", mass=m, com=(0, 0, -0.4), inertia=cd.inertia.rod(m, 0.8, axis="z"))
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -1.0), lower)
scene.force("elbow_spring", cd.JointSpring("elbow", stiffness=k, damping=d))
equations = cd.derive(scene)

# What was recorded: a simulation at parameters that the fit does not know, with noise.
truth = {"m": 0.8, "k": 3.5, "d": 0.15}
count, h = 150, 0.01
times = np.linspace(0.0, count * h, count + 1)
start = {"q": {"shoulder": 0.8, "elbow": 0.6}}
model = cd.compile(equations)
recorded = model.simulate(times, **start, parameters=truth).q
recorded = recorded + 1e-3 * np.random.default_rng(0).standard_normal(recorded.shape)

# The model in JAX, and steps of Runge and Kutta through it.
folder = equations.export(out / "links_jax", ["rhs"], language="jax")
sys.path.insert(0, str(folder))
import links_jax  # noqa: E402


@jax.jit
def angles(values):
    def slope(x):
        return links_jax.rhs(0.0, x, parameters=dict(zip(truth, values, strict=True)))

    def step(x, _):
        a = slope(x)
        b = slope(x + h / 2 * a)
        c = slope(x + h / 2 * b)
        x = x + h / 6 * (a + 2 * b + 2 * c + slope(x + h * c))
        return x, x

    first = jnp.array([0.8, 0.6, 0.0, 0.0])
    _, rest = jax.lax.scan(step, first, None, length=count)
    return jnp.vstack([first, rest])[:, :2]


# Gauss-Newton: the sensitivity of all 151 states to three parameters is one call.
sensitivity = jax.jit(jax.jacfwd(angles))
values = jnp.array([0.5, 2.0, 0.02])
before = angles(values)
for _ in range(8):
    error = (angles(values) - recorded).ravel()
    step, *_ = jnp.linalg.lstsq(sensitivity(values).reshape(len(error), 3), -error)
    values = values + step
    print(
        "error",
        f"{float(jnp.sqrt(jnp.mean(error**2))):.2e} rad,",
        [f"{value:.4f}" for value in values],
    )
found = dict(zip(truth, map(float, values), strict=True))
print("found", {name: round(value, 3) for name, value in found.items()}, "true", truth)
assert all(abs(found[name] - truth[name]) < 0.02 * truth[name] for name in truth)

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.plot(times, recorded, "k.", markersize=3)
axes.plot(times, before, "C1--", linewidth=1)
axes.plot(times, angles(values), "C0")
axes.set_xlabel("t [s]")
axes.set_ylabel("angles [rad]")
axes.set_title("Recorded (dots), first guess (dashed), after Gauss-Newton (lines)")
figure.savefig(out / "fit.png", dpi=120)
