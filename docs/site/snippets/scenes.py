"""A cart with a pole, and what else a scene can hold."""

from pathlib import Path

import sympy
from sympy.physics.mechanics import dynamicsymbols

import cardan as cd

# Scene
scene = cd.Scene("cart_pole", gravity=(0, 0, -9.81))

# Scene.parameter
m = scene.parameter("m", 500, unit="g")  # a SymPy symbol; 0.5 kg

# Scene.input
push = scene.input("push", default=0.0, unit="N")

# Scene.body
cart = scene.body("cart", mass=2.0, inertia=cd.inertia.box(2.0, 0.4, 0.2, 0.2))
pole = scene.body("pole", mass=m, com=(0, 0, 0.5), inertia=cd.inertia.rod(m, 1.0, axis="z"))

# Scene.joint
scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
scene.joint("hinge", cd.Revolute("y"), cart.at(0, 0, 0.1), pole)

# Scene.force
scene.force("motor", cd.JointForce("track", push))

# Body
print(cart.name, cart.mass, cart.inertia)

# Body.at
tip = pole.at(0, 0, 1, name="tip")

# Body.body
print(pole.body is pole)

# Body.position, Body.velocity
print(pole.position()[0], pole.velocity()[2])

# Body.acceleration, Body.angular_velocity, Body.rotation
print(pole.acceleration().shape, pole.angular_velocity().shape, pole.rotation().shape)

# Frame
print(tip.name, tip.body.name)

# Frame.at
beyond = tip.at(0, 0, 0.1)

# Frame.position, Frame.velocity, Frame.acceleration
height = tip.position()[2]  # an expression, for outputs and force laws
print(tip.velocity()[0], tip.acceleration()[0])

# Frame.angular_velocity, Frame.rotation
print(tip.angular_velocity(wrt=cart)[1], tip.rotation()[0, 0])

# Scene.output
scene.output("height", height, unit="m")

# Scene.q, Scene.u
scene.output("energy_like", scene.q("hinge") ** 2 + scene.u("hinge") ** 2)

# Scene.graph
print(scene.graph)

# GraphView
graph = scene.graph

# GraphView.incidence, GraphView.path, GraphView.circuit
print(graph.incidence, graph.path, graph.circuit)

# GraphView.spanning_tree, GraphView.joints, GraphView.mass_pattern
print(graph.spanning_tree, graph.joints, graph.mass_pattern)

# GraphView.svg, GraphView.dot
print(len(graph.svg()), graph.dot().splitlines()[0])

# Joint
print(scene.joints["hinge"].kind)

# scene.Force
print(scene.forces["motor"].element)

# Scene.joint_kinds
print(scene.joint_kinds()["hinge"])

# Scene.place
print(scene.place("me", "tip").name)

# Scene.add_frame
marker = scene.add_frame(cart, (0, 0.1, 0), None, "marker")

# Scene.placeholders
print(scene.placeholders(pole, "position", 3, [None, None]))

# Scene.new_place
scene.new_place("frame", "free_name")

# Scene.save
scene.save("cart_pole.yaml")

# load
again = cd.load("cart_pole.yaml")

# Scene.include
train = cd.Scene("train")
front = train.include(scene, "front")

# Included
print(list(front.bodies), list(front.joints))

# Scene.constraint
planar = cd.Scene("skate")
skate = planar.body("skate", mass=1.0, inertia=(0, 0, 0.1))
planar.joint("ice", cd.Planar(), planar.ground, skate)
along, across = sympy.sin(planar.q("ice.angle")), sympy.cos(planar.q("ice.angle"))
planar.constraint("blade", planar.u("ice.x") * along - planar.u("ice.y") * across, unit="m/s")

# t
moved = cd.Scene("shaken")
table = moved.body("table", mass=1.0)
moved.joint("drive", cd.Prismatic("x"), moved.ground, table, prescribed=0.1 * sympy.sin(cd.t))

# table
curve = cd.table([0.0, 0.1, 0.3], [0.0, 5.0, 40.0])

# Interpolation
print(curve.kind, curve(sympy.Symbol("x")))

# Interpolation.name
print(curve.name)

# examples
print(list(cd.examples)[:3])
pendulum = cd.examples["double_pendulum"]

# from_dh
arm = cd.from_dh([{"d": 0.3, "a": 0.0, "alpha": 1.57}, {"d": 0.0, "a": 0.5, "alpha": 0.0}])

# from_sympy
x, v = dynamicsymbols("x v")
oscillator = cd.from_sympy(([x], [v], sympy.Matrix([[2]]), sympy.Matrix([-8 * x])))

# Scene.beam
flexible = cd.Scene("mast")
steel = cd.material(E=210e9, nu=0.3, rho=7850)
tube = cd.section.tube(outer=0.05, inner=0.04)
mast = flexible.beam("mast", flexible.ground, (0, 0, 2), section=tube, material=steel, elements=4)

# Beam
print(mast.name, mast.elements)

# Beam.at
middle = mast.at(0.5, name="middle")

# Beam.start, Beam.end
print(mast.start, mast.end)

# Beam.releases
print(mast.releases())

# Scene.cable
stay = flexible.cable("stay", (1, 0, 0), mast.end, EA=1e6, rhoA=0.1, tension=100.0, elements=2)

# scene.Cable
print(stay.name, stay.elements)

# scene.Cable.at, scene.Cable.start, scene.Cable.end
print(stay.at(0.5), stay.start, stay.end)

# scene.Cable.inner_nodes, scene.Cable.node_name, scene.Cable.node_mass
print(stay.inner_nodes(), stay.node_name(1), stay.node_mass(1))

# scene.Cable.limits, scene.Cable.symbol
print(stay.limits(), stay.symbol("EA"))

# Scene.reduce
record = flexible.reduce("mast", modes=4)

# Scene.superelement, FlexibleBody
robot = cd.Scene("robot")
link = robot.superelement("link", record)

# FlexibleBody.at
print(link.at(next(iter(link.record.interfaces)).name))

# Scene.state
controlled = cd.Scene("controlled")
slider = controlled.body("slider", mass=1.0)
controlled.joint("rail", cd.Prismatic("x"), controlled.ground, slider)
integral = sympy.Symbol("e")
law = cd.Controller(
    "rail",
    states=("e",),
    changes=(controlled.q("rail"),),
    force=-9 * controlled.q("rail") - integral,
)
controlled.force("pid", law)
print(controlled.state("pid.e"))
Path("cart_pole.yaml").unlink()
