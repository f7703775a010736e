"""Equilibria, load paths and stability: faults that were silent."""

from __future__ import annotations

import json
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.statics.settling import forbidden
from cardan.analyses.statics.static_problem import Point, Problem
from cardan.analyses.systems import dynamic_system_of
from mechanisms.loaded import arch, follower_column, shaft
from spread import some

RADIUS = 100.0  # of the deep arch [m]
REFERENCES = Path(__file__).parents[1] / "references"


def known(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((REFERENCES / f"{name}.json").read_text("utf-8"))
    return found


def unbalanced(row: cd.Equilibrium, size: float) -> float:
    """Largest force [N] that nothing balances, by the accelerations it makes: M udot.

    A moment counts by the forces that make it over the size of the scene.
    """
    model = row.model
    force = model.inverse_dynamics(row.q, row.u, 0 * row.u)
    held = model.constraint_jacobian(row.q).T @ row.lam
    turns = [speed["unit"] == "rad/s" for speed in model.manifest["speeds"]]
    return float(np.abs((force - held) / np.where(turns, size, 1.0)).max())


# order four: 2.6e-3 and 1.8e-4 with 8 and 16 elements; the shear of a finite GA takes 4e-5
@pytest.mark.parametrize(("elements", "off"), some([(16, 1e-3), (8, 4e-3), (32, 1e-3)], 3))
def test_a6_a_moment_twists_a_shaft_until_it_buckles(elements: int, off: float) -> None:
    """Two eigenvalues passed 0 at once, in a stiffness whose skew part no joint allows."""
    with pytest.warns(cd.SolveWarning, match=r"unstable from a load between T = \d+.*gives way"):
        path = shaft(elements).statics(T=(0, 1100.0))
    (found,) = path.critical()
    assert found["T"] == pytest.approx(898.682, rel=off)
    assert path.n_negative.tolist() == [0 if found["T"] > T else 2 for T in path["T"]]
    assert path.stable == [bool(found["T"] > T) for T in path["T"]]


@pytest.mark.slow
def test_a6_the_error_of_a_critical_torque_is_that_of_the_elements() -> None:
    """The place on the path is exact; 2.6e-3 with 8 elements falls by order four."""
    loads = []
    for elements in (8, 16, 32):
        model = shaft(elements)
        with pytest.warns(cd.SolveWarning, match="gives way"):
            (found,) = model.statics(T=(0, 1100.0)).critical()
        loads.append(found["T"])
        sides = [model.with_parameters(T=found["T"] * (1 + by)) for by in (-1e-6, 1e-6)]
        assert [side.equilibrium().n_negative for side in sides] == [0, 2]
    order = np.log2((loads[0] - loads[1]) / (loads[1] - loads[2]))
    assert order == pytest.approx(4.0, abs=0.3)
    turns = 8.98682 / 8
    assert (loads[0] - loads[1]) / 898.682 == pytest.approx(1.75e-3 * turns**4 * 15 / 16, rel=0.2)


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
@pytest.mark.parametrize("stiffness", [1e12, 1e16])
def test_a7_a_soft_part_rests_only_where_it_balances(stiffness: float, coordinates: str) -> None:
    """Beside a stiff spring forces of a soft one were let pass: converged 33 m from rest."""
    scene = cd.Scene("two")
    for name, own in (("stiff", stiffness), ("soft", 0.3)):
        body = scene.body(f"{name}_mass", mass=1.0, inertia=(1, 1, 1))
        scene.joint(name, cd.Prismatic("z"), scene.ground, body)
        scene.force(f"{name}_spring", cd.JointSpring(name, stiffness=own))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        row = cd.compile(scene, coordinates=coordinates).equilibrium()
    # 16 digits do not hold both: that is said, and nothing wrong is
    assert row.converged == (stiffness < 1e14)
    if row.converged:
        assert row["soft"] == pytest.approx(-9.81 / 0.3, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("elements", [16, 64])
def test_a7_rows_next_to_a_limit_load_balance(elements: int) -> None:
    """Forces along directions softer than 1e-13 of the largest stiffness were let pass."""
    reference = known("deep_arch_hinged_A")
    model = arch(elements, reference["parameters"])
    # past the sway bifurcation on the symmetric branch, up to its limit load
    with pytest.warns(cd.SolveWarning, match="limit point P = 946"):
        path = model.statics(P=(0, 1000.0))
    assert not path.success
    limit = path.critical()[-1]["P"]
    # the floor: 50 eps times EA |p| / h at the two elements that meet in a node
    length = np.radians(reference["parameters"]["arc_deg"]) * RADIUS / elements
    floor = 2 * 50 * np.finfo(float).eps * 1e8 * RADIUS / length
    assert [row.converged for row in path] == [True] * len(path)
    assert max(unbalanced(row, 2 * RADIUS) for row in path) <= 1e-8 * limit + floor
    assert path["P"].max() <= limit
    wanted = reference["reference"]["symmetric_limits"][0]["P"]
    # order four: 16 elements are 3.7e-4 off, 64 1.5e-6
    assert limit == pytest.approx(wanted, rel=2e-3 * (16 / elements) ** 4)


@pytest.mark.slow
def test_a7_the_limit_load_is_that_of_prescribed_displacements() -> None:
    """The load of the fold itself was not to be had; rows came to within 1e-4 of it."""
    reference = known("arch_clamped_hinged_180")
    model = arch(16, reference["parameters"], clamped=True, coordinates="absolute")
    with pytest.warns(cd.SolveWarning, match=r"the limit point P = 10\.25"):
        loaded = model.statics(P=(0, 12.0))
    (limit,) = loaded.critical()
    # the maximum of the force over the displacement, another way
    held = model.statics(locked={"crown.pz": (1.0, 0.1)}, steps=10)
    assert held.success
    (crossed,) = held.critical()
    assert -crossed["crown.pz.holding_force"] == pytest.approx(limit["P"], rel=1e-9)
    near = crossed["crown.pz"] + 1e-4 * np.arange(-2, 3)
    forces = model.statics(locked={"crown.pz": near}, q=held[8].q)["crown.pz.holding_force"]
    parabola = np.polynomial.Polynomial.fit(near, -forces, 4)
    (top,) = [x.real for x in parabola.deriv().roots() if abs(x - crossed["crown.pz"]) < 1e-4]
    assert parabola(top) == pytest.approx(limit["P"], rel=1e-6)
    assert loaded["P"].max() <= limit["P"]
    # 16 elements of order four
    assert limit["P"] == pytest.approx(reference["reference"]["limit"]["P"], rel=5e-4)


def test_a19_stability_under_dead_loads_and_as_it_is_held() -> None:
    """The stability of the held system was told as that of the dead load."""
    reference = known("arch_clamped_hinged_180")
    model = arch(8, reference["parameters"], clamped=True, coordinates="absolute")
    path = model.statics(locked={"crown.pz": (1.0, 0.0)}, steps=10)
    rising = np.gradient(path["crown.pz.holding_force"], path["crown.pz"]) > 0
    assert path.stable[1:-1] == rising[1:-1].tolist()
    assert path.n_negative.tolist() == [int(not x) for x in path.stable]
    assert path.stable_held == [True] * len(path)
    assert path.n_negative_held.tolist() == [0] * len(path)
    assert "stability under dead loads changes between crown.pz" in repr(path)


@pytest.mark.parametrize("elements", some([8, 16], 2))
def test_a8_a_follower_load_makes_a_column_flutter(elements: int) -> None:
    """The path went on stably in its own eyes: only ``stable`` turned False, far behind."""
    with pytest.warns(cd.SolveWarning, match=r"P = 200.*oscillation of 110\.\d+ rad/s.*flutter"):
        path = follower_column(elements).statics(P=(0, 2500.0))
    (found,) = path.critical()
    (crossing,) = path.crossings
    assert crossing.kind == "flutter"
    wanted = known("beck")["reference"]
    assert found["P"] / 100.0 == pytest.approx(wanted["P"], rel=1e-3)
    # at the double eigenvalue itself
    frequency = crossing.stability_at(crossing.after).frequency / 10.0
    assert frequency == pytest.approx(wanted["omega"], rel=2e-3)
    assert path.stable == [bool(found["P"] > P) for P in path["P"]]


@pytest.mark.slow
def test_b3_campbell_of_a_round_shaft_between_bearings() -> None:
    """Twisting and axial motions whirled by rounding, and their crossings could not be found."""
    scene = cd.Scene("rotor", gravity=(0, 0, 0))
    scene.body("shaft", mass=0.1, inertia=(1e-4,) * 3)
    disk = scene.body("disk", mass=5.0, inertia=(0.1, 0.05, 0.05), pose=(0.5, 0, 0))
    end = scene.body("end", mass=0.1, inertia=(1e-4,) * 3, pose=(1, 0, 0))
    scene.joint("spin", cd.Revolute("x"), scene.ground, "shaft")
    scene.joint("far", cd.Cylindrical("x"), scene.ground.at(1, 0, 0), end)
    section, steel = cd.section.circle(0.01), cd.material(E=2.1e11, nu=0.3, rho=7800)
    scene.beam("a", "shaft", disk, section, steel, elements=2)
    scene.beam("b", disk, end, section, steel, elements=2)
    diagram = cd.compile(scene).campbell(spin=(0, 600), locked={"spin": 0}, count=3)
    critical = diagram.critical()
    assert "critical speeds: " in repr(diagram)
    # the shaft twists at one frequency, seen from the ground and by one who turns along
    still = np.abs(diagram.whirl).max(axis=0) < 1e-9
    twists = diagram.frequencies[:, still]
    assert twists.size
    np.testing.assert_allclose(twists - twists[0], 0, atol=1e-3 * twists[0].max())
    # twisting, and bending forward and backward: between rows the frequency passes the spin
    assert len(critical) == 4
    behind = diagram.frequencies < diagram.speed[:, None]
    for speed in critical:
        row = np.searchsorted(diagram.speed, speed)
        assert diagram.speed[row - 1] <= speed <= diagram.speed[row]
        assert (behind[row - 1] != behind[row]).any()


def elastic_arm() -> cd.CompiledModel:
    """A beam on a hub that turns."""
    scene = cd.Scene("arm", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1, 1, 1))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub)
    section, metal = cd.section.rectangle(0.02, 0.01), cd.material(E=7e10, nu=0.3, rho=2700)
    scene.beam("beam", hub, (1.1, 0.3, 0.2), section, metal, elements=4)
    return cd.compile(scene)


