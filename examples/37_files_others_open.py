"""One motion for six other programs.

A robot arm falls, and a stop holds its elbow. Its motion goes to a table, to MATLAB, to Blender and
to Foxglove; the arm itself becomes a URDF, and its linear model goes to a controller's designer.
"""

from importlib.util import find_spec

import cardan as cd

scene = cd.Scene("lamp_arm", gravity=(0, 0, -9.81))
rod = cd.inertia.rod(1.0, 0.6, axis="z")
bar = cd.shape.box(0.06, 0.04, 0.6, position=(0, 0, -0.3), color=(0.9, 0.4, 0.1))
upper = scene.body("upper", mass=1.0, com=(0, 0, -0.3), inertia=rod, shape=bar)
lower = scene.body("lower", mass=1.0, com=(0, 0, -0.3), inertia=rod, shape=bar)
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.6), lower)
hand = lower.at(0, 0, -0.6, name="hand")
scene.force("friction", cd.JointDamper("shoulder", 0.1))
scene.force("stop", cd.Stop("elbow", upper=0.4, restitution=0.4))
scene.force("motor", cd.JointForce("shoulder", scene.input("torque")))
scene.output("height", hand.position()[2], unit="m")

model = cd.compile(scene)
motion = model.simulate(5.0, q={"shoulder": 1.2, "elbow": -0.5})

# a table with units, cell arrays of names, an animated scene
print(motion.save("arm.csv").open(encoding="utf-8").readline()[:60], "...")
for name in ("arm.mat", "arm.glb"):
    print(motion.save(name))

# extras: pip install 'cardan[mcap]', pip install 'cardan[data]'
if find_spec("mcap"):
    print(motion.save("arm.mcap"))
if find_spec("pandas"):
    table = motion.to_pandas()
    print(table.describe().loc[["min", "max"], ["elbow", "height"]], table.attrs["units"]["elbow"])

# A, B, C, D with names and units, about hanging at rest; they come back bit by bit
linear = model.linearize(q={"shoulder": 0.0, "elbow": 0.0})
print(linear.save("arm_linear.mat"))
again = cd.load_linear(linear.save("arm_linear.npz"))
assert (again.A == linear.A).all()

# a robot for other programs, and what it lacks
for loss in scene.save("arm.urdf"):
    print("not in arm.urdf:", loss)
