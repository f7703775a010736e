"""Every force on one scene of bodies that can move."""

import cardan as cd

scene = cd.Scene("forces")
ground = scene.ground
cart = scene.body("cart", mass=2.0)
arm = scene.body("arm", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
ball = scene.body("ball", mass=0.2, inertia=(1e-4, 1e-4, 1e-4))
scene.joint("rail", cd.Prismatic("x"), ground, cart)
scene.joint("elbow", cd.Revolute("y"), cart, arm)
scene.joint("flight", cd.Free(), ground, ball)
tip, anchor = arm.at(0, 0, -1), ground.at(0.5, 0, 0)

# Force
scene.force("wind", cd.Force(ball, (0.1, 0, 0)))  # at a point, in ground axes

# Torque
scene.force("twist", cd.Torque(ball, (0, 0, 0.01)))

# SpringDamper
spring = cd.SpringDamper(tip, anchor, stiffness=40.0, damping=0.5, rest_length=1.0)
scene.force("spring", spring)

# Maxwell
scene.force("damper", cd.Maxwell(tip, anchor, stiffness=50.0, damping=5.0, rest_length=1.0))

# Bushing
rubber = cd.Bushing(ball, anchor, stiffness=(1, 1, 1, 500, 500, 800), damping=(0, 0, 0, 5, 5, 8))
scene.force("bushing", rubber)

# FlexibleHinge
hinge = cd.FlexibleHinge(ground, ball, "z", turn=0.5, tilt=40.0, axial=1e4, radial=1e4)
scene.force("flexure", hinge)

# Cable
scene.force("rope", cd.Cable(tip, anchor, EA=1e4, length=1.2))  # pulls only

# JointSpring
scene.force("return", cd.JointSpring("rail", stiffness=100.0))

# JointForce
scene.force("motor", cd.JointForce("elbow", 0.3))

# JointDamper
scene.force("friction_like", cd.JointDamper("elbow", damping=0.1))

# Drive
scene.force("gearbox", cd.Drive("elbow", inertia=1e-4, ratio=50.0))

# Rotor
scene.force("wheel", cd.Rotor(ball, "z", inertia=1e-5, speed=100.0))

# Actuator
scene.force("servo", cd.Actuator("rail", command=2.0, lag=0.02, limit=10.0))

# Controller
speed, position = scene.u("elbow"), scene.q("elbow")
scene.force("pd", cd.Controller("elbow", force=-2.0 * position - 0.2 * speed))

# Friction
scene.force("dry", cd.Friction("rail", coulomb=0.5))

# Stop
scene.force("end", cd.Stop("rail", lower=-1.0, upper=1.0, restitution=0.3))

# Lock
scene.force("latch", cd.Lock("elbow", when=1.2))

# Contact
floor = cd.Contact(ball, ground.at(0, 0, -1), radius=0.05, stiffness=1e5, damping=0.1)
scene.force("floor", floor)

# Event
scene.force("crossing", cd.Event(scene.q("elbow")))

# CentralGravity
space = cd.Scene("space", gravity=(0, 0, 0))
satellite = space.body("satellite", mass=100.0, inertia=(10.0, 20.0, 25.0))
space.joint("orbit", cd.Free(), space.ground, satellite)
space.force("earth", cd.CentralGravity(space.ground, mu=3.986e14))

# GravityGradient
space.force("gradient", cd.GravityGradient(space.ground, mu=3.986e14, force=False))

# J2
space.force("flattened", cd.J2(space.ground, mu=3.986e14, j2=1.0826e-3, radius=6.378e6))

# LineLoad
bridge = cd.Scene("bridge")
steel = cd.material(E=210e9, nu=0.3, rho=7850)
deck = cd.section.rectangle(width=0.3, height=0.05)
bridge.beam("deck", bridge.ground, (5, 0, 0), section=deck, material=steel, elements=4)
bridge.force("snow", cd.LineLoad("deck", force=(0, 0, -200.0)))

for loaded in (scene, space, bridge):
    model = cd.compile(loaded)
    print(loaded.name, model.nu)
