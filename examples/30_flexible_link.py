"""A link of a robot from its mesh: reduced, in large motion, colored by stress.

Run it anywhere; it writes into ``out/flexible_link``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/flexible_link")
out.mkdir(parents=True, exist_ok=True)

# The mesh: a plate of 300 x 150 x 50 mm with a hole, in units of 5 mm; "root" and "hole" are
# surfaces of it. They become interfaces; stress is recovered at all nodes of the volume "lug".
file = Path(__file__).with_name("lug.inp")
nylon = cd.material(E=2e9, nu=0.4, rho=1150, damping=1e-4)
surfaces = {"root": "root", "pin": "hole"}
link = cd.superelement.from_mesh(file, nylon, surfaces, modes=4, stress="lug", scale=5e-3)
print(link)

# The robot: a motor turns the root of the link, a load of 5 kg hangs on a pin in its hole.
scene = cd.Scene("flexible_link", gravity=(0, -9.81, 0))
drum = cd.shape.cylinder(0.085, 0.06, position=(-0.04, 0, 0))
hub = scene.body("hub", mass=2.0, inertia=(0.01, 0.01, 0.01), shape=drum)
scene.joint("motor", cd.Revolute("z"), scene.ground, hub)
arm = scene.superelement("arm", link, {"root": hub}, frame="root")
shapes = [
    cd.shape.cylinder(0.038, 0.1),
    cd.shape.box(0.05, 0.2, 0.02, position=(0, -0.1, 0.04)),
    cd.shape.sphere(0.06, position=(0, -0.2, 0.04)),
]
load = scene.body("load", mass=5.0, com=(0, -0.2, 0), inertia=(0.05, 0.05, 0.05), shape=shapes)
scene.joint("pin", cd.Revolute("z"), arm.at("pin"), load)
scene.force("torque", cd.JointForce("motor", 18.0))

# The motion, and where the stress is largest.
# The link vibrates at 5000 rad/s and more, which an implicit method passes over.
times = np.linspace(0, 1, 201)
motion = cd.compile(scene).simulate(times, q={"motor": -0.2}, method="GeneralizedAlpha", step=2e-3)
print(motion)
shape = motion.superelement("arm")
print(shape)
row = int(shape.largest_stress.argmax())
point = shape.stressed[shape.von_mises[row].argmax()]
print(
    f"von Mises stress of {shape.largest_stress[row] / 1e6:.2f} MPa at t = {motion.t[row]:.3f} s,"
)
print(f"at {np.round(shape.surface.points[point], 3)} m of the undeformed link")
motion.animate(out / "link.html", plots=["motor", "pin", "energy"])
shape.plot(out / "link.png", row=row)
