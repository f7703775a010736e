"""A bar of beams, reduced to its ends and some modes, in a scene."""

import numpy as np

import cardan as cd

drawing = cd.Scene("drawing", gravity=(0, 0, 0))
steel = cd.material(E=210e9, nu=0.3, rho=7850)
square = cd.section.rectangle(width=0.02, height=0.01)
drawing.beam("bar", drawing.ground, (1, 0, 0), section=square, material=steel, elements=8)

# superelement, superelement.from_beams
bar = cd.superelement.from_beams(drawing, "bar", modes=4)

# superelement.Superelement
print(isinstance(bar, cd.superelement.Superelement), bar)

# superelement.read
matrices = cd.superelement.read("bar.sti")  # with bar.mas, bar.dof and bar.inp beside it

# superelement.ComponentMatrices
print(isinstance(matrices, cd.superelement.ComponentMatrices))

# superelement.ComponentMatrices.reduce
faces = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}
reduced = matrices.reduce(faces, modes=8, damping=0.01)

# superelement.reduce
again = cd.superelement.reduce(
    matrices.M, matrices.K, matrices.nodes, faces, modes=8,
    node_ids=matrices.node_ids, dofs=matrices.dofs,
)  # fmt: skip

# superelement.Superelement.save, superelement.load
path = reduced.save("bar.npz")
same = cd.superelement.load("bar.npz")

# superelement.from_mesh
nylon = cd.material(E=2e9, nu=0.4, rho=1150, damping=1e-4)
ends = {"root": "root", "pin": "hole"}
lug = cd.superelement.from_mesh("lug.inp", nylon, ends, modes=4, stress="lug", scale=5e-3)

# superelement.InterfaceFrame, superelement.InterfaceFrame.labels
print(isinstance(lug.interfaces[0], cd.superelement.InterfaceFrame), lug.interfaces[0].labels)

# superelement.Superelement.interface, superelement.Superelement.labels
print(lug.interface("pin").position, lug.labels[:3])

# superelement.Superelement.n, superelement.Superelement.n_boundary
print(lug.n, lug.n_boundary)

# superelement.Superelement.modes, superelement.ReducedModes
supported = lug.modes(locked=["root"])
print(isinstance(supported, cd.superelement.ReducedModes), supported.frequencies)

# superelement.Superelement.cost, superelement.ReductionCost
print(isinstance(lug.cost, cd.superelement.ReductionCost), lug.cost)

# superelement.Superelement.admittance, superelement.Superelement.impedance
print(reduced.admittance([500.0]).shape, reduced.impedance([500.0]).shape)

# superelement.Superelement.displacements, superelement.Superelement.surface_displacements
z = np.zeros(lug.n)
print(lug.displacements(z).shape, lug.surface_displacements(z).shape)

# superelement.Superelement.stresses
print(lug.stresses(z).shape)

# superelement.Superelement.gravity, superelement.Superelement.rigid_motions
print(lug.gravity.shape, lug.rigid_motions().shape)

# superelement.Superelement.section_forces
print(bar.section_forces(np.zeros(bar.n), "bar"))

# superelement.Superelement.surface_points, superelement.Superelement.surface_basis
print(lug.surface_points.shape, lug.surface_basis.shape)

# superelement.Surface, superelement.Surface.points, superelement.Surface.basis
assert isinstance(lug.surface, cd.superelement.Surface)
print(lug.surface.points(lug.dofs).shape, lug.surface.basis(lug.basis, lug.dofs).shape)

# superelement.ProjectedInertia, superelement.ProjectedInertia.n
print(isinstance(lug.inertia, cd.superelement.ProjectedInertia), lug.inertia.n)

# superelement.ProjectedInertia.matrix, superelement.ProjectedInertia.drift
print(lug.inertia.matrix().shape, lug.inertia.drift)

# superelement.Superelement.animate
lug.animate(1, "mode.html", locked=["root"])

# superelement.Superelement.plot
lug.plot(1, "mode.png", locked=["root"])

# superelement.Superelement.load_stress
warm = cd.material(E=2e9, nu=0.4, rho=1150, expansion=8e-5)
part = cd.superelement.from_mesh("lug.inp", warm, ends, modes=4, stress="lug", scale=5e-3)
print(part.load_stress("temperature").shape)

robot = cd.Scene("robot", gravity=(0, -9.81, 0))
link = robot.superelement("link", lug, {"root": robot.ground}, frame="root")
robot.joint(
    "pin",
    cd.Revolute("z"),
    link.at("pin"),
    robot.body("load", mass=1.0, inertia=(0.01, 0.01, 0.01)),
)
model = cd.compile(robot)
q, u = model.split(model.initial())

# CompiledModel.superelement
shape = model.superelement("link", q)

# CompiledModel.superelement_parts, SuperelementParts
parts = model.superelement_parts("link", q)

# SuperelementParts.total
print(parts.total("K"))

# Trajectory.superelement, DeformedSuperelement
shape = model.simulate(0.01).superelement("link")

# DeformedSuperelement.largest_stress, DeformedSuperelement.stress, DeformedSuperelement.von_mises
print(shape.largest_stress.shape, shape.stress.shape, shape.von_mises.shape)

# DeformedSuperelement.amplitudes
print(shape.amplitudes.shape)

# DeformedSuperelement.displacements, DeformedSuperelement.positions
print(shape.displacements.shape, shape.positions.shape)

# DeformedSuperelement.triangles, DeformedSuperelement.lines, DeformedSuperelement.stressed
print(shape.triangles.shape, shape.lines.shape, shape.stressed.shape)

# DeformedSuperelement.check_stress
shape.check_stress()  # an error where the record has no stresses

# DeformedSuperelement.plot
shape.plot("shape.png")
