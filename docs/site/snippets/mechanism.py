"""A four-bar linkage: loops, assembly, drives, positions of rest."""

import numpy as np

import cardan as cd

scene = cd.examples["four_bar"]
model = cd.compile(scene)
driver, other = model.coordinates[0], model.coordinates[-1]
q, u = model.split(model.assemble({driver: 0.5}, u={driver: 3.0}).x)
t = 0.0

# CompiledModel.assemble
found = model.assemble({driver: 0.5}, u={driver: 3.0})

# Assembly
print(found)

# Assembly.x, Assembly.coordinates, Assembly.speeds, Assembly.name
print(found.x, found.coordinates, found.speeds, found.name)

# Assembly.animate
found.animate("found.html")

# CompiledModel.constraints
g = model.constraints(q)

# CompiledModel.constraint_rates
rates = model.constraint_rates(q, u)

# CompiledModel.constraint_jacobian
G = model.constraint_jacobian(q)

# CompiledModel.closure
gaps = model.closure(q)

# CompiledModel.assembly_signs
print(model.assembly_signs(q))

# CompiledModel.multipliers
lam = model.multipliers(q, u)

# CompiledModel.close_position
closer = model.close_position(q)[: model.nq]

# CompiledModel.close_velocity
speeds = model.close_velocity(q, u)[: model.nu]

# CompiledModel.sweep
turn = model.sweep(driver, np.linspace(0.5, 1.5, 11), rate=10.0)

# Sweep.values, Sweep.minimum, Sweep.success
print(turn.values.shape, turn.minimum, turn.success)

# Sweep.pose
print(turn.pose(model.bodies[-1]).shape)

# Sweep.plot, Sweep.animate
turn.plot("turn.svg")
turn.animate("turn.html")

# CompiledModel.singular_positions
dead = model.singular_positions(driver, (0.2, 6.2), driver=other)

# Singular.values
print(dead.values)

# CompiledModel.workspace
reach = model.workspace(model.bodies[-1], samples=50)

# Workspace.box, Workspace.plot
print(reach.box)
reach.plot("reach.svg")

# CompiledModel.redundancy
print(model.redundancy(q).freedoms)

# Redundancy.joints, Redundancy.redundant, Redundancy.undetermined
loops = model.redundancy(q)
print(loops.joints, loops.redundant, loops.undetermined)

# Redundancy.released
print(loops.released(next(iter(loops.joints))))

# CompiledModel.actuation
drive = model.actuation(q, u, model.forward_dynamics(q, u), [driver])

# Actuation.unique
print(drive.unique)

# CompiledModel.hybrid_dynamics
given = model.hybrid_dynamics(q, u, {driver: 2.0})

# CompiledModel.partition
partition = model.partition(q)

# Partition.reduce, Partition.full
y = partition.reduce(np.concatenate([q, u]))
x = partition.full(t, y)

# CompiledModel.reduced_rhs
ydot = model.reduced_rhs(t, y, partition)

# Partition.rhs
print(partition.rhs(t, y))

# CompiledModel.residual
udot = model.forward_dynamics(q, u)
rest = model.residual(t, q, u, udot, lam, qdot=model.qdot(q, u))

# CompiledModel.dependents
closed_form = cd.compile(scene, constraints="closed_form")
print(closed_form.dependents(closed_form.initial()[: closed_form.nq], np.zeros(closed_form.nu)))
