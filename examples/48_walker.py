"""A walker without motors: its gait down a slope, how it recovers, and where it begins to limp.

Two legs and a hip, the compass gait. A step ends where the swinging foot strikes the ground; then
the legs change their names.

Run it anywhere; it writes into ``out/walker``. See docs/cycles.md.

Source: A. Goswami, B. Thuilot, B. Espiau, Int. J. Robotics Research 17 (1998), 1282-1301.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp

import cardan as cd

out = Path("out/walker")
out.mkdir(parents=True, exist_ok=True)
LEG, HIP, A, B = 5.0, 10.0, 0.5, 0.5  # kg, kg, and a leg's mass above its foot and below the hip, m
LENGTH = A + B

# Legs are bars without mass that carry theirs in the middle; angles are from the vertical.
scene = cd.Scene("compass_gait", gravity=(0, 0, -9.81))
slope = scene.parameter("slope", np.radians(3), "rad")
stance = scene.body("stance_leg", mass=LEG, com=(0, 0, A), inertia=(0, 0, 0))
hip = scene.body("hip_mass", mass=HIP, inertia=(0, 0, 0))
swing = scene.body("swing_leg", mass=LEG, com=(0, 0, -B), inertia=(0, 0, 0))
scene.joint("stance", cd.Revolute((0, -1, 0)), scene.ground, stance)
scene.joint("top", cd.Fixed(), stance.at(0, 0, LENGTH), hip)
scene.joint("hip", cd.Revolute((0, -1, 0)), stance.at(0, 0, LENGTH), swing)
# a step ends where the foot comes to the ground with legs apart, not where it passes the other leg
height = 2 * scene.q("stance") + scene.q("hip") + 2 * slope
scene.force("strike", cd.Event(sp.Max(height, 0.1 - scene.q("hip")), terminal=True))
model = cd.compile(scene)


def strike(before):
    """The state behind the impact: the foot stays, the other one leaves the ground.

    The whole keeps its angular momentum about the new contact, the trailing leg about the hip.
    """
    c = np.cos(before["hip"])
    rates = np.array([before["stance.u"] + before["hip.u"], before["stance.u"]])
    whole = -LEG * A * B + (HIP * LENGTH**2 + 2 * LEG * A * LENGTH) * c
    old = [[-LEG * A * B, whole], [0, -LEG * A * B]]
    whole = LEG * LENGTH * (LENGTH - B * c) + LEG * A**2 + HIP * LENGTH**2
    new = [[LEG * B * (B - LENGTH * c), whole], [LEG * B**2, -LEG * B * LENGTH * c]]
    swing, stance = np.linalg.solve(new, old @ rates)
    angle = before["stance"] + before["hip"]
    return {"stance": angle, "hip": -before["hip"], "stance.u": stance, "hip.u": swing - stance}


# The gait, from 3 percent off.
near = {"stance": 0.2187, "hip": -0.5421, "stance.u": -1.0924, "hip.u": 0.7150}
start = {name: 1.03 * value for name, value in near.items()}
gait = model.cycle(start, section="strike", symmetry=strike, check=True)
print(gait)

# From a Taylor series in 22 digits, by another program: angles and rates of both legs, period.
angle, swing_rate, stance_rate = 0.21866880293899058, -0.37737394890719933, -1.0923835898836036
reference = [angle, -2 * angle - 2 * np.radians(3), stance_rate, swing_rate - stance_rate]
off = max(abs(gait[name] - value) for name, value in zip(near, reference, strict=True))
late = abs(gait.period - 0.7343463911587157)
factor = gait.multipliers[0]
apart_from = abs(factor - (-0.19972612682999336 + 0.5444760620947514j))
print(f"state off by {off:.0e}, period by {late:.0e} s, multiplier by {apart_from:.0e}")
assert max(off, late, apart_from) < 1e-10
print(f"steps of {2 * LENGTH * np.sin(abs(gait['hip']) / 2):.4f} m in {gait.period:.4f} s")


def step(state, **parameters):
    """The state behind the next strike, and when it happens [s]."""
    names = ("stance", "hip")
    q, u = ({name: state[name + ending] for name in names} for ending in ("", ".u"))
    motion = model.simulate(3.0, q=q, u=u, rtol=1e-10, parameters=parameters, check=True)
    assert motion.status == "event", "it fell"
    return strike({name: float(motion[name][-1]) for name in near}), float(motion.t[-1])


# How it recovers from the 3 percent, step by step; the multipliers say by which factor.
away, state = [], start
for _ in range(16):
    away.append(np.linalg.norm([state[name] - gait[name] for name in near]))
    state, _ = step(state)
rate = (away[13] / away[1]) ** (1 / 12)
print(f"a disturbance shrinks by {rate:.3f} a step, the multiplier has {abs(factor):.3f}")
assert abs(rate - abs(factor)) < 0.05

# Down steeper slopes: above a slope every other step is shorter, and above another every fourth.
steepest = np.radians(5)
path = model.continuation(slope=(np.radians(3), steepest), of="cycles", start=gait)
limp = path.point("period doubling 1")
limping = model.continuation(slope=(limp["slope"], steepest), of="cycles", start=limp)
fours = limping.point("period doubling 1")
print(f"it limps above {np.degrees(limp['slope']):.3f} degrees, with the period of two steps,")
print(f"and above {np.degrees(fours['slope']):.3f} degrees with that of four")

figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
left.semilogy(away, "o-", label="steps")
left.semilogy(away[1] * abs(factor) ** np.arange(-1, 15), "0.6", label="largest multiplier")
left.set(xlabel="step", ylabel="distance from the gait", title="It recovers from 3 percent")
left.legend()
right.plot(np.degrees(path["slope"]), path["period"], "C0.-", label="all steps alike")
durations = []
for cycle, steep in zip(limping, limping["slope"], strict=True):
    _, first = step({name: cycle[name] for name in near}, slope=steep)
    durations.append((first, cycle.period - first))
right.plot(np.degrees(limping["slope"]), durations, "C1.-", label=["short steps", "long"])
right.axvline(np.degrees(fours["slope"]), color="0.7", label="four steps repeat")
right.set(
    xlabel="slope [degrees]",
    ylabel="duration of a step [s]",
    title="and limps down a steeper slope",
)
right.legend()
figure.savefig(out / "walker.png", dpi=120)
gait.animate(out / "walker.html")
