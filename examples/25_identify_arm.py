"""What does the robot on the table really weigh?

Its URDF says one thing; the robot carries a tool, and its joints are stiffer than they were. It
moves in a way that shows its inertia, positions and torques are measured with noise, and the model
is corrected by what they tell: no more than they can tell, each number with its deviation.

Run it anywhere; it writes into ``out/identify_arm``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/identify_arm")
out.mkdir(parents=True, exist_ok=True)
scene = cd.load(Path(__file__).with_name("arm.urdf"))
model = cd.compile(scene)

# only combinations of masses and inertias act on the torques
base = model.base_parameters()
print(base)

# a motion that shows them, within the limits of the joints
motion = cd.excitation(model, period=8.0, speed=3.0, acceleration=20.0, steps=15)
print(motion)
motion.save(out / "motion.csv", rate=200)

# the robot does it five times; here it is a simulated one
robot = model.with_parameters({
    "hand.mass": 0.55,
    "forearm.com.x": 0.17,
    "elbow.damping": 0.16,
    "waist.damping": 0.25,
})  # fmt: skip
plan = motion.motion(rate=200, periods=5)
torques = robot.torques(plan)
print(torques)
rng = np.random.default_rng(1)
measured = {
    "t": plan["t"],
    "q": plan["q"] + 2e-5 * rng.normal(size=plan["q"].shape),
    "tau": torques.tau + [0.3, 0.2, 0.1] * rng.normal(size=plan["q"].shape),
}

# positions are periodic: their Fourier series is differentiated, not the noise
found = cd.identify(model, measured, period=motion.period, harmonics=motion.harmonics)
print(found)
truth = base.of(list(robot.inertial_parameters().values()))
worst = np.abs((found.estimates - truth) / found.deviations).max()
print(f"largest error: {worst:.1f} standard deviations")

# the model with these numbers foretells torques of a motion that it has not seen
t = np.linspace(0, 3, 601)
other = {"t": t, "q": np.sin(np.outer(t, [1.5, 2.0, 2.5]))}
want = robot.torques(other)
for name, one in (("as the file says", model), ("identified", found.model)):
    left = one.torques(other).forces - want.forces
    missed = np.sqrt(np.mean(left**2, axis=0)) / want.rms
    print(f"{name:16}: torques missed by {', '.join(f'{x:.1%}' for x in missed)}")
found.plot(out / "fit.png")
