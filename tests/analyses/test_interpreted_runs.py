"""Runs whose model functions are evaluated in Python: every integrator as with compiled ones."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from analyses.interpreted import beam, bouncing, four_bar, without_compiler
from cardan.build import prebuilt
from cardan.schema.integrators import INTEGRATORS

RTOL = 1e-6
# order 2 without damping needs constraints that it keeps itself
DAMPED = {"Newmark"}
# moves bodies as such
FREE = {"EnergyMomentum"}
# derivatives of the right-hand side, which elements do not offer
DERIVED = {"Radau", "Rosenbrock"}
SCENES: dict[str, tuple[Callable[[], cd.Scene], float, dict[str, Any], set[str]]] = {
    "tree": (double_scene, 0.5, {"q": {"elbow": 0.4}}, FREE),
    "loop": (four_bar, 0.3, {"q": {"A": 0.5}, "u": {"A": 8.0}}, FREE | DAMPED),
    "events": (bouncing, 1.0, {}, FREE | DAMPED),
    "beam": (beam, 0.02, {}, DERIVED | DAMPED),
}


def options(name: str) -> dict[str, Any]:
    """How the table runs a method."""
    method = INTEGRATORS[name]
    fixed = not method.adaptive or method.fixed_step_on_request
    return {"method": name, **({"step": 2e-3} if fixed else {"rtol": RTOL})}


# in a process of its own, whose cache is empty
WITHOUT = """
import json, sys, warnings
import numpy as np
import cardan as cd
from analyses.conftest import double_scene
from analyses.interpreted import beam, bouncing, four_bar
from cardan.build import toolchain

if "bare" in sys.argv:
    toolchain.ziglang = list
warnings.simplefilter("ignore")
found = {}
for name, scene, end, start in (
    ("tree", double_scene(), 0.3, {"q": {"elbow": 0.4}}),
    ("loop", four_bar(), 0.1, {"q": {"A": 0.5}, "u": {"A": 8.0}}),
    ("events", bouncing(), 1.0, {}),
    ("beam", beam(), 0.01, {}),
):
    motion = cd.compile(scene).simulate(end, **start)
    found[name] = [motion.status, motion.statistics["steps"], motion.x[-1].tolist()]
made = cd.compile(double_scene()).ensemble(0.3, q={"elbow": np.linspace(0, 1, 8)}, threads=4)
found["ensemble"] = ["finished" if made.success else "", 0, made.final.ravel().tolist()]
print(json.dumps(found))
"""


@pytest.mark.filterwarnings("ignore::cardan.errors.SolveWarning")
@pytest.mark.parametrize("scene", SCENES)
def test_every_integrator_runs_as_compiled(scene: str, monkeypatch: pytest.MonkeyPatch) -> None:
    build, end, start, unsuited = SCENES[scene]
    model = cd.compile(build(), **({"constraints": "multipliers"} if scene == "loop" else {}))
    methods = [name for name in INTEGRATORS if name not in unsuited]
    known = {name: model.simulate(end, **options(name), **start) for name in methods}
    other = without_compiler(model, monkeypatch)
    for name, compiled in known.items():
        motion = other.simulate(end, **options(name), **start)
        assert motion.status == compiled.status == "finished", (name, motion.message)
        assert [e.name for e in motion.events] == [e.name for e in compiled.events]
        steps = motion.statistics["steps"], compiled.statistics["steps"]
        assert abs(steps[0] - steps[1]) <= 0.02 * steps[1], (name, steps)
        size = np.maximum(1.0, np.abs(compiled.x[-1]))
        error = np.abs(motion.x[-1] - compiled.x[-1]) / size
        assert error.max() <= 10 * RTOL, (name, error.max())
        assert "pip install 'cardan[compiler]'" in motion.solver_info.settings
        assert "pip install" not in compiled.solver_info.settings


@pytest.mark.parametrize("threads", [1, 4])
def test_an_ensemble(threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    model = cd.compile(double_scene())
    varied: dict[str, Any] = {
        "t": np.linspace(0, 0.5, 6),
        "vary": {"elbow": np.linspace(0, 1, 12), "upper.mass": np.linspace(1, 2, 12)},
    }
    compiled = model.ensemble(**varied)
    other = without_compiler(model, monkeypatch)
    found = other.ensemble(**varied, threads=threads)
    assert found.status.tolist() == ["finished"] * 12
    np.testing.assert_allclose(found.final, compiled.final, rtol=0, atol=10 * RTOL)


@pytest.mark.skipif(prebuilt.current() is None, reason="no kernels were compiled at installation")
def test_a_machine_without_any_compiler(tmp_path: Path) -> None:
    """From scenes to motions in an empty cache: only kernels of the installation are there."""
    root = Path(__file__).parents[1]
    paths = os.pathsep.join([str(root), *filter(None, [os.environ.get("PYTHONPATH")])])
    usual = os.environ | {"PYTHONPATH": paths}
    bare = {name: value for name, value in usual.items() if name != "CC"}
    bare |= {"PATH": "/nonexistent", "CARDAN_CACHE": str(tmp_path / "cache")}
    command = [sys.executable, "-c", WITHOUT]
    compiled, found = (
        json.loads(subprocess.check_output([*command, *words], env=environment, text=True))
        for words, environment in (((), usual), (("bare",), bare))
    )
    assert not list((tmp_path / "cache").rglob("*.so"))
    for name, (status, steps, last) in found.items():
        assert status == compiled[name][0] == "finished"
        assert abs(steps - compiled[name][1]) <= 0.02 * compiled[name][1]
        wanted = np.array(compiled[name][2])
        assert np.abs(last - wanted).max() <= 10 * RTOL * max(1.0, np.abs(wanted).max())
