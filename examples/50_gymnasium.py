"""Thousands of carts with poles for learning: a vector environment of Gymnasium.

The task is Gymnasium's ``CartPole-v1``: the same masses, actions, bounds and rewards. All
environments step together; each stage of Runge and Kutta's step is one call of compiled C, which
takes eight states side by side. Random search then finds a controller.

Run it anywhere; it writes into ``out/gymnasium``. Needs Gymnasium: pip install gymnasium.
"""

from pathlib import Path
from time import perf_counter

import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/gymnasium")
out.mkdir(parents=True, exist_ok=True)
STEP, FORCE, LONGEST = 0.02, 10.0, 500  # s, N, steps of an episode

# A pole of one meter on a cart; its angle is 0 upright.
scene = cd.Scene("balanced_pole", gravity=(0, 0, -9.8))
push = scene.input("push", unit="N")
cart = scene.body("cart", mass=1.0, inertia=(0.1, 0.1, 0.1), shape=cd.shape.box(0.3, 0.2, 0.1))
pole = scene.body("pole", mass=0.1, com=(0, 0, 0.5), inertia=cd.inertia.rod(0.1, 1.0, axis="z"))
scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
scene.joint("hinge", cd.Revolute("y"), cart, pole)
scene.force("motor", cd.JointForce("rail", push))
model = cd.compile(scene)

try:
    import gymnasium as gym
except ModuleNotFoundError as missing:
    raise SystemExit("this example needs Gymnasium: pip install gymnasium") from missing

ORDER = [0, 2, 1, 3]  # an observation is rail, its speed, hinge, its speed; a state q, then u


def advanced(x, r):
    """States (n, 4) a step later, by Runge and Kutta's method, at inputs (n, 1)."""
    rate = model.rhs(0.0, x, r=r)
    total, stage = rate.copy(), np.empty_like(x)
    for part, weight in ((STEP / 2, 2.0), (STEP / 2, 2.0), (STEP, 1.0)):
        # in place: thousands of states that are copied take as long as their rates
        np.multiply(rate, part, out=stage)
        stage += x
        rate = model.rhs(0.0, stage, r=r)
        total += np.multiply(rate, weight, out=stage)
    total *= STEP / 6
    total += x
    return total


class CartPoles(gym.vector.VectorEnv):
    """Carts with poles side by side; one that fell begins anew at its next step."""

    metadata = {"autoreset_mode": gym.vector.AutoresetMode.NEXT_STEP}  # noqa: RUF012

    def __init__(self, count):
        self.num_envs = count
        most = np.array([4.8, np.inf, 0.4189, np.inf], np.float32)
        self.single_observation_space = gym.spaces.Box(-most, most)
        self.single_action_space = gym.spaces.Discrete(2)
        batched = gym.vector.utils.batch_space
        self.observation_space = batched(self.single_observation_space, count)
        self.action_space = batched(self.single_action_space, count)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.x = self.np_random.uniform(-0.05, 0.05, (self.num_envs, 4))
        self.age = np.zeros(self.num_envs, int)
        self.over = np.zeros(self.num_envs, bool)
        return self.x[:, ORDER].astype(np.float32), {}

    def step(self, actions):
        self.x = advanced(self.x, np.where(actions, FORCE, -FORCE)[:, None])
        self.age += 1
        fell = (np.abs(self.x[:, 0]) > 2.4) | (np.abs(self.x[:, 1]) > np.radians(12))
        late = self.age >= LONGEST
        again = np.flatnonzero(self.over)
        reward = np.ones(self.num_envs, np.float32)
        if again.size:
            self.x[again] = self.np_random.uniform(-0.05, 0.05, (again.size, 4))
            self.age[again], reward[again], fell[again], late[again] = 0, 0.0, False, False
        self.over = fell | late
        return self.x[:, ORDER].astype(np.float32), reward, fell, late, {}


