"""A bay of a mast folds: three bars and six prestressed cables, by least strain energy.

Data are our own. Run it anywhere; it writes into ``out/truss``.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import cardan as cd

out = Path("out/truss")
out.mkdir(parents=True, exist_ok=True)
RADIUS, HEIGHT, TURN = 0.5, 0.8, 2 * np.pi / 3
BAR, EA, TENSION = 1.3e7, 2e4, 400.0  # N/m; N; N
SLACK = np.sqrt(HEIGHT**2 + 3 * RADIUS**2) / (1 + TENSION / EA)

# The upper triangle moves along its axis and turns about it. Bars stand upright; each corner
# below is tied to the next and to the last corner above.
scene = cd.Scene("bay", gravity=(0, 0, 0))
carriage = scene.body("carriage")
disk = cd.shape.cylinder(RADIUS, 0.01)
top = scene.body("top", mass=5.0, inertia=(0.5, 0.5, 1.0), shape=disk)
scene.joint("height", cd.Prismatic("z"), scene.ground, carriage, q0=HEIGHT)
scene.joint("twist", cd.Revolute("z"), carriage, top)
corners = [(RADIUS * np.cos(k * TURN), RADIUS * np.sin(k * TURN), 0.0) for k in range(3)]
for k in range(3):
    foot, ahead, behind = scene.ground.at(*corners[k]), corners[(k + 1) % 3], corners[k - 1]
    bar = cd.SpringDamper(foot, top.at(*corners[k]), BAR, damping=2e3, rest_length=HEIGHT)
    scene.force(f"bar{k}", bar)
    scene.cable(f"cable{k}", foot, top.at(*ahead), EA=EA, length=SLACK, damping=1e-3)
    scene.cable(f"counter{k}", foot, top.at(*behind), EA=EA, length=SLACK, damping=1e-3)
load = scene.parameter("load", 0.0, "N")
scene.force("load", cd.Force(top, (0, 0, -load)))
scene.force("end", cd.Stop("twist", upper=1.7, restitution=0.3, settle=0.05))
model = cd.compile(scene)

# Along the twist: force and strain energy, beside the closed form for rigid bars.
twist = np.concatenate([[1e-3], np.linspace(0.02, 1.68, 84)])
folding = model.sweep("twist", twist, by="strain_energy")
print(folding)
height = np.sqrt(HEIGHT**2 - 2 * RADIUS**2 * (1 - np.cos(twist)))
slope = -(RADIUS**2) * np.sin(twist) / height  # of the height over the twist
energy, torque = np.zeros_like(twist), np.zeros_like(twist)
for side in (TURN, -TURN):
    length = np.sqrt(HEIGHT**2 + 2 * RADIUS**2 * (np.cos(twist) - np.cos(twist + side)))
    pull = EA * np.maximum(length / SLACK - 1, 0)
    energy += 1.5 * pull**2 * SLACK / EA
    torque += 3 * pull * RADIUS**2 * (np.sin(twist + side) - np.sin(twist)) / length
force = -folding["twist.holding_force"] / slope
peak = folding.energy.argmax()
print(f"height off by {np.abs(folding['height'] - height).max():.1e} m from that of rigid bars,")
print(f"energy by {np.abs(folding.energy - energy).max():.1e} J of {energy.max():.1f} J,")
print(f"force by {np.abs(force + torque / slope).max():.1f} N of {force.max():.0f} N")
turned, down = np.degrees(twist[peak]), HEIGHT - height[peak]
print(f"beyond {turned:.0f} degrees, {down:.3f} m down, it folds by itself")
slack = np.flatnonzero(folding.energy < 1e-9)[0]
print(f"cables are slack from {np.degrees(twist[slack]):.0f} degrees on")

# It begins to twist at the load at which the straight bay is no longer stable.
length = SLACK * (1 + TENSION / EA)
first = RADIUS**2 * np.sin(TURN) / length  # derivatives of the length of a cable by the twist
second = -(1.5 * RADIUS**2 + first**2) / length
buckling = 6 * (EA / SLACK * first**2 + TENSION * second) * HEIGHT / RADIUS**2
print(f"it begins to twist at {force[0]:.1f} N, with rigid bars at {buckling:.1f} N")
print(f"it bears {force.max():.1f} N at {np.degrees(twist[force.argmax()]):.1f} degrees")

# A tenth more than it bears: it snaps, folds and hits the stop.
begin = {name: folding[name][1] for name in ("height", "twist")}
motion = model.simulate(0.25, q=begin, parameters={"load": 1.1 * force.max()})
print(motion)
motion.animate(out / "snap.html", plots=["twist", "height", "energy"])
folding.animate(out / "folding.html", plots=["height"])

figure, (above, below) = plt.subplots(2, 1, sharex=True, layout="constrained")
above.plot(HEIGHT - folding["height"], force, label="elastic bars")
above.plot(HEIGHT - height, -torque / slope, "k:", label="rigid bars")
below.plot(HEIGHT - folding["height"], folding.energy)
above.set(ylabel="axial force [N]")
below.set(xlabel="travel [m]", ylabel="strain energy [J]")
above.legend()
figure.savefig(out / "retraction.png")
