"""Andrews' squeezing mechanism: seven bodies, three loops, one drive.

A benchmark for methods of integration (Mazzia and Magherini, Test Set for IVP Solvers). Run it
anywhere; it writes into ``out/andrews``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/andrews")
out.mkdir(parents=True, exist_ok=True)

# Mass [kg], moment of inertia [kg m^2] and center of mass [m] of every body.
BODIES = {
    "K1": (0.04325, 2.194e-6, (0.00092, 0, 0)),
    "K2": (0.00365, 4.41e-7, (-0.0115, 0, 0)),
    "K3": (0.02373, 5.255e-6, (0.01043, -0.01874, 0)),
    "K4": (0.00706, 5.667e-7, (0, -0.00579, 0)),
    "K5": (0.0705, 1.169e-5, (0.02308, 0.00916, 0)),
    "K6": (0.00706, 5.667e-7, (0.00579, 0, 0)),
    "K7": (0.05498, 1.912e-5, (-0.00449, -0.01228, 0)),
}
scene = cd.Scene("andrews", gravity=(0, 0, 0))
bodies = {}
for name, (mass, moment, center) in BODIES.items():
    inertia = (moment / 2, moment / 2, moment)
    bodies[name] = scene.body(name, mass=mass, com=center, inertia=inertia)
k1, k2, k3, k4, k5, k6, k7 = bodies.values()

# Three chains from the ground and a crank meet in one point, the tip of K2.
hinge, ground = cd.Revolute("z"), scene.ground
scene.joint("beta", hinge, ground, k1)
scene.joint("theta", hinge, k1.at(0.007, 0, 0), k2)
scene.joint("gamma", hinge, ground.at(-0.03635, 0.03273, 0), k3)
scene.joint("delta", hinge, ground.at(-0.06934, -0.00227, 0), k5)
scene.joint("phi", hinge, k5.at(0.04, 0, 0), k4)
scene.joint("epsilon", hinge, ground.at(-0.06934, -0.00227, 0), k7)
scene.joint("omega", hinge, k7.at(0, -0.04, 0), k6)
tip = k2.at(-0.028, 0, 0)
scene.joint("E3", hinge, tip, k3.at(0, -0.035, 0))
scene.joint("E4", hinge, tip, k4.at(0, -0.02, 0))
scene.joint("E6", hinge, tip, k6.at(0.02, 0, 0))
hook, anchor = k3.at(0.02, -0.018, 0), ground.at(0.014, 0.072, 0)
scene.force("spring", cd.SpringDamper(anchor, hook, stiffness=4530.0, rest_length=0.07785))
scene.force("drive", cd.JointForce("beta", 0.033))

model = cd.compile(scene)
print("cut:", *(f"{cut['name']} ({cut['reason']})" for cut in model.manifest["cuts"]), sep="\n  ")

# The published start is nearly closed; the run closes it to the last digit.
start = {
    "beta": -0.06171389001427645,
    "theta": 0.0,
    "gamma": 0.4552798191630703,
    "delta": 0.48736497954384256,
    "phi": 0.22266839016588588,
    "epsilon": 1.2305474445498212,
    "omega": -0.22266839016588588,
}
motion = model.simulate(0.03, q=start, rtol=1e-11, atol=1e-13)
print(motion)

# The published angle of the crank has ten right digits; this one has more.
print(f"beta at 0.03 s: {motion['beta'][-1]:.13f}, published 15.81077119630, exact 15.81077119515")
assert abs(motion["beta"][-1] - 15.810771195153707) < 1e-9

# Forces in the pin where the four chains meet, over the run.
forces = np.linalg.norm(model.reaction("E3", motion.q, motion.u)[:, 3:], axis=1)
print(f"the pin of K3 carries up to {forces.max():.0f} N")
motion.animate(out / "andrews.html")