@pytest.mark.parametrize(
    "call", [lambda m: m.assemble({"drive": 0.3}), lambda m: m.sweep("drive", [0, 0.1])]
)
def test_b6_kinematics_of_scenes_with_beams(call: Any) -> None:
    """Refused with a text about a function that nobody asked for."""
    with pytest.raises(
        cd.ModelError, match=r"(assemble|sweep): .*beams.*model\.statics\(locked="
    ) as refused:
        call(elastic_arm())
    assert "relative" not in str(refused.value)


def test_b6_actuation_of_a_resting_elastic_arm() -> None:
    """Refused over the rounding of elastic forces: 1e-14 of nothing."""
    arm = elastic_arm()
    # the stiffest: EA |p| / h, 50 units of rounding of it
    floor = 50 * np.finfo(float).eps * 7e10 * 0.02 * 0.01 * 1.16 / 0.29
    for angle in (0.0, 0.3, 0.6):
        rest = arm.equilibrium(locked={"drive": angle})
        q = np.stack([rest.q, rest.q])
        found = arm.actuation(q, np.zeros(arm.nu), np.zeros(arm.nu), ["drive"])
        assert np.abs(found.forces).max() <= floor


def test_b7_modes_whose_search_does_not_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """ARPACK's own text reached the user, though full matrices of that size are quick."""
    from scipy.sparse.linalg import ArpackError

    from cardan.analyses.linear import modes

    model = follower_column(6)
    wanted = model.modes(6).frequencies

    def fails(*_: Any) -> Any:
        raise ArpackError(-9999)

    monkeypatch.setattr(modes, "near", fails)
    np.testing.assert_allclose(model.modes(6).frequencies, wanted, rtol=1e-9)
    monkeypatch.setattr(modes, "FULL", 10)
    with pytest.raises(cd.SolveError, match="Ask for fewer") as refused:
        model.modes(6)
    assert "ARPACK" not in str(refused.value)


