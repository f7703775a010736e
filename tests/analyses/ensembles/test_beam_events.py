"""Ensembles of scenes with elements and events: the bits of single runs, in threads."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.ensembles.test_bits import same
from analyses.test_beam_checkpoints import METHODS, ball, case, made
from analyses.test_run_file import alike
from spread import some

RUNS = 10  # two blocks
# what differs from run to run, and by how much
VARIED = {"EnergyMomentum": "rod.material.E", "Newmark": "ball.mass"}


def ensemble(method: str) -> tuple[cd.CompiledModel, dict[str, Any], str, Any]:
    """A model, what to call it with, and a parameter that differs from run to run."""
    model, options = case(method)
    name = VARIED.get(method, "head.mass")
    options["t"] = options["t"] * (0.5 if method in VARIED else 0.2)
    return model, options, name, model.parameters[name] * np.linspace(0.9, 1.2, RUNS)


@pytest.mark.parametrize("method", some(METHODS, 2))
def test_runs_have_the_bits_of_simulate(method: str) -> None:
    model, options, name, values = ensemble(method)
    runs = model.ensemble(**options, parameters={name: values}, threads=2)
    assert runs.success
    assert len({row.tobytes() for row in runs.final}) == RUNS
    for k in (0, 3, 9):
        alone = model.with_parameters({name: values[k]}).simulate(**options)
        np.testing.assert_array_equal(runs.final[k], alone.x[-1])
        assert runs.statistics["steps"][k] == alone.statistics["steps"]
        if k == 3:
            alike(runs.run(k), alone)


@pytest.mark.parametrize("method", ["GeneralizedAlpha", "DOP853"])
def test_threads_and_files_change_nothing(method: str, tmp_path: Any) -> None:
    model, options, name, values = ensemble(method)
    options |= {"parameters": {name: values}, "checkpoint": tmp_path / "runs"}
    first = model.ensemble(**options, threads=1)
    content = (tmp_path / "runs").read_bytes()
    # a killed process leaves whole blocks, and one that was cut off
    (tmp_path / "runs").write_bytes(content[: len(content) * 2 // 3])
    same(first, model.ensemble(**options, threads=2))


@pytest.mark.parametrize("method", ["DOP853", "RK45"])
def test_scenes_without_constraints_go_one_by_one(method: str) -> None:
    """Loops over lanes took the tables of elements for numbers."""
    model, masses = made(ball), np.array([0.1, 0.2, 0.3])
    runs = model.ensemble(0.1, q={"J.pz": 0.12}, parameters={"ball.mass": masses}, method=method)
    for k, mass in enumerate(masses):
        one = model.with_parameters({"ball.mass": mass})
        alone = one.simulate(0.1, q={"J.pz": 0.12}, method=method)
        np.testing.assert_array_equal(runs.final[k], alone.x[-1])
        assert len(alone.events) > 0


def test_reductions_take_the_parameters_of_their_run() -> None:
    model, masses = made(ball), np.array([0.1, 0.2, 0.3])
    runs = model.ensemble(
        np.linspace(0, 0.1, 5),
        q={"J.pz": 0.3},
        parameters={"ball.mass": masses},
        reduce="max of energy",
    )
    assert runs["max of energy"] == pytest.approx(masses * 9.81 * 0.3, rel=1e-9)
