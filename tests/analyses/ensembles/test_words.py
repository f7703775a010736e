"""Messages, warnings, tables and named energies of ensembles."""

from __future__ import annotations

import csv
import warnings
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from mechanisms.closed_planar import four_bar


@pytest.fixture(scope="module")
def pendulum() -> cd.CompiledModel:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    return cd.compile(scene)


def test_one_warning_counts_the_runs_and_points_here() -> None:
    """Every run warned for itself, at a line of a thread."""
    model = cd.compile(four_bar())
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        model.ensemble(0.01, q={"A": [0.0, 0.0, 0.5, 0.0]})
    (one,) = [w for w in told if "equally near" in str(w.message)]
    assert one.filename == __file__
    assert str(one.message).startswith("3 of 4 runs: the start of 'four_bar' is equally near")
    assert str(one.message).endswith("(run 0, the first)")


def test_a_loop_that_does_not_close_names_arguments_that_exist() -> None:
    """It said start=, which is an argument of assemble alone, and blamed digits of lengths."""
    model = cd.compile(four_bar(ground=0.5503))
    with pytest.raises(cd.ModelError, match="the loop that joint 'C' closes") as told:
        model.simulate(0.1)
    assert "give q= near" in str(told.value)
    assert "digits" not in str(told.value)
    with pytest.raises(cd.ModelError, match="give start= near"):
        model.assemble()


def test_a_failed_run_is_named_with_its_motion() -> None:
    """There is no motion at hand: run(k) makes it."""
    scene = cd.Scene("broken")
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
    scene.force("push", cd.JointForce("slide", sp.sqrt(1 - scene.q("slide"))))
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match=r"runs\.run\(1\)\.x\[-1\]"):
        runs = model.ensemble(3.0, q={"slide": [-200.0, 0.9]}, u={"slide": [0.0, 5.0]})
    assert runs.status[1] == "not_finite"
    assert "motion.x" not in runs.messages[1].replace("run(1).x", "")


def test_a_negative_mass_names_run_and_value(pendulum: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=r"cannot be -1 kg \(run 1 of 3, from 0\)"):
        pendulum.ensemble(0.1, vary={"rod.mass": [1.0, -1.0, 2.0]})


def test_energies_have_histories(pendulum: cd.CompiledModel) -> None:
    """By the energy balance: nothing is lost, and kinetic energy is largest at the bottom."""
    words = ["max of kinetic energy", "min of potential energy", "range of energy"]
    runs = pendulum.ensemble(2.0, q={"pivot": [0.5, 1.0]}, reduce=words, rtol=1e-10)
    drop = 9.81 * 0.5 * (1 - np.cos([0.5, 1.0]))
    assert runs["max of kinetic energy"] == pytest.approx(drop, rel=1e-3)
    assert runs["min of potential energy"] == pytest.approx([-9.81 / 2] * 2, rel=1e-3)
    assert runs["range of energy"] == pytest.approx([0, 0], abs=1e-8)
    with pytest.raises(cd.ModelError, match=r"no history 'enrgy'.*Did you mean 'energy'"):
        pendulum.ensemble(1.0, q={"pivot": [0.5, 1.0]}, reduce="max of enrgy")


def test_columns_of_a_table_have_the_names_of_states(
    pendulum: cd.CompiledModel, tmp_path: Path
) -> None:
    runs = pendulum.ensemble(0.1, q={"pivot": [0.5, 1.0]}, reduce="states")
    runs.save(tmp_path / "runs.csv")
    with (tmp_path / "runs.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["final pivot"]) for row in rows] == runs["pivot"].tolist()
    assert [float(row["final pivot.u"]) for row in rows] == runs["pivot.u"].tolist()
    assert float(rows[1]["states[0] pivot"]) == 1.0
