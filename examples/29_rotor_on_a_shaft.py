"""A rotor on a flexible shaft: damping inside the shaft makes it whirl above a limit.

Run it anywhere; it writes into ``out/rotor_on_a_shaft``.

Source: G. Genta, Dynamics of Rotating Systems (2005), chapter 2 (the rotor of Jeffcott).
"""

from pathlib import Path

import numpy as np
from scipy.optimize import brentq

import cardan as cd

out = Path("out/rotor_on_a_shaft")
out.mkdir(parents=True, exist_ok=True)
MASS, LENGTH, RADIUS, E, LOSS, OUTER = 2.0, 0.6, 0.005, 2e11, 1e-4, 20.0

# A disk amid a light shaft that both bearings clamp; its material damps, and so does the air.
scene = cd.Scene("rotor_on_a_shaft", gravity=(0, 0, 0))
steel = cd.material(E=E, nu=0.3, rho=1.0, damping=LOSS)
drum = scene.body("drum", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
disk = scene.body("disk", mass=MASS, inertia=(4e-3, 2e-3, 2e-3), pose=(LENGTH / 2, 0, 0))
end = scene.body("end", mass=0.1, inertia=(1e-4, 1e-4, 1e-4))
scene.joint("bearing", cd.Revolute("x"), scene.ground, drum)
scene.joint("other", cd.Cylindrical("x"), scene.ground.at(LENGTH, 0, 0), end)
for name, ends in (("near", (drum, disk)), ("far", (disk, end))):
    scene.beam(name, *ends, cd.section.circle(RADIUS), steel, elements=1)
_, vy, vz = disk.velocity()
scene.force("air", cd.Force(disk, (0, -OUTER * vy, -OUTER * vz)))
scene.output("y", disk.position()[1], unit="m")
scene.output("z", disk.position()[2], unit="m")
model = cd.compile(scene)

# In axes that do not turn: m w'' + (outer + inner) w' + (k - i inner speed) w = 0, w = y + i z.
k = 192 * E * (np.pi * RADIUS**4 / 4) / LENGTH**3
inner = LOSS * k
critical = np.sqrt(k / MASS)
limit = critical * (1 + OUTER / inner)


def expected(speed: float) -> float:
    """Growth of the whirl by that equation [1/s]."""
    return float(np.roots([MASS, OUTER + inner, k - 1j * inner * speed]).real.max())


def growth(speed: float) -> float:
    """Growth of the whirl by the linear model about the rotating shaft [1/s]."""
    values = model.linearize(model.equilibrium(u={"bearing": speed})).eigenvalues
    # axes that turn along see the whirl lag behind by the difference of both speeds
    return float(values[np.abs(values - 1j * (speed - critical)).argmin()].real)


print(f"critical speed {critical:.1f} rad/s, stable up to {limit:.1f} rad/s in closed form")
turned = brentq(growth, 0.5 * limit, 2 * limit, xtol=1e-3)
print(f"stable up to {turned:.1f} rad/s by the linear models of the scene")
assert abs(turned / limit - 1) < 1e-3

# Below the limit a push dies out, above it the whirl grows, at the rates that the equation gives.
times = np.linspace(0, 1, 1001)
for part in (0.7, 1.3):
    speed = part * limit
    motion = model.simulate(times, u={"bearing": speed, "disk.u.py": 0.02})
    radius = np.hypot(motion["y"], motion["z"])
    late = times > 0.1
    rate = np.polyfit(times[late], np.log(radius[late]), 1)[0]
    print(
        f"at {speed:.0f} rad/s the radius grows by {rate:.2f} 1/s, expected {expected(speed):.2f}"
    )
    assert abs(rate - expected(speed)) < 0.1
motion.animate(out / "rotor.html")
