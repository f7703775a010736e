"""A pendulum that hits a stop, and a beam that swings: what a motion holds."""

import numpy as np

import cardan as cd

scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=cd.inertia.rod(1.0, 1.0, axis="z"))
scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
scene.force("wall", cd.Stop("pivot", lower=-0.5, restitution=0.6))
rod.at(0, 0, -1, name="tip")
model = cd.compile(scene)

# CompiledModel.simulate
motion = model.simulate(2.0, q={"pivot": 1.0}, rtol=1e-9)

# Trajectory
print(motion)

# Trajectory.x, Trajectory.q, Trajectory.u, Trajectory.z, Trajectory.s
print(motion.x.shape, motion.q.shape, motion.u.shape, motion.z.shape, motion.s.shape)

# Trajectory.nq, Trajectory.scene, Trajectory.parameters
print(motion.nq, motion.scene, motion.parameters)

# Trajectory.at
print(motion.at(0.123))

# Trajectory.resample
video = motion.resample(np.arange(0, 2, 1 / 60))

# Trajectory.pose
print(motion.pose("tip")[-1])

# Trajectory.frame_on_body
print(motion.frame_on_body("tip"))

# Trajectory.reaction
print(np.abs(motion.reaction("pivot")).max())

# Trajectory.energy, Trajectory.energy_residual
print(motion.energy.total[0], np.abs(motion.energy_residual).max())

# Trajectory.balance
print(motion.balance)

# Trajectory.work
print(motion.work)

# Trajectory.events, Trajectory.ticks
print(motion.events[0].t, len(motion.ticks))

# Trajectory.success, Trajectory.status, Trajectory.message
print(motion.success, motion.status, motion.message)

# Trajectory.statistics
print(motion.statistics)

# Trajectory.screw_axis
axis = motion.screw_axis("rod")

# Trajectory.plot
figure = motion.plot("pendulum.svg", ["pivot"])

# Trajectory.animate
page = motion.animate("pendulum.html", traces="tip")

# page
live = cd.page(cd.examples["double_pendulum"], "live.html", q={"shoulder": 1.0})

# Page.saved
print(page.saved())

# Trajectory.save
motion.save("run.nc")

# load_motion
again = cd.load_motion("run.nc")

# Trajectory.of_states
still = cd.Trajectory.of_states(model, motion.t, motion.x, motion.r, "the same states")

# Trajectory.torques
smooth = model.simulate(0.3, q={"pivot": 1.0})
print(smooth.torques().tau.shape)

# CompiledModel.stepper
stepper = model.stepper(q={"pivot": 1.0})

# Stepper.step
state = stepper.step(0.01)

# Stepper.t, Stepper.state, Stepper.events, Stepper.ticks
print(stepper.t, stepper.state, stepper.events, stepper.ticks)

# Stepper.inputs, Stepper.modes, Stepper.work
print(stepper.inputs, stepper.modes, stepper.work)

# Stepper.save, Stepper.restore
saved = stepper.save("state.npz")
stepper.restore(saved)

# CompiledModel.resume
there = model.resume("state.npz")

# CompiledModel.report
report = model.report()  # every function: operations, time and error

# Report.table
print(report.table)

# Trajectory.constraints, Trajectory.drift, Trajectory.multipliers
loop = cd.examples["four_bar"]
turning = cd.compile(loop).simulate(0.2)
print(turning.constraints.keys(), turning.drift, turning.multipliers.keys())

# Ledger.worst, Ledger.table
print(turning.drift.worst("position"), turning.drift.table.shape)

# CompiledModel.beam, CompiledModel.cable
rig = cd.Scene("rig")
steel = cd.material(E=210e9, nu=0.3, rho=7850, damping=1e-3)
tube = cd.section.tube(outer=0.02, inner=0.018)
pole = rig.beam("pole", rig.ground, (1, 0, 0), section=tube, material=steel, elements=4)
rig.cable("stay", (0, 0, 0.5), pole.end, EA=1e5, rhoA=0.05, tension=5.0, elements=2)
swaying = cd.compile(rig)
q = swaying.split(swaying.initial())[0]
print(swaying.beam("pole", q), swaying.cable("stay", q))

# CableTension.taut
print(swaying.cable("stay", q).taut)

# Trajectory.beam, Trajectory.cable
sway = swaying.simulate(0.05, rtol=1e-4)
print(sway.beam("pole").extreme.max(), sway.cable("stay").tension.max())

# BeamStress.extreme, BeamStress.extreme_at_nodes, BeamStress.extreme_strain
stress = sway.beam("pole")
print(stress.extreme.shape, stress.extreme_at_nodes.shape, stress.extreme_strain.shape)

# BeamStress.normal_stress
print(stress.normal_stress(0.0, 0.02).shape)

# Trajectory.line, Trajectory.sections
print(sway.line("pole").shape, sway.sections("pole").shape)

# Trajectory.to_pandas
try:
    print(motion.to_pandas().shape)
except cd.CardanError as problem:  # needs pandas
    print(problem)

# Trajectory.to_xarray
try:
    print(motion.to_xarray())
except cd.CardanError as problem:  # needs the extra "data"
    print(problem)
