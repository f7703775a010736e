"""A double pendulum and a sliding door as FMUs, simulated by another program.

Run it anywhere; it writes into ``out/fmu``. Needs fmpy: pip install fmpy.
"""

from pathlib import Path

import fmpy
import numpy as np
from fmpy.validation import validate_fmu

import cardan as cd

out = Path("out/fmu")
out.mkdir(parents=True, exist_ok=True)

# One file: the description, a binary for this machine, and its C for all others.
equations = cd.derive(cd.examples["double_pendulum"])
arm = equations.export(out / "arm.fmu", q={"shoulder": 1.0})
print(f"{arm} has {arm.stat().st_size // 1000} KB; fmpy objects to {validate_fmu(str(arm))}")

# Co-simulation: cardan's own integrator moves inside the FMU, from one output time to the next.
# Model exchange: the importer integrates, here with CVode.
times = np.linspace(0, 2, 41)
expected = cd.compile(equations).simulate(times, q={"shoulder": 1.0}, rtol=1e-9)
for kind in ("CoSimulation", "ModelExchange"):
    rows = fmpy.simulate_fmu(
        str(arm),
        fmi_type=kind,
        stop_time=2.0,
        output_interval=0.05,
        relative_tolerance=1e-10,
        output=["shoulder", "elbow", "energy.total"],
    )
    apart = np.abs(rows["elbow"] - expected["elbow"]).max()
    print(f"{kind}: the elbow is within {apart:.0e} rad of simulate()")
    assert apart < 1e-5

# Stops and a sampled controller: events happen inside the steps of co-simulation, and
# are signs and times for the importer in model exchange. FMI 2.0 is for programs that know no 3.0.
scene = cd.Scene("elevator_door")
door = scene.body("door", mass=20.0)
scene.joint("rail", cd.Prismatic("x"), scene.ground, door)
scene.force("friction", cd.JointDamper("rail", 12.0))
scene.force("ends", cd.Stop("rail", lower=0.0, upper=0.9, restitution=0.4, settle=0.02))
x, v = scene.q("rail"), scene.u("rail")
goal = scene.input("goal", default=0.9, unit="m")
law = {"target": goal, "kp": 600.0, "ki": 0.0, "kd": 220.0}
scene.force("motor", cd.Controller.pid("rail", x, v, sample=0.02, **law))
path = cd.derive(scene).export(out / "door.fmu", fmi="2.0")
rows = fmpy.simulate_fmu(
    str(path), stop_time=4.0, output_interval=0.01, start_values={"goal": 0.8}, output=["rail"]
)
print(f"the door stands at {rows['rail'][-1]:.3f} m")
assert abs(rows["rail"][-1] - 0.8) < 0.05
