"""A cart swings its pole up: direct collocation by CasADi and IPOPT on exported C.

The exported functions come with exact sparse Jacobians and second derivatives, and so does the
Lagrangian; IPOPT takes fewer iterations with it than where it finds the Hessian from changes of
gradients (L-BFGS). The plan is then driven by cardan's own simulation.

Run it anywhere; it writes into ``out/swing_up``. Needs CasADi: pip install casadi.
"""

import sys
from pathlib import Path
from time import perf_counter

import casadi as ca
import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/swing_up")
out.mkdir(parents=True, exist_ok=True)

# A cart on a rail, which an input pushes, with a pole that hangs.
scene = cd.Scene("swing_up", gravity=(0, 0, -9.81))
push = scene.input("push", unit="N")
cart = scene.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1))
pole = scene.body("pole", mass=0.3, com=(0, 0, -0.5), inertia=cd.inertia.rod(0.3, 1.0, axis="z"))
scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
scene.joint("hinge", cd.Revolute("y"), cart, pole)
scene.force("motor", cd.JointForce("rail", push))
equations = cd.derive(scene)

# The C of the dynamics, and a module that gives it to CasADi: rhs(x, r) with its derivatives.
functions = ["rhs", ("hessian", "rhs: q u")]
folder = equations.export(out / "swing_up_casadi", functions, language="casadi")
sys.path.insert(0, str(folder))
import swing_up_casadi as exported  # noqa: E402

rhs = exported.function("rhs")
print(rhs)
print("entries of d rhs / d x that are not always 0:", rhs.jacobian().nnz_out(0), "of 16")

# Hermite-Simpson collocation: states and pushes at the ends and in the middle of every interval.
count, duration, strongest = 50, 2.0, 20.0
h = duration / count
x = ca.MX.sym("x", 4, 2 * count + 1)
r = ca.MX.sym("r", 1, 2 * count + 1)
f = rhs.map(2 * count + 1)(x, r)
left, middle, right = (slice(k, 2 * count - 1 + k, 2) for k in range(3))
defects = [
    x[:, middle] - (x[:, left] + x[:, right]) / 2 - h / 8 * (f[:, left] - f[:, right]),
    x[:, right] - x[:, left] - h / 6 * (f[:, left] + 4 * f[:, middle] + f[:, right]),
]
cost = h / 6 * ca.sum2(r[left] ** 2 + 4 * r[middle] ** 2 + r[right] ** 2)
names = [*exported.COORDINATES, *exported.SPEEDS]
hanging, upright = np.zeros(4), np.array([0.0, np.pi, 0.0, 0.0])
g = ca.vertcat(*map(ca.vec, defects), x[:, 0] - hanging, x[:, -1] - upright)
variables = ca.vertcat(ca.vec(x), ca.vec(r))
guess = np.concatenate([np.linspace(hanging, upright, 2 * count + 1).ravel(), np.zeros(r.numel())])
most = np.concatenate([np.full(x.numel(), np.inf), np.full(r.numel(), strongest)])

iterations = {}
for hessian in ("limited-memory", "exact"):
    solver = ca.nlpsol(
        "swing_up",
        "ipopt",
        {"x": variables, "f": cost, "g": g},
        {
            "ipopt": {"hessian_approximation": hessian, "print_level": 0, "sb": "yes"},
            "print_time": False,
        },
    )
    start = perf_counter()
    solution = solver(x0=guess, lbx=-most, ubx=most, lbg=0, ubg=0)
    stats = solver.stats()
    iterations[hessian] = stats["iter_count"]
    print(
        f"{stats['return_status']} with the Hessian {hessian}: {iterations[hessian]} iterations, "
        f"{perf_counter() - start:.2f} s, cost {float(solution['f']):.4f}"
    )
    assert stats["success"]
assert iterations["exact"] < iterations["limited-memory"]
states = np.array(solution["x"][: x.numel()]).reshape(-1, 4)
pushes = np.array(solution["x"][x.numel() :]).ravel()
times = np.linspace(0.0, duration, 2 * count + 1)

# The plan in cardan's simulation: pushes are a parabola over every interval.
pieces = [np.polyfit(times[2 * k : 2 * k + 3], pushes[2 * k : 2 * k + 3], 2) for k in range(count)]


def plan(t, x):
    return np.polyval(pieces[min(int(t / h), count - 1)], t)


model = cd.compile(equations)
motion = model.simulate(duration, inputs={"push": plan}, max_step=h)
print("open-loop end:", dict(zip(names, np.round(motion.x[-1], 3).tolist(), strict=True)))
assert np.abs(motion.x[-1] - upright).max() < 0.01

figure, (above, below) = plt.subplots(2, 1, figsize=(7, 5), sharex=True, layout="constrained")
above.plot(motion.t, motion["hinge"], label="hinge [rad]")
above.plot(motion.t, motion["rail"], label="rail [m]")
above.plot(times, states[:, :2], "k.", markersize=3)
above.axhline(np.pi, color="0.8", zorder=0)
above.legend()
above.set_title("Swing-up: collocation (dots) and the simulated motion (lines)")
below.plot(times, pushes)
below.set_ylabel("push [N]")
below.set_xlabel("t [s]")
figure.savefig(out / "swing_up.png", dpi=120)
motion.animate(out / "swing_up.html")
