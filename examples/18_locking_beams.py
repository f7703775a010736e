"""A boom of two elastic tubes swings open and locks: the shock runs through both of them.

Run it anywhere; it writes into ``out/locking``.
"""

from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/locking")
out.mkdir(parents=True, exist_ok=True)


def boom(is_locked: bool) -> cd.CompiledModel:
    """Two tubes with a hinge between them, which a spring opens; or locked straight."""
    scene = cd.Scene("boom", gravity=(0, 0, 0))
    carbon = cd.material(E=7e10, nu=0.3, rho=1600, damping=2e-4)
    tube = cd.section.tube(outer=0.02, inner=0.018)
    inner = scene.beam("inner", scene.ground, (1, 0, 0), tube, carbon, elements=3)
    latch = scene.body("latch", mass=0.05, inertia=(1e-5, 1e-5, 1e-5))
    if is_locked:
        scene.joint("lock", cd.Fixed(), inner.end, latch)
    else:
        scene.joint("hinge", cd.Revolute("z"), inner.end, latch)
        scene.force("spring", cd.JointSpring("hinge", stiffness=2.0, rest=0.5))
    scene.beam("outer", latch, (2, 0, 0), tube, carbon, elements=3)
    return cd.compile(scene)


# Folded by a right angle; the run ends where the hinge is straight.
method = cd.GeneralizedAlpha(0.7)
opening = boom(False).simulate(
    3.0, q={"hinge": -np.pi / 2}, method=method, events={"straight": ("hinge", 0.0)}
)
print(opening)
print(f"straight after {opening.t[-1]:.3f} s, with {opening['hinge.u'][-1]:.2f} rad/s")

# Locked, the boom is another model; poses of nodes and bodies have the same names in both.
locked = boom(True)
places = [name for name in locked.joints if name in opening.model.joints]
start = locked.initial(q={n: opening[n][-1] for n in places})
start = np.concatenate([start[: locked.nq], *(opening[f"{n}.u"][-1] for n in places)])
swinging = locked.simulate((opening.t[-1], opening.t[-1] + 1.0), x0=start, method=method)
print(swinging)

# What the lock takes away is what its impulse takes: momentum stays, energy does not.
before, after = opening.energy.total[-1], swinging.energy.total[0]
print(f"energy before the lock {before:.3f} J, behind it {after:.3f} J")
for name, motion in (("opening", opening), ("locked", swinging)):
    moment = np.abs(motion.beam("inner").moment[..., 2]).max()
    print(f"{name}: the root bends with up to {moment:.1f} N m")
swinging.animate(out / "locking.html")
