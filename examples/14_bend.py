"""An eighth of a ring under a force across its plane: a test that every beam must pass.

Run it anywhere; it writes into ``out/bend``.

Source: K.-J. Bathe, S. Bolourchi, IJNME 14 (1979), 961-986.
"""

import math
from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/bend")
out.mkdir(parents=True, exist_ok=True)
RADIUS = 100.0
# where the tip goes under 300, 450 and 600, from the equations of the rod integrated to 10 digits
KNOWN = [
    (22.24478095, 58.77912249, 40.19189167),
    (18.50817893, 52.23855801, 48.50292734),
    (15.68480053, 47.15043857, 53.47485879),
]


def bend(elements: int) -> cd.CompiledModel:
    """Clamped at the origin along y, curving to x; a force P along z at the tip."""
    scene = cd.Scene("bend", gravity=(0, 0, 0))
    P = scene.parameter("P", 0.0, unit="N")
    E, G = 1e7, 5e6
    section = cd.section.general(EA=E, GA=G, GJ=G / 6, EI=E / 12, rhoA=1)
    middle, tip = (
        (RADIUS * (1 - math.cos(a)), RADIUS * math.sin(a), 0) for a in (math.pi / 8, math.pi / 4)
    )
    arc = cd.arc(through=middle)
    beam = scene.beam("bend", scene.ground, tip, section, line=arc, elements=elements)
    scene.force("load", cd.Force(beam.end, (0, 0, P)))
    return cd.compile(scene)


# Twice as many elements: a sixteenth of the error.
errors = []
for elements in (4, 8):
    path = bend(elements).statics(P=[0, 300, 450, 600])
    tips = np.stack([path[f"bend.end.{axis}"] for axis in ("px", "py", "pz")], axis=-1)
    errors.append(np.abs(tips[1:] - KNOWN).max())
    print(f"{elements} elements: the tip is off by {errors[-1]:.1e} of {RADIUS:g}")
order = math.log2(errors[0] / errors[1])
print(f"order {order:.2f}")
assert abs(order - 4) < 0.2
path.plot(out / "bend.png", ["bend.end.px", "bend.end.py", "bend.end.pz"])
