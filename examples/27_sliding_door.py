"""A sliding door: dry friction on its rail, stops at both ends, and a computer that moves it.

Run it anywhere; it writes into ``out/door``.
"""

from pathlib import Path

import sympy as sp

import cardan as cd

out = Path("out/door")
out.mkdir(parents=True, exist_ok=True)

# A door that is pushed along its rail, and a lamp that hangs from it.
scene = cd.Scene("sliding_door")
door = scene.body("door", mass=20.0, com=(0, 0, -1), inertia=(7.0, 8.0, 1.5))
lamp = scene.body("lamp", mass=1.2, com=(0, 0, -0.4), inertia=(0.02, 0.02, 0.005))
scene.joint("rail", cd.Prismatic("x"), scene.ground, door)
scene.joint("hook", cd.Revolute("y"), door.at(0.3, 0, -0.5), lamp)
scene.force("friction", cd.Friction("rail", coulomb=12.0, static=18.0, viscous=4.0))
scene.force("ends", cd.Stop("rail", lower=0.0, upper=0.9, restitution=0.4, settle=0.02))

# The computer measures 50 times a second: it pulls towards ``goal`` and learns the friction.
goal = scene.input("goal", default=0.9, unit="m")
error, learned = goal - scene.q("rail"), sp.Symbol("learned")
scene.force(
    "motor",
    cd.Controller(
        "rail",
        states=(learned,),
        changes=(learned + 2.0 * error,),
        force=60.0 * error - 30.0 * scene.u("rail") + learned,
        sample=0.02,
    ),
)
model = cd.compile(scene)
motion = model.simulate(4.0, rtol=1e-8)
for event in motion.events:
    print(f"{event.t:.4f} s  {event.name} ({event.kind})")
print(motion.balance)
motion.animate(out / "door.html")

# The door leaves its rest against friction, and comes to lie at the far end.
assert motion.events[0].element == "friction"
assert any(event.element == "ends" for event in motion.events)
assert abs(motion["rail"][-1] - 0.9) < 1e-9
