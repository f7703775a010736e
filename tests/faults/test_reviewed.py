"""Faults that were found by reading the code."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.analyses.statics import critical_load
from cardan.arguments import kinds_of, read
from cardan.errors import ArgumentError, BuildError
from cardan.runtime.verification.differences import missing, relative, worst_of
from cardan.runtime.verification.evaluation import Trial
from cardan.runtime.verification.finite_elements import elements
from cardan.runtime.verification.finite_elements.members import Members
from cardan.runtime.verification.verify import verify
from mechanisms.pendulums import double_pendulum


def straight_parallelogram() -> cd.Scene:
    """Sides 1, 2, 1, 2, all on one line in the reference position: a singular one."""
    scene = cd.Scene("straight_parallelogram", gravity=(0, -9.81, 0))
    ends = {"a": 1.0, "b": 2.0, "c": 1.0}
    a, b, c = (
        scene.body(name, mass=1.0, com=(x / 2, 0, 0), inertia=cd.inertia.rod(1.0, x, axis="x"))
        for name, x in ends.items()
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, a)
    scene.joint("B", cd.Revolute("z"), a.at(1, 0, 0), b)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(2, 0, 0), c)
    scene.joint("C", cd.Revolute("z"), b.at(2, 0, 0), c.at(1, 0, 0))
    return scene


def test_constraints_are_judged_though_the_reference_position_is_singular() -> None:
    """Builds failed where the start that nobody asked for is refused."""
    model = cd.compile(cd.derive(straight_parallelogram()))
    assert model.constraint_jacobian(np.zeros(model.nq)).shape[-1] == model.nu
    assert model.verify().worst < 1e-9
    assert model.simulate(0.2, q={"A": 0.3}, u={"A": 1.0}).t[-1] == 0.2


def test_numbers_that_are_none_are_wrong() -> None:
    """``max(worst, nan)`` kept what it was: a function of NaN passed for one that agrees."""
    sharp, one = np.zeros(2), np.ones((2, 1))
    broken = np.array([[1.0], [np.nan]])
    assert missing(one, sharp, broken) == np.inf
    assert missing(one, sharp, one) == 0.0
    # where there is no slope there is nothing to compare with
    assert missing(np.array([[1.0], [np.inf]]), np.array([0.0, np.inf]), broken) == 0.0
    assert relative(broken - one, one) == np.inf
    # what has no bound is not divided by itself
    boundless = np.array([[1.0], [np.inf]])
    assert missing(one, sharp, boundless) == np.inf
    assert relative(boundless - one, one, boundless) == np.inf


def test_comparisons_that_say_nothing_are_no_agreement() -> None:
    """Slopes that are nowhere sharp counted as 0 differences from them."""
    blurred, one = np.full(2, np.inf), np.ones((2, 1))
    assert np.isnan(missing(one, blurred, one))
    assert np.isnan(worst_of(np.nan, np.nan))
    assert worst_of(np.nan, 0.5, 0.1) == 0.5


@pytest.mark.parametrize("form", ["pose", "frame_jacobian", "rhs_jacobian"])
def test_function_of_no_numbers_is_refused(form: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A NaN behind entries that agree was passed over."""
    model = cd.compile(cd.derive(double_pendulum()))
    of = None if form == "rhs_jacobian" else model.manifest["frames"][-1]["name"]
    model.rhs(0.0, np.zeros(model.nx))
    assert not verify(model, functions=[(form, of)]).unchecked
    plain = Trial.call

    def wrong(self: Trial, name: str, *given: Any) -> np.ndarray:
        value = plain(self, name, *given)
        if name == form:
            value = value.copy()
            value[0].flat[0] = np.nan
        return value

    monkeypatch.setattr(Trial, "call", wrong)
    with pytest.raises(BuildError, match=form):
        verify(model, functions=[(form, of)])


@pytest.mark.parametrize("flag", [True, False, np.True_, np.False_])
def test_flags_of_numpy_are_flags(flag: bool) -> None:
    """NumPy 2 calls the type ``bool``: its flags were refused."""
    found = read("simulate", "check", flag, kinds_of("bool"))
    assert type(found) is bool
    assert found == flag
    with pytest.raises(ArgumentError):
        read("simulate", "check", 1, kinds_of("bool"))


def test_names_for_control_are_those_of_the_system() -> None:
    """An output took the place of a state whose plain name was another one."""
    pytest.importorskip("control")
    linear = cd.compile(cd.derive(double_pendulum())).linearize(outputs=["shoulder", "elbow"])
    states = ("a.b", "a_b", *linear.states[2:])
    outputs = ("a_b", "a b")[: len(linear.outputs)]
    named = replace(linear, states=states, outputs=outputs)
    system, names = named.to_control()
    assert [names[name] for name in states] == system.state_labels
    assert [names[name] for name in outputs] == system.output_labels
    assert len(set(names.values())) == len(names)


def test_columns_that_are_compared_with_nothing_are_not_checked() -> None:
    """Columns of springs passed where the forces that they follow from were not compiled."""
    scene = double_pendulum()
    k, d = scene.parameter("k", 3.0), scene.parameter("d", 0.1)
    scene.force("spring", cd.JointSpring("elbow", stiffness=k, damping=d))
    model = cd.compile(cd.derive(scene))
    assert verify(model, functions=["regressor"]).unchecked == ("regressor",)
    model.prepare("inverse_dynamics", "inertial_parameters")
    assert verify(model, functions=["regressor"]).unchecked == ()


