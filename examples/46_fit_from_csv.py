"""A double pendulum from a measured motion: masses, lengths and friction of its bearings.

A file with noise, and with gaps where the camera lost a marker, is all that is known. A fit says
what the data tell, how well, and what they do not.

Run it anywhere; it writes into ``out/pendulum_fit``. See docs/fits.md.
"""

import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/pendulum_fit")
out.mkdir(parents=True, exist_ok=True)

# Two rods with dampers in their joints. The values here are guesses.
scene = cd.Scene("filmed_pendulum", gravity=(0, 0, -9.81))
m1, m2 = scene.parameter("m1", 1.0, "kg"), scene.parameter("m2", 1.0, "kg")
l1, l2 = scene.parameter("l1", 0.8, "m"), scene.parameter("l2", 0.8, "m")
d1, d2 = (scene.parameter(name, 0.05, "N*m*s/rad") for name in ("d1", "d2"))
upper = scene.body("upper", mass=m1, com=(0, 0, -l1 / 2), inertia=cd.inertia.rod(m1, l1, axis="z"))
lower = scene.body("lower", mass=m2, com=(0, 0, -l2 / 2), inertia=cd.inertia.rod(m2, l2, axis="z"))
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -l1), lower)
scene.force("upper_bearing", cd.JointDamper("shoulder", d1))
scene.force("lower_bearing", cd.JointDamper("elbow", d2))
model = cd.compile(scene)

# What a camera would have written: 50 pictures a second, 0.01 rad of noise, a gap of 0.4 s.
truth = {"m1": 1.0, "m2": 0.6, "l1": 1.0, "l2": 0.7, "d1": 0.08, "d2": 0.02}
t = np.linspace(0.0, 6.0, 301)
motion = model.simulate(t, q={"shoulder": 2.0, "elbow": -0.5}, parameters=truth, rtol=1e-10)
angles = motion.q + 0.01 * np.random.default_rng(0).standard_normal(motion.q.shape)
angles[150:170, 1] = np.nan
file = out / "motion.csv"
heading = "t [s],shoulder [rad],elbow [rad]"
np.savetxt(file, np.c_[t, angles], fmt="%.5f", delimiter=",", header=heading, comments="")

# Everything at once: only ratios of masses and dampers move a pendulum that swings freely. A
# warning says so too.
start = {"q": {"shoulder": 1.9, "elbow": -0.4}}
with warnings.catch_warnings(record=True):
    every = model.fit(file, unknown=(*truth, "q0", "u0"), **start)
print(every)
(combination,) = every.undetermined
assert set(combination) == {"m1", "m2", "d1", "d2"}
assert np.ptp(list(combination.values())) < 1e-6

# The upper rod is weighed; all else follows.
unknown = [name for name in truth if name != "m1"]
fit = model.fit(file, unknown=(*unknown, "q0", "u0"), **start)
print(fit)
print(f"noise {fit.sigma:.4f} rad, in the file 0.0100")
print("Durbin-Watson", {name: round(number, 2) for name, number in fit.durbin_watson.items()})
for name in unknown:
    value, half = fit.parameters[name], 1.96 * fit.standard_errors[name]
    off = (value - truth[name]) / fit.standard_errors[name]
    print(
        f"{name}: 95 % between {value - half:.4f} and {value + half:.4f}, "
        f"true {truth[name]:.4f}, {off:+.1f} standard errors off"
    )
    assert abs(off) < 4

figure, (above, below) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, layout="constrained")
guess = model.simulate(t, **start)
for k, name in enumerate(("shoulder", "elbow")):
    above.plot(t, angles[:, k], f"C{k}.", markersize=3, label=f"{name}, measured")
    above.plot(t, guess[name], f"C{k}:", linewidth=1)
    above.plot(fit.motion.t, fit.motion[name], f"C{k}", label=f"{name}, fit")
    below.plot(t, fit.residuals[name], f"C{k}.", markersize=3)
above.set(ylabel="angle [rad]", title="Measured, first guess (dotted) and fit")
above.legend()
below.set(xlabel="t [s]", ylabel="measured less fit [rad]")
figure.savefig(out / "fit.png", dpi=120)
