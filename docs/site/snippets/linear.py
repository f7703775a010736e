"""A rotor on springs and a column under load: rest, modes, stability, branches."""

import numpy as np
import sympy

import cardan as cd

scene = cd.Scene("column", gravity=(0, 0, 0))
P = scene.parameter("P", 0.5)
bar = scene.body("bar", mass=1.0, com=(0, 0, 0.5), inertia=(0.1, 0.1, 0.01))
scene.joint("foot", cd.Revolute("y"), scene.ground, bar)
scene.force("spring", cd.JointForce("foot", -2.0 * scene.q("foot")))
scene.force("load", cd.Force(bar.at(0, 0, 1), (0, 0, -P)))
model = cd.compile(scene)

# CompiledModel.equilibrium
rest = model.equilibrium(q={"foot": 0.1})

# Equilibrium.q, Equilibrium.u, Equilibrium.named
print(rest.q, rest.u, rest.named)

# Equilibrium.pose, Equilibrium.reaction
print(rest.pose("bar"), rest.reaction("foot"))

# Equilibrium.animate
rest.animate("rest.html")

# CompiledModel.linearize
linear = model.linearize(q={"foot": 0.0}, inputs=["foot"], outputs=["foot"])

# LinearModel
print(linear.A, linear.B, linear.C, linear.D)

# LinearModel.eigenvalues, LinearModel.stable, LinearModel.spectrum
print(linear.eigenvalues, linear.stable, linear.spectrum)

# LinearModel.shape, LinearModel.adjoint, LinearModel.participation
print(linear.shape(0), linear.adjoint(0), linear.participation)

# LinearModel.frequency_response
print(linear.frequency_response([1.0, 2.0]))

# LinearModel.plot
linear.plot("bode.svg")

# LinearModel.second_order
second = linear.second_order()

# LinearModel.M, LinearModel.K, LinearModel.damping, LinearModel.forces
print(linear.M, linear.K, linear.damping, linear.forces)

# LinearModel.gyroscopic, LinearModel.circulatory
print(linear.gyroscopic, linear.circulatory)

# LinearModel.conservative, LinearModel.dissipative, LinearModel.drifts
print(linear.conservative, linear.dissipative, linear.drifts)

# LinearModel.to_control
system = linear.to_control()  # a StateSpace of python-control

# CompiledModel.modes
modes = model.modes()

# Modes.frequencies, Modes.angular, Modes.damping, Modes.rigid
print(modes.frequencies, modes.angular, modes.damping, modes.rigid)

# Modes.shape, Modes.twist
print(modes.shape(0), modes.twist(0, "bar"))

# Modes.participation, Modes.effective_mass
print(modes.participation, modes.effective_mass)

# Modes.motion, Modes.animate
modes.animate(0, "mode.html")
print(modes.motion(0).q.shape)

# Modes.plot
modes.plot("modes.svg")

# CompiledModel.statics
path = model.statics(P=(0, 3))

# StaticPath.q, StaticPath.x, StaticPath.lam
print(path.q.shape, path.x.shape, path.lam.shape)

# StaticPath.stable, StaticPath.stable_held, StaticPath.success
print(path.stable, path.stable_held, path.success)

# StaticPath.n_negative, StaticPath.n_negative_held, StaticPath.iterations, StaticPath.model
print(path.n_negative, path.n_negative_held, path.iterations, path.model.name)

# StaticPath.pose, StaticPath.reaction
print(path.pose("bar").shape, path.reaction("foot").shape)

# StaticPath.plot, StaticPath.animate
path.plot("path.svg")
path.animate("path.html")

# StaticPath.critical
print(path.critical()[0]["P"])

# CompiledModel.continuation
branches = model.continuation(P=(0, 4), branches=1, bounds={"foot": (-1.5, 1.5)})

# Continuation
print(branches)

# Continuation.point
point = branches.point("branch point 1")

