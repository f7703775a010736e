"""Trim against closed forms, published circles, runs that stay, and what cannot be had."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd

REFERENCES = Path(__file__).parents[1] / "references"
BICYCLE = REFERENCES.parents[1] / "src" / "cardan" / "scenes" / "bicycle.yaml"
G = 9.81
COIN = json.loads((REFERENCES / "coin_steady.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def coin() -> cd.CompiledModel:
    m, r = COIN["parameters"]["m"], COIN["parameters"]["r"]
    scene = cd.Scene("coin", gravity=(0, 0, -G))
    disk = scene.body("disk", mass=m, inertia=(m * r**2 / 4, m * r**2 / 2, m * r**2 / 4))
    scene.joint("rolls", cd.RollingDisk(r), scene.ground, disk)
    return cd.compile(scene)


@pytest.mark.parametrize("case", COIN["reference"]["cases"])
def test_circles_of_a_coin(coin: cd.CompiledModel, case: dict[str, float]) -> None:
    lean = math.pi / 2 - math.radians(case["axis_incl_deg"])
    wanted = {"rolls.lean": lean, "rolls.u.yaw": case["W"]}
    found = coin.trim(wanted, free=["rolls.u.spin"], u={"rolls.u.spin": -10.0})
    assert found.converged
    assert found["rolls.u.spin"] == pytest.approx(case["spin_rel"], rel=1e-12)
    assert found.linear.acceleration < 1e-12
    # modes are those of the same first-order equations, not of the turning of the contact
    slow = found.model.modes(x=found).values
    growth = found.linear.eigenvalues
    assert np.abs(growth[:, None] - slow[np.abs(slow) > 1e-6]).min(axis=0).max() < 1e-9
    # the other way round: which lean belongs to these rates
    rates = {"rolls.u.spin": case["spin_rel"], "rolls.u.yaw": case["W"]}
    other = coin.trim(rates, q={"rolls.lean": lean + 0.1})
    assert other["rolls.lean"] == pytest.approx(lean, rel=1e-10)
    assert set(found.free_motions) == {"rolls.x", "rolls.y", "rolls.yaw", "rolls.spin"}


@pytest.mark.slow
def test_stability_of_circles_by_a_run(coin: cd.CompiledModel) -> None:
    case = COIN["reference"]["cases"][2]
    lean = math.pi / 2 - math.radians(case["axis_incl_deg"])
    rates = {"rolls.u.spin": case["spin_rel"], "rolls.u.yaw": case["W"]}
    found = coin.trim(rates, q={"rolls.lean": lean})
    beside = found.x.copy()
    beside[3] += 1e-4
    motion = coin.simulate(3.0, x0=beside, rtol=1e-10, atol=1e-12)
    spread = float(np.abs(motion["rolls.lean"] - lean).max())
    assert found.stable is bool(spread < 1e-2)


@pytest.fixture(scope="module")
def bicycle() -> cd.CompiledModel:
    return cd.compile(cd.load(BICYCLE))


def test_a_bicycle_turns_steadily(bicycle: cd.CompiledModel) -> None:
    found = bicycle.trim(
        {"rear_contact.u.yaw": 0.5, "rear_hub.u": -15.0}, free=["steer.driving_force"]
    )
    assert found.converged
    # the other way round: the turn that belongs to this lean
    wanted = {"rear_contact.lean": found["rear_contact.lean"], "rear_hub.u": -15.0}
    other = bicycle.trim(wanted, free=["steer.driving_force"])
    assert other["steer.driving_force"] == pytest.approx(found["steer.driving_force"], rel=1e-9)
    assert other["rear_contact.u.yaw"] == pytest.approx(0.5, rel=1e-9)
    # leaned as a point mass would be, but for spin of the wheels and their width of 0
    speed = 4.5
    assert math.tan(-found["rear_contact.lean"]) == pytest.approx(speed * 0.5 / G, rel=0.1)
    # another function says that nothing changes but the direction of the contact
    tau = np.zeros(bicycle.nu)
    tau[bicycle.speeds.index("steer.u")] = found["steer.driving_force"]
    udot = dict(zip(bicycle.speeds, bicycle.forward_dynamics(found.q, found.u, tau=tau),
                    strict=True))  # fmt: skip
    assert udot.pop("rear_contact.u.y") == pytest.approx(speed * 0.5, rel=1e-9)
    np.testing.assert_allclose(list(udot.values()), 0, atol=1e-9)


def gyroscope() -> cd.Scene:
    """A heavy top in Euler angles."""
    scene = cd.Scene("top", gravity=(0, 0, -G))
    outer, inner = (scene.body(name, mass=0, inertia=(0, 0, 0)) for name in ("outer", "inner"))
    top = scene.body("top", mass=2.0, com=(0, 0, 0.4), inertia=(0.18, 0.18, 0.1))
    scene.joint("precession", cd.Revolute("z"), scene.ground, outer)
    scene.joint("nutation", cd.Revolute("x"), outer, inner, q0=0.5)
    scene.joint("spin", cd.Revolute("z"), inner, top)
    scene.output("height", top.at(0, 0, 0.4).position()[2])
    return scene


@pytest.fixture(scope="module")
def top() -> cd.CompiledModel:
    return cd.compile(gyroscope())


def test_both_precessions_of_a_top(top: cd.CompiledModel) -> None:
    angle, w, I1, I3, mgl = 0.5, 100.0, 0.5, 0.1, 2.0 * G * 0.4
    # (I1 - I3) cos P^2 - I3 w P + m g l = 0, w the spin against the precessing frame
    expected = np.sort(np.roots([(I1 - I3) * math.cos(angle), -I3 * w, mgl]))
    for start, precession in zip((1.0, 30.0), expected, strict=True):
        found = top.trim({"nutation": angle}, free=["precession.u"],
                         u={"spin": w, "precession": start})  # fmt: skip
        assert found["precession.u"] == pytest.approx(precession, rel=1e-12)
        assert found.stable
        assert found["spin.u"] == w


def test_outputs_and_parameters(top: cd.CompiledModel) -> None:
    u = {"spin": 100.0, "precession": 1.0}
    found = top.trim({"height": 0.3}, free=["top.mass"], u=u)
    angle = math.acos(0.3 / 0.4)
    assert found["nutation"] == pytest.approx(angle, rel=1e-11)
    m = found["top.mass"]
    # the inertia about the centre of mass stays
    I1 = 0.18 + m * 0.4**2
    assert (I1 - 0.1) * math.cos(angle) - 10.0 + m * G * 0.4 == pytest.approx(0, abs=1e-10)
    assert found.model.parameters["top.mass"] == m
    assert "(free)" in repr(found)


def test_conical_pendulum() -> None:
    scene = cd.Scene("cone", gravity=(0, 0, -G))
    shaft = scene.body("shaft", mass=0.1, inertia=(0.1, 0.1, 0.1))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -0.8))
    scene.joint("turn", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("swing", cd.Revolute("y"), shaft, bob)
    model = cd.compile(scene)
    found = model.trim({"swing": 1.1}, free=["turn.u"], u={"turn": 1.0})
    assert found["turn.u"] ** 2 == pytest.approx(G / (0.8 * math.cos(1.1)), rel=1e-12)
    assert found.stable


def governor() -> cd.Scene:
    """An arm, a rod and a sleeve on a shaft: a closed loop that turns."""
    scene = cd.Scene("governor", gravity=(0, 0, -G))
    shaft, sleeve = (scene.body(n, mass=1.0, inertia=(0.1, 0.1, 0.1)) for n in ("shaft", "sleeve"))
    arm = scene.body("arm", mass=0.5, com=(0, 0, -0.5), inertia=(0.02, 0.02, 0.001))
    rod = scene.body("rod", mass=0.2, com=(0, 0, -0.25), inertia=(0.02, 0.02, 0.001))
    hinge = cd.Revolute("y")
    scene.joint("spin", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("slide", cd.Prismatic("z"), shaft, sleeve, q0=-0.7)
    scene.joint("arm", hinge, shaft.at(0.05, 0, 0), arm, q0=-0.8)
    scene.joint("rod", hinge, arm.at(0, 0, -0.5), rod, q0=1.6)
    scene.joint("foot", hinge, rod.at(0, 0, -0.5), sleeve.at(0.05, 0, 0))
    return scene


def test_what_holds_a_circuit() -> None:
    model = cd.compile(governor())
    found = model.trim({"slide": -0.65}, free=["spin.u"], u={"spin": 5.0})
    assert found.converged
    # the other analysis finds the height that belongs to this speed
    again = model.equilibrium(q=found.q, u={"spin": found["spin.u"]})
    assert again["slide"] == pytest.approx(-0.65, abs=1e-10)
    assert found.stable is again.stable
    held = model.trim({"slide": -0.65}, free=["slide.driving_force"])
    rest = model.equilibrium(q=held.q, locked={"slide": -0.65, "spin": 0.0})
    assert held["slide.driving_force"] == pytest.approx(rest.holding_forces["slide"], rel=1e-9)


def test_controllers_come_to_rest() -> None:
    scene = cd.Scene("arm", gravity=(0, 0, -G))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    angle, rate = scene.q("pivot"), scene.u("pivot")
    aim = scene.input("aim")
    pid = cd.Controller.pid("pivot", angle, rate, target=aim, kp=20.0, ki=5.0, kd=2.0)
    scene.force("pid", pid)
    found = cd.compile(scene).trim({"pivot": 0.4}, free=["aim"])
    assert found["aim"] == pytest.approx(0.4, abs=1e-10)
    assert 5.0 * found["pid.integral"] == pytest.approx(0.5 * G * math.sin(0.4), rel=1e-9)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"free": ["precession.u", "spin.u"]}, "left over: .*'precession.u'.*'spin.u'|left over"),
        ({"u": {"spin": 100.0, "precession": 1.0}}, "no steady motion: .*Free"),
        ({"free": ["spin.u"], "u": {"precession": 0.0}}, "no steady motion"),
    ],
)
def test_what_cannot_be_had(top: cd.CompiledModel, options: dict[str, Any], said: str) -> None:
    given = {"u": {"spin": 100.0}} | options
    with pytest.raises(cd.SolveError, match=said):
        top.trim({"nutation": 0.5}, **given, check=True)
    with pytest.warns(cd.SolveWarning, match=said):
        assert not top.trim({"nutation": 0.5}, **given).converged


def test_a_force_without_a_lever() -> None:
    scene = cd.Scene("crank", gravity=(0, 0, -G))
    bar = scene.body("bar", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.1))
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar)
    scene.force("pull", cd.Force(bar.at(0, 0, -1), (scene.input("F"), 0, 0)))
    model = cd.compile(scene)
    with pytest.raises(
        cd.SolveError, match=r"'F' = .* still growing .* Free .*: <joint>.driving_force"
    ):
        model.trim({"pin": math.pi / 2}, free=["F"], check=True)
    assert model.trim({"pin": math.pi / 2}, free=["pin.driving_force"]).converged


def test_weight_that_does_not_turn_along() -> None:
    scene = cd.Scene("wheel", gravity=(0, 0, -G))
    wheel = scene.body("wheel", mass=1.0, com=(0, 0, -0.1), inertia=(0.1, 0.1, 0.1))
    scene.joint("axle", cd.Revolute("y"), scene.ground, wheel)
    model = cd.compile(scene)
    with pytest.raises(cd.SolveError, match=r"as 'axle.u' goes on, accelerations change"):
        model.trim({"axle.u": 3.0}, check=True)
    assert model.trim({"axle.u": 3.0}, parameters={"wheel.com.z": 0.0}).converged


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m: m.trim({"nutatoin": 1.0}), "Did you mean 'nutation'"),
        (lambda m: m.trim({"nutation": math.nan}), "finite"),
        (
            lambda m: m.trim({"nutation": 1.0}, free=["spin.driving_forse"]),
            "Did you mean 'spin.driving_force'",
        ),
        (lambda m: m.trim({"spin.u": 1.0}, free=["spin.u"]), "a target and free"),
        (lambda m: m.trim({"nutation": 1.0}, u={"spinn": 3}), "spin"),
        (lambda m: m.trim({"nutation": 1.0}, t=math.inf), "finite"),
        (lambda m: m.trim(["nutation"]), "give numbers by name"),
        (
            lambda m: m.trim({"nutation": 0.5}, free=["nutation.driving_force"])["spinn"],
            "Did you mean",
        ),
    ],
)
def test_nonsense_is_refused(top: cd.CompiledModel, call: Callable[[Any], Any], said: str) -> None:
    with pytest.raises(cd.CardanError, match=said):
        call(top)


def test_beams_are_sent_elsewhere() -> None:
    scene = cd.Scene("strip", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e6, GA=1e6, GJ=80, EI=100, rhoA=1, rhoI=1e-6)
    scene.beam("beam", scene.ground, (1, 0, 0), section, elements=1)
    with pytest.raises(cd.ModelError, match=r"model.equilibrium\(u="):
        cd.compile(scene).trim({})
