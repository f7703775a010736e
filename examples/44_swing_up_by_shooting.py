"""A cart swings its pole up: direct shooting by SciPy, with exact gradients of whole motions.

Unknown are the pushes at the knots of a table, a line between two of them. What the run costs and
where it ends come with gradients by all knots, each from one sweep backward over the run.

Run it anywhere; it writes into ``out/shooting``. See docs/gradients.md.

Source: M. Kelly, SIAM Review 59 (2017), section 6. The optimum that is reached there, from a
straight line, is one of several; shooting reaches one with less effort.
"""

from itertools import pairwise
from pathlib import Path
from time import perf_counter

import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize

import cardan as cd

out = Path("out/shooting")
out.mkdir(parents=True, exist_ok=True)
DURATION, PUBLISHED = 2.0, 58.80767  # s, N^2 s

# A cart on a rail, which an input pushes, with a bob on a massless rod; the angle is 0 hanging.
scene = cd.Scene("cart_and_pole", gravity=(0, 0, -9.81))
push = scene.input("push", unit="N")
cart = scene.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1))
bob = scene.body("bob", mass=0.3, com=(0, 0, -0.5), inertia=(0, 0, 0))
scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
scene.joint("hinge", cd.Revolute((0, -1, 0)), cart, bob)
scene.force("motor", cd.JointForce("rail", push))
model = cd.compile(scene)

# From rest at 0 to rest at 1 m, the pole upright.
goal = {"rail": 1.0, "hinge": np.pi, "rail.u": 0.0, "hinge.u": 0.0}
costs = [cd.cost(running="push^2"), *(cd.cost(final=f"{k} - {v}") for k, v in goal.items())]


class Shooting:
    """The effort of pushes at some knots, what the end misses, and their gradients."""

    def __init__(self, count: int) -> None:
        self.times = np.linspace(0.0, DURATION, count)
        # of lines between knots the effort is pushes @ overlap @ pushes; in unknowns in which it is
        # 1/2 |y|^2 no direction is steeper than another
        h = self.times[1]
        overlap = h / 3 * np.diag([1.0, *[2.0] * (count - 2), 1.0])
        overlap += h / 6 * (np.eye(count, k=1) + np.eye(count, k=-1))
        self.scale = np.linalg.inv(np.linalg.cholesky(2 * overlap)).T
        self.last, self.runs = None, 0

    def __call__(self, y):
        """Values (5,) and slopes (5, count): the effort, then what each end value misses."""
        if self.last is None or not np.array_equal(self.last[0], y):
            table = {"push": (self.times, self.scale @ y)}
            parts = [model.gradient(DURATION, cost, wrt="push", inputs=table) for cost in costs]
            slopes = np.array([part.slope["push"] for part in parts]) @ self.scale
            self.last = y.copy(), np.array([part.value for part in parts]), slopes
            self.runs += len(costs)
        return self.last[1:]

    def solve(self, guess):
        """Pushes (count,), their effort, what the end misses, iterations."""
        ends = {"type": "eq", "fun": lambda y: self(y)[0][1:], "jac": lambda y: self(y)[1][1:]}
        done = minimize(
            lambda y: (self(y)[0][0], self(y)[1][0]),
            np.linalg.solve(self.scale, guess),
            jac=True,
            method="SLSQP",
            constraints=ends,
            options={"maxiter": 400, "ftol": 1e-9},
        )
        assert done.success, done.message
        return self.scale @ done.x, done.fun, np.abs(self(done.x)[0][1:]).max(), done.nit


def textbook(t, y, times, pushes):
    """Kelly's equations of motion, and the effort: nothing of cardan is in here."""
    m1, m2, l, g = 1.0, 0.3, 0.5, 9.81
    _, angle, v, w, _ = y
    s, c, force = np.sin(angle), np.cos(angle), np.interp(t, times, pushes)
    a = (l * m2 * s * w**2 + force + m2 * g * c * s) / (m1 + m2 * s**2)
    b = -(l * m2 * c * s * w**2 + force * c + (m1 + m2) * g * s) / (l * m1 + l * m2 * s**2)
    return [v, w, a, b, force**2]


figure, (above, below) = plt.subplots(2, 1, figsize=(7, 5), sharex=True, layout="constrained")
efforts = {}
for count in (11, 41):
    shooting, begin = Shooting(count), perf_counter()
    guess = 5.0 * np.sin(np.pi * shooting.times)
    pushes, effort, missed, iterations = shooting.solve(guess)
    seconds = perf_counter() - begin
    efforts[count] = effort
    # another integrator on the equations of the paper, from knot to knot
    y = np.zeros(5)
    for span in pairwise(shooting.times):
        run = solve_ivp(textbook, span, y, args=(shooting.times, pushes), rtol=1e-11, atol=1e-12)
        y = run.y[:, -1]
    off = np.abs(y[:4] - list(goal.values())).max()
    print(
        f"{count} knots: effort {effort:.4f} N^2 s, {effort / PUBLISHED - 1:+.2%} of the published "
        f"optimum; end off by {missed:.0e}, replayed with the equations of the paper by {off:.0e} "
        f"and {abs(y[4] / effort - 1):.0e} of the effort; {iterations} iterations, "
        f"{shooting.runs} gradients, {seconds:.1f} s"
    )
    assert off < 1e-6
    below.plot(shooting.times, pushes, ".-", label=f"{count} knots")
# every table of 11 knots is one of 41, too
assert efforts[41] < efforts[11]

motion = model.simulate(
    np.linspace(0.0, DURATION, 201), inputs={"push": (shooting.times, pushes)}, rtol=1e-9
)
above.plot(motion.t, motion["hinge"], label="hinge [rad]")
above.plot(motion.t, motion["rail"], label="rail [m]")
above.axhline(np.pi, color="0.8", zorder=0)
above.set_title("Swing-up by shooting")
below.set(xlabel="t [s]", ylabel="push [N]")
for axes in (above, below):
    axes.legend()
figure.savefig(out / "swing_up.png", dpi=120)
motion.animate(out / "swing_up.html")