def test_slopes_of_a_free_joint_away_from_the_origin() -> None:
    """Its rates were differentiated as those of a node: builds with nodes were refused."""
    scene = cd.Scene("free", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, inertia=(0.1, 0.2, 0.3))
    scene.joint("joint", cd.Free(), scene.ground.at(1, 2, 3), body)
    model = cd.compile(scene, coordinates="absolute")
    assert model.verify().worst < 1e-12
    motion = model.simulate(0.5, u={"joint": (0, 0, 0, 1, 0, 0)})
    np.testing.assert_allclose(motion["joint.px"][-1], 0.5, atol=1e-6)
    np.testing.assert_allclose(motion["joint.pz"][-1], -9.81 / 8, atol=1e-5)


def leaning() -> cd.CompiledModel:
    """A bar of length 1 m on a spring of 10 Nm, upright under a weight P: it falls beyond 10 N."""
    scene = cd.Scene("leaning", gravity=(0, 0, 0))
    bar = scene.body("bar", mass=1.0, inertia=(1, 1, 1))
    scene.joint("h", cd.Revolute("y"), scene.ground, bar)
    P, h = scene.parameter("P", 0.0), scene.q("h")
    scene.force("spring", cd.JointForce("h", P * sp.sin(h) - 10.0 * h))
    return cd.compile(scene)


@pytest.mark.parametrize("gap", [(9.9, 10.05), (9.999, 10.9), (0.0, 20.0)])
def test_a_critical_load_next_to_which_no_search_converges(
    gap: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The load where searches ceased to converge was told as the critical one, without a word."""
    with pytest.warns(cd.SolveWarning, match="unstable"):
        path = leaning().statics(P=(0, 20.0))
    (sure,) = path.critical()
    assert sure == {"P": pytest.approx(10.0, rel=1e-9)}
    search = critical_load.equilibrium_search

    def lost(problem: Any, point: Any, load: Any, ways: Any) -> Any:
        found = search(problem, point, load, ways)
        return replace(found, converged=not gap[0] < load.parameters["P"] < gap[1])

    monkeypatch.setattr(critical_load, "equilibrium_search", lost)
    monkeypatch.setattr(critical_load, "balance", lambda *a: SimpleNamespace(holds=False))
    with pytest.warns(cd.SolveWarning, match=r"known to lie within P = .* only"):
        (found,) = path.critical()
    low, high = (
        path.loading.values(place.s)["P"]
        for place in (path.crossings[0].before, path.crossings[0].after)
    )
    ends = max(gap[0], low), min(gap[1], high)
    assert found["P"] == pytest.approx(sum(ends) / 2, rel=1e-9)
    assert found["P.width"] == pytest.approx(ends[1] - ends[0], rel=1e-6)


def contact(**how: Any) -> cd.Contact:
    """A ball on the ground."""
    ground = cd.Scene("one").ground
    return cd.Contact(ground, ground, **{"radius": 0.1, "stiffness": 1e6, **how})


@pytest.mark.parametrize("truth", [True, np.True_, np.array(True)])
def test_a_truth_value_is_not_a_number(truth: Any) -> None:
    """Those of NumPy were taken as 1, and ``restitution=True`` too."""
    with pytest.raises(ArgumentError):
        read("f", "x", truth, kinds_of("float"))
    with pytest.raises(cd.ModelError, match="restitution"):
        contact(restitution=truth, speed=1.0)
    with pytest.raises(cd.ModelError, match="stiffness"):
        contact(stiffness=truth)


def test_a_contact_takes_numbers_of_numpy() -> None:
    """``np.float32`` was refused."""
    found = contact(restitution=np.float32(0.5), speed=np.int64(2))
    assert found.damping == contact(restitution=0.5, speed=2.0).damping


def test_a_fault_in_a_law_of_elements_is_no_missing_function(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Any KeyError was told as a function that is not there."""

    def broken(members: Any) -> float:
        return float({}["typo"])

    def needing(members: Any) -> Any:
        return Members.call(members, "momentum")

    table = SimpleNamespace(kind=SimpleNamespace(parts={}))
    here = SimpleNamespace(codes={"energy": None}, table=table, in_all_modes=None)
    here.weighed = lambda form: here
    monkeypatch.setattr(elements, "_text", lambda members, form: 0.0)
    monkeypatch.setitem(elements.LAWS, "energy", needing)
    assert list(elements.check_kinds(here)) == [("energy", 0.0, "needs 'momentum'")]  # type: ignore[arg-type]
    monkeypatch.setitem(elements.LAWS, "energy", broken)
    with pytest.raises(KeyError, match="typo"):
        list(elements.check_kinds(here))  # type: ignore[arg-type]


def test_forces_of_elements_are_not_called_velocity_products() -> None:
    """On nodes ``bias`` gave h - f, with what forces apply, under the name of h."""
    for coordinates in ("relative", "absolute"):
        scene = cd.Scene("pushed", gravity=(0, 0, -9.81))
        block = scene.body("block", mass=1, inertia=(1, 1, 1))
        scene.joint("lift", cd.Prismatic("z"), scene.ground, block)
        scene.force("push", cd.JointForce("lift", 5.0))
        model = cd.compile(scene, coordinates=coordinates)
        q, u = model.split(model.initial())
        # on nodes the weight acts on the block, the push along the joint
        assert model.inverse_dynamics(q, u, 0 * u).sum() == pytest.approx(9.81 - 5.0)
        if coordinates == "relative":
            assert model.bias(q, u) == pytest.approx(9.81)
        else:
            with pytest.raises(cd.ModelError, match="no 'bias'"):
                model.bias(q, u)
