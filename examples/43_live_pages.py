"""Pages in which a model runs: sliders, a mouse, and no compiler.

`cd.page` writes the equations as WebAssembly into one HTML file, beside the integrator of
`simulate`. Open the files in a browser: move a slider, pull a body, share the link.
"""

import sys
from pathlib import Path

import cardan as cd

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")

# a mass on a spring that swings; parameters that the scene declares are sliders
scene = cd.Scene("elastic_pendulum", gravity=(0, 0, -9.81))
mass = scene.parameter("mass", 1.0, unit="kg")
stiffness = scene.parameter("stiffness", 60.0, unit="N/m")
arm = scene.body("arm", mass=0.05, com=(0, 0, -0.1), inertia=(1e-4, 1e-4, 1e-5))
bob = scene.body("bob", mass=mass, com=(0, 0, 0), shape=cd.shape.sphere(0.06))
scene.joint("pivot", cd.Revolute("y"), scene.ground, arm)
scene.joint("slide", cd.Prismatic("z"), arm.at(0, 0, -0.5), bob)
scene.force("spring", cd.JointSpring("slide", stiffness=stiffness, damping=0.05))
equations = cd.derive(scene)
pendulum = cd.page(
    equations, out / "pendulum.html", q={"pivot": 1.0}, traces="bob", plots=["energy", "slide"]
)
print(f"pendulum: {Path(pendulum).stat().st_size / 1e3:.0f} KB")

# a loop is closed again while the length of its coupler changes
four_bar = cd.page(
    cd.load(cd.examples.path("four_bar")),
    out / "four_bar.html",
    sliders={"C.position.x": (0.2, 1.0)},
    q={"A": 0.6},
    plots=["A", "D"],
)
print(f"four-bar: {Path(four_bar).stat().st_size / 1e3:.0f} KB")

# a ball that bounces: events happen in the page as in `simulate`
ball = cd.page(cd.load(cd.examples.path("bouncing_ball")), out / "ball.html")
print(f"ball: {Path(ball).stat().st_size / 1e3:.0f} KB")
