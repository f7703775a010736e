"""Faults of the verification of builds: what was compiled without being judged."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.errors import BuildError, SolveWarning
from cardan.runtime import truth
from cardan.runtime.judged import scene_of
from cardan.runtime.verification.elements import judged
from cardan.runtime.verification.members import Members, members_of
from cardan.runtime.verify_tree import BOUND
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
    assert found.states > 0
    assert found.unchecked == ()
    assert str(found).splitlines()[0].endswith("all are checked")
    names = {check.function for check in found.checks}
    assert names >= {f"hellinger_reissner {form}" for form in ("energy", "stress", "mixed")}
    assert found.worst < 1e-10


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

    assert all(error <= BOUND for _, error, _ in judged(own))
    monkeypatch.setattr(Members, "call", wrong)
    monkeypatch.setattr(Members, "expressions", lambda self, name, given=None: None)
    assert any(error > BOUND for _, error, _ in judged(own))


def test_a12_custom_joint_is_judged_by_its_pose() -> None:
    """A scene with a ``Custom`` joint compiled "not checked" without a word."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = cd.compile(ZOO["parabola"].build())
    model.prepare("rhs", "mass_matrix", "bias")
    found = model.verify()
    # the cache may hold other functions of this scene, some of which nothing judges
    assert found.states == 3
    assert not {"rhs", "mass_matrix", "bias"} & set(found.unchecked)
    # the pose is what judges: that of another joint does not agree
    scene = scene_of(model)
    (number,) = scene.poses
    right = scene.poses[number]
    other = replace(scene, poses={number: lambda q: (right(q)[0], 1.001 * right(q)[1])})
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("cardan.runtime.verify.scene_of", lambda model: other)
        # what was found of the right scene is kept for its next functions
        patch.setattr(model._objects, "truth", None)
        with pytest.raises(BuildError, match="differs"):
            model.verify()


X = sympy.Symbol("x")
PROFILES = {
    "teeth of 30 mm": sympy.sin(200 * X) / 500,
    "teeth of 1 mm": sympy.sin(6000 * X) / 20_000,
    "two cases": sympy.Piecewise((0, X < 0), (X**3, True)),
}


@pytest.mark.parametrize("name", PROFILES)
def test_a12_profiles_with_short_waves_or_cases_are_judged(name: str) -> None:
    """Circles of one radius saw other waves, and other cases, than those next to the state."""
    scene = cd.Model("cam")
    body = scene.body("b", mass=1.0, inertia=(0.1, 0.1, 0.1))
    slide = cd.Custom([X], position=(X, 0, PROFILES[name]))
    scene.joint("slide", slide, scene.ground, body)
    model = cd.compile(scene)
    model.prepare("rhs", "mass_matrix", "bias")
    found = model.verify()
    assert found.unchecked == ()
    assert found.worst < BOUND / 5


def _fast(name: str) -> cd.Model:
    """A double pendulum with a wave of 1000 rad/s, or a case that begins, in one place."""
    scene, moves = cd.Model(name, gravity=(0, 0, -9.81)), {}
    if name == "motion":
        moves = {"motion": sympy.sin(300 * cd.t) / 100}
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


def linked() -> cd.Model:
    """Two pendulums whose angles a relation of the user's own couples."""
    scene = cd.Model("linked")
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


def braked() -> cd.Model:
    """A mass on a rail and a pendulum on it, both with friction of what presses their joints."""
    scene = cd.Model("braked")
    cart = scene.body("cart", mass=2.0, com=(0.05, 0, 0.1), inertia=(0.1, 0.2, 0.3))
    arm = scene.body("arm", mass=1.0, com=(0.1, 0.02, -0.4), inertia=(0.1, 0.1, 0.02))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("pin", cd.Revolute("y"), cart.at(0, 0, 0.1), arm)
    scene.force("brake", cd.Friction("rail", mu=0.2))
    scene.force("bearing", cd.Friction("pin", mu=0.3, radius=0.05, static=0.4, viscous=0.1))
    scene.force("spring", cd.TorsionSpring("pin", stiffness=2.0))
    return scene


def test_a12_friction_from_reactions_is_judged_by_free_bodies(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Friction that follows from reactions was compared with nothing but its own expressions."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = cd.compile(braked())
    names = ("rhs", "forward_dynamics", "inverse_dynamics", "applied", "energy", "power")
    model.prepare(
        *names, "qdot", "momentum_rates", "momenta", ("reaction", "rail"), ("reaction", "pin")
    )
    found = model.verify()
    assert found.states == 3
    assert found.unchecked == ()
    assert found.worst < 1e-12
    # the coefficient, the line along which nothing presses and the wrenches matter
    right: Any = truth.pressed
    for harmed in (
        lambda known: replace(known, coefficient=1.001 * known.coefficient),
        lambda known: replace(known, joints=tuple((i, False) for i, _ in known.joints)),
        lambda known: replace(known, force=known.force + 0.1),
    ):
        model._objects.truth = None
        monkeypatch.setattr(truth, "pressed", lambda *given, harmed=harmed: harmed(right(*given)))
        with pytest.raises(BuildError, match="differs"):
            model.verify()


def test_a12_what_stays_unjudged_is_said_first_and_warned_of() -> None:
    """ "Not checked" stood between the lines, and compiling said nothing."""
    scene = cd.Model("own speeds")
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
    scene = cd.Model("table", gravity=(0, 0, -9.81))
    top = scene.body("top", mass=20, com=(0.1, 0.05, 0), inertia=(2, 2, 4), pose=(0, 0, 1))
    for k, (x, y) in enumerate([(1, 1), (1, -1), (-1, -1), (-1, 1)][:legs]):
        scene.joint(f"leg{k}", cd.Spherical(), scene.ground.at(x, y, 1), top.at(x, y, 0))
    model = cd.compile(scene)
    q, u = model.split(model.initial({}, {}))
    with pytest.warns(SolveWarning, match="is not determined"):
        total = sum(model.reaction(f"leg{k}", q, u)[3:] for k in range(legs))
    if legs == 4:
        assert total == pytest.approx([0, 0, 20 * 9.81], abs=1e-9)
    assert model.verify().states > 0
