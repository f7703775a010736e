"""A rotor between two bearings: whirl over its speed, critical speeds, the limit of stability.

Run it anywhere; it writes into ``out/campbell``.

Source: G. Genta, Dynamics of Rotating Systems (2005), chapters 2 and 4.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/campbell")
out.mkdir(parents=True, exist_ok=True)

# A disk off the middle of a light shaft: it moves across and tilts, and both are coupled.
m, transverse, polar = 4.0, 0.05, 0.08
scene = cd.Scene("rotor", gravity=(0, 0, 0))
across, along, tilted = (scene.body(name, mass=0, inertia=(0, 0, 0)) for name in "abc")
shaft = scene.body("shaft", mass=0, inertia=(0, 0, 0))
disk = scene.body("disk", mass=m, inertia=(transverse, transverse, polar))
scene.joint("x", cd.Prismatic("x"), scene.ground, across)
scene.joint("y", cd.Prismatic("y"), across, along)
scene.joint("tilt", cd.Revolute("x"), along, tilted)
scene.joint("lean", cd.Revolute("y"), tilted, shaft)
scene.joint("spin", cd.Revolute("z"), shaft, disk)

# Stiffness of the shaft at the disk, dampers of the bearings, and damping inside the shaft.
k, coupling, turning = 4e5, 2e4, 8e3
outer = scene.parameter("outer", 60.0)
inner = scene.parameter("inner", 20.0)
q = {name: scene.q(name) for name in ("x", "y", "tilt", "lean")}
u = {name: scene.u(name) for name in ("x", "y", "tilt", "lean", "spin")}
pairs = {
    "x": k * q["x"] + coupling * q["lean"],
    "y": k * q["y"] - coupling * q["tilt"],
    "tilt": turning * q["tilt"] - coupling * q["y"],
    "lean": turning * q["lean"] + coupling * q["x"],
}
inside = {"x": u["x"] + u["spin"] * q["y"], "y": u["y"] - u["spin"] * q["x"]}
for name, elastic in pairs.items():
    force = -elastic
    if name in inside:
        force += -outer * u[name] - inner * inside[name]
    scene.force(f"on_{name}", cd.JointForce(name, force))
model = cd.compile(scene)

# Every speed has its own linear model; motions are followed from one to the next.
diagram = model.campbell(spin=(0, 1500), count=51)
print(diagram)
diagram.plot(out / "campbell.png", orders=(1, 2))
diagram.locus.plot(out / "locus.png")

# Without dampers in the shaft it is stable at all speeds, with them up to a limit.
(limit,) = diagram.locus.changes
print(f"{limit.kind} from {limit.values['spin']:.1f} rad/s on, at {limit.frequency:.1f} rad/s")
quiet = model.campbell(spin=(0, 1500), count=21, parameters={"inner": 0.0})
assert not quiet.locus.changes

# What the limit depends on: derivatives of the eigenvalue that grows there.
there = model.equilibrium(u={"spin": limit.values["spin"]})
change = model.sensitivity(["outer", "inner", "disk.mass"], there)
top = int(np.abs(change.eigenvalues - 1j * limit.frequency).argmin())
for name in change.parameters:
    print(f"growth by {name}: {change[name][top].real:.4g} 1/s for each unit")

# The same from a linear model: what the shaft does to the disk falls apart into four parts.
parts = model.linearize(there).second_order(["x", "y", "tilt", "lean"])
print(f"circulatory force {np.abs(parts.circulatory).max():.0f} N/m, against")
print(f"damping {np.abs(parts.dissipative).max():.0f} N s/m and stiffness {k:.0f} N/m")