# Continuation.main, Continuation.points, Continuation.success, Continuation.message
print(branches.main, branches.points, branches.success, branches.message)

# Continuation.table, Continuation.report
print(branches.table().keys(), branches.report())

# Continuation.save, Continuation.explain, Continuation.animate
branches.save("branches.nc")
branches.explain("branches.md")
branches.animate("branches.html")

# Continuation.plot
figure = branches.plot("P", "foot", "branches.svg")

# CompiledModel.stability_chart
chart = model.stability_chart({"P": (0, 4)}, {"bar.mass": [1.0, 2.0]})

# StabilityChartRecord.line, StabilityChartRecord.plot
print(chart.line("branch point"))
chart.plot("chart.svg")

# CompiledModel.trim
coin = cd.Scene("coin", gravity=(0, 0, -9.81))
disk = coin.body("disk", mass=1, inertia=(0.0025, 0.005, 0.0025))
coin.joint("rolls", cd.RollingDisk(0.1), coin.ground, disk)
rolling = cd.compile(coin)
circle = rolling.trim({"rolls.lean": 0.5, "rolls.u.yaw": 3}, free=["rolls.u.spin"])

# SteadyMotion.stable, SteadyMotion.named, SteadyMotion.linear
print(circle.stable, circle.named, circle.linear)

# SteadyMotion.q, SteadyMotion.u
print(circle.q, circle.u)

# CompiledModel.root_locus
upright = {"rolls.lean": 0, "rolls.u.yaw": 0, "rolls.u.spin": (2, 12)}
locus = rolling.root_locus(targets=upright)

# Locus.stable, Locus.moving
print(locus.stable, locus.moving)

# Locus.plot
locus.plot("locus.svg")

# CompiledModel.campbell
gyro = cd.Scene("wheel", gravity=(0, 0, 0))
rings = [gyro.body(name, mass=0, inertia=(0, 0, 0)) for name in ("outer", "inner")]
wheel = gyro.body("wheel", mass=1, inertia=(0.5, 0.5, 0.3))
for name, axis, parent, child in (("tilt", "x", gyro.ground, rings[0]), ("lean", "y", *rings)):
    gyro.joint(name, cd.Revolute(axis), parent, child)
    gyro.force(f"spring_{name}", cd.JointForce(name, -200 * gyro.q(name)))
gyro.joint("spin", cd.Revolute("z"), rings[1], wheel)
spinning = cd.compile(gyro)
diagram = spinning.campbell(spin=(0, 60))

# Campbell.critical, Campbell.stable, Campbell.values, Campbell.rotor
print(diagram.critical(), diagram.stable, diagram.values.shape, diagram.rotor)

# Campbell.plot
diagram.plot("campbell.svg")

# CompiledModel.sensitivity
print(spinning.sensitivity(["wheel.inertia.zz"], spinning.equilibrium(u={"spin": 40})))

# CompiledModel.cycle
duffing = cd.Scene("duffing", gravity=(0, 0, 0))
duffing.joint("x", cd.Prismatic("x"), duffing.ground, duffing.body("mass", mass=1.0))
s, v = duffing.q("x"), duffing.u("x")
duffing.force("force", cd.JointForce("x", 0.5 * sympy.cos(0.7 * cd.t) - 0.1 * v - s - s**3))
lap = cd.compile(duffing).cycle({"x": 0.6}, period=2 * np.pi / 0.7, settle=5)

# Cycle.stable, Cycle.n_unstable, Cycle.named
print(lap.stable, lap.n_unstable, lap.named)

# Cycle.plot
lap.plot("lap.svg")
lap.plot("orbit.svg", "x.u", against="x")

# Cycle.animate
lap.animate("lap.html")

# Cycle.state, Cycle.q, Cycle.u
print(lap.state, lap.q, lap.u)

# Cycle.motion
print(lap.motion)

# load_linear
model.linearize(q={"foot": 0.0}).save("column.npz")
again = cd.load_linear("column.npz")
