"""Inertias, shapes, sections, lines, orbits; how constraints are treated; samples; methods."""

from pathlib import Path

import numpy as np

import cardan as cd

# inertia
mass, ball = 2.0, cd.inertia.sphere(2.0, radius=0.1)

# inertia.box
crate = cd.inertia.box(mass, x=0.4, y=0.3, z=0.2)

# inertia.cylinder
drum = cd.inertia.cylinder(mass, radius=0.1, length=0.4, axis="y")

# inertia.rod
rod = cd.inertia.rod(mass, length=1.0, axis="z")

# inertia.sphere
marble = cd.inertia.sphere(mass, radius=0.05)

# inertia.tube
pipe = cd.inertia.tube(mass, outer=0.05, inner=0.04, length=1.0)

# shape, shape.box
scene = cd.Scene("shapes")
box = cd.shape.box(0.4, 0.3, 0.2, color=(0.8, 0.2, 0.2))
crate = scene.body("crate", mass=1.0, shape=box)

# shape.capsule, shape.cylinder
looks = [cd.shape.capsule(0.05, 0.5), cd.shape.cylinder(0.1, 0.3, axis="x")]

# shape.sphere
looks.append(cd.shape.sphere(0.1, position=(0, 0, 0.3)))

# shape.mesh
looks.append(cd.shape.mesh("hand.stl", scale=(1e-3, 1e-3, 1e-3)))

# shape.Shape
print(isinstance(box, cd.shape.Shape), box.kind)

# section, section.circle
round_bar = cd.section.circle(radius=0.02)

# section.tube
tube = cd.section.tube(outer=0.05, inner=0.04)

# section.rectangle
plank = cd.section.rectangle(width=0.3, height=0.05)

# section.hollow_rectangle
profile = cd.section.hollow_rectangle(width=0.1, height=0.06, thickness=0.004)

# section.i_beam
girder = cd.section.i_beam(width=0.1, height=0.2, flange=0.0085, web=0.0056)

# section.general
blade = cd.section.general(EA=1e8, GA=(3e7, 3e7), GJ=1e5, EI=(2e5, 4e5), rhoA=9.0, rhoI=(0.1, 0.2))

# section.Section
print(isinstance(tube, cd.section.Section))

# material
steel = cd.material(E=210e9, nu=0.3, rho=7850, damping=1e-4)

# Material
print(steel.E, steel.rho)

# Material.elastic, Material.quantities
print(steel.elastic, list(steel.quantities()))

# arc
bow = cd.Scene("bow")
line = cd.arc(through=(1, 0, 0.5))
bow.beam("limb", bow.ground, (2, 0, 0), section=plank, material=steel, line=line, elements=4)

# spline
hook = cd.Scene("hook")
bent = cd.spline([(0, 0, 0), (0.3, 0, 0.2), (0.6, 0, 0.1), (1, 0, 0)])
hook.beam("wire", hook.ground, (1, 0, 0), section=round_bar, material=steel, line=bent)

# orbit, orbit.circular
space = cd.Scene("space", gravity=(0, 0, 0))
orbiting = cd.orbit.circular(space, "orbiting", mu=3.986e14, radius=7e6)

# orbit.attitude, orbit.axes
satellite = space.body("satellite", mass=100.0, inertia=(10.0, 20.0, 25.0))
space.joint("flight", cd.Free(), orbiting, satellite)
roll, pitch, yaw = cd.orbit.attitude(satellite)
print(cd.orbit.axes(satellite).shape)

# constraints
four_bar = cd.examples["four_bar"]
equations = cd.derive(four_bar, constraints=cd.constraints.Penalty(1e8))

# constraints.Multipliers
exact = cd.derive(four_bar, constraints=cd.constraints.Multipliers())

# constraints.Elimination
eliminated = cd.derive(four_bar, constraints=cd.constraints.Elimination())

# constraints.NullSpace
projected = cd.derive(four_bar, constraints=cd.constraints.NullSpace())

