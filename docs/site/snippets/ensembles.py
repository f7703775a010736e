"""A hundred pendulums that differ."""

import cardan as cd

scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
m = scene.parameter("m", 1.0, unit="kg")
rod = scene.body("rod", mass=m, com=(0, 0, -0.5), inertia=cd.inertia.rod(m, 1.0, axis="z"))
scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
model = cd.compile(scene)

# CompiledModel.ensemble
plan = cd.sample.random(100, {"m": cd.sample.normal(1, 0.1), "pivot": (-1, 1)}, seed=1)
runs = model.ensemble(1.0, vary=plan, reduce=["max of pivot"])

# Ensemble
print(runs["max of pivot"].shape)

# Ensemble.q, Ensemble.u, Ensemble.t
print(runs.q.shape, runs.u.shape, runs.t.shape)

# Ensemble.success, Ensemble.status, Ensemble.finished, Ensemble.done, Ensemble.interrupted
print(runs.success, runs.status[0], runs.finished.all(), runs.done, runs.interrupted)

# Ensemble.varied
print(runs.varied["m"][:3])

# Ensemble.sensitivity, RunSensitivities
few = model.ensemble(0.5, vary={"m": [1.0, 1.2]}, sensitivity="m")
print(few.sensitivity["m"].shape)  # (runs, times, states)
print(few.sensitivity.of("energy")["m"].shape)  # (runs, times)

# Ensemble.statistics
print(runs.statistics.keys())

# Ensemble.message
print(runs.message(17))

# Ensemble.run
one = runs.run(17)  # that run again, with all it holds

# Ensemble.job
print(runs.job)

# Ensemble.save
runs.save("runs.nc")

# load_ensemble
again = cd.load_ensemble("runs.nc")

# Ensemble.part, Ensemble.join
for k in (1, 2):  # each in a job of its own
    part = model.ensemble(1.0, vary=plan, part=(k, 2), checkpoint=f"runs-{k}.part")
    print(part.part)
whole = cd.Ensemble.join("runs-*.part")

# Ensemble.of
print(cd.Ensemble.of.__doc__)  # called by the runner

# Ensemble.to_xarray
try:
    print(runs.to_xarray())
except cd.CardanError as problem:  # needs the extra "data"
    print(problem)
