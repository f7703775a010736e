"""How far does a pendulum cart swing if its numbers are only roughly known?

A cart on rails is pushed for a moment; the pendulum on it swings. Mass, length and the push are
known to some percent. 4096 runs tell what that means for the largest angle.
"""

import numpy as np

import cardan as cd

scene = cd.Scene("cart", gravity=(0, 0, -9.81))
m = scene.parameter("m", 1.0, unit="kg")
length = scene.parameter("l", 0.5, unit="m")
push = scene.input("push")

cart = scene.body("cart", mass=2.0, com=(0, 0, 0), inertia=(0.1, 0.1, 0.1))
bob = scene.body("bob", mass=m, com=(0, 0, -length))
scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
scene.joint("swing", cd.Revolute("y"), cart, bob)
scene.force("pusher", cd.JointForce("slide", push))
model = cd.compile(scene)

# a Sobol sequence covers the box of unknowns evenly
plan = cd.sample.sobol(
    4096,
    {
        "m": cd.sample.normal(1.0, 0.05),
        "l": cd.sample.uniform(0.48, 0.52),
        "slide.u": cd.sample.normal(0.0, 0.05),
    },
    seed=1,
)
kick = ([0.0, 0.3, 0.3, 5.0], [20.0, 20.0, 0.0, 0.0])
runs = model.ensemble(
    5.0,
    vary=plan,
    inputs={"push": kick},
    reduce={"largest": "max of swing", "mean": "mean of swing", "spread": "deviation of swing"},
)
print(runs)

largest = np.degrees(runs["largest"])
print(f"largest angle {largest.mean():.1f} degrees, 95 % between "
      f"{np.quantile(largest, 0.025):.1f} and {np.quantile(largest, 0.975):.1f}")  # fmt: skip

# which unknown matters: correlation of each with the largest angle. The speed of the cart does
# not: the pendulum cannot tell whether the rails are on a train
for name, values in runs.varied.items():
    print(f"{name:8} {np.corrcoef(values, largest)[0, 1]:+.2f}")

# the run that swings farthest, with everything between its steps
farthest = runs.run(int(largest.argmax()))
print(farthest)
runs.save("runs.nc")
