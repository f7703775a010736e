"""A cart with a pole: equations to read, C to take away.

Run it anywhere; it writes into ``out/cart_pole``.
"""

import shutil
from pathlib import Path

import cardan as cd

out = Path("out/cart_pole")
shutil.rmtree(out, ignore_errors=True)

# A force on the cart is an input; a spring pulls it back.
scene = cd.Scene("cart_pole", gravity=(0, 0, -9.81))
push = scene.input("push", default=0.0)
cart = scene.body("cart", mass=2.0)
pole = scene.body("pole", mass=0.5, com=(0, 0, 0.4), inertia=cd.inertia.rod(0.5, 0.8, axis="z"))
scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
scene.joint("hinge", cd.Revolute("y"), cart, pole)
scene.force("motor", cd.JointForce("track", push))
scene.force("spring", cd.JointForce("track", -40.0 * scene.q("track")))

# Every formalism gives the same equations; they differ in how many operations they cost.
for method in ("kane", "newton_euler", "composite", "articulated"):
    counts = cd.derive(scene, method=method).operations["forward_dynamics"]
    print(f"{method:13s} {sum(counts.values())} operations")

# The equations as SymPy matrices, and with named intermediates where they are long.
equations = cd.derive(scene, method="kane")
print("M =", equations.mass_matrix)
print("h =", equations.bias)
print("f =", equations.forces)
shared, matrix = equations.symbolic("mass_matrix")
print(f"{len(shared)} shared intermediates")

# C, header and manifest that compile on their own, without Python and without cardan.
equations.export(out, functions=("forward_dynamics", "mass_matrix"))
for path in sorted(out.iterdir()):
    print(path.name)
print((out / "forward_dynamics.c").read_text(encoding="utf-8"))
