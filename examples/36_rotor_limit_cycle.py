"""A rotor with damping inside: the speed at which it begins to whirl, and the whirl behind it.

Run it anywhere; it writes into ``out/limit_cycle``.

Source: G. Genta, Dynamics of Rotating Systems (2005), chapters 2 and 4; closed forms are our own.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/limit_cycle")
out.mkdir(parents=True, exist_ok=True)
MASS, STIFFNESS, FASTEST = 1.0, 1e4, 600.0  # kg, N/m, rad/s

# A disk in the middle of a shaft. Damping of the bearings grows with the square of the whirl;
# damping inside the shaft turns along with it, and drives the whirl above a speed. Bearings are
# stiffer along x than along y, by ``uneven``.
scene = cd.Scene("whirling_rotor", gravity=(0, 0, 0))
speed = scene.parameter("speed", 0.0, "rad/s")
inner, outer = scene.parameter("inner", 4.0, "N s/m"), scene.parameter("outer", 4.0, "N s/m")
cubic = scene.parameter("cubic", 2e6, "N s/m^3")
uneven = scene.parameter("uneven", 0.0)
across = scene.body("across")
disk = scene.body("disk", mass=MASS, inertia=(1e-3, 1e-3, 2e-3))
scene.joint("x", cd.Prismatic("x"), scene.ground, across)
scene.joint("y", cd.Prismatic("y"), across, disk)
x, y, vx, vy = scene.q("x"), scene.q("y"), scene.u("x"), scene.u("y")
bearings = outer + cubic * (x**2 + y**2)
on_x = -STIFFNESS * (1 + uneven) * x - bearings * vx - inner * (vx + speed * y)
on_y = -STIFFNESS * (1 - uneven) * y - bearings * vy - inner * (vy - speed * x)
scene.force("on_x", cd.JointForce("x", on_x))
scene.force("on_y", cd.JointForce("y", on_y))
model = cd.compile(scene)

# The chart: at which speed it ceases to be stable, over the damping inside, for three shafts. In
# closed form (inner speed)^2 = (inner + outer)^2 STIFFNESS / MASS + (uneven STIFFNESS)^2.
chart, worst = {}, 0.0
damping = np.linspace(2.0, 12.0, 11)
for part in (0.0, 0.05, 0.1):
    limits = []
    for value in damping:
        values = {"inner": value, "uneven": part}
        rest = model.continuation(speed=(0, 1500.0), parameters=values)
        limits.append(rest.point("Hopf point 1")["speed"])
    exact = np.hypot((damping + 4.0) * np.sqrt(STIFFNESS / MASS), part * STIFFNESS) / damping
    worst = max(worst, np.abs(np.array(limits) / exact - 1).max())
    chart[part] = limits
print(f"{3 * len(damping)} Hopf points, off by {worst:.0e} at most from the closed form")

# The whirl that begins there grows until the bearings take out what the shaft puts in.
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
whirls = {}
for part, limits in chart.items():
    rest = model.continuation(speed=(0, FASTEST), parameters={"uneven": part})
    point = rest.point("Hopf point 1")
    print(f"uneven by {100 * part:.0f} %: {point}")
    whirl = model.continuation(speed=(0, FASTEST), of="cycles", start=point, step=0.1)
    print(whirl)
    whirls[part] = whirl
    left.plot(damping, limits, ".-", label=f"uneven by {100 * part:.0f} %")
    right.plot(whirl["speed"], 1e3 * whirl["x.max"], ".-")
left.set(xlabel="damping inside [N s/m]", ylabel="speed [rad/s]", title="it begins to whirl")
right.set(xlabel="speed [rad/s]", ylabel="largest x [mm]", title="how far it whirls")
left.legend()
figure.savefig(out / "whirl.png")

# An even shaft whirls in a circle, at its frequency, with a radius in closed form.
even = whirls[0.0]
radius = np.sqrt((4.0 * (even["speed"] / np.sqrt(STIFFNESS / MASS) - 1) - 4.0) / 2e6)
print(f"radius off by {np.abs(even['x.max'] - radius).max():.0e} m of {radius[-1]:.6f} m")

# A run from a small push ends on the cycle; the multiplier says how fast from lap to lap.
last = whirls[0.1][-1]
motion = last.model.simulate(np.linspace(0, 3.0, 12001), q={"x": 1e-6})
late = motion.t > 2.8
print(last)
print(f"a run comes to x = {1e3 * motion['x'][late].max():.4f} mm, the cycle has "
      f"{1e3 * whirls[0.1]['x.max'][-1]:.4f} mm")  # fmt: skip
motion.animate(out / "whirl.html", plots=["x", "y"])
