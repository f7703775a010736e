"""An arm of two links with a motor, a spring and a stop: every function of its model."""

import importlib.util

import jax
import numpy as np

import cardan as cd

scene = cd.Scene("arm", gravity=(0, 0, -9.81))
torque = scene.input("torque", default=0.0, unit="N*m")
rod = {"mass": 1.0, "com": (0, 0, -0.25), "inertia": cd.inertia.rod(1.0, 0.5, axis="z")}
upper, lower = scene.body("upper", **rod), scene.body("lower", **rod)
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper, limits=(-3, 3))
scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.5), lower)
scene.force("motor", cd.JointForce("elbow", torque))
scene.force("spring", cd.JointSpring("elbow", stiffness=2.0, damping=0.1))
scene.force("stop", cd.Stop("elbow", upper=1.5, restitution=0.5))
hand = lower.at(0, 0, -0.5, name="hand")
scene.output("height", hand.position()[2], unit="m")

# compile
model = cd.compile(scene)  # derived, written as C, compiled, checked, loaded

# CompiledModel
print(model)

# CompiledModel.initial
x = model.initial({"shoulder": 0.5}, {"elbow": 1.0})

# CompiledModel.split
q, u = model.split(x)

# CompiledModel.parts_of
q, u, z = model.parts_of(x)

# CompiledModel.rhs
xdot = model.rhs(0.0, x)  # as SciPy's solve_ivp calls it

# CompiledModel.forward_dynamics
udot = model.forward_dynamics(q, u, tau={"elbow": 0.3})

# CompiledModel.inverse_dynamics
tau = model.inverse_dynamics(q, u, [0.0, 0.0])

# CompiledModel.mass_matrix
M = model.mass_matrix(q)

# CompiledModel.bias
h = model.bias(q, u)

# CompiledModel.gravity
holding = model.gravity(q)  # gravity compensation

# CompiledModel.coriolis
products = model.coriolis(q, u)

# CompiledModel.applied_forces
f = model.applied_forces(q, u, r={"torque": 0.2})

# CompiledModel.qdot
qdot = model.qdot(q, u)

# CompiledModel.energy
print(model.energy(q, u).total)

# CompiledModel.strain_energy
print(model.strain_energy(q))

# CompiledModel.momentum
angular_then_linear = model.momentum(q, u)

# CompiledModel.momenta
p = model.momenta(q, u)

# CompiledModel.momentum_rates
pdot = model.momentum_rates(q, u)

# CompiledModel.hamiltonian
H = model.hamiltonian(q, u)

# CompiledModel.power
print(model.power(q, u))

# CompiledModel.pose
T = model.pose("hand", q)  # (4, 4): rotation and position

# CompiledModel.velocity
twist = model.velocity("hand", q, u)  # angular part first

# CompiledModel.acceleration
spatial = model.acceleration("hand", q, u, udot)

# CompiledModel.frame_jacobian
J = model.frame_jacobian("hand", q)

# CompiledModel.com
print(model.com(q))

# CompiledModel.reaction
wrench = model.reaction("shoulder", q, u)

# CompiledModel.element_forces
print(model.element_forces(q, u))

# CompiledModel.outputs
print(model.outputs(q, u))

# CompiledModel.events
print(model.events(q, u), model.event_names)

# CompiledModel.transition
behind = model.transition(q, u, np.ones(len(model.event_names)))

# CompiledModel.derivative
A, B = model.derivative("forward_dynamics", wrt=("q", "u"))(q, u)

# Derivative.operations, Derivative.request
derivative = model.derivative("forward_dynamics", wrt="q")
print(derivative.operations, derivative.request)

# CompiledModel.fit
t = np.linspace(0, 0.5, 20)
data = {"t": t, model.coordinates[0]: model.simulate(t, method="DOP853").x[:, 0]}
fit = model.fit(data, unknown="q0")
print(fit.standard_errors)

# Fit.interval
low, high = fit.interval(fit.names[0])

# Fit.correlation, Fit.combinations, Fit.serially_correlated
print(fit.correlation, fit.combinations, fit.serially_correlated)

# Fit.plot
fit.plot("fit.svg")