def test_advice_holds_what_can_be_held() -> None:
    """Users were told to hold what cannot be, or what they held already."""
    scene = cd.Scene("loose", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e6, GA=1e6, GJ=80, EI=100, rhoA=1, rhoI=1e-6)
    hub = scene.body("hub", mass=1.0, inertia=(1, 1, 1))
    scene.joint("rail", cd.Cylindrical("x"), scene.ground, hub)
    beam = scene.beam("beam", hub, (1, 0, 0), section, elements=2)
    scene.force("push", cd.Force(beam.end, (1.0, 0, 0)))
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match=r"nothing holds .* lock it: locked=\{'"):
        found = model.equilibrium()
    name = found.message.partition("locked={'")[2].partition("'")[0]
    # positions of nodes can be held, and parts of joints
    held = model.equilibrium(locked={name: 0.0, "rail.angle": 0.0})
    assert held.converged
    assert held.holding_forces[name] == pytest.approx(-1.0, rel=1e-9)
    # who holds already is not told to
    moved = {"beam.end.px": 1.0, "rail.angle": 0.0}
    assert model.equilibrium(locked=moved).holding_forces["beam.end.px"] == pytest.approx(
        -1.0, rel=1e-9
    )


def test_one_mode_is_one() -> None:
    """'1 modes'."""
    scene = cd.Scene("one", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    assert "'one': 1 mode\n" in repr(cd.compile(scene).modes())


def block(joint: str, **given: Any) -> tuple[cd.Scene, cd.Body]:
    """2 kg on a straight guide, in a field of gravity."""
    scene = cd.Scene("block", **given)
    body = scene.body("b", mass=2.0, inertia=(1, 1, 1))
    scene.joint(joint, cd.Prismatic(joint), scene.ground, body)
    return scene, body


def test_a14_a_mass_comes_to_rest_on_a_stop() -> None:
    """It rested 120 m below the stop, or nothing held it."""
    scene, _ = block("z", gravity=(0, 0, -9.81))
    scene.force("stop", cd.Stop("z", lower=0.0))
    scene.force("pull", cd.JointForce("z", scene.parameter("F", 0.0) - 10.0 * scene.q("z")))
    model = cd.compile(scene)
    for start in (1.0, 1e-3, 0.0):
        found = model.equilibrium(q={"z": start})
        assert found.converged
        assert found["z"] == pytest.approx(0.0, abs=1e-12)
        assert found.modes == {"stop": "at the lower stop"}
        assert found["stop.stop"] == pytest.approx(2 * 9.81, rel=1e-12)
    lifted = model.equilibrium(parameters={"F": 30.0})
    assert lifted["z"] == pytest.approx((30.0 - 2 * 9.81) / 10.0, rel=1e-9)
    assert lifted.modes == {"stop": "free"}
    # along a path it leaves the stop, and comes back to it
    for ends in ((0.0, 40.0), (40.0, 0.0)):
        path = model.statics(F=ends)
        z = np.maximum((path["F"] - 2 * 9.81) / 10.0, 0.0)
        np.testing.assert_allclose(path["z"], z, atol=1e-9)
    with pytest.raises(cd.ModelError, match="starts beyond its lower stop"):
        model.equilibrium(q={"z": -0.5})


def test_a14_friction_holds_a_block_on_a_slope() -> None:
    """'nothing holds x'."""
    angle, mu = 0.3, 0.5
    weight = 2 * 9.81
    most = mu * weight * np.cos(angle)
    scene, _ = block("x", gravity=(9.81 * np.sin(angle), 0, -9.81 * np.cos(angle)))
    scene.force("dry", cd.Friction("x", coulomb=most))
    scene.force("pull", cd.JointForce("x", scene.parameter("F", 0.0) - 50.0 * scene.q("x")))
    model = cd.compile(scene)
    ends = (weight * np.sin(angle) + most * np.array([-1, 1])) / 50.0
    for start in (ends[0] + 1e-3, 0.0, 0.1, ends[1] - 1e-3):
        found = model.equilibrium(q={"x": start})
        assert found["x"] == start
        assert found.modes == {"dry": "sticking"}
        assert "one of a set" in found.message
    # from outside it slides to the edge of the set
    for start, end in zip((-1.0, 1.0), ends, strict=True):
        found = model.equilibrium(q={"x": start})
        assert found["x"] == pytest.approx(end, rel=1e-9)
        assert "one of a set" in found.message
    path = model.statics(F=(0.0, 20.0))
    slipped = (path["F"] + weight * np.sin(angle) - most) / 50.0
    # on every row, to rounding of forces of 20 N over 50 N/m; searches end at 1e-9 of these
    np.testing.assert_allclose(path["x"], np.maximum(slipped, 0.0), atol=1e-9)


@pytest.mark.parametrize("mass", [1e-9, 1.0])
def test_a14_what_forbids_a_mode_counts_in_units_of_its_kind(mass: float) -> None:
    """One number stood for angles, lengths, forces and speeds: light things were forbidden what
    rounding does, and sliding could end behind where it began."""
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    trolley, hook = (scene.body(name, mass=mass, inertia=(mass,) * 3) for name in ("a", "b"))
    scene.joint("x", cd.Prismatic("x"), scene.ground, trolley)
    scene.joint("h", cd.Revolute("y"), trolley.at(0, 0, -1000.0), hook)
    scene.force("buffer", cd.Stop("x", lower=0.0))
    scene.force("catch", cd.Stop("h", lower=0.0))
    scene.force("rub", cd.Friction("x", coulomb=1e-3 * mass))
    model = cd.compile(scene)
    system = dynamic_system_of(model)
    assert system.sign_units == ("m", "N", "rad", "N*m", "m/s", "N")
    none = system.input_vector(None)
    moment = system.start(0.0, {"x": 1.0, "h": 1.0}, none, {}, system.changed({}))
    moment = replace(
        moment, s=np.where([row["name"] == "rub" for row in model.manifest["s"]], 1.0, moment.s)
    )
    problem, start = Problem(system), Point(moment, np.zeros(0))

    def passed(x: float, h: float) -> list[str]:
        end = Point(replace(moment, q=np.array([x, h])), np.zeros(0))
        named = zip(model.manifest["events"], forbidden(problem, start, end), strict=True)
        return [row["name"] for row, happens in named if happens]

    assert passed(2.0, 1.0) == []
    # in parts of 1000 m, and of a radian
    assert "buffer.lower" not in passed(-1e-7, 1.0)
    assert "buffer.lower" in passed(-1e-5, 1.0)
    assert "catch.lower" not in passed(2.0, -1e-10)
    assert "catch.lower" in passed(2.0, -1e-8)
    # it slides forward
    assert passed(1.0 - 1e-7, 1.0) == []
    assert passed(0.999, 1.0) == ["rub.stop"]


def test_a14_a_latch_catches_what_falls_into_it() -> None:
    """Equilibria did not know of locks."""
    scene = cd.Scene("latch", gravity=(0, 0, -9.81))
    bar = scene.body("bar", mass=1.0, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
    scene.joint("h", cd.Revolute("y"), scene.ground, bar)
    scene.force("lock", cd.Lock("h", when=scene.q("h") - 0.5))
    found = cd.compile(scene).equilibrium(q={"h": 1.5})
    assert found["h"] == pytest.approx(0.5, abs=1e-12)
    assert found.modes == {"lock": "locked"}
    assert abs(found["lock.lock"]) == pytest.approx(9.81 * np.sin(0.5), rel=1e-12)


def test_a14_several_stops_and_springs() -> None:
    """Modes follow each other: a stop below a stop."""
    scene = cd.Scene("two", gravity=(0, 0, -9.81))
    one, two = (scene.body(name, mass=1.0, inertia=(1, 1, 1)) for name in ("one", "two"))
    for name, parent, child, low, k in (
        ("a", scene.ground, one, -0.1, 50),
        ("c", one, two, -0.3, 20),
    ):
        scene.joint(name, cd.Prismatic("z"), parent, child)
        scene.force(f"stop_{name}", cd.Stop(name, lower=low))
        scene.force(f"spring_{name}", cd.JointForce(name, -k * scene.q(name)))
    found = cd.compile(scene).equilibrium()
    np.testing.assert_allclose(found.q, [-0.1, -0.3], atol=1e-12)
    np.testing.assert_allclose(found.lam, [2 * 9.81 - 5, 9.81 - 6], rtol=1e-9)
