"""Parameters of an arm from measured motions; states of other programs."""

import numpy as np

import cardan as cd

scene = cd.Scene("arm", gravity=(0, 0, -9.81))
arm = scene.body("arm", mass=2.0, com=(0.01, 0, -0.25), inertia=(0.05, 0.04, 0.01))
scene.joint("elbow", cd.Revolute("y"), scene.ground, arm, limits=(-2, 2))
scene.force("drag", cd.JointDamper("elbow", 0.3))
model = cd.compile(scene)

# CompiledModel.base_parameters
base = model.base_parameters()

# Base.names, Base.expressions
print(base.names, base.expressions)

# Base.of, Base.regressor
values = base.of(list(model.inertial_parameters().values()))
columns = base.regressor(model.regressor([0.1], [0.2], [0.3]))

# CompiledModel.torques
t = np.linspace(0, 2, 401)
torques = model.torques({"t": t, "elbow": np.sin(2 * t)})

# Torques.tau, Torques.power, Torques.work, Torques.peak, Torques.rms
print(torques.tau.shape, torques.power.shape, torques.work, torques.peak, torques.rms)

# Torques.table, Torques.save, Torques.plot
torques.save("torques.csv")
print(torques.table().keys(), torques.plot("torques.svg"))

# excitation, CompiledModel.excitation
plan = cd.excitation(model, period=6.0, speed=3.0, acceleration=15.0, steps=5)
same = model.excitation(period=6.0, speed=3.0, acceleration=15.0, steps=5)

# Excitation.at, Excitation.motion
measured = plan.motion(rate=200, periods=2)
print(plan.at(0.5))

# Excitation.period, Excitation.harmonics
print(plan.period, plan.harmonics)

# Excitation.save, Excitation.plot
plan.save("plan.csv", rate=100)
plan.plot("plan.svg")

# identify, CompiledModel.identify
robot = model.with_parameters({"arm.mass": 2.4})
data = {"t": measured["t"], "q": measured["q"], "tau": robot.torques(measured).tau}
found = cd.identify(model, data, period=6.0)
again = model.identify(data, period=6.0)

# Identification.parameters, Identification.names, Identification.model
print(found.parameters["arm.mass"], found.names, found.model.name)

# Identification.deviations, Identification.relative, Identification.interval
print(found.deviations, found.relative, found.interval(found.names[0]))

# Identification.expected, Identification.explained, Identification.well
print(found.expected, found.explained, found.well)

# Identification.implausible, Identification.missed
print(found.implausible, found.missed)

# Identification.nearest_to
print(found.nearest_to(model, only=["arm.mass"]))

# Identification.plot
found.plot("fit.svg")

# convert, convert.to_pinocchio
q, u = model.split(model.initial({"elbow": 0.3}))
q_pin, v = cd.convert.to_pinocchio(model, q, u)

# convert.from_pinocchio
q, u = cd.convert.from_pinocchio(model, q_pin, v)

# convert.to_mujoco
qpos, qvel = cd.convert.to_mujoco(model, q, u)

# convert.from_mujoco
q, u = cd.convert.from_mujoco(model, qpos, qvel)
