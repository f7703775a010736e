"""Runs over elements in files: every integrator goes on to the bit, events and states included."""

from __future__ import annotations

import functools
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_event_runs import REFUSED, everything
from analyses.test_run_file import alike, killed
from cardan.analyses.simulation import run
from cardan.schema.integrators import INTEGRATORS
from hostile.kinds import records, together
from spread import some

SPAN = 0.06
# given steps: as many as there are records
STEPS = {"RK4": 1e-4, "RKMK4": 1e-4, "EnergyMidpoint": 2e-4, "EnergyMomentum": 1e-3}


def soft() -> cd.Scene:
    """The beam with what may happen to it, of a material that leaves explicit methods long steps.

    A motor with a lag has states of its own beside those of the sampled controller, and inputs
    push at the tip.
    """
    scene = everything()
    scene.force("motor", cd.Actuator("tilt", command=scene.input("command"), lag=0.01, limit=0.1))
    return scene


def ball() -> cd.Scene:
    """A ball that meets a floor: no constraints."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    sphere = scene.body("ball", mass=0.2, inertia=(1e-3,) * 3)
    scene.joint("J", cd.Free(), scene.ground, sphere, q0=(1, 0, 0, 0, 0, 0, 0.15))
    scene.force(
        "floor", cd.Contact(sphere, scene.ground, radius=0.1, stiffness=2e3, damping=0.1, mu=0.2)
    )
    return scene


def rod() -> cd.Scene:
    """A rubber beam on a pin: nothing is lost."""
    scene = cd.Scene("rod", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.5, rho=1100)
    tube = cd.section.tube(0.01, 0.002)
    beam = scene.beam("rod", (0, 0, 0), (1, 0, 0), tube, rubber, elements=4, inertia="lumped")
    scene.joint("pin", cd.Spherical(), scene.ground, beam.start)
    return scene


@functools.cache
def made(scene: Callable[[], cd.Scene], coordinates: str | None = "absolute") -> cd.CompiledModel:
    """Compiled once for all tests."""
    return cd.compile(scene(), coordinates=coordinates)


def case(method: str) -> tuple[cd.CompiledModel, dict[str, Any]]:
    """A model that a method takes, with as much in it as it does, and a run of it."""
    options: dict[str, Any] = {"method": method}
    options |= {"step": STEPS[method]} if method in STEPS else {"rtol": 1e-6, "atol": 1e-9}
    if method == "EnergyMomentum":
        return made(rod), options | {"t": 0.2}
    if method == "Newmark":
        return made(ball), options | {"t": 0.4, "rtol": 1e-8}
    push = ([0.0, 0.02, 0.02, 1.0], [0.0, 0.05, -0.05, 0.1])
    return made(soft, None), options | {"t": SPAN, "inputs": {"command": push}}


METHODS = [m for m in INTEGRATORS if "rhs_jacobian" not in REFUSED.get(m, "")]


@pytest.mark.parametrize("method", some([*METHODS, "auto"], 3))
def test_a_killed_run_goes_on_to_the_bit(method: str, tmp_path: Path) -> None:
    model, options = case(method)
    whole = model.simulate(**options)
    assert whole.success
    assert method == "EnergyMomentum" or len(whole.events) > 0
    stored = options | {"checkpoint": tmp_path / "run", "every": 0.0}
    killed(model, stored, tmp_path, 0.4, piece=0.0)
    # it goes on where the other one was
    last = records(stored["checkpoint"].read_bytes())["records"][-1]["head"]
    assert 0.4 < last["record"]["t"] / options["t"] < 1.0
    alike(model.simulate(**stored), whole)


@pytest.mark.parametrize("method", some(["Radau", "HHT", "GeneralizedAlpha", "DOP853"], 2))
def test_a_run_goes_on_from_every_place(
    method: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between an event and what it changes, beside a sample, in the first step behind it."""
    model, options = case(method)
    path, whole = tmp_path / "run", model.simulate(**options)
    stored = options | {"checkpoint": path, "every": 0.0}
    with monkeypatch.context() as slices:
        # of one step or event each, with a record after every one
        slices.setattr(run, "SLICE", 0.0)
        model.simulate(**stored)
    parts = records(path.read_bytes())
    heads = [one["head"]["record"] for one in parts["records"]]
    assert {head["event_pending"] for head in heads} == {0, 1}
    around = [k + i for k, head in enumerate(heads) for i in (0, 1, 2) if head["event_pending"]]
    chosen = {*around[:: max(1, len(around) // 12)], *range(1, len(heads), len(heads) // 6)}
    for count in sorted(chosen & {*range(1, len(heads))}):
        path.write_bytes(together({**parts, "records": parts["records"][:count]}))
        alike(model.simulate(**stored), whole)


GO_ON = """
import sys, cardan as cd
model = cd.load_model(sys.argv[1])
stepper = model.resume(sys.argv[2])
print(stepper.step(float(sys.argv[3])).tobytes().hex(), repr(stepper.modes))
"""


@pytest.mark.parametrize("method", some(METHODS, 4))
def test_a_stepper_goes_on_in_another_process(method: str, tmp_path: Path) -> None:
    model, options = case(method)
    part = options.pop("t") / 2
    given = options.pop("inputs", {})
    stepper = model.stepper(**options)
    stepper.step(part, inputs={name: values[0] + 0.05 for name, (_, values) in given.items()})
    stepper.save(tmp_path / "run.npz")
    command = [sys.executable, "-c", GO_ON, str(model.directory), str(tmp_path / "run.npz")]
    done = subprocess.run([*command, str(part)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    there = stepper.step(part)
    assert np.abs(there[: model.nq]).max() > 0
    assert done.stdout.strip() == f"{there.tobytes().hex()} {stepper.modes!r}"


def test_files_of_other_elements_are_refused(tmp_path: Path, bare: Any) -> None:
    model, options = case("GeneralizedAlpha")
    path = tmp_path / "run"
    stored = options | {"t": 0.005, "checkpoint": path}
    model.simulate(**stored)
    other = model.with_parameters({"head.mass": 0.2})
    with pytest.raises(cd.ModelError, match="computed with another model"):
        other.simulate(**stored)
    with pytest.raises(cd.ModelError, match="another compiler, processor"):
        bare(model).simulate(**stored)
    stepper = model.stepper(method="DOP853")
    stepper.save(tmp_path / "run.npz")
    with pytest.raises(cd.ModelError, match="other equations or parameters"):
        other.resume(tmp_path / "run.npz")
