"""An antenna of eight flexible ribs unfolds from a spinning spacecraft and latches.

Hub, hinges and ribs are data of our own. Run it anywhere; it writes into ``out/antenna``.
"""

import time
from pathlib import Path

import numpy as np

import cardan as cd

out = Path("out/antenna")
out.mkdir(parents=True, exist_ok=True)
RIBS, LENGTH, RISE, WIDTH, HEIGHT, STOWED = 8, 3.0, 0.6, 0.02, 0.04, -1.4
carbon = cd.material(E=70e9, nu=0.3, rho=1600, damping=1e-3)


def rib_mesh(cells=16):
    """A bar along a parabola: bricks with 20 nodes, one behind the other."""
    corners = [(x, *yz) for x in (0, 2) for yz in ((0, 0), (2, 0), (2, 2), (0, 2))]
    edges = ["01", "12", "23", "30", "45", "56", "67", "74", "04", "15", "26", "37"]
    middles = [np.add(corners[int(a)], corners[int(b)]) // 2 for a, b in edges]
    step, y, z = np.indices((2 * cells + 1, 3, 3)).reshape(3, -1)
    s, side, up = step / step.max(), WIDTH * (y - 1) / 2, HEIGHT * (z - 1) / 2
    angle = np.arctan2(2 * RISE * s, LENGTH)
    x, z = LENGTH * s - up * np.sin(angle), RISE * s**2 + up * np.cos(angle)
    first = np.array(corners + middles) @ (9, 3, 1)
    used, bricks = np.unique(first + 18 * np.arange(cells)[:, None], return_inverse=True)
    ends = {"root": np.flatnonzero(step[used] == 0), "tip": np.flatnonzero(s[used] == 1)}
    points, bricks = np.stack([x, side, z], axis=1)[used], bricks.reshape(cells, 20)
    return cd.superelement.mesh.from_arrays(points, {"hex20": bricks}, ends)


# Reduced once. The ends follow the mean of their nodes, as sections of beams do.
mesh, ends = rib_mesh(), {"root": "root", "tip": "tip"}
nodes = range(len(mesh.points))
rib = cd.superelement.from_mesh(mesh, carbon, ends, modes=4, rigid="rbe3", stress=nodes)
print(rib)
line = [(LENGTH * s, 0, RISE * s**2) for s in np.linspace(0, 1, 9)]


def antenna(rib=None, angle=None):
    """Ribs are one record eight times, or beams without it; an angle holds the hinges there."""
    scene = cd.Scene("antenna", gravity=(0, 0, 0))
    drum = cd.shape.cylinder(0.5, 0.5, position=(0, 0, -0.2))
    hub = scene.body("hub", mass=120.0, inertia=(20.0, 20.0, 30.0), shape=drum)
    scene.joint("drift", cd.Free(), scene.ground, hub)
    for k in range(RIBS):
        turn = 2 * np.pi * k / RIBS
        place = hub.at(0.5 * np.cos(turn), 0.5 * np.sin(turn), 0, rotation=("ZYX", turn, 0, 0))
        fitting = scene.body(f"fitting{k}", mass=0.5, inertia=(1e-3, 1e-3, 1e-3))
        if angle is not None:
            held = place.at(rotation=("ZYX", 0, angle, 0))
            scene.joint(f"hinge{k}", cd.Fixed(), held, fitting)
        else:
            # Gears keep all hinges in step with the first.
            gear = ("hinge0", 1) if k else None
            scene.joint(f"hinge{k}", cd.Revolute("y"), place, fitting, couple=gear)
        if rib is None:
            section = cd.section.rectangle(WIDTH, HEIGHT)
            curve = cd.spline(line)
            scene.beam(f"rib{k}", fitting, line[-1], section, carbon, 8, line=curve, base=fitting)
        else:
            one = scene.superelement(f"rib{k}", rib, {"root": fitting}, frame="root")
            scene.output(f"tip{k}", one.at("tip").position(wrt=hub, in_=hub)[2], unit="m")
    if angle is None:
        # A spring with a damper opens the hinges, a latch catches them where the ribs are open.
        spring = cd.JointSpring("hinge0", stiffness=40.0, damping=60.0, rest=0.1)
        scene.force("spring", spring)
        scene.force("latch", cd.Lock("hinge0", when=-scene.q("hinge0")))
    return scene


# Frequencies with hinges that are held, beside those of geometrically exact beams.
for name, angle in (("stowed", STOWED), ("deployed", 0.0)):
    found, beams = (cd.compile(antenna(one, angle)).modes(30).frequencies for one in (rib, None))
    found, beams = found[6:24], beams[6:24]
    print(f"{name}: {np.round(found[[0, 5, 7]], 3)} Hz ... {found[-1]:.2f} Hz")
    print(
        f"  of beams {np.round(beams[[0, 5, 7]], 3)} Hz, {np.abs(found / beams - 1).max():.1e} off"
    )

# The motion, from a slow spin. Symmetric ribs move alike; no momentum comes from anywhere.
scene = antenna(rib)
model = cd.compile(scene)
folded, spin = {"hinge0": STOWED}, {"drift": [0, 0, 0.5, 0, 0, 0]}
model.simulate(0.01, q=folded, u=spin)  # compiles what runs need
begin = time.perf_counter()
motion = model.simulate(6.0, q=folded, u=spin, rtol=1e-5)
seconds = time.perf_counter() - begin
print(motion)
(latch,) = motion.events
rate, tips = motion["drift.u.z"], np.array([motion[f"tip{k}"] for k in range(RIBS)])
momentum = model.momentum(motion.q, motion.u)
drift = np.abs(momentum - momentum[0]).max() / np.linalg.norm(momentum[0])
stress = motion.superelement("rib0").largest_stress
after = motion.t > latch.t
print(f"latched at {latch.t:.3f} s; the spin falls from {rate[0]:.3f} to {rate[-1]:.3f} rad/s")
print(f"tips swing by {np.ptp(tips[0, after]) / 2:.3f} m; von Mises {stress.max() / 1e6:.1f} MPa")
print(f"momentum off by {drift:.1e}, ribs differ by {np.ptp(tips, axis=0).max():.1e} m")
print(f"energy: {motion.balance}")
print(f"{1000 * seconds / (len(motion.t) - 1):.2f} ms per step")
assert drift < 1e-4
assert np.ptp(tips, axis=0).max() < 1e-9
page = motion.animate(out / "antenna.html", plots=["hinge0", "tip0", "energy"])
