"""Faults of the verification of builds: what was compiled without being judged."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.errors import BuildError, SolveWarning
from cardan.runtime.verification import reference_values
from cardan.runtime.verification.differences import BOUND
from cardan.runtime.verification.evaluation import Trial
from cardan.runtime.verification.finite_elements.elements import check_kinds
from cardan.runtime.verification.finite_elements.members import Members, members_of
from cardan.runtime.verification.flat_scene import scene_of
from cardan.runtime.verification.joint_motion import JointData, joint_data
from cardan.runtime.verification.verify import verify
from cardan.schema.functions import FUNCTIONS
from mechanisms import ZOO, flexible

BEAM = ("balance", "balance_tangent", "energy", "momentum", "stress", "mixed", "mixed_step")


def kinds(model: cd.CompiledModel) -> list[Members]:
    """Members of every kind of element of a model."""
    elements = model._source.results(model).mesh
    symbols = [s for g in elements.tables.groups for s in g.kind.functions.values()]
    codes = dict(zip(symbols, model._objects.load(symbols), strict=True))
    return members_of(model, elements, codes, 1)


def test_a12_scene_with_beams_is_judged_kind_by_kind() -> None:
    """``verify()`` of a scene with beams checked 0 states and said so between the lines."""
    found = cd.compile(flexible.bend45(elements=2)).verify()
    assert found.states == 3
    assert found.unchecked == ()
    assert str(found).splitlines()[0].endswith("all are checked")
    names = {check.function for check in found.checks}
    assert names >= {f"hellinger_reissner {form}" for form in ("energy", "stress", "mixed")}
    assert found.worst < 1e-10


def test_a12_a_model_without_functions_is_not_said_to_be_checked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """ "At 0 random states: all are checked"."""
    monkeypatch.setenv("CARDAN_CACHE", str(tmp_path / "cache"))
    scene = cd.Scene("bob", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -0.731))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    model = cd.compile(scene)
    assert "NOTHING CHECKED" in str(model.verify())
    model.prepare("forward_dynamics")
    assert str(model.verify()).splitlines()[0].endswith("all are checked")


@pytest.mark.parametrize("form", BEAM)
def test_a12_wrong_function_of_a_beam_is_found(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """No function of an element was compared with anything."""
    model = cd.compile(flexible.bend45(elements=2))
    (own,) = [
        m
        for m in kinds(model)
        if form in m.codes and m.table.kind.name in ("hellinger_reissner", "linked_inertia")
    ][:1]
    plain = Members.call

    def wrong(self: Members, name: str, given: object = None) -> np.ndarray:
        value = plain(self, name, given)  # type: ignore[arg-type]
        if name == form:
            value = value.copy()
            value[:, np.abs(value).max(axis=0).argmax()] *= 1.0001
        return value

    assert all(error <= BOUND for _, error, _ in check_kinds(own))
    monkeypatch.setattr(Members, "call", wrong)
    monkeypatch.setattr(Members, "expressions", lambda self, name, given=None: None)
    assert any(error > BOUND for _, error, _ in check_kinds(own))


def test_a_tangent_that_is_missing_is_found() -> None:
    """A kind without a tangent was taken for one whose balance nothing changes."""
    scene = cd.Scene("sprung", gravity=(0, 0, 0))
    body = scene.body("body", mass=1.0, inertia=(1, 1, 1))
    scene.joint("free", cd.Free(), scene.ground, body)
    pull = cd.Force(body, (-3 * scene.q("free.px"), 0, 0))
    scene.force("pull", pull)
    model = cd.compile(scene, coordinates="absolute")
    (own,) = [m for m in kinds(model) if m.table.kind.name == "force"]
    judged = {form: error for form, error, _ in check_kinds(own)}
    assert judged["balance"] < BOUND
    assert judged["balance_tangent"] < BOUND
    kind = own.table.kind
    functions = {form: name for form, name in kind.functions.items() if form != "balance_tangent"}
    bare = type(kind)(**{**vars(kind), "functions": functions, "parts": {}})
    codes = {form: code for form, code in own.codes.items() if form != "balance_tangent"}
    without = replace(own, table=replace(own.table, kind=bare), codes=codes, cache={})
    judged = {form: error for form, error, _ in check_kinds(without)}
    assert judged["balance"] > 1e-2


def test_a12_custom_joint_is_judged_by_its_pose(tmp_path: Path) -> None:
    """A scene with a ``Custom`` joint compiled "not checked" without a word."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # in a folder of its own: the cache may hold functions that others asked for
        model = cd.compile(ZOO["parabola"].build(), directory=tmp_path)
    names = [name for name in model.manifest["available"] if not FUNCTIONS[name].of]
    model.prepare(*names)
    found = model.verify()
    assert found.states == 3
    # outputs are what users write: only their own expressions tell of them
    assert found.unchecked == ("outputs",)
    assert {*names} - {"outputs"} == set(found.checked)
    # the pose is what judges: that of another joint does not agree
    scene = scene_of(model)
    kinds = enumerate(scene.kinds)
    other = replace(
        scene,
        joints=tuple(
            _stretched(scene.joints[i]) if k == "custom" else scene.joints[i] for i, k in kinds
        ),
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("cardan.runtime.verification.verify.scene_of", lambda model: other)
        # what was found of the right scene is kept for its next functions
        patch.setattr(model._objects, "reference", None)
        with pytest.raises(BuildError, match="differs"):
            model.verify()


def _stretched(joint: JointData) -> JointData:
    """The joint with a pose that is 0.1 % farther away."""
    right = joint.pose.pose
    return joint_data(lambda q: (right(q)[0], 1.001 * right(q)[1]), "", joint.rotation)


X = sympy.Symbol("x")
PROFILES = {
    "teeth of 30 mm": sympy.sin(200 * X) / 500,
    "teeth of 1 mm": sympy.sin(6000 * X) / 20_000,
    "two cases": sympy.Piecewise((0, X < 0), (X**3, True)),
}


@pytest.mark.parametrize("name", PROFILES)
def test_a12_profiles_with_short_waves_or_cases_are_judged(name: str) -> None:
    """Circles of one radius saw other waves, and other cases, than those next to the state."""
    scene = cd.Scene("cam")
    body = scene.body("b", mass=1.0, inertia=(0.1, 0.1, 0.1))
    slide = cd.Custom([X], position=(X, 0, PROFILES[name]))
    scene.joint("slide", slide, scene.ground, body)
    model = cd.compile(scene)
    model.prepare("rhs", "mass_matrix", "bias")
    found = model.verify()
    assert found.unchecked == ()
    assert found.worst < BOUND / 5


def _fast(name: str) -> cd.Scene:
    """A double pendulum with a wave of 1000 rad/s, or a case that begins, in one place."""
    scene, moves = cd.Scene(name, gravity=(0, 0, -9.81)), {}
    if name == "motion":
        moves = {"prescribed": sympy.sin(300 * cd.t) / 100}
    one, two = (scene.body(n, mass=1.0, com=(0, 0, -0.5), inertia=(0.1,) * 3) for n in "ab")
    scene.joint("A", cd.Revolute("y"), scene.ground, one, **moves)
    scene.joint("B", cd.Revolute("x"), one.at(0, 0, -1), two)
    if name == "force":
        wave = sympy.sin(500 * scene.q("A"))
        scene.force("f", cd.JointForce("A", 5 * sympy.sin(1000 * cd.t) + wave))
    if name == "relation":
        angle = scene.q("A")
        scene.constraint("c", scene.q("B") - sympy.Piecewise((0, angle < 0), (angle**3, True)))
    return scene


@pytest.mark.parametrize("name", ["force", "motion", "relation"])
def test_a12_fast_waves_are_no_faults(name: str) -> None:
    """Steps that are halves of each other agreed on slow waves that are not there."""
    scene = _fast(name)
    model = cd.compile(scene)
    asked = ("rhs", "rhs_jacobian", "energy", "power", "forward_dynamics", "momentum_rates")
    model.prepare(*[n for n in asked if n in model.manifest["available"]])
    found = model.verify()
    assert found.states > 0
    assert {"rhs", "forward_dynamics"} <= set(found.checked)
    assert found.worst < BOUND / 5


def linked() -> cd.Scene:
    """Two pendulums whose angles a relation of the user's own couples."""
    scene = cd.Scene("linked")
    upper = scene.body("upper", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.2, 0.1))
    lower = scene.body("lower", mass=2.0, com=(0, 0, -0.3), inertia=(0.1, 0.1, 0.1))
    scene.joint("one", cd.Revolute("y"), scene.ground, upper)
    scene.joint("two", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    scene.constraint("link", sympy.sin(scene.q("one")) + 2 * scene.q("two"))
    return scene


def test_a12_constraints_of_the_users_own_are_judged() -> None:
    """Accelerations of scenes with ``scene.constraint`` were compared with nothing."""
    model = cd.compile(linked())
    names = ("rhs", "forward_dynamics", "multipliers", "constraint_rates", "constraint_jacobian")
    model.prepare(*names)
    found = model.verify()
    assert {*names} <= set(found.checked)
    assert found.unchecked == ()


def braked() -> cd.Scene:
    """A mass on a rail and a pendulum on it, both with friction of what presses their joints."""
    scene = cd.Scene("braked")
    cart = scene.body("cart", mass=2.0, com=(0.05, 0, 0.1), inertia=(0.1, 0.2, 0.3))
    arm = scene.body("arm", mass=1.0, com=(0.1, 0.02, -0.4), inertia=(0.1, 0.1, 0.02))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("pin", cd.Revolute("y"), cart.at(0, 0, 0.1), arm)
    scene.force("brake", cd.Friction("rail", mu=0.2))
    scene.force("bearing", cd.Friction("pin", mu=0.3, radius=0.05, static=0.4, viscous=0.1))
    scene.force("spring", cd.JointSpring("pin", stiffness=2.0))
    return scene


def test_a12_friction_from_reactions_is_judged_by_free_bodies(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Friction that follows from reactions was compared with nothing but its own expressions."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = cd.compile(braked(), directory=tmp_path)
    names = ("rhs", "forward_dynamics", "inverse_dynamics", "applied_forces", "energy", "power")
    model.prepare(
        *names, "qdot", "momentum_rates", "momenta", ("reaction", "rail"), ("reaction", "pin")
    )
    found = model.verify()
    assert found.states == 3
    assert found.unchecked == ()
    assert found.worst < 1e-12
    # the coefficient, the line along which nothing presses and the wrenches matter
    right: Any = reference_values.reaction_friction
    for harmed in (
        lambda known: replace(known, coefficient=1.001 * known.coefficient),
        lambda known: replace(known, joints=tuple((i, False) for i, _ in known.joints)),
        lambda known: replace(known, force=known.force + 0.1),
    ):
        model._objects.reference = None
        monkeypatch.setattr(
            reference_values,
            "reaction_friction",
            lambda *given, harmed=harmed: harmed(right(*given)),
        )
        with pytest.raises(BuildError, match="differs"):
            model.verify()


def test_a12_elements_are_judged_at_as_many_states_as_are_asked_for() -> None:
    """They were judged at two, whatever ``states`` was."""
    model = cd.compile(flexible.bend45(elements=2))
    elements = model._source.results(model).mesh
    symbols = [s for g in elements.tables.groups for s in g.kind.functions.values()]
    codes = dict(zip(symbols, model._objects.load(symbols), strict=True))
    few, many = (members_of(model, elements, codes, 1, n) for n in (1, 5))
    for one, five in zip(few, many, strict=True):
        assert len(five.inputs["q"]) == 5 * len(one.inputs["q"])
    assert model.verify(states=5).states == 5


def test_a12_columns_of_a_regressor_that_nothing_changes_are_said() -> None:
    """Columns of elements whose numbers are not parameters were skipped, and counted as checked."""
    names = ("regressor", "energy_regressor", "inertial_parameters", "inverse_dynamics", "power")

    def rail(**how: Any) -> cd.CompiledModel:
        scene = cd.Scene("rail")
        c = scene.parameter("c", 0.3)
        cart = scene.body("cart", mass=2.0, com=(0.05, 0, 0.1), inertia=(0.1, 0.2, 0.3))
        scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
        how = {name: value(c) for name, value in how.items()}
        scene.force("spring", cd.JointSpring("x", **how))
        model = cd.compile(scene)
        model.prepare(*names)
        return model

    # expressions of parameters change with these
    model = rail(stiffness=lambda c: c**2, damping=lambda c: 2 * c)
    found = {check.function: check for check in model.verify().checks}
    assert found["regressor"].error < 1e-12
    assert found["energy_regressor"].error < 1e-12
    plain = Trial.call

    def wrong(self: Trial, name: str, *given: Any) -> np.ndarray:
        value = plain(self, name, *given)
        if name in ("regressor", "energy_regressor"):
            value = value.copy()
            value[..., -1, -1] *= 1.0001
        return value

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Trial, "call", wrong)
        for name in ("regressor", "energy_regressor"):
            with pytest.raises(BuildError, match=name):
                verify(model, functions=[*names[2:], name])
    # a number never changes
    found = {check.function: check for check in rail(stiffness=lambda c: 3.0).verify().checks}
    for name in ("regressor", "energy_regressor"):
        assert "nothing changes 'spring.damping'" in found[name].reason


@pytest.mark.parametrize("name", ["q", "u"])
def test_derivatives_know_that_friction_follows_from_reactions(name: str) -> None:
    """That friction stood still in them, and in the tangents that equilibria are found by."""
    model, h = cd.compile(braked()), 1e-6
    rng = np.random.default_rng(5)
    q, u, udot = rng.uniform(-1, 1, (3, 2))
    speeds = np.eye(2)
    at = {"q": q, "u": u}

    def slope(function: Any) -> np.ndarray:
        moved = ({**at, name: at[name] + sign * h * e} for e in speeds for sign in (1, -1))
        values = [np.ravel(function(**m)) for m in moved]
        return np.stack([(a - b) / (2 * h) for a, b in zip(values[::2], values[1::2], strict=True)])

    def error(found: Any, function: Any) -> float:
        known = slope(function)
        return float(np.abs(np.reshape(found, known.T.shape).T - known).max())

    given = model.derivative("inverse_dynamics", name)(q, u, udot)
    assert error(given, lambda q, u: model.inverse_dynamics(q, u, udot)) < 1e-6
    given = model.derivative("power", name)(q, u)
    assert error(given, model.power) < 1e-6
    names = ("balance", "balance_tangent", "qdot", "inverse_dynamics")
    model.prepare(*names)
    found = {check.function: check for check in model.verify().checks}
    assert found["balance_tangent"].error < BOUND


def test_the_power_of_friction_from_reactions_is_no_matter_of_energies() -> None:
    """It ended in a fault of the build: "energy_regressor reads udot"."""
    model = cd.compile(braked())
    with pytest.raises(cd.DerivationError, match=r"friction of 'brake' follows from reactions.*"):
        model.prepare("energy_regressor")
    model.prepare("regressor")


def test_a12_what_stays_unjudged_is_said_first_and_warned_of() -> None:
    """ "Not checked" stood between the lines, and compiling said nothing."""
    scene = cd.Scene("own speeds")
    body = scene.body("body", mass=1.0, com=(0, 0, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, body)
    equations = cd.derive(scene, speeds={"w": 2 * scene.u("hinge")})
    with pytest.warns(SolveWarning, match=r"'own speeds'.*not checked: the speeds are chosen"):
        model = cd.compile(equations)
    model.prepare("rhs")
    found = model.verify()
    assert "NOT CHECKED: rhs" in str(found).splitlines()[0]
    # C is compared with what it was written from all the same
    (check,) = found.checks
    assert check.written < BOUND


@pytest.mark.parametrize("legs", [2, 4])
def test_a_table_on_ball_joints_is_no_fault_of_the_compiler(legs: int) -> None:
    """Rounding that chooses between equal legs was reported as a wrong build: zeros of a structure
    were never shaken, nor were parameters."""
    scene = cd.Scene("table", gravity=(0, 0, -9.81))
    top = scene.body("top", mass=20, com=(0.1, 0.05, 0), inertia=(2, 2, 4), pose=(0, 0, 1))
    for k, (x, y) in enumerate([(1, 1), (1, -1), (-1, -1), (-1, 1)][:legs]):
        scene.joint(f"leg{k}", cd.Spherical(), scene.ground.at(x, y, 1), top.at(x, y, 0))
    model = cd.compile(scene)
    q, u = model.split(model.initial({}, {}))
    with pytest.warns(SolveWarning, match="are not determined"):
        total = sum(model.reaction(f"leg{k}", q, u)[3:] for k in range(legs))
    if legs == 4:
        assert total == pytest.approx([0, 0, 20 * 9.81], abs=1e-9)
    assert model.verify().states > 0
