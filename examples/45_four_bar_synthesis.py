"""The lengths of a four-bar from the curve that its coupler point is to follow.

Gradients of the distance by all lengths pass through the closed loop and through its assembly.
First the curve of a linkage that is known, to see that it is found again, then the path of a foot
through eight points, which no four-bar follows exactly.

Run it anywhere; it writes into ``out/synthesis``. See docs/gradients.md.
"""

from pathlib import Path
from time import perf_counter

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from scipy.optimize import minimize

import cardan as cd

out = Path("out/synthesis")
out.mkdir(parents=True, exist_ok=True)

# Where the search begins: lengths [m], the place of the frame [m], angles [rad].
START = {"crank": 0.25, "coupler": 0.7, "rocker": 0.7, "ground": 0.6, "along": 1.0, "aside": 0.1}
START |= {"base_x": 0.0, "base_y": 0.0, "tilt": 0.0, "phase": 0.0}

UNITS = dict.fromkeys(START, "m") | {"tilt": "rad", "phase": "rad"}


def four_bar(target):
    """The mechanism, and a closed curve through points (n, 2) that its coupler point is to follow.

    The crank turns once a second. Links are in the plane of x and y, along x where all angles are
    0; the frame of the linkage stands anywhere, turned by any angle.
    """
    scene = cd.Scene("foot_linkage", gravity=(0, 0, 0))
    p = {name: scene.parameter(name, value, UNITS[name]) for name, value in START.items()}
    crank, coupler, rocker = (
        scene.body(f"{name}_link", mass=1.0, inertia=(0.1, 0.1, 0.1))
        for name in ("crank", "coupler", "rocker")
    )
    turn = 2 * sp.pi * cd.t + p["phase"]
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, prescribed=turn)
    scene.joint("B", cd.Revolute("z"), crank.at(p["crank"], 0, 0), coupler, q0=1.4)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(p["ground"], 0, 0), rocker, q0=1.8)
    scene.joint("C", cd.Revolute("z"), coupler.at(p["coupler"], 0, 0), rocker.at(p["rocker"], 0, 0))
    x, y, _ = coupler.at(p["along"], p["aside"], 0).position()
    c, s = sp.cos(p["tilt"]), sp.sin(p["tilt"])
    scene.output("x", p["base_x"] + c * x - s * y)
    scene.output("y", p["base_y"] + s * x + c * y)
    closed = np.array([*target, target[0]])
    times = np.linspace(0.0, 1.0, len(closed))
    for name, values in zip(("target_x", "target_y"), closed.T, strict=True):
        scene.output(name, cd.table(times, values, "periodic")(cd.t))
    return cd.compile(scene)


distance = cd.cost(running="(x - target_x)^2 + (y - target_y)^2")

# Links have at most 1 m. Grashof: the crank turns all around if it, with any other link, is shorter
# than the other two.
BOUNDS = [(0.05, 1.0)] * 4 + [(-1.0, 1.0)] * 4 + [(None, None)] * 2
TURNS = np.zeros((4, len(START)))
TURNS[:, :4] = [[-1, 1, 1, -1], [-1, -1, 1, 1], [-1, 1, -1, 1], [1, 0, 0, 0]]


def synthesis(model, start):
    """Parameters of the linkage whose coupler point is nearest to the curve; a local optimum."""
    begin = perf_counter()

    def square(values):
        linkage = dict(zip(START, values, strict=True))
        value, slope = model.gradient(1.0, distance, wrt=tuple(START), parameters=linkage)
        return value, np.array([slope[name] for name in START])

    done = minimize(
        square,
        list(start.values()),
        jac=True,
        method="SLSQP",
        bounds=BOUNDS,
        constraints={"type": "ineq", "fun": lambda v: TURNS @ v - 0.03, "jac": lambda v: TURNS},
        options={"maxiter": 500, "ftol": 1e-13},
    )
    print(f"{done.nit} iterations, {done.nfev} runs, {perf_counter() - begin:.1f} s")
    return dict(zip(START, done.x.tolist(), strict=True))


def curve(model, linkage, times):
    """The coupler curve (nt, 2)."""
    motion = model.simulate(times, parameters=linkage, rtol=1e-10)
    return np.stack([motion["x"], motion["y"]], axis=1)


def by_circles(v, t):
    """The same in closed form: C is where circles about B and D meet."""
    angle = 2 * np.pi * t + v["phase"]
    B = v["crank"] * np.exp(1j * angle)
    far = v["ground"] - B
    length = np.abs(far)
    along = (length**2 + v["coupler"] ** 2 - v["rocker"] ** 2) / (2 * length)
    C = B + far / length * (along + 1j * np.sqrt(v["coupler"] ** 2 - along**2))
    point = B + (C - B) / v["coupler"] * (v["along"] + 1j * v["aside"])
    point = v["base_x"] + 1j * v["base_y"] + np.exp(1j * v["tilt"]) * point
    return np.stack([point.real, point.imag], axis=1)


# A known linkage is found again from one with other lengths.
truth = START | {"crank": 0.2, "coupler": 0.8, "rocker": 0.65, "ground": 0.7, "along": 0.8}
truth |= {"aside": 0.25, "tilt": 0.2, "phase": 0.15, "base_x": 0.05}
times = np.linspace(0.0, 1.0, 97)
known = by_circles(truth, times)
model = four_bar(known[:-1])
found = synthesis(model, START)
worst = max(abs(found[name] - truth[name]) for name in START)
off = np.linalg.norm(curve(model, found, times) - known, axis=1).max()
print(f"a known linkage: curve off by {1e6 * off:.2g} um, parameters by {worst:.1e} at most")
assert off < 1e-5

# A foot: along the ground for half a turn, at nearly one speed, then lifted and back.
points = np.array([(-30, 0), (-10, 0), (10, 0), (30, 0), (33, 12), (12, 20), (-12, 20), (-33, 12)])
points = points / 100
model = four_bar(points)
start = START | {"tilt": np.pi / 2}
middle = points.mean(axis=0) - curve(model, start, np.linspace(0, 1, 9))[:-1].mean(axis=0)
start |= {"base_x": middle[0], "base_y": middle[1]}
foot = synthesis(model, start)
print("foot:", {name: round(value, 4) for name, value in foot.items()})
paths = {"before": curve(model, start, times), "after": curve(model, foot, times)}
for name, path in paths.items():
    away = 1e3 * np.linalg.norm(path[:-1:12] - points, axis=1)
    print(f"{name}: points missed by {away.mean():.1f} mm, {away.max():.1f} at most, of 660 mm")
error = np.abs(paths["after"] - by_circles(foot, times)).max()
print(f"the curve of the simulation and that of closed form differ by {error:.0e} m")
assert error < 1e-7

motion = model.simulate(times, parameters=foot)
figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
axes.plot(*points.T, "ko", label="points of the foot")
axes.plot(motion["target_x"], motion["target_y"], "0.7", label="target")
axes.plot(*paths["before"].T, "C1--", label="first lengths")
axes.plot(*paths["after"].T, "C0", label="after the search")
axes.plot(*paths["after"][:-1:12].T, "C0.", label="at the times of the points")
axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="A four-bar for a foot")
axes.legend()
figure.savefig(out / "foot.png", dpi=120)
motion.animate(out / "foot.html")
