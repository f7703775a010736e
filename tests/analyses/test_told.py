"""What runs and assemblies of closed systems say: who is to blame, and in which unit."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace

import numpy as np
import pytest

import cardan as cd
from mechanisms.closed_planar import four_bar, slider_crank
from mechanisms.closed_spatial import bricard


@pytest.fixture(scope="module")
def bars() -> cd.CompiledModel:
    return cd.compile(four_bar())


@pytest.mark.parametrize("angle", [0.0, 0.1, 0.3, math.pi])
def test_runs_and_assemblies_start_at_the_same_place(bars: cd.CompiledModel, angle: float) -> None:
    found = bars.assemble({"A": angle})
    motion = bars.simulate(1e-6, q={"A": angle})
    np.testing.assert_array_equal(motion.q[0], found.q)


def test_constraints_in_conflict_are_named() -> None:
    scene = four_bar()
    scene.constraint("lock", scene.q("A") - 1.0, unit="rad")
    scene.constraint("wedge", scene.q("D") - 2.0, unit="rad")
    assert "must hold as well" in str(cd.derive(scene).feasibility())
    model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match="'lock' and 'wedge' are inconsistent with"):
        model.assemble()


def test_one_constraint_out_of_reach_is_named() -> None:
    scene = four_bar()
    scene.constraint("wedge", scene.q("D") - 1.0 - cd.t, unit="rad")
    model = cd.compile(cd.derive(scene))
    with pytest.raises(cd.ModelError, match=r"constraint 'wedge' is inconsistent .* at t = 2\.5 s"):
        model.assemble(t=2.5)


def test_constraints_without_circuits_say_their_unit() -> None:
    scene = cd.Scene("lone")
    body = scene.body("body", mass=1.0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
    scene.constraint("far", scene.q("slide") ** 2 + 4.0, unit="m^2")
    told = str(cd.derive(scene).feasibility())
    assert told.startswith("constraint 'far' stays open: the least residual found is 4 m^2")
    model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match="constraint 'far' is inconsistent"):
        model.assemble()


def test_prescribed_motions_are_blamed() -> None:
    scene = four_bar()
    scene.constraint("drive", scene.q("D") - 2.0 - cd.t, unit="rad")
    model = cd.compile(scene)
    said = r"What is prescribed \('drive'\) asks for more than the mechanism can follow"
    with pytest.warns(cd.SolveWarning, match=said):
        motion = model.simulate(2.0)
    assert motion.status == "not_closed"
    # the constraint is an angle
    assert "position of 'drive' to" in repr(motion)
    assert motion.drift.position["drive"].unit == "rad"
    assert motion.drift.velocity["drive"].unit == "rad/s"


@pytest.mark.parametrize(
    ("scene", "name", "asked", "reached"),
    [
        (four_bar, "D", 6.0, 2 * math.pi - math.pi + math.acos(0.0625)),
        (slider_crank, "guide", -5.0, -0.4),
        (bricard, "J0", -1.0, -math.pi / 6),
    ],
)
def test_the_nearest_value_is_told(scene, name: str, asked: float, reached: float) -> None:
    model = cd.compile(scene())
    with pytest.raises(cd.ModelError, match="is out of reach") as error:
        model.sweep(name, [asked, asked + 1])
    told = float(str(error.value).split("reached ")[1].split(")")[0])
    assert told == pytest.approx(reached, abs=1e-5)


def test_reactions_that_are_not_determined_say_so_once() -> None:
    model = cd.compile(bricard())
    found = model.assemble({"J0": 0.3})
    said = r"reactions are not determined in .* of 'J1', 'J4'; .*: constraints are redundant"
    with pytest.warns(cd.SolveWarning, match=said):
        model.reaction("J1", found.q, found.u)
    motion = model.simulate(0.1, x0=found.x)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model.reaction("J1", found.q, found.u)
        # the warning named the others too
        motion.reaction("J2")


def test_one_warning_names_all_reactions_that_are_not_determined() -> None:
    motion = cd.compile(four_bar()).simulate(0.1, q={"A": 0.3})
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        for joint in "ABCD":
            motion.reaction(joint)
    (said,) = told
    assert "Mx, My, Fz of 'A', 'B', 'D', 'C': " in str(said.message)


def test_reactions_that_are_determined_say_nothing() -> None:
    scene = four_bar()
    # a ball and a universal joint at the coupler: nothing is redundant
    scene.joints["B"] = replace(scene.joints["B"], kind=cd.Universal("z", "y"))
    scene.joints["C"] = replace(scene.joints["C"], kind=cd.Spherical())
    motion = cd.compile(scene).simulate(0.1, q={"A": 0.3})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert motion.reaction("B").shape == (len(motion), 6)


def test_multipliers_have_histories(bars: cd.CompiledModel) -> None:
    motion = bars.simulate(0.1, q={"A": 0.3})
    expected = bars.multipliers(motion.q, motion.u)
    for k, name in enumerate(bars.multipliers_of):
        np.testing.assert_array_equal(motion[name], expected[:, k])
    with pytest.raises(cd.ModelError, match=r"no such history.*C\.p[xy]"):
        motion["C.pp"]


def test_a_run_tells_inputs_and_rest_apart() -> None:
    scene = four_bar()
    scene.force("motor", cd.JointForce("A", scene.input("torque", 0.0)))
    model = cd.compile(scene)
    start = model.assemble({"A": math.pi / 2})
    lines = repr(model.simulate(0.01, q={"A": start["A"]})).splitlines()
    (assembled,) = [line for line in lines if "assembled:" in line]
    (default,) = [line for line in lines if "by default:" in line]
    assert "torque" not in assembled
    assert "torque = 0" in default


def test_what_rests_has_no_part_of_its_kinetic_energy() -> None:
    scene = cd.Scene("hangs", gravity=(0, -9.81, 0))
    rod = scene.body("rod", mass=1.0, com=(0, -1, 0), inertia=(0.1, 0.1, 0.1))
    scene.joint("pin", cd.Revolute("z"), scene.ground, rod)
    assert "unaccounted for (at rest)" in repr(cd.compile(scene).simulate(1.0))


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_reaction_holds_the_spring_of_its_joint(coordinates: str) -> None:
    """As its documentation says: the torque acts through the joint."""
    scene = cd.Scene("door", gravity=(0, 0, 0))
    door = scene.body("door", mass=1.0, inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("z"), scene.ground, door)
    scene.force("spring", cd.JointSpring("hinge", 5.0, rest=1.0))
    model = cd.compile(scene, coordinates=coordinates)
    q, u = model.split(model.initial({"hinge": 0.2}))
    assert model.reaction("hinge", q, u) == pytest.approx([0, 0, 5.0 * 0.8, 0, 0, 0], abs=1e-12)
    about = cd.CompiledModel.reaction.__doc__ or ""
    assert "JointSpring" in about
    assert "JointSpring" in (cd.Trajectory.reaction.__doc__ or "")
