"""Paths of least strain energy: struts that buckle, snaps, prestress, lengths that are driven."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import cardan as cd

INERT: dict[str, Any] = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0)}


# beams


def strut(coordinates: str = "auto") -> cd.CompiledModel:
    """A strip between the ground and a block on rails: clamped at both ends."""
    scene = cd.Scene("strut", gravity=(0, 0, -9.81))
    block = scene.body("block", **INERT)
    scene.joint("slide", cd.Prismatic("x"), scene.ground.at(1, 0, 0), block)
    section = cd.section.general(EA=1e6, GA=1e6, GJ=80, EI=100, rhoA=1, rhoI=1e-6)
    scene.beam("beam", scene.ground, block, section, elements=4)
    return cd.compile(scene, coordinates=coordinates)


def test_a_strut_buckles_where_minima_are_followed() -> None:
    model = strut()
    values = -np.linspace(0, 0.04, 9)
    with pytest.warns(cd.SolveWarning, match="not least: it falls along 'beam"):
        straight = model.sweep("slide", values, by="strain_energy")
    assert straight.success
    assert straight.minimum == [True] + [False] * 8
    np.testing.assert_allclose(straight.energy, 0.5e6 * values**2, rtol=1e-10, atol=1e-12)
    bent = model.sweep("slide", values, by="strain_energy", snap=True)
    assert bent.success
    assert all(bent.minimum)
    (snap,) = bent.snaps
    # it begins to bend without a jump, at the critical load of the mesh, 2.7 % below Euler's
    critical = -snap.values["slide"] * 1e6
    assert 0 < snap.released < 1e-3 * bent.energy[-1]
    assert critical == pytest.approx(4 * math.pi**2 * 100, rel=0.03)
    statics = model.equilibrium(
        q=bent.q[-1], locked={"slide": values[-1]}, parameters={"gravity.z": 0.0}
    )
    np.testing.assert_allclose(bent.q[-1], statics.q, rtol=0, atol=1e-9)
    force = bent["slide.holding_force"][-1]
    assert force == pytest.approx(statics.holding_forces["slide"], rel=1e-9)
    # in other coordinates too; assembled by itself it is bent as well
    other = strut("absolute").assemble({"slide": values[-1]}, by="strain_energy")
    assert other.energy == pytest.approx(bent.energy[-1], rel=1e-9)


# snaps


BAR, RISE, PUSH = 2000.0, 0.3, 20.0


def pushed_bar() -> cd.CompiledModel:
    """The apex of a shallow truss on a rail, pushed through a soft spring."""
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    carriage, apex = (scene.body(name, **INERT) for name in ("carriage", "apex"))
    scene.joint("drive", cd.Prismatic("z"), scene.ground, carriage)
    scene.joint("apex", cd.Prismatic("z"), scene.ground, apex)
    scene.parameter("stiffness", PUSH)
    length = math.hypot(1, RISE)
    foot = scene.ground.at(1, 0, 0)
    scene.force("bar", cd.SpringDamper(foot, apex, stiffness=BAR, rest_length=length))
    push = cd.SpringDamper(carriage.at(0, 0, 1), apex, stiffness=PUSH, rest_length=1.0)
    scene.force("push", push)
    return cd.compile(scene)


def bar_force(z: float) -> float:
    length = math.hypot(1, z)
    return BAR * (length - math.hypot(1, RISE)) * z / length


def bar_stiffness(z: float) -> float:
    length = math.hypot(1, z)
    return BAR * ((z / length) ** 2 + (length - math.hypot(1, RISE)) / length**3)


def test_a_snap_is_told_and_passed_where_asked() -> None:
    model = pushed_bar()
    values = np.linspace(RISE, -0.6, 46)
    # the minimum ends where the spring is as soft as the truss is unstable
    fold = brentq(lambda z: bar_stiffness(z) + PUSH, 0.0, RISE, xtol=1e-15)
    drive = fold + bar_force(fold) / PUSH
    after = brentq(lambda z: bar_force(z) + PUSH * (z - drive), -1, -0.2, xtol=1e-15)
    with pytest.warns(
        cd.SolveWarning, match="minimum of the strain energy ends there along 'apex'"
    ):
        stopped = model.sweep("drive", values, by="strain_energy", start={"apex": RISE})
    assert stopped.status == "singular"
    assert len(stopped) == np.sum(values > drive)
    assert f"{drive:.6g}" in stopped.message
    with pytest.raises(cd.SolveError, match="snap=True goes on"):
        model.sweep("drive", values, by="strain_energy", start={"apex": RISE}, check=True)
    swept = model.sweep("drive", values, by="strain_energy", start={"apex": RISE}, snap=True)
    assert swept.success
    assert all(swept.minimum)
    (snap,) = swept.snaps
    place = model.coordinates.index("apex")
    assert snap.values["drive"] == pytest.approx(drive, abs=1e-10)
    # at a fold the position is known to the root of what the load is
    assert snap.before[place] == pytest.approx(fold, abs=1e-5)
    assert snap.after[place] == pytest.approx(after, abs=1e-5)
    length = math.hypot(1, RISE)
    energies = [
        0.5 * BAR * (math.hypot(1, z) - length) ** 2 + 0.5 * PUSH * (z - drive) ** 2
        for z in (fold, after)
    ]
    assert snap.released == pytest.approx(energies[0] - energies[1], abs=1e-5)
    balance = [bar_force(z) + PUSH * (z - v) for z, v in zip(swept["apex"], values, strict=True)]
    np.testing.assert_allclose(balance, 0, atol=1e-10)
    assert "snap at drive" in repr(swept)


# lengths that are driven, cables that go slack


def test_a_parameter_drives_and_rates_follow() -> None:
    model = pushed_bar()
    lengths = np.linspace(1.0, 1.05, 6)
    swept = model.sweep(
        "push.rest_length", lengths, by="strain_energy", locked={"drive": RISE}, rate=2.0,
        start={"apex": RISE},
    )  # fmt: skip
    assert swept.success
    # force balance of the apex, and its derivative: (k_bar + k) z' = -k l'
    z = swept["apex"]
    balance = [bar_force(a) + PUSH * (a - RISE - 1 + L) for a, L in zip(z, lengths, strict=True)]
    np.testing.assert_allclose(balance, 0, atol=1e-10)
    slopes = [-PUSH / (bar_stiffness(a) + PUSH) * 2.0 for a in z]
    np.testing.assert_allclose(swept["apex.u"], slopes, rtol=1e-8)
    assert swept["drive.holding_force"] == pytest.approx(-PUSH * (z - RISE - 1 + lengths))


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_prestressed_cables_hold_a_mast_and_go_slack(coordinates: str) -> None:
    """A mast between two cables, shorter than their distance: both pull until one is slack."""
    EA, width, height = 1e4, 0.5, 1.0
    taut = math.hypot(width, height)
    length = 0.98 * taut
    scene = cd.Scene("mast", gravity=(0, 0, 0))
    mast = scene.body("mast", **INERT)
    scene.joint("foot", cd.Revolute("y"), scene.ground, mast)
    for name, side in (("left", -width), ("right", width)):
        anchor = scene.ground.at(side, 0, 0)
        scene.force(name, cd.Cable(anchor, mast.at(0, 0, height), EA=EA, length=length))
    model = cd.compile(scene, coordinates=coordinates)
    angles = np.linspace(-0.3, 0.3, 13)
    swept = model.sweep("foot", angles, by="strain_energy")
    energy = np.zeros(len(angles))
    for side in (-width, width):
        top = height * np.stack([np.sin(angles), np.cos(angles)])
        strain = np.hypot(top[0] - side, top[1]) / length - 1
        energy += 0.5 * EA * length * np.maximum(strain, 0) ** 2
    np.testing.assert_allclose(swept.energy, energy, rtol=1e-10, atol=1e-10)
    # one of the cables is slack at the ends
    assert np.hypot(height * math.sin(0.3) - width, height * math.cos(0.3)) < length
    upright = model.assemble(by="strain_energy", start={"foot": 0.1})
    assert upright["foot"] == pytest.approx(0.0, abs=1e-9)


def test_an_input_may_be_a_length() -> None:
    scene = cd.Scene("actuator", gravity=(0, 0, 0))
    arm = scene.body("arm", **INERT)
    scene.joint("hinge", cd.Revolute("z"), scene.ground, arm)
    length = scene.input("length", default=1.0)
    tip = arm.at(1, 0, 0)
    scene.force("rod", cd.SpringDamper(scene.ground.at(0, -1, 0), tip, stiffness=1e3,
                                       rest_length=length))  # fmt: skip
    model = cd.compile(scene)
    lengths = np.linspace(1.2, 1.6, 5)
    swept = model.sweep("length", lengths, by="strain_energy", start={"hinge": -0.3})
    # nothing else pulls: the rod has its length
    exact = 2 * np.arcsin(lengths / 2) - math.pi / 2
    np.testing.assert_allclose(swept["hinge"], exact, rtol=0, atol=1e-9)
    np.testing.assert_allclose(swept.energy, 0, atol=1e-14)
    with pytest.raises(cd.ModelError, match="changes with time or inputs"):
        cd.compile(scene, coordinates="absolute").assemble(by="strain_energy")


def test_beams_whose_energy_holds_their_loads_are_refused() -> None:
    scene = cd.Scene("loaded", gravity=(0, 0, -9.81))
    section = cd.section.circle(0.01)
    material = cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", scene.ground, (1, 0, 0), section, material, elements=2,
               element="hellinger_reissner_loaded")  # fmt: skip
    with pytest.raises(cd.ModelError, match="carries a load"):
        cd.compile(scene).assemble(by="strain_energy")


def test_time_drives_a_prescribed_motion() -> None:
    """A stiff spring leads an arm behind another one, a soft one holds it back."""
    scene = cd.Scene("arms", gravity=(0, 0, 0))
    leader, follower = (scene.body(name, **INERT) for name in ("leader", "follower"))
    scene.joint("leader", cd.Revolute("z"), scene.ground, leader, prescribed=0.3 * cd.t)
    scene.joint("follower", cd.Revolute("z"), scene.ground, follower)
    tie = cd.Bushing(leader, follower, stiffness=(0, 0, 100.0, 0, 0, 0))
    scene.force("tie", tie)
    scene.force("back", cd.JointSpring("follower", stiffness=1.0))
    times = np.linspace(0, 2, 5)
    swept = cd.compile(scene).sweep("t", times, by="strain_energy", check=True)
    np.testing.assert_allclose(swept["follower"], 0.3 * times * 100 / 101, rtol=0, atol=1e-12)
    np.testing.assert_allclose(swept["follower.u"], 0.3 * 100 / 101, rtol=1e-9)
    np.testing.assert_array_equal(swept.t, times)
