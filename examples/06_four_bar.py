"""A four-bar linkage: a loop that closes itself, its branches, its forces.

Run it anywhere; it writes into ``out/four_bar``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/four_bar")
out.mkdir(parents=True, exist_ok=True)

# Links in the x-y plane, along x where all angles are 0. Joints are declared as for a tree.
scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
links = {}
for name, length in {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}.items():
    rod = cd.inertia.box(length, length, 0.02, 0.01)
    links[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=rod)
crank, coupler, rocker = links.values()
scene.joint("A", cd.Revolute("z"), scene.ground, crank)
scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler)
scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker)
scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0))

# The equations say which joint closes the loop, why, and what that holds.
equations = cd.derive(scene)
print(equations)
model = cd.compile(equations)

# A crank angle leaves two ways to assemble the links; a branch chooses one.
for side in "+-":
    found = model.assemble({"A": 0.5}, branch={"B": side})
    print(f"B {side}: ", *(f"{x:.4f}" for x in found.q))

# The crank turns at 8 rad/s and is left to itself; named values are held, the rest follows.
motion = model.simulate(2.0, q={"A": 0.5}, u={"A": 8.0}, rtol=1e-9)
print(motion)
motion.animate(out / "four_bar.html")

# The joint that was cut has reactions like any other.
forces = model.reaction("C", motion.q, motion.u)[:, 3:]
print(f"largest force in C: {np.linalg.norm(forces, axis=1).max():.3f} N")

# Wherever the loop is cut and however it is treated, it moves in one way.
for treatment in ("multipliers", "elimination", "null_space"):
    other = cd.compile(cd.derive(scene, constraints=treatment))
    end = other.simulate(2.0, q={"A": 0.5}, u={"A": 8.0}, rtol=1e-9)["A"][-1]
    print(f"{treatment:12s} A = {end:.6f}")
    assert abs(end - motion["A"][-1]) < 1e-5

# The minimal form has one coordinate and one speed.
partition = model.partition(motion.q[0])
print(partition)
print("derivative of", partition.reduce(motion.x[0]), "is", end=" ")
print(model.reduced_rhs(0.0, partition.reduce(motion.x[0]), partition))
