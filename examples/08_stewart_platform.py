"""A Stewart platform: five loops in space, inverse kinematics, a controlled lift.

Run it anywhere; it writes into ``out/stewart_platform``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/stewart_platform")
out.mkdir(parents=True, exist_ok=True)


def ring(radius: float, angles: list[float]) -> list[tuple[float, float, float]]:
    """Points on a circle; angles in degrees."""
    return [(radius * np.cos(a), radius * np.sin(a), 0.0) for a in np.radians(angles)]


BASE = ring(0.6, [-10, 10, 110, 130, 230, 250])
TOP = ring(0.4, [-50, 50, 70, 170, 190, 290])

# Six legs of two bodies: universal joint below, slide with a drive, ball joint above.
scene = cd.Scene("stewart_platform", gravity=(0, 0, -9.81))
platform = scene.body("platform", mass=5.0, com=(0, 0, 0.03), inertia=(0.22, 0.25, 0.4))
for k in range(6):
    tube = scene.body(f"tube{k}", mass=1.2, com=(0, 0, 0.2), inertia=(0.016, 0.016, 5e-4))
    rod = scene.body(f"rod{k}", mass=0.5, com=(0, 0, -0.2), inertia=(0.007, 0.007, 6e-5))
    drive = scene.input(f"drive{k}", default=0.0)
    scene.joint(f"hooke{k}", cd.Universal("x", "y"), scene.ground.at(*BASE[k]), tube)
    scene.joint(f"slide{k}", cd.Prismatic("z"), tube.at(0, 0, 0.5), rod, q0=0.3)
    scene.joint(f"ball{k}", cd.Spherical(), rod, platform.at(*TOP[k]))
    scene.force(f"drive{k}", cd.JointForce(f"slide{k}", drive))

# One ball joint stays in the tree; the other five close loops.
model = cd.compile(scene)
cuts = ", ".join(cut["name"] for cut in model.manifest["cuts"])
print(f"{model.nu} speeds, {model.nlam} constraints; cut: {cuts}")


def pose(height: float, tilt: float) -> np.ndarray:
    """The platform above the base, turned about x."""
    c, s = np.cos(tilt), np.sin(tilt)
    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, height], [0, 0, 0, 1]])


# Inverse kinematics: the coordinates of all legs for a pose of the platform.
low = model.assemble({"platform": pose(0.75, 0.0)})
high = model.assemble({"platform": pose(0.85, 0.15)}, start=low.q)
print(model.redundancy(low.q))
slides = [model.coordinates.index(f"slide{k}") for k in range(6)]
rates = [model.speeds.index(f"slide{k}.u") for k in range(6)]
print("legs below:", low.q[slides])
print("legs above:", high.q[slides])


# Every drive knows its own leg: it carries its share of the weight and follows a ramp of 1 s.
def control(k: int) -> object:
    def force(t: float, x: np.ndarray) -> float:
        s = min(t, 1.0)
        way = s * s * (3 - 2 * s)
        wanted = low.q[slides[k]] * (1 - way) + high.q[slides[k]] * way
        length, rate = x[slides[k]], x[model.nq + rates[k]]
        return 14.0 + 4000.0 * (wanted - length) - 200.0 * rate

    return force


drives = {f"drive{k}": control(k) for k in range(6)}
motion = model.simulate(2.0, q=low.q, inputs=drives, rtol=1e-6)
print(motion)
reached = model.pose("platform", motion.q[-1])
print("height and tilt reached:", reached[2, 3], np.arctan2(reached[2, 1], reached[2, 2]))
assert abs(reached[2, 3] - 0.85) < 5e-3
motion.animate(out / "stewart.html")