# CompiledModel.gradient, cost
value, slope = model.gradient(0.2, cd.cost(final=f"{model.coordinates[0]}^2"), wrt=("x0", "p"))

# CompiledModel.expression
value = model.expression(f"{model.coordinates[0]}^2 + t", q, u)

# CompiledModel.vjp
by_q, by_m = model.vjp("forward_dynamics", wrt=("q", "p"))(q, u, np.ones(model.nu))

# CompiledModel.jvp
change = model.jvp("forward_dynamics", wrt="u")(q, u, direction=np.ones(model.nu))

# CompiledModel.hessian
H = model.hessian("forward_dynamics", wrt=("q", "u"))(q, u, weights=np.ones(model.nu))

# CompiledModel.rhs_jacobian
dx, dt, dr = model.rhs_jacobian(0.0, x)

# CompiledModel.integrate
q_next = model.integrate(q, 0.01 * u)

# CompiledModel.difference
du = model.difference(q, q_next)

# CompiledModel.step
x_next = model.step(x, 0.01)

# CompiledModel.regressor
Y = model.regressor(q, u, udot)

# CompiledModel.energy_regressor
E = model.energy_regressor(q, u)

# CompiledModel.inertial_parameters
phi = model.inertial_parameters()

# CompiledModel.random_state
states = model.random_state(1, shape=(1000,))
print(model.rhs(0.0, states).shape)  # all functions take many states at once

# CompiledModel.screw_axis
axis = model.screw_axis("hand", q, u)

# ScrewAxis.pitch
print(axis.pitch)

# CompiledModel.with_parameters
heavy = model.with_parameters({"lower.mass": 2.0})

# CompiledModel.parameters
print(model.parameters["lower.mass"])

# Parameters.unit, Parameters.vector
print(model.parameters.unit("lower.mass"), model.parameters.vector)

# Parameters.changed
print(model.parameters.changed({"lower.mass": 2.0}))

# CompiledModel.limits
print(model.limits)

# CompiledModel.verify
print(model.verify().worst)

# Verification.worst, Verification.checked, Verification.unchecked
verification = model.verify()
print(verification.worst, verification.checked, verification.unchecked)

# CompiledModel.to_jax
jax.config.update("jax_enable_x64", True)
slope = jax.jacrev(model.to_jax("bias"), argnums=1)(q, u)

# CompiledModel.to_torch
if importlib.util.find_spec("torch"):
    bias = model.to_torch("bias")(q, u)  # takes tensors, and numbers as here

# CompiledModel.prepare
model.prepare("rhs", ("pose", "hand"))  # compile these now

# CompiledModel.lanes
print(model.lanes("rhs"))

# CompiledModel.stiffness
print(model.stiffness(x))

# Stiffness.explicit_steps, Stiffness.implicit_steps, Stiffness.implicit_pays
stiffness = model.stiffness(x)
print(stiffness.explicit_steps, stiffness.implicit_steps, stiffness.implicit_pays)

# CompiledModel.coordinates, CompiledModel.speeds, CompiledModel.internals
print(model.coordinates, model.speeds, model.internals)

# CompiledModel.inputs, CompiledModel.mode_names, CompiledModel.event_names
print(model.inputs, model.mode_names, model.event_names)

# CompiledModel.bodies, CompiledModel.frames, CompiledModel.joints
print(model.bodies, model.frames, model.joints)

# CompiledModel.nq, CompiledModel.nu, CompiledModel.nz, CompiledModel.nx
print(model.nq, model.nu, model.nz, model.nx)

# CompiledModel.nr, CompiledModel.ns, CompiledModel.nlam
print(model.nr, model.ns, model.nlam)

# CompiledModel.multipliers_of, CompiledModel.part_of
print(model.multipliers_of, model.part_of)

# CompiledModel.name, CompiledModel.manifest, CompiledModel.directory
print(model.name, model.manifest.available[:2], model.directory.is_dir())

# CompiledModel.operations, CompiledModel.source, CompiledModel.saved
print(model.operations["rhs"], len(model.source["rhs"]), model.saved)

# load_model
again = cd.load_model(model.directory)
