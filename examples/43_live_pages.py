"""Pages in which a model runs: sliders, a mouse, and no compiler.

`cd.page` writes the equations as WebAssembly into one HTML file, beside the integrator of
`simulate`. Open the files in a browser: move a slider, pull a body, share the link.
"""

import sys
from pathlib import Path

import cardan as cd

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")

# parameters that the scene declares are sliders; the path of the tip is drawn
pendulum = cd.page(
    cd.load(cd.examples.path("double_pendulum")),
    out / "pendulum.html",
    q={"shoulder": 1.6},
    traces="lower",
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