# constraints.Baumgarte
stabilized = cd.derive(four_bar, constraints=cd.constraints.Baumgarte(frequency=20.0, damping=1.0))

# constraints.Penalty
springs = cd.derive(four_bar, constraints=cd.constraints.Penalty(weight=1e7))

# constraints.Augmented
repeated = cd.derive(four_bar, constraints=cd.constraints.Augmented(repetitions=2))

# constraints.Perturbed
regular = cd.derive(four_bar, constraints=cd.constraints.Perturbed(compliance=1e-8))

# constraints.treatment, constraints.Treatment
chosen = cd.constraints.treatment("baumgarte")
print(isinstance(chosen, cd.constraints.Treatment))

# constraints.Bound, constraints.Labels
print(cd.constraints.Bound.__name__, cd.constraints.Labels())  # what a treatment of your own reads

# sample, sample.normal
masses = cd.sample.normal(mean=1.0, deviation=0.05)

# sample.uniform
angles = cd.sample.uniform(-0.2, 0.2)

# sample.log_uniform
stiffnesses = cd.sample.log_uniform(1e2, 1e4)

# sample.random
plan = cd.sample.random(100, {"m": masses, "k": stiffnesses}, seed=1)

# sample.sobol
even = cd.sample.sobol(128, {"m": masses, "k": stiffnesses})

# sample.latin_hypercube
spread = cd.sample.latin_hypercube(100, {"m": masses, "k": stiffnesses})

# sample.grid
mesh = cd.sample.grid(m=[1.0, 2.0], k=[100.0, 200.0, 300.0])

# sample.Plan
print(isinstance(mesh, cd.sample.Plan))

# sample.Plan.names
print(mesh.names)

# sample.Normal, sample.Uniform, sample.LogUniform
print(cd.sample.Normal(1.0, 0.1), cd.sample.Uniform(0.0, 1.0), cd.sample.LogUniform(1.0, 10.0))

# sample.Normal.ppf, sample.Uniform.ppf, sample.LogUniform.ppf
print(masses.ppf(0.9), angles.ppf(0.5), stiffnesses.ppf(0.5))

# sample.Distribution.ppf
print(cd.sample.Distribution.ppf.__doc__)  # what a distribution of your own has

# sample.Distribution, sample.distribution
print(isinstance(cd.sample.distribution("m", masses), cd.sample.Distribution))

# sample.drawn, sample.checked_seed
print(cd.sample.drawn("m", masses, 5, cd.sample.checked_seed(1)).shape)

# CFunction
Path("push.c").write_text("""
int push(double t, const double *x, const double *reads, double *gives)
{
    gives[0] = 1.0 - t;
    return 0;
}
""")
law = cd.CFunction("push.c")  # simulate(inputs={"thrust": law}); it runs with your permissions
print(law.name, law.reads)

# GeneralizedAlpha
method = cd.GeneralizedAlpha(rho_inf=0.8)

# GeneralizedAlpha.alpha
print(method.alpha)

# Alpha
print(cd.stability.Alpha(am=0.0, af=0.0, beta=0.25, gamma=0.5).order)

# Alpha.newmark, Alpha.hht, Alpha.chung_hulbert
print(
    cd.stability.Alpha.newmark(),
    cd.stability.Alpha.hht(-0.1),
    cd.stability.Alpha.chung_hulbert(0.8),
)

# Alpha.order, Alpha.rho_inf, Alpha.shift
print(method.alpha.order, method.alpha.rho_inf, method.alpha.shift)

# stability, stability.spectral_radius
print(cd.stability.spectral_radius(method, [0.1, 1.0, 1e6]))

# stability.amplification
print(cd.stability.amplification(method, [0.1]).shape)

# stability.period_error
print(cd.stability.period_error(method, [0.1]))

# stability.response
print(abs(cd.stability.response("RK4", np.array([-1.0, -3.0]))))

# stability.stable_along
print(cd.stability.stable_along("RK4", -1))
