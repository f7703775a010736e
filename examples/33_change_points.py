"""A linkage with all its branches: three cranks, four ways to assemble them, two change points.

Run it anywhere; it writes into ``out/change_points``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/change_points")
out.mkdir(parents=True, exist_ok=True)
CRANK, GROUND, TURN = 0.6, 1.1, 2 * np.pi

# Two parallelograms in a row: the follower of the first is the crank of the second.
scene = cd.Scene("change_points", gravity=(0, 0, 0))
hinge, cranks = cd.Revolute("z"), []
for k in range(3):
    rod = cd.inertia.rod(1.0, CRANK, axis="x")
    cranks.append(scene.body(f"crank{k}", mass=1.0, com=(CRANK / 2, 0, 0), inertia=rod))
    scene.joint(f"A{k}", hinge, scene.ground.at(k * GROUND, 0, 0), cranks[k])
for k in range(2):
    rod = cd.inertia.rod(1.0, GROUND, axis="x")
    coupler = scene.body(f"coupler{k}", mass=1.0, com=(GROUND / 2, 0, 0), inertia=rod)
    scene.joint(f"B{k}", hinge, cranks[k].at(CRANK, 0, 0), coupler)
    scene.joint(f"C{k}", hinge, coupler.at(GROUND, 0, 0), cranks[k + 1].at(CRANK, 0, 0))
model = cd.compile(scene)

# One turn of the first crank, begun where all cranks are parallel. Where all links lie on one line
# both loops lose rank, and four assemblies meet.
begin = {"A0": 0.5, "A1": 0.5, "A2": 0.5, "B0": -0.5, "B1": -0.5}
path = model.continuation(A0=(0.5, 0.5 + TURN), of="positions", q=begin, branches=True)
print(path)
path.plot("A0", "A2", out / "branches.png")

# Directions at such a point: A1 / A0 is 1, or -(d - a) / (d + a) where the loop is crossed.
flat = path.point("branch point 1")
crossed = -(GROUND - CRANK) / (GROUND + CRANK)
names = [name.removesuffix(".u") for name in model.speeds]
a0, a1, a2 = (flat.tangents[:, names.index(name)] for name in ("A0", "A1", "A2"))
print(f"of a crossed loop: {crossed:.6f}; A1 / A0 and A2 / A1 of the branches:")
for first, second in zip(a1 / a0, a2 / a1, strict=True):
    print(f"  {first:9.6f} {second:9.6f}")

# Along a crossed loop: tan(A1 / 2) = -(d + a) / (d - a) tan(A0 / 2).
for name, branch in path.branches.items():
    sides = [
        (GROUND - CRANK) * np.sin(branch[f"A{k + 1}"] / 2) * np.cos(branch[f"A{k}"] / 2)
        + (GROUND + CRANK) * np.cos(branch[f"A{k + 1}"] / 2) * np.sin(branch[f"A{k}"] / 2)
        for k in range(2)
    ]
    kinds = ["crossed" if np.abs(side).max() < 1e-9 else "parallel" for side in sides]
    print(f"  {name:5s} {' and '.join(kinds)}, A0 from {branch['A0'][0]:.3f} to "
          f"{branch['A0'][-1]:.3f}")  # fmt: skip

# Any position starts a run: the last assembly turns at 2 rad/s.
position = path.branches["1a"][-1]
motion = model.simulate(3.0, q=position.q, u={"A0": 2.0})
motion.animate(out / "crossed.html")
print(motion)
