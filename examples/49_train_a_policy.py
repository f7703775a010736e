"""A neural network learns to reach with an arm: gradients through whole motions in JAX.

``model.to_jax`` gives the compiled equations to JAX, with their exact derivatives. The loop that
trains is JAX alone: a motion is a ``scan`` over steps, all targets of a batch go side by side.

Run it anywhere; it writes into ``out/policy``. Needs JAX: pip install jax. See docs/derivatives.md.
"""

from itertools import pairwise
from pathlib import Path
from time import perf_counter

import jax
import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

jax.config.update("jax_enable_x64", True)
out = Path("out/policy")
out.mkdir(parents=True, exist_ok=True)

# An arm of two links in a horizontal plane, with a motor in each joint.
scene = cd.Scene("reaching_arm", gravity=(0, 0, 0))
rod = cd.inertia.rod(1.0, 0.5, axis="x")
upper = scene.body("upper", mass=1.0, com=(0.25, 0, 0), inertia=rod)
lower = scene.body("lower", mass=1.0, com=(0.25, 0, 0), inertia=rod)
scene.joint("shoulder", cd.Revolute("z"), scene.ground, upper)
scene.joint("elbow", cd.Revolute("z"), upper.at(0.5, 0, 0), lower)
for joint in ("shoulder", "elbow"):
    scene.force(f"{joint}_motor", cd.JointForce(joint, scene.input(f"{joint}_torque", unit="N*m")))
    scene.force(f"{joint}_bearing", cd.JointDamper(joint, 0.1))
for axis, place in zip("xy", lower.at(0.5, 0, 0).position(), strict=False):
    scene.output(f"hand_{axis}", place)
model = cd.compile(scene)
rhs, hand = model.to_jax("rhs"), model.to_jax("outputs")

STEP, COUNT = 0.05, 20  # s, and steps of a motion
START = jnp.array([0.5, 1.0, 0.0, 0.0])


def torques(network, x, target):
    """What the network does at states (n, 4), for targets (n, 2): torques (n, 2) [N m]."""
    layer = jnp.concatenate([jnp.cos(x[:, :2]), jnp.sin(x[:, :2]), x[:, 2:], target], axis=1)
    for weights, offsets in network[:-1]:
        layer = jnp.tanh(layer @ weights + offsets)
    weights, offsets = network[-1]
    return layer @ weights + offsets


def ends(network, targets):
    """States (n, 4) at the end, and the torques (COUNT, n, 2): each is held over a step."""

    def step(x, _):
        r = torques(network, x, targets)
        middle = x + STEP / 2 * rhs(0.0, x, r=r)
        return x + STEP * rhs(0.0, middle, r=r), r

    return jax.lax.scan(step, jnp.tile(START, (len(targets), 1)), None, length=COUNT)


def loss(network, targets):
    """How far hands are from their targets, how fast, and at what effort."""
    x, r = ends(network, targets)
    away = hand(x[:, :2], x[:, 2:]) - targets
    return jnp.mean(
        jnp.sum(away**2, 1) + 0.01 * jnp.sum(x[:, 2:] ** 2, 1) + 1e-5 * jnp.sum(r**2, (0, 2))
    )


def some_targets(rng, n):
    """Places (n, 2) on a part of a ring around the shoulder."""
    far, angle = rng.uniform(0.4, 0.9, n), rng.uniform(-0.5, 2.0, n)
    return jnp.array(np.stack([far * np.cos(angle), far * np.sin(angle)], axis=1))


rng = np.random.default_rng(0)
sizes = (8, 32, 2)
network = [
    (jnp.array(rng.standard_normal((m, n)) / np.sqrt(m)) * (0.1 if n == 2 else 1), jnp.zeros(n))
    for m, n in pairwise(sizes)
]

# The gradient against a central difference along a random direction.
targets = some_targets(rng, 128)
slope = jax.grad(loss)(network, targets)
direction = jax.tree.map(lambda w: jnp.array(rng.standard_normal(w.shape)), network)
moved = [jax.tree.map(lambda w, d, s=s: w + s * 2e-6 * d, network, direction) for s in (1, -1)]
difference = (loss(moved[0], targets) - loss(moved[1], targets)) / 4e-6
along = sum(jnp.vdot(a, b) for a, b in zip(*map(jax.tree.leaves, (slope, direction)), strict=True))
print(f"gradient through the motions {along:.8f}, by differences {difference:.8f}")
assert abs(along - difference) < 1e-6 * abs(difference)

# The training, by Adam: a new batch of targets in every step.
first = second = jax.tree.map(jnp.zeros_like, network)
value_and_slope, losses, begin = jax.jit(jax.value_and_grad(loss)), [], perf_counter()
for k in range(1, 151):
    value, slope = value_and_slope(network, some_targets(rng, 128))
    first = jax.tree.map(lambda m, g: 0.9 * m + 0.1 * g, first, slope)
    second = jax.tree.map(lambda v, g: 0.99 * v + 0.01 * g**2, second, slope)
    rate = 0.03 * 0.985**k * np.sqrt(1 - 0.99**k) / (1 - 0.9**k)
    network = jax.tree.map(
        lambda w, m, v, rate=rate: w - rate * m / (jnp.sqrt(v) + 1e-8), network, first, second
    )
    losses.append(float(value))
seconds = perf_counter() - begin
print(f"loss {losses[0]:.4f}, at the end {np.mean(losses[-10:]):.4f}")
print(f"{1e3 * seconds / len(losses):.0f} ms for 128 motions and their gradient")

# Targets that it has not seen: in JAX, and in cardan's own runs, where torques are held as well.
targets = some_targets(np.random.default_rng(99), 12)
x, _ = ends(network, targets)
names, act = model.inputs, jax.jit(torques)
motions = []
for target in targets:
    inputs = {
        name: lambda t, x, k=k, target=target: float(act(network, x[None], target[None])[0, k])
        for k, name in enumerate(names)
    }
    motions.append(
        model.simulate(STEP * COUNT, q=np.asarray(START[:2]), inputs=inputs, sample=STEP, rtol=1e-9)
    )
steps = max(np.abs(m.x[-1] - end).max() for m, end in zip(motions, x, strict=True))
places = np.array([[m["hand_x"][-1], m["hand_y"][-1]] for m in motions])
missed = 1e3 * np.linalg.norm(places - targets, axis=1)
print(
    f"12 new targets are missed by {missed.mean():.0f} mm, {missed.max():.0f} at most, of 1000 mm"
)
print(f"JAX's steps and runs at a tight tolerance end apart by {steps:.0e} rad or rad/s")
assert missed.mean() < 60

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.5), layout="constrained")
left.semilogy(losses)
left.set(xlabel="batch", ylabel="loss", title="Training")
for m, target in zip(motions, targets, strict=True):
    (line,) = right.plot(m["hand_x"], m["hand_y"])
    right.plot(*target, "x", color=line.get_color())
right.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="The hand, to new targets (x)")
figure.savefig(out / "policy.png", dpi=120)
motions[0].animate(out / "arm.html", traces=["lower"])
