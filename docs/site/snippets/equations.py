"""The equations of an arm with a spring, as formulas."""

import cardan as cd

scene = cd.Scene("arm", gravity=(0, 0, -9.81))
m = scene.parameter("m", 1.0, unit="kg")
arm = scene.body("arm", mass=m, com=(0, 0, -0.5), inertia=cd.inertia.rod(m, 1.0, axis="z"))
scene.joint("elbow", cd.Revolute("y"), scene.ground, arm)
scene.force("spring", cd.JointSpring("elbow", stiffness=2.0))

# derive
equations = cd.derive(scene, method="kane")

# Equations
print(equations)

# Equations.mass_matrix, Equations.bias, Equations.forces
print(equations.mass_matrix, equations.bias, equations.forces)

# Equations.kinematics
print(equations.kinematics)

# Equations.coordinates, Equations.speeds, Equations.inputs
print(equations.coordinates, equations.speeds, equations.inputs)

# Equations.parameters, Equations.multipliers, Equations.symbols
print(equations.parameters, equations.multipliers, equations.symbols)

# Equations.regressor, Equations.inertial_parameters
print(equations.regressor.shape, equations.inertial_parameters)

# Equations.base_parameters
print(equations.base_parameters().combinations)

# Equations.contributions
for part in equations.contributions("mass_matrix"):
    print(part.owner)

# Equations.symbolic
replacements, (M,) = (equations.symbolic("mass_matrix")[0], [equations.symbolic("mass_matrix")[1]])

# Equations.named
formulas, M = equations.named("mass_matrix")

# Equations.written
print(equations.written("mass_matrix"))

# Equations.linearize
linear = equations.linearize({"elbow": 0})

# Linearized.A, Linearized.B, Linearized.C, Linearized.D
print(linear.A, linear.B, linear.C, linear.D)

# Linearized.M, Linearized.K, Linearized.damping, Linearized.forces
print(linear.M, linear.K, linear.damping, linear.forces)

# Linearized.gyroscopic, Linearized.circulatory
print(linear.gyroscopic, linear.circulatory)

# Linearized.conservative, Linearized.dissipative
print(linear.conservative, linear.dissipative)

# Linearized.coordinates, Linearized.speeds, Linearized.along, Linearized.needed
print(linear.coordinates, linear.speeds, linear.along, linear.needed)

# Equations.linearize_along
motion = cd.compile(scene).simulate(1.0, q={"elbow": 0.5})
along = equations.linearize_along(motion)

# Equations.classification, Equations.conserved
print(equations.classification(), equations.conserved())

# Conserved.names, Conserved.energy_statement
print(equations.conserved().names, equations.conserved().energy_statement())

# Equations.operations, Equations.operations_of
print(equations.operations["forward_dynamics"], equations.operations_of("rhs"))

# Equations.sources
print(equations.sources)

# Equations.formalism, Equations.blocks, Equations.names
print(equations.formalism.name, list(equations.blocks), equations.names()[:3])

# Equations.to_sympy
mechanics = equations.to_sympy()

# Mechanics.mass_matrix_full, Mechanics.forcing_full, Mechanics.kindiffdict, Mechanics.rhs
print(mechanics.mass_matrix_full, mechanics.forcing_full, mechanics.kindiffdict(), mechanics.rhs())

# Equations.function, Equations.derivative
rhs = equations.function("rhs")
jacobian = equations.derivative("forward_dynamics", wrt=("q", "u"))

# Function.operations, Function.cost, Function.critical_path
print(rhs.operations, rhs.cost, rhs.critical_path)

# Function.live, Function.roots
print(len(rhs.live()), len(rhs.roots))

# Equations.form, Equations.loops, Equations.refusal, Equations.ways
print(equations.form("rhs"), equations.loops("rhs"), equations.ways("rhs", None))
print(equations.refusal("mass_matrix"))

# Equations.notes, Equations.c_name
print(equations.notes("rhs", None, equations.form("rhs")), equations.c_name("rhs"))

# Equations.named_function
function, coefficients = equations.named_function("mass_matrix")

# Equations.recursion
chain = cd.derive(scene, method="articulated").recursion("forward_dynamics")

# Equations.rewritten, Equations.with_rewrites, Equations.without_rewrites
print(equations.rewritten("rhs"), equations.with_rewrites(()), equations.without_rewrites)

# Equations.fresh, Equations.gain, Equations.follows
print(equations.fresh, equations.gain, equations.follows)

# Equations.explain
equations.explain("arm.html")  # or .md, .tex: a page with all formulas and where terms come from

# Equations.export
equations.export("arm_c", functions=["forward_dynamics", "mass_matrix"])
equations.export("arm_wasm", ["rhs"], language="wasm")  # for node and pages

# Equations.constraints, Equations.constraint_jacobian, Equations.constraint_bias
loop = cd.derive(cd.examples["four_bar"])
print(loop.constraints.shape, loop.constraint_jacobian.shape, loop.constraint_bias.shape)

# Equations.feasibility
print(loop.feasibility())

# Equations.constraint_rows
print(loop.constraint_rows[0])

# vectors
v = cd.vectors(equations)

# Vectors.position, Vectors.velocity, Vectors.acceleration
print(v.position("arm"), v.velocity("arm"), v.acceleration("arm"))

# Vectors.angular_velocity, Vectors.angular_acceleration, Vectors.rotation
print(v.angular_velocity("arm"), v.angular_acceleration("arm"), v.rotation("arm"))

# Vectors.center_of_mass, Vectors.mass, Vectors.inertia
print(v.center_of_mass("arm"), v.mass("arm"), v.inertia("arm"))

# Vectors.axes, Vectors.vector, Vectors.frames
print(v.axes("arm"), v.vector((1, 0, 0)), v.frames)

# Vectors.gravity, Vectors.identity, Vectors.path_vectors, Vectors.augmented_bodies
print(v.gravity, v.identity, v.path_vectors("arm"), v.augmented_bodies())

# FiniteElementEquations
nodes = cd.derive(scene, coordinates="absolute")

# FiniteElementEquations.coordinates
print(nodes.coordinates)
