"""A steep truss of two bars: it snaps through, or sways before; imperfect trusses beside it.

Run it anywhere; it writes into ``out/snap_through``.

Source: R. von Mises (1923); W. T. Koiter, On the Stability of Elastic Equilibrium (1945).
"""

from pathlib import Path

import numpy as np
import sympy as sp

import cardan as cd

out = Path("out/snap_through")
out.mkdir(parents=True, exist_ok=True)
RISE = 3.0  # of the apex over supports at -1 and 1; the axial stiffness of the bars is 1
LENGTH = float(np.hypot(1.0, RISE))

# The apex moves aside by u and down by w. The load P leans to the side by a part ``tilt`` of it.
scene = cd.Scene("truss", gravity=(0, 0, 0))
P, tilt = scene.parameter("P", 0.0), scene.parameter("tilt", 0.0)
slide = scene.body("slide")
apex = scene.body("apex", mass=1.0, inertia=(1.0, 1.0, 1.0))
scene.joint("u", cd.Prismatic("x"), scene.ground.at(0, 0, RISE), slide)
scene.joint("w", cd.Prismatic("-z"), slide, apex)
for name, x in (("left", -1.0), ("right", 1.0)):
    foot = scene.ground.at(x, 0, 0)
    bar = cd.SpringDamper(foot, apex, stiffness=1 / LENGTH, rest_length=LENGTH)
    scene.force(name, bar)
    scene.output(name, sp.sqrt((scene.q("u") - x) ** 2 + (RISE - scene.q("w")) ** 2))
scene.force("load", cd.Force(apex, (tilt * P, 0, -P)))
model = cd.compile(scene)

# The perfect truss. Two of its branches lead to a bar without length, where we stop them.
lengths = dict.fromkeys(("left", "right"), (0.1, 10.0))
path = model.continuation(P=(0, 1.0), branches=1, bounds=lengths)
print(path)

# Closed forms: the snap at l^3 = L, sway at l^3 - L l^2 + L = 0, with l the length of a bar.
sway = max(root.real for root in np.roots([1, -LENGTH, 0, LENGTH]))
for name, length in (("fold 1", LENGTH ** (1 / 3)), ("branch point 1", sway)):
    exact = 2 * np.sqrt(length**2 - 1) * (1 / length - 1 / LENGTH)
    print(f"{name}: P = {path.point(name)['P']:.10f}, exact {exact:.10f}")

# How steeply the branch falls: P = P_c (1 + a u + b u^2).
point = path.point("branch point 1")
critical, (a, b) = point["P"], point.postbuckling("u")["1a"]
print(f"a = {a:.3f}, b = {b:.4f}: the branch is unstable, and small imperfections matter")

# Koiter: the largest load falls with the power 2/3 of an imperfection. ``softening`` is the change
# of the stiffness against sway with the load.
slope = 2 * (1 / np.sqrt(sway**2 - 1) * (1 - sway / LENGTH) - np.sqrt(sway**2 - 1) / sway**2)
softening = 2 / sway**2 * (1 - 3 / sway**2) / slope
print("  tilt     P at the fold   Koiter")
imperfect = {}
for part in (1e-4, 1e-3, 1e-2, 5e-2):
    leaning = {"parameters": {"tilt": part}, "until": {"u": 1.5}, "step": 0.02}
    imperfect[part] = model.continuation(P=(0, 1.0), **leaning)
    borne = imperfect[part].point("fold 1")["P"]
    law = critical * (1 - 3 * np.cbrt(-b) * (part / 2 / abs(softening)) ** (2 / 3))
    print(f"  {part:6.4f}   {borne:.6f}        {law:.6f}")

# Both pictures; stable parts are solid lines. The second one has the imperfect trusses in gray.
path.plot("w", "P", out / "branches.png")
near = model.continuation(P=(0, 0.35), branches=1, bounds={"u": (-1.5, 1.5)})
figure = near.plot("u", "P")
(axis,) = figure.axes
for leaning in imperfect.values():
    for side in (-1, 1):
        axis.plot(side * leaning["u"], leaning["P"], color="0.6", linewidth=0.8, zorder=0)
axis.set(xlabel="u, aside", ylabel="load P")
figure.savefig(out / "imperfect.png")
