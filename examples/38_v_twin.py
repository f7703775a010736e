"""A V-twin engine: two slider-cranks of the library on one shaft.

Run it anywhere; it writes into ``out/v_twin``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/v_twin")
out.mkdir(parents=True, exist_ok=True)

# The cylinders lie 90 degrees apart: each part gets a frame whose x is the line of its piston.
scene = cd.Scene("v_twin")
banks = {"right": np.pi / 4, "left": 3 * np.pi / 4}
for k, (name, angle) in enumerate(banks.items()):
    line = scene.ground.at(0, 0.05 * k, 0, rotation=("XYZ", 0, -angle, 0))
    scene.include(cd.parts.slider_crank(rod_length=0.2), prefix=name, at=line)

# One shaft: both cranks point in the same direction.
turn = scene.q("right.crank") - scene.q("left.crank")
scene.constraint("shaft", turn - np.pi / 2, "rad")
print(scene)

# Gas pushes each piston for half a turn, and a brake on the shaft takes what that gives.
model = cd.compile(scene)
places = {name: model.coordinates.index(f"{name}.crank") for name in banks}


def gas(name: str) -> object:
    return lambda t, x: -300.0 if np.sin(x[places[name]]) > 0 else 0.0


inputs = {f"{name}.force": gas(name) for name in banks} | {"right.torque": -9.0}
start = {"q": {"right.crank": 0.6}, "u": {"right.crank": 60.0}}
motion = model.simulate(1.0, **start, inputs=inputs, sample=1e-3, rtol=1e-8)
print(motion)
motion.animate(out / "v_twin.html")

# Both pistons are where the lengths of their parts put them.
r, l = (model.parameters[f"right.{name}_length"] for name in ("crank", "rod"))
for name in banks:
    angle = motion[f"{name}.crank"]
    x = r * np.cos(angle) + np.sqrt(l**2 - (r * np.sin(angle)) ** 2)
    print(f"{name}: piston within {np.abs(motion[f'{name}.piston.x'] - x).max():.1e} m")
    assert np.abs(motion[f"{name}.piston.x"] - x).max() < 1e-8

# Why 90 degrees: together the pistons shake by a vector that turns with the crank, so that a weight
# on the crank balances it; what stays is of the rods' finite length. One alone shakes to and fro.
speeds = np.array([motion[f"{name}.piston.u"] for name in banks]) / motion["right.crank.u"] / r
print("one piston:", *(f"{x:.2f}" for x in (np.abs(speeds[0]).min(), np.abs(speeds[0]).max())))
together = np.linalg.norm(speeds, axis=0)
print("both together:", *(f"{x:.2f}" for x in (together.min(), together.max())))
assert together.min() > 0.7
