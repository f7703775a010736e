"""Loops and rolling are judged: what is right agrees, what is wrong is found and named."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import shutil
from itertools import product
from typing import Any

import pytest

import cardan as cd
from cardan.api.compiled_model import CompiledModel
from cardan.elements.joints.rolling import Rolling
from cardan.equations.constraints import closures
from cardan.equations.constraints.constraints import Constraints
from cardan.equations.constraints.treatments import TREATMENTS
from cardan.errors import BuildError
from cardan.ir.matrix import Matrix
from laws.test_cut_joints import INSTANCES, machine
from mechanisms.closed import CLOSED
from mechanisms.rolling import ROLLING
from spread import some

# they harm what they compile
pytestmark = pytest.mark.usefixtures("cache_directory")
OF_CIRCUITS = ("forward_dynamics", "rhs", "constraint_rates", "constraint_jacobian", "multipliers")
SOLVED = ("mass_matrix", "bias", "gravity", "inverse_dynamics", "forward_dynamics", "dependents")


def checked(scene: cd.Scene, *functions: str, constraints: Any = "auto") -> cd.CompiledModel:
    """A model whose functions are built, and so judged."""
    model = cd.compile(cd.derive(scene, constraints=constraints))
    model.prepare(*functions)
    return model


@pytest.mark.parametrize("name", ["four_bar", "bricard"])
def test_circuits_agree_to_rounding(name):
    result = checked(CLOSED[name].build(), *OF_CIRCUITS, "constraints").verify()
    assert {*OF_CIRCUITS, "constraints"} <= set(result.checked), str(result)
    assert result.worst < 1e-12


KINDS = ("screw", "constant velocity", "distance", "wheel that drifts")


@pytest.mark.parametrize(("kind", "back"), some(product(KINDS, (False, True)), 5))
def test_kinds_that_close_circuits_agree(kind, back):
    result = checked(machine(INSTANCES[kind], True, back), *OF_CIRCUITS).verify()
    assert set(OF_CIRCUITS) <= set(result.checked), str(result)
    assert result.worst < 1e-12


@pytest.mark.parametrize("name", some(ROLLING, 4, 1))
def test_rolling_agrees(name):
    result = checked(ROLLING[name](), *OF_CIRCUITS).verify()
    assert set(OF_CIRCUITS) <= set(result.checked), str(result)
    assert result.worst < 1e-12


@pytest.mark.parametrize("name", some(["slider_crank", "andrews"], 2))
def test_circuits_in_closed_form_agree(name):
    result = checked(CLOSED[name].build(), *SOLVED, constraints="closed_form").verify()
    assert set(SOLVED) <= set(result.checked), str(result)
    assert result.worst < 1e-12


def test_circuits_in_closed_form_beside_rolling_agree():
    scene = CLOSED["four_bar"].build()
    disk = scene.body("disk", mass=1.0, inertia=(0.01, 0.02, 0.01))
    scene.joint("rolls", cd.RollingDisk(0.1), scene.ground, disk)
    result = checked(scene, *OF_CIRCUITS, constraints="closed_form").verify()
    assert set(OF_CIRCUITS) <= set(result.checked), str(result)
    assert result.worst < 1e-12


def test_joints_that_move_as_told_take_part():
    # the crank turns as the clock says; what follows is all of the motion
    scene = CLOSED["four_bar"].build()
    crank = scene.joints["A"]
    scene.joints["A"] = dataclasses.replace(crank, prescribed=0.4 * cd.t + 0.2)
    result = checked(scene, *OF_CIRCUITS).verify()
    assert "forward_dynamics" in result.checked, str(result)
    assert result.worst < 1e-12


@pytest.mark.parametrize(
    "treatment", some((name for name, t in TREATMENTS.items() if t.exact), 2, 1)
)
def test_exact_treatments_are_judged(treatment):
    scene = CLOSED["four_bar"].build()
    assert (
        "forward_dynamics"
        in checked(scene, "forward_dynamics", constraints=treatment).verify().checked
    )


def test_treatments_that_give_way_are_named():
    model = checked(
        CLOSED["four_bar"].build(), "forward_dynamics", "mass_matrix", constraints="penalty"
    )
    reasons = {c.function: c.reason for c in model.verify().checks}
    assert reasons["forward_dynamics"] == "not checked: constraints treated by 'penalty' give way"
    assert reasons["mass_matrix"] == ""


def test_relations_of_the_user_are_judged():
    scene = cd.Scene("linked")
    for name in ("one", "other"):
        body = scene.body(name, mass=1.0, com=(0.1, 0, 0), inertia=(0.1, 0.1, 0.1))
        scene.joint(f"hinge_{name}", cd.Revolute("z"), scene.ground, body)
    scene.constraint("together", scene.q("hinge_one") - 2 * scene.q("hinge_other"))
    model = checked(scene, "forward_dynamics", "mass_matrix")
    reasons = {c.function: c.reason for c in model.verify().checks}
    assert reasons["forward_dynamics"] == ""
    assert reasons["mass_matrix"] == ""


def test_circuits_that_never_close_are_named():
    scene = CLOSED["four_bar"].build()
    model = cd.compile(scene)
    model.prepare("forward_dynamics")
    long = next(name for name in model.parameters if name.endswith(".px") or "position" in name)
    found = model.with_parameters({long: 100.0}).verify()
    reasons = {c.function: c.reason for c in found.checks}
    assert "no position was found" in reasons["forward_dynamics"]


def test_wrong_closing_condition_is_found(monkeypatch):
    right = cd.Revolute.closure

    def wrong(self: Any, R: Any, p: Any, **data: Any) -> Any:
        return right(self, R, p + R.column(0) * 1e-3, **data)

    monkeypatch.setattr(cd.Revolute, "closure", wrong)
    with pytest.raises(BuildError, match="compiled constraints differs"):
        checked(CLOSED["four_bar"].build(), "constraints")
    with pytest.raises(BuildError, match="compiled forward_dynamics differs"):
        checked(CLOSED["four_bar"].build(), "forward_dynamics")


def test_wrong_acceleration_terms_are_found(monkeypatch):
    right = Constraints.gamma.func
    monkeypatch.setattr(Constraints, "gamma", property(lambda self: -right(self)))
    with pytest.raises(BuildError, match="compiled rhs differs"):
        checked(CLOSED["slider_crank"].build(), "rhs")


def test_a_condition_too_few_is_found(monkeypatch):
    right = Constraints.jacobian.func

    def wrong(self: Any) -> Matrix:
        G = right(self)
        first = G.block(slice(0, 1))
        return Matrix.vstack(first, first, G.block(slice(2, None)))

    monkeypatch.setattr(Constraints, "jacobian", property(wrong))
    with pytest.raises(BuildError, match="compiled constraint_jacobian differs"):
        checked(CLOSED["four_bar"].build(), "constraint_jacobian")


def test_wrong_slip_is_found(monkeypatch):
    right = Rolling.sliding

    def wrong(self: Any, q: Any, u: Any, **data: Any) -> Any:
        found = right(self, q, u, **data)
        return found + Matrix.vector(q.graph, [u[4] * 1e-3] * len(found))

    monkeypatch.setattr(Rolling, "sliding", wrong)
    with pytest.raises(BuildError, match="compiled forward_dynamics differs"):
        checked(ROLLING["coin"](), "forward_dynamics")
    with pytest.raises(BuildError, match=r"compiled constraint_(rates|jacobian) differs"):
        checked(ROLLING["coin"](), "constraint_jacobian")


@pytest.mark.parametrize("function", some(["forward_dynamics", "dependents"], 2))
def test_wrong_solution_of_a_circuit_is_found(monkeypatch, function):
    right = closures.JointSolution.coordinate
    monkeypatch.setattr(
        closures.JointSolution, "coordinate", lambda self, g: g.mul(right(self, g), g.const(1.001))
    )
    with pytest.raises(BuildError, match=f"compiled {function} differs"):
        checked(CLOSED["slider_crank"].build(), function, constraints="closed_form")


def test_wrong_rates_of_a_circuit_are_found(monkeypatch):
    right = closures._inverse
    monkeypatch.setattr(closures, "_inverse", lambda a: right(a) * 1.001)
    with pytest.raises(BuildError, match="compiled mass_matrix differs"):
        checked(CLOSED["four_bar"].build(), "mass_matrix", constraints="closed_form")


def test_wrong_code_is_found(tmp_path):
    model = cd.compile(CLOSED["four_bar"].build())
    model.prepare("forward_dynamics")
    harmed = tmp_path / "model"
    shutil.copytree(model.directory, harmed)
    text = (harmed / "forward_dynamics.c").read_text()
    before, found, after = text.rpartition("out[1] = ")
    assert found
    text = f"{before}{found}1.0001 * {after}"
    (harmed / "forward_dynamics.c").write_text(text)
    manifest = json.loads((harmed / "manifest.json").read_text())
    # changed on purpose
    del manifest["digest"]
    entry = manifest["functions"]["forward_dynamics"]
    entry["sha256"] = hashlib.sha256(text.encode()).hexdigest()
    (harmed / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(BuildError, match="compiled forward_dynamics differs"):
        CompiledModel(harmed).prepare("forward_dynamics")


def test_bodies_without_mass_are_no_obstacle():
    scene = cd.Scene("light", gravity=(0, -9.81, 0))
    crank, rocker = scene.body("crank"), scene.body("rocker")
    coupler = scene.body("coupler", mass=0.3, com=(0.1, 0, 0), inertia=(1e-3, 2e-3, 2e-3))
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0), cut=True)
    result = checked(scene, "forward_dynamics", "constraint_jacobian", "multipliers").verify()
    assert {"forward_dynamics", "multipliers"} <= set(result.checked), str(result)
    assert result.worst < 1e-10
