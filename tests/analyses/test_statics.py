"""Load paths against closed forms: stability, limit loads, prescribed displacements, messages."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from mechanisms.closed import CLOSED

KNOWN = Path(__file__).parents[1] / "references" / "bar_spring_bifurcation.json"
LENGTH, STIFFNESS = (json.loads(KNOWN.read_text("utf-8"))["parameters"][k] for k in ("L", "k"))


def column(spring: str) -> cd.CompiledModel:
    """A rigid bar on its foot under a dead load P, held by a spring; leaning by ``phi0``."""
    scene = cd.Scene(spring, gravity=(0, 0, 0))
    P, k, lean = scene.parameter("P", 0.0), float(STIFFNESS), scene.parameter("phi0", 0.0)
    bar = scene.body("bar", mass=1.0, com=(0, 0, LENGTH / 2), inertia=(0.1, 0.1, 0.01))
    scene.joint("base", cd.Revolute("y"), scene.ground, bar)
    scene.force("load", cd.Force(bar.at(0, 0, LENGTH), (0, 0, -P)))
    phi = scene.q("base")
    if spring == "torsion":
        scene.force("spring", cd.JointForce("base", -k * phi))
    else:
        # horizontal, as far as the tip is from where it leans at rest
        moment = LENGTH * (sympy.sin(phi) - sympy.sin(lean)) * LENGTH * sympy.cos(phi)
        scene.force("spring", cd.JointForce("base", -k * moment))
    return cd.compile(scene)


@pytest.fixture(scope="module")
def torsion() -> cd.CompiledModel:
    return column("torsion")


@pytest.fixture(scope="module")
def horizontal() -> cd.CompiledModel:
    return column("horizontal")


def test_straight_column_loses_stability(
    torsion: cd.CompiledModel, horizontal: cd.CompiledModel
) -> None:
    for model, critical in ((torsion, STIFFNESS / LENGTH), (horizontal, STIFFNESS * LENGTH)):
        with pytest.warns(cd.SolveWarning, match=r"unstable from a load between .*along 'base'"):
            path = model.statics(P=(0, 2 * critical))
        assert path.success
        assert np.all(path["base"] == 0)
        assert [bool(s) for s in path.stable] == (path["P"] < critical - 1e-9).tolist()
        (found,) = path.critical()
        assert found["P"] == pytest.approx(critical, rel=1e-9)
        assert "stability changes between P = " in repr(path)


def test_stable_symmetric_branch(torsion: cd.CompiledModel) -> None:
    path = torsion.statics(P=(3.0, 1.01), q={"base": 1.5})
    phi = path["base"]
    np.testing.assert_allclose(path["P"], STIFFNESS * phi / (LENGTH * np.sin(phi)), rtol=1e-12)
    assert all(path.stable)
    # next to the bifurcation Newton's method slows down
    assert path.iterations[1:-1].max() <= 6


def test_unstable_symmetric_branch(horizontal: cd.CompiledModel) -> None:
    # unstable under the load, yet followed by prescribing the angle: the load is P = k L cos(phi)
    path = horizontal.statics(locked={"base": (0.1, 1.0)}, parameters={"P": 0.5})
    phi = path["base"]
    moment = STIFFNESS * LENGTH**2 * np.sin(phi) * np.cos(phi) - 0.5 * LENGTH * np.sin(phi)
    np.testing.assert_allclose(path["base.holding_force"], moment, rtol=1e-12, atol=1e-14)
    # without the hand it would be there under that load
    for angle in (0.3, 0.8):
        load = STIFFNESS * LENGTH * np.cos(angle)
        found = horizontal.equilibrium(q={"base": angle}, parameters={"P": load})
        assert found["base"] == pytest.approx(angle, rel=1e-9)
        assert found.stable is False


@pytest.mark.parametrize("lean", [0.01, 0.05, 0.2])
def test_imperfect_column_has_a_limit_load(horizontal: cd.CompiledModel, lean: float) -> None:
    limit = STIFFNESS * LENGTH * (1 - np.sin(lean) ** (2 / 3)) ** 1.5
    with pytest.warns(cd.SolveWarning, match=r"beyond P = .*along 'base'.*limit point"):
        path = horizontal.statics(P=(0, 1), q={"base": lean}, parameters={"phi0": lean})
    assert not path.success
    assert path.status == "singular"
    # what is kept comes close from below, and rests
    assert path["P"][-1] <= limit * (1 + 1e-9)
    assert path["P"][-1] == pytest.approx(limit, rel=1e-4)
    assert path[-1].converged
    assert path[-1].least < 0.2 * path[0].least
    with pytest.raises(cd.SolveError, match="limit point"):
        horizontal.statics(P=(0, 1), q={"base": lean}, parameters={"phi0": lean}, check=True)


def test_several_loads_go_together(torsion: cd.CompiledModel) -> None:
    path = torsion.statics(P=[0, 0.1, 0.5], phi0=[0, 1, 2])
    np.testing.assert_allclose(path["P"], [0, 0.1, 0.5])
    np.testing.assert_allclose(path["phi0"], [0, 1, 2])
    assert len(path) == 3
    assert path.model.parameters["P"] == 0.5


def test_reactions_and_runs_along_a_path(torsion: cd.CompiledModel) -> None:
    path = torsion.statics(P=(0, 0.9))
    wrench = path.reaction("base")
    np.testing.assert_allclose(wrench[:, 5], path["P"], atol=1e-12)
    assert path.pose("bar").shape == (len(path), 4, 4)
    # stable below P = 1: a push stays small
    motion = path.model.simulate(20.0, x0=path[-1].x + np.array([0, 1e-3]), rtol=1e-9)
    assert np.abs(motion["base"]).max() < 0.01


def test_a_mechanism_is_driven_by_an_input(crank: cd.CompiledModel) -> None:
    path = crank.statics(angle=(0, 1.2))
    np.testing.assert_allclose(path["hinge"], -path["angle"], atol=1e-12)


def test_circuit_under_a_held_crank() -> None:
    model = cd.compile(CLOSED["four_bar"].build())
    start = model.equilibrium()
    path = model.statics(locked={"A": (float(start["A"]), float(start["A"]) + 1.0)}, q=start.q)
    assert path.success
    # positions are those of the kinematic analysis, torques the change of the potential
    sweep = model.sweep("A", path["A"], start=start.q)
    np.testing.assert_allclose(path.q, sweep.q, atol=1e-9)
    h = 1e-5
    for k in (3, 7):
        sides = [model.sweep("A", [path["A"][k], path["A"][k] + s * h], start=path.q[k]).q[-1]
                 for s in (1, -1)]  # fmt: skip
        rest = np.zeros(model.nu)
        change = model.energy(sides[0], rest).potential - model.energy(sides[1], rest).potential
        # a central difference: 1e-10 of a curvature of order 10, and rounding 1e-15 / 1e-5
        assert path["A.holding_force"][k] == pytest.approx(change / (2 * h), abs=1e-8)


def test_a_path_that_cannot_begin() -> None:
    scene = cd.Scene("loose", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("rail", cd.Prismatic("z"), scene.ground, body)
    model = cd.compile(scene)
    with pytest.raises(cd.SolveError, match=r"at the start .*nothing holds 'rail'"):
        model.statics({"gravity.z": (-9.81, -1)})


def test_a_path_that_begins_with_nothing_that_holds(double: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match=r"nothing holds '.*' there. Begin where loads"):
        path = double.statics({"gravity.z": (0, -9.81)}, q={"shoulder": 1.5})
    assert len(path) == 1


def test_picture(torsion: cd.CompiledModel, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    torsion.statics(P=(0, 0.5)).plot(tmp_path / "path.png")
    assert (tmp_path / "path.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("call", "kind", "said"),
    [
        (lambda m: m.statics(), cd.ModelError, "what is swept"),
        (lambda m: m.statics(Q=(0, 1)), cd.ModelError, r"no parameter or input 'Q'.*Known"),
        (lambda m: m.statics(P=3), cd.ArgumentError, r"\(start, end\)"),
        (lambda m: m.statics(P=(0, np.nan)), cd.SolveError, "finite"),
        (lambda m: m.statics(P="many"), cd.ArgumentError, r"\(start, end\)"),
        (lambda m: m.statics(P=(0, 1), phi0=[0, 1, 2]), cd.ArgumentError, "'P' has 2"),
        (lambda m: m.statics(P=(0, 1), steps=0), cd.ArgumentError, "at least 1"),
        (lambda m: m.statics(locked={"bse": (0, 1)}), cd.ModelError, "Did you mean 'base'"),
        (lambda m: m.statics(P=(0, 1), locked="base"), cd.ModelError, "go by name"),
        (lambda m: m.statics({"P": (0, 1)})["bse"], cd.ModelError, "Did you mean 'base'"),
    ],
)
def test_nonsense_is_refused(
    torsion: cd.CompiledModel, call: Callable[[Any], Any], kind: type[Exception], said: str
) -> None:
    with pytest.raises(kind, match=said):
        call(torsion)
