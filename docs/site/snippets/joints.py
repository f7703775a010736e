"""A body on every joint there is, side by side."""

import sympy

import cardan as cd

scene = cd.Scene("joints")
ground = scene.ground


def body(name):
    return scene.body(name, mass=1.0, com=(0, 0, -0.1), inertia=(0.01, 0.01, 0.02))


# Fixed
scene.joint("weld", cd.Fixed(), ground, body("welded"))

# Revolute
scene.joint("hinge", cd.Revolute("y"), ground, body("door"), limits=(-1.5, 1.5))

# Prismatic
scene.joint("rail", cd.Prismatic("x"), ground, body("slider"))

# Cylindrical
scene.joint("sleeve", cd.Cylindrical("z"), ground, body("piston"))

# Screw
scene.joint("spindle", cd.Screw("z", pitch=0.005), ground, body("nut"))

# Universal
scene.joint("cross", cd.Universal("x", "y"), ground, body("shaft"))

# ConstantVelocity
scene.joint("cv", cd.ConstantVelocity("z"), ground, body("halfshaft"))

# Spherical
scene.joint("ball", cd.Spherical(), ground, body("socket"))  # quaternions; or rotation="XYZ"

# Planar
scene.joint("table", cd.Planar("z"), ground, body("puck"))

# Translation
scene.joint("gantry", cd.Translation(), ground, body("hook"))

# Free
scene.joint("flight", cd.Free(), ground, body("satellite"))

# PointOnPlane
scene.joint("caster", cd.PointOnPlane("z"), ground, body("caster_wheel"))

# PointOnCurve
track = [(0, 0, 0), (1, 0, 0.2), (2, 0.5, 0), (3, 0.5, 0)]
scene.joint("wire", cd.PointOnCurve(track), ground, body("bead"))

# Distance
scene.joint("rod", cd.Distance(0.5), ground, body("bob"))

# Gear
wheel = body("pinion")
scene.joint("mesh", cd.Gear("hinge", ratio=-2.0, axis="y"), ground, wheel)

# Wheel
scene.joint("rolls", cd.Wheel(0.3), ground, body("tire"))

# RollingDisk
scene.joint("coin", cd.RollingDisk(0.02), ground, body("disk"))

# Custom
a = sympy.Symbol("a")
parabola = cd.Custom(symbols=("a",), position=(a, 0, a**2))
scene.joint("groove", parabola, ground, body("pin"))

model = cd.compile(scene)
print(model.forward_dynamics(*model.split(model.initial())).shape)
