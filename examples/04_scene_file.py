"""Scene files: the double pendulum as text, a mistake in it, a machine of parts, a robot to edit.

Run it anywhere; it writes into ``out/scene_file``. The format is described in docs/scene_files.md.
"""

from pathlib import Path

import cardan as cd

here, out = Path(__file__).parent, Path("out/scene_file")
out.mkdir(parents=True, exist_ok=True)

# The file says what 01_double_pendulum.py says, in the same words. So it becomes the same C.
file = cd.examples.path("double_pendulum")
scene = cd.load(file)
print(scene)

# A file may say how it wants to be simulated; `cardan simulate FILE` does just this.
motion = cd.compile(scene).simulate(**scene.settings)
print(motion)

# A mistake is named by line and column, with what was probably meant.
wrong = out / "mistake.yaml"
text = file.read_text(encoding="utf-8")
wrong.write_text(text.replace("child: lower", "child: lover"), encoding="utf-8")
try:
    cd.load(wrong)
except cd.ModelError as problem:
    print(problem)

# Machines are made of parts: the trolley carries the same bucket twice, one with more load.
trolley = cd.examples["trolley"]
model = cd.compile(trolley)
swinging = model.simulate(**trolley.settings)
print("coordinates:", *model.coordinates)
print(f"the left bucket swings up to {abs(swinging['left.hang.angle2']).max():.3f} rad")

# A robot from elsewhere becomes a scene that can be edited, and back, to the last bit.
robot = cd.load(here / "arm.urdf")
robot.save(out / "arm.yaml")
print((out / "arm.yaml").read_text(encoding="utf-8")[:400], "...")
rest = [0.3, -0.6, 0.9]
again = cd.compile(cd.load(out / "arm.yaml")).gravity(rest)
assert (again == cd.compile(robot).gravity(rest)).all()
