"""A drone in a plane held by a linear-quadratic regulator: cardan's linear model in python-control.

Run it anywhere; it writes into ``out/lqr``. Needs python-control: pip install 'cardan[control]'.
"""

from pathlib import Path

import control
import numpy as np

import cardan as cd

out = Path("out/lqr")
out.mkdir(parents=True, exist_ok=True)

# A plate that moves in the x-z plane, with a propeller at each end that pushes along its own z.
scene = cd.Scene("drone", gravity=(0, 0, -9.81))
left, right = scene.input("left"), scene.input("right")
drone = scene.body("drone", mass=1.2, inertia=(0.01, 0.02, 0.02))
scene.joint("fly", cd.Planar("y"), scene.ground, drone)
scene.force("left", cd.Force(drone.at(-0.2, 0, 0), (0, 0, left), in_=drone))
scene.force("right", cd.Force(drone.at(0.2, 0, 0), (0, 0, right), in_=drone))
model = cd.compile(scene)

# The linear model about hovering. python-control takes no dots in names: the map says what it
# calls them.
hover = 1.2 * 9.81 / 2
linear = model.linearize(r={"left": hover, "right": hover})
system, names = linear.to_control()
print(names)
gains, _, poles = control.lqr(system, np.diag([10.0, 10.0, 1.0, 1.0, 1.0, 0.1]), np.eye(2))
print("poles", np.round(poles, 2))

# The regulator drives the whole model, which is not linear, from a tilted start a meter away.
places = [*model.coordinates, *model.speeds]
order = [places.index(name) for name in linear.states]


def thrust(motor: int):
    return lambda t, x: hover - float(gains[motor] @ x[order])


motion = model.simulate(
    10.0, q={"fly": [1.0, -0.5, 0.6]}, inputs={"left": thrust(0), "right": thrust(1)}, sample=0.01
)
print(motion)
print("distance at the end", np.abs(motion.q[-1]).max())
assert np.abs(motion.q[-1]).max() < 1e-3
motion.animate(out / "drone.html")
