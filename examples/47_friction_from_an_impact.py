"""Friction and restitution of a block that slides, hits a stop and comes to rest.

The fit sees positions alone. What the stop and the friction do to them is differentiated through
the impact, whose time moves with all unknowns.

Run it anywhere; it writes into ``out/block``. See docs/fits.md and docs/gradients.md.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/block")
out.mkdir(parents=True, exist_ok=True)
GRAVITY, WALL = 9.81, 1.0  # m/s^2, m

# The friction is mu times the force with which the rail carries the block.
scene = cd.Scene("sliding_block", gravity=(0, 0, -GRAVITY))
mu, e = scene.parameter("mu", 0.2), scene.parameter("e", 0.5)
box = cd.shape.box(0.2, 0.2, 0.1)
block = scene.body("block", mass=2.0, inertia=(0.01, 0.01, 0.01), shape=box)
scene.joint("slide", cd.Prismatic("x"), scene.ground, block)
scene.force("friction", cd.Friction("slide", mu=mu))
scene.force("wall", cd.Stop("slide", upper=WALL, restitution=e))
model = cd.compile(scene)


def textbook(t, mu, e, v0):
    """The motion in closed form, and the times of the impact and of rest."""
    a = mu * GRAVITY
    v1 = np.sqrt(v0**2 - 2 * a * WALL)
    hit, v2 = (v0 - v1) / a, e * v1
    rest = hit + v2 / a
    later = np.clip(t, hit, rest) - hit
    x = np.where(t < hit, v0 * t - a * t**2 / 2, WALL - v2 * later + a * later**2 / 2)
    return x, hit, rest


# The run and its derivatives against closed form; those by complex steps.
truth, v0 = {"mu": 0.31, "e": 0.62}, 3.0
t = np.linspace(0.0, 1.5, 76)
motion = model.simulate(
    (0.0, 1.5), u={"slide": v0}, parameters=truth, rtol=1e-10, sensitivity=("mu", "e", "u0.slide")
)
for event in motion.events:
    print(f"{event.t:.6f} s  {event.name} ({event.kind})")
exact, hit, rest = textbook(t, **truth, v0=v0)
error = np.abs(motion.resample(t)["slide"] - exact).max()
print(f"impact at {hit:.6f} s, rest at {rest:.6f} s; positions are off by {error:.0e} m")


def end(mu, e, v0):
    """Where it comes to rest, also for complex numbers."""
    return WALL - e**2 * (v0**2 - 2 * mu * GRAVITY * WALL) / (2 * mu * GRAVITY)


slopes = motion.sensitivity.at([1.5])
values = {**truth, "v0": v0}
for name, known in (("mu", "mu"), ("e", "e"), ("u0.slide", "v0")):
    moved = values | {known: values[known] + 1e-30j}
    exact_slope = end(**moved).imag / 1e-30
    off = abs(slopes[name][0, 0] - exact_slope)
    print(f"d (place of rest) / d {known} = {slopes[name][0, 0]:+.6f}, off by {off:.0e}")
    assert off < 1e-9

# A camera measures it, to 2 mm. The first guess hits the wall at another time and returns less.
measured = exact + 2e-3 * np.random.default_rng(1).standard_normal(len(t))
first = model.simulate(t, u={"slide": 2.5})
fit = model.fit(
    {"t": t, "slide": measured}, unknown=("mu", "e", "u0.slide"), u={"slide": 2.5}, segments=1
)
print(fit)
for name, true in truth.items():
    off = fit.parameters[name] - true
    print(f"{name}: off by {off:+.4f}, {off / fit.standard_errors[name]:+.1f} standard errors")
    assert abs(off) < 4 * fit.standard_errors[name]

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.plot(t, measured, "k.", markersize=4, label="measured")
axes.plot(t, first["slide"], "C1--", label="first guess")
fine = np.linspace(0.0, 1.5, 601)
axes.plot(fine, fit.motion.resample(fine)["slide"], "C0", label="fit")
axes.axhline(WALL, color="0.8", zorder=0)
axes.set(xlabel="t [s]", ylabel="x [m]", title="A block slides to a wall and back")
axes.legend()
figure.savefig(out / "fit.png", dpi=120)
motion.animate(out / "block.html")
