"""Every error says what, where and what to do."""

import warnings

import cardan as cd

scene = cd.Scene("arm")
arm = scene.body("arm", mass=1.0, com=(0, 0, -0.5))
scene.joint("elbow", cd.Revolute("y"), scene.ground, arm)

# ModelError
try:
    scene.joint("wrist", cd.Revolute("y"), "arn", arm)
except cd.ModelError as problem:
    print(problem)

# CardanError
try:
    cd.load("nothing.yaml")
except cd.CardanError as problem:  # the base of them all
    print(problem)

# TopologyError
try:
    loose = cd.Scene("loose")
    loose.body("adrift", mass=1.0)
    cd.derive(loose)
except cd.TopologyError as problem:
    print(problem)

# DerivationError
try:
    cd.derive(scene, method="newton")
except cd.DerivationError as problem:
    print(problem)

# CodegenError
try:
    cd.derive(scene).export("out", language="fortran")
except (cd.CodegenError, cd.CardanError) as problem:
    print(problem)

# BuildError, CompilerMissing
print(issubclass(cd.CompilerMissing, cd.BuildError))

# ArgumentError
model = cd.compile(scene)
try:
    model.forward_dynamics([0.1, 0.2], [0.0])
except cd.ArgumentError as problem:
    print(problem)

# FunctionError
try:
    model.simulate(1.0, events={"broken": lambda t, x: 1 / 0})
except (cd.FunctionError, cd.CardanError) as problem:
    print(problem)

# SolveError
try:
    model.forward_dynamics([float("nan")], [0.0])
except cd.SolveError as problem:
    print(problem)

# ModelWarning, BuildWarning, SolveWarning
for category in (cd.ModelWarning, cd.BuildWarning, cd.SolveWarning):
    warnings.simplefilter("error", category)  # or "ignore"