# The equations of motion are those of Gymnasium: a step of Euler's method there tells its rates.
count = 4096
theirs = gym.make_vec("CartPole-v1", count, vectorization_mode="vector_entry_point").unwrapped
rng = np.random.default_rng(0)
theirs.reset(seed=0)
x = rng.uniform(-0.2, 0.2, (count, 4))
actions = rng.integers(0, 2, count)
theirs.state = x[:, ORDER].T.copy()
theirs.step(actions)
rates = (theirs.state.T[:, ORDER] - x) / STEP
r = np.where(actions, FORCE, -FORCE)[:, None]
print(f"rates of states differ by {np.abs(rates - model.rhs(0.0, x, r=r)).max():.0e}")
assert np.abs(rates - model.rhs(0.0, x, r=r)).max() < 1e-11

# Errors of one step, against runs at a tight tolerance.
exact = model.ensemble(STEP, x0=x, inputs={"push": r[:, 0]}, rtol=1e-12).final
ours, euler = np.abs(advanced(x, r) - exact).max(), np.abs(theirs.state.T[:, ORDER] - exact).max()
print(f"error of a step: {ours:.0e}, of Gymnasium's Euler method {euler:.0e}")
assert ours < 1e-6


def throughput(environments, steps):
    """Steps of environments in a second, by the fastest of three."""
    environments.reset(seed=0)
    chosen = rng.integers(0, 2, (steps, environments.num_envs))
    seconds = []
    for _ in range(3):
        begin = perf_counter()
        for actions in chosen:
            environments.step(actions)
        seconds.append(perf_counter() - begin)
    return environments.num_envs * steps / min(seconds)


for many in (256, 4096, 16384, 65536):
    here = throughput(CartPoles(many), 50)
    vector = gym.make_vec("CartPole-v1", many, vectorization_mode="vector_entry_point").unwrapped
    there = throughput(vector, 50)
    print(
        f"{many:6d} environments: {here:.2e} steps/s of four evaluations; Gymnasium's own formulas "
        f"in NumPy, one evaluation: {there:.2e}"
    )

# Random search: each environment tries gains of its own; the best tenth says where to look next.
environments, begin = CartPoles(1024), perf_counter()
mean, spread, history = np.zeros(4), np.ones(4), []
for generation in range(8):
    gains = mean + spread * rng.standard_normal((environments.num_envs, 4))
    seen, _ = environments.reset(seed=generation)
    lasted, alive = np.zeros(len(gains)), np.ones(len(gains), bool)
    for _ in range(LONGEST):
        seen, reward, fell, late, _ = environments.step((gains * seen).sum(axis=1) > 0)
        lasted += reward * alive
        alive &= ~(fell | late)
        if not alive.any():
            break
    best = gains[np.argsort(lasted)[-len(gains) // 10 :]]
    mean, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    history.append(lasted)
seconds = perf_counter() - begin
print(f"random search took {seconds:.1f} s; gains {np.round(mean, 2)}")

# The controller that was found, in Gymnasium's own environments.
theirs.reset(seed=1)
seen, lasted, alive = theirs.state.T, np.zeros(count), np.ones(count, bool)
for _ in range(LONGEST):
    seen, reward, fell, late, _ = theirs.step((seen @ mean > 0).astype(int))
    lasted += reward * alive
    alive &= ~(fell | late)
print(f"in {count} environments of Gymnasium it balances {lasted.mean():.1f} of {LONGEST} steps")
assert lasted.mean() > 450

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.violinplot(history, showmedians=True)
axes.set(xlabel="generation", ylabel="steps until it falls", title="Gains by random search")
figure.savefig(out / "search.png", dpi=120)

# One of them, with the force held over every step.
motion = model.simulate(
    10.0,
    q={"hinge": 0.05},
    inputs={"push": lambda t, x: FORCE if x[ORDER] @ mean > 0 else -FORCE},
    sample=STEP,
)
motion.animate(out / "cart.html", plots=["hinge", "rail"])
