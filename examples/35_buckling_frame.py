"""Two frames of beams: one snaps back and forth, one leaves its plane where it branches.

Run it anywhere; it writes into ``out/frames``.

Source: S.-L. Lee, F. S. Manuel, E. C. Rossow, Large Deflections and Stability of Elastic Frames
(1968); J. H. Argyris et al. (1979) and J. C. Simo, L. Vu-Quoc (1986) for the narrow right angle.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/frames")
out.mkdir(parents=True, exist_ok=True)

# Lee's frame [cm, N]: a column and a beam with a stiff corner, hinged at both ends, under a load
# on the beam at a fifth of its length.
SIDE, E, NU, AREA, INERTIA = 120.0, 7.2e6, 0.3, 6.0, 2.0
EA, EI, GA = E * AREA, E * INERTIA, 5 / 6 * E * AREA / (2 * (1 + NU))
scene = cd.Scene("lee", gravity=(0, 0, 0))
section = cd.section.general(EA=EA, GA=GA, GJ=EI, EI=EI)
column = scene.beam("column", (0, 0, 0), (0, 0, SIDE), section, elements=7, up="y")
short = scene.beam("short", column.end, (SIDE / 5, 0, SIDE), section, elements=2, up="y")
long = scene.beam("long", short.end, (SIDE, 0, SIDE), section, elements=7, up="y")
scene.joint("foot", cd.Revolute("y"), scene.ground, column.start)
scene.joint("hinge", cd.Revolute("y"), scene.ground.at(SIDE, 0, SIDE), long.end)
scene.force("load", cd.Force(short.end, (0, 0, -scene.parameter("P", 0.0))))
scene.output("down", SIDE - short.end.position()[2])
lee = cd.compile(scene, plane="y")

# The load turns back at two folds, and so does the displacement under it: neither could be
# prescribed all the way.
path = lee.continuation(P=(0, 40000.0), until={"down": 95.0})
print(path)
down = path["down"]
turns = [
    k for k in range(1, len(down) - 1) if (down[k] - down[k - 1]) * (down[k + 1] - down[k]) < 0
]
print("the displacement turns back near", ", ".join(f"{down[k]:.1f}" for k in turns))
for name, published in (("fold 1", 18544.52), ("fold 2", -9392.49)):
    load = path.point(name)["P"]
    print(f"{name}: {load:9.2f} N, exact beam {published:9.2f} N, {load / published - 1:+.1e}")
path.plot("down", "P", out / "lee.png")

# A dead load jumps at the first fold to where the path bears as much again.
low = int(path["P"].argmin())
limit = path.point("fold 1")
landing = np.interp(limit["P"], path["P"][low:], down[low:])
print(f"a dead load snaps from {limit['down']:.1f} to {landing:.1f} cm")

# The narrow right angle [mm, N]: two arms 30 mm wide and 0.6 mm thick, one clamped, one pulled at
# its end along the first. All of it lies in a plane until it branches.
ARM, WIDE, THIN, MODULUS = 240.0, 30.0, 0.6, 71240.0
G = MODULUS / (2 * (1 + 0.31))
area = WIDE * THIN
weak, strong = MODULUS * WIDE * THIN**3 / 12, MODULUS * THIN * WIDE**3 / 12
strip = cd.section.general(
    EA=MODULUS * area, GA=G * area, GJ=G * WIDE * THIN**3 / 3, EI=(strong, weak)
)
frame = cd.Scene("right_angle", gravity=(0, 0, 0))
one = frame.beam("one", frame.ground, (ARM, 0, 0), strip, elements=8, up="y")
two = frame.beam("two", one.end, (ARM, -ARM, 0), strip, elements=8, up="x")
frame.force("load", cd.Force(two.end, (frame.parameter("P", 0.0), 0, 0)))
frame.output("aside", two.end.position()[2])
narrow = cd.compile(frame)

# One call for each sense of the load, without a push or an imperfection. Exact beams of these data
# branch at 1.08752 N; Argyris et al. have 1.088 and -0.680 N.
for sense, last in (("pulled", 1.6), ("pushed", -1.2)):
    path = narrow.continuation(P=(0, last), branches=1, bounds={"aside": (-60, 60)})
    print(path)
    point = path.point("branch point 1")
    a, b = point.postbuckling("aside")["1a"]
    critical, end = point["P"], path.branches["1a"]["P"][-1]
    print(f"{sense}: leaves its plane at {critical:.4f} N; a = {a:.1e} /mm, b = {b:.2e} /mm^2;")
    print(f"at 60 mm {end:.4f} N, by a and b alone {critical * (1 + b * 60**2):.4f} N")
    path.plot("aside", "P", out / f"{sense}.png")
