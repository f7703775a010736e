"""Every build is checked: a wrong function is found, reported and thrown out of the cache."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.api.compiled_model import CompiledModel
from cardan.errors import BuildError, SolveWarning
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.serialize import to_dict
from cardan.runtime.verification import verify as checks
from cardan.runtime.verification.flat_scene import scene_of
from cardan.runtime.verification.reference_values import finite, reference_values
from runtime import pendulum

pytestmark = pytest.mark.usefixtures("cache_directory")

WRONG = {
    "forward_dynamics": ("- in->w[1]", "+ in->w[1]"),
    "inverse_dynamics": ("in->udot[0]", "0.999 * in->udot[0]"),
    "mass_matrix": ("in->w[0]", "1.000001 * in->w[0]"),
    "qdot": ("in->u[0]", "-in->u[0]"),
    "rhs": ("out[1] = -", "out[1] = "),
}


def harm(directory, name):
    """Write a model whose function is wrong; text and manifest agree."""
    recipe = pendulum.FUNCTIONS[name]
    before, after = WRONG[name]
    wrong = {**recipe, "body": recipe["body"].replace(before, after)}
    pendulum.write(directory)
    (directory / f"{name}.c").write_text(pendulum.text(name, wrong))
    manifest = json.loads((directory / "manifest.json").read_text())
    manifest["functions"][name] = pendulum.entry(name, wrong)
    (directory / "manifest.json").write_text(json.dumps(manifest))
    return CompiledModel(directory)


def test_right_functions_agree_to_rounding(model):
    result = model.verify()
    assert set(WRONG) <= set(result.checked)
    assert result.worst < 1e-15
    assert "forward_dynamics" in str(result)


@pytest.mark.parametrize("name", WRONG)
def test_wrong_function_is_found_when_it_is_built(tmp_path, cache_directory, name):
    model = harm(tmp_path / "model", name)
    for _ in range(2):
        with pytest.raises(BuildError, match=rf"'pendulum': the compiled {name} differs"):
            model._function(name)
        assert list(cache_directory.glob("*.so")) == []


def test_only_new_builds_are_checked(directory, monkeypatch):
    CompiledModel(directory).prepare("rhs", "mass_matrix")
    asked = []
    nothing = checks.Verification("", 0, ())

    def noted(model, functions):
        asked.append(functions)
        return nothing

    monkeypatch.setattr(checks, "verify", noted)
    model = CompiledModel(directory)
    model.prepare("rhs", "mass_matrix")
    assert asked == []
    model.prepare("rhs", "inverse_dynamics", ("pose", "bob"))
    assert asked == [[("inverse_dynamics", None), ("pose", "bob")]]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"poses": ["none"]}, "the poses of its joints are not saved"),
        ({"kinds": ["spherical"], "rotations": ["odd"]}, "joint 'swing' is described by odd"),
        ({"unknown": ["user-chosen speeds"]}, "user-chosen speeds"),
    ],
)
def test_what_cannot_be_checked_is_said(directory, change, reason):
    manifest = json.loads((directory / "manifest.json").read_text())
    manifest["scene"].update(change)
    (directory / "manifest.json").write_text(json.dumps(manifest))
    result = CompiledModel(directory).verify()
    assert result.checked == ()
    assert set(WRONG) < {c.function for c in result.checks}
    assert all(c.reason == f"not checked: {reason}" for c in result.checks)


def test_directory_without_a_scene(directory):
    (directory / "functions.json").unlink()
    result = CompiledModel(directory).verify()
    assert "holds no scene" in result.checks[0].reason


def test_forces_that_are_not_saved(directory):
    saved = json.loads((directory / "functions.json").read_text())
    del saved["applied_forces"]
    (directory / "functions.json").write_text(json.dumps(saved))
    result = CompiledModel(directory).verify()
    assert {"mass_matrix", "qdot"} == set(result.checked) & set(WRONG)
    reasons = {c.reason for c in result.checks if c.function in WRONG and c.reason}
    assert reasons == {"not checked: the forces of the model are not saved"}


def test_singular_mass_matrix_is_said(directory):
    result = CompiledModel(directory).with_parameters(m=0.0).verify()
    reasons = {c.function: c.reason for c in result.checks}
    assert reasons["forward_dynamics"] == "not checked: the mass matrix is singular"
    assert reasons["mass_matrix"] == ""


def test_states_without_finite_forces_are_passed_over(directory):
    # f = log(q) exists for half of all angles
    saved = json.loads((directory / "functions.json").read_text())
    q = Block("q", ("swing",), ("rad",))
    g = Graph()
    f = Output("f", (1,), (g.apply("log", g.var("q", 0)),))
    saved["applied_forces"] = to_dict(Function("applied_forces", g, (q,), (f,)))
    (directory / "functions.json").write_text(json.dumps(saved))
    model = CompiledModel(directory)
    states = 40
    truth = reference_values(model, scene_of(model), states, seed=1)
    found = finite(truth)
    assert 0 < len(found) < states
    assert np.all(truth.q[found] > 0)


def test_rotors_of_drives_are_judged() -> None:
    from mechanisms import ZOO

    named = [name for name in ZOO if "drive" in name]
    assert named
    for name in named:
        model = cd.compile(ZOO[name].build(), functions=("mass_matrix", "forward_dynamics"))
        model.prepare("mass_matrix", "forward_dynamics")
        found = model.verify()
        assert {"mass_matrix", "forward_dynamics"} <= set(found.checked), str(found)


def test_terms_that_cancel_are_no_fault() -> None:
    scene = cd.Scene("ball", gravity=(0, 0, 0))
    ball = scene.body("ball", mass=1, inertia=(1, 1, 1))
    scene.joint("pivot", cd.Spherical(), scene.ground, ball)
    model = cd.compile(scene)
    # omega x I omega is 0 but for rounding: all that is left on both sides
    model.prepare("rhs", "forward_dynamics", "inverse_dynamics", "bias", "coriolis", "gravity")
    assert model.verify().worst < 1e-12


def test_a_singular_mass_matrix_is_announced_by_name() -> None:
    scene = cd.Scene("table")
    table = scene.body("table")
    arm = scene.body("arm", mass=1.0, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.3))
    scene.joint("base", cd.Spherical(), scene.ground, table)
    scene.joint("waist", cd.Revolute("z"), table, arm)
    model = cd.compile(scene)
    with pytest.warns(SolveWarning, match=r"nothing resists a motion of base\.u\.z, waist\.u"):
        model.prepare("forward_dynamics")


def test_only_what_was_asked_for_is_verified() -> None:
    scene = cd.Scene("asked")
    body = scene.body("body", mass=1.0, com=(0, 0, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, body)
    cd.compile(scene).prepare("rhs", "bias")
    few = cd.compile(scene, functions=("bias",))
    few.prepare("bias")
    assert few.verify().checked == ("bias",)


def test_constraints_that_act_in_some_modes_alone():
    # friction holds a joint while it sticks; nothing binds the states that are drawn
    scene = cd.Scene("slider")
    block = scene.body("block", mass=1.0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, block)
    scene.force("rub", cd.Friction("slide", 0.3))
    model = cd.compile(scene)
    model.prepare("constraint_jacobian", "multipliers", "forward_dynamics")
    found = model.verify()
    assert {"constraint_jacobian", "multipliers", "forward_dynamics"} <= set(found.checked)
    assert found.worst < 1e-12


def test_lost_digits_are_said_by_every_process(cache_directory: Path) -> None:
    """Masses of 1e-12 to 1e12 along a chain: whoever compiled, by loops or straight lines."""

    def chain(least: float) -> cd.Scene:
        scene = cd.Scene("chain")
        place = scene.ground.at(0, 0, 0)
        for k, mass in enumerate(np.geomspace(least, 1 / least, 14)):
            inertia = (0.02 * mass, 0.02 * mass, 0.01 * mass)
            link = scene.body(f"link{k}", mass=float(mass), com=(0, 0, -0.25), inertia=inertia)
            scene.joint(f"pin{k}", cd.Revolute("xyz"[k % 2]), place, link)
            place = link.at(0, 0, -0.5)
        return scene

    q = np.linspace(-1, 1, 14)
    for loops in (True, False, True, False):
        model = cd.compile(chain(1e-12), loops=loops)
        with pytest.warns(cd.SolveWarning, match="the mass matrix is singular"):
            model.forward_dynamics(q, q)
    # slopes alone, too
    model = cd.compile(chain(1e-12), loops=False)
    with pytest.warns(cd.SolveWarning, match="the mass matrix is singular"):
        model.derivative("forward_dynamics", wrt="q")(q, q)
    for _ in range(2):
        cd.compile(chain(1.0)).forward_dynamics(q, q)
    marks = [*cache_directory.glob("models/*/regular")]
    assert len(marks) == 1
