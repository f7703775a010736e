"""Constraints by kind: level, time, and whether those of velocities follow from positions."""

from __future__ import annotations

from pathlib import Path

import sympy

import cardan as cd
from mechanisms.closed import four_bar

BICYCLE = Path(__file__).parents[2] / "src" / "cardan" / "scenes" / "bicycle.yaml"


def kinds(scene: cd.Scene) -> dict[str, tuple[str, bool, bool]]:
    """Multiplier -> level, rheonomic, integrable."""
    found = cd.derive(scene).classification()
    return {row.name: (row.level, row.rheonomic, row.integrable) for row in found.rows}


def sledge() -> cd.Scene:
    """A body that slides and turns on a plane: u = rates of x, y, angle."""
    scene = cd.Scene("sledge")
    body = scene.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("plane", cd.Planar(), scene.ground, body)
    return scene


def places(scene: cd.Scene) -> tuple[list[sympy.Symbol], list[sympy.Symbol]]:
    """Coordinates and speeds of the sledge."""
    names = [f"plane.{name}" for name in ("x", "y", "angle")]
    return [scene.q(name) for name in names], [scene.u(name) for name in names]


def test_a_closed_circuit_is_of_positions() -> None:
    held = ("position", False, True)
    assert kinds(four_bar()) == {"C.px": held, "C.py": held}


def test_a_rolling_coin_is_nonholonomic() -> None:
    scene = cd.Scene("coin", gravity=(0, 0, -9.81))
    coin = scene.body("coin", mass=1.0, inertia=(0.0025, 0.005, 0.0025))
    scene.joint("rolling", cd.RollingDisk(0.1), scene.ground, coin)
    slipping = ("velocity", False, False)
    assert kinds(scene) == {"rolling.longitudinal": slipping, "rolling.lateral": slipping}


def test_a_bicycle_has_one_constraint_of_positions() -> None:
    found = kinds(cd.load(BICYCLE))
    assert found.pop("front_contact.pz") == ("position", False, True)
    assert set(found.values()) == {("velocity", False, False)}
    assert len(found) == 4


def test_a_skate_is_not_integrable_but_a_rail_is() -> None:
    skate, rail, wheel = sledge(), sledge(), sledge()
    q, u = places(skate)
    skate.constraint("edge", -sympy.sin(q[2]) * u[0] + sympy.cos(q[2]) * u[1])
    assert kinds(skate) == {"edge": ("velocity", False, False)}
    # d(x² y + angle) written with speeds
    q, u = places(rail)
    rail.constraint("rail", 2 * q[0] * q[1] * u[0] + q[0] ** 2 * u[1] + u[2])
    assert kinds(rail) == {"rail": ("velocity", False, True)}
    told = str(cd.derive(rail).classification())
    assert told == (
        "rail: velocity level, scleronomic, holonomic; note: it is integrable, so that it could "
        "be written for positions"
    )
    # the same times a factor, which no longer is a derivative but means the same
    q, u = places(wheel)
    factor = 2 + sympy.sin(q[0] + q[2])
    wheel.constraint("rail", factor * (2 * q[0] * q[1] * u[0] + q[0] ** 2 * u[1] + u[2]))
    assert kinds(wheel) == {"rail": ("velocity", False, True)}


def test_a_skate_on_a_rail_that_keeps_its_heading_is_integrable() -> None:
    scene = sledge()
    q, u = places(scene)
    scene.constraint("edge", -sympy.sin(q[2]) * u[0] + sympy.cos(q[2]) * u[1])
    scene.constraint("heading", u[2])
    held = ("velocity", False, True)
    assert kinds(scene) == {"edge": held, "heading": held}


def test_body_fixed_angular_velocity_is_not_integrable() -> None:
    """No spin about a body axis: rates of quaternions and angular velocity do not commute."""
    scene = cd.Scene("top")
    body = scene.body("body", mass=1.0, inertia=(1, 2, 3))
    scene.joint("ball", cd.Spherical(), scene.ground, body)
    scene.constraint("spin", scene.u("ball.z"))
    assert kinds(scene) == {"spin": ("velocity", False, False)}


def test_time_makes_rheonomic() -> None:
    scene = sledge()
    scene.constraint("lift", places(scene)[0][1] - sympy.sin(cd.t))
    scene.constraint("pull", places(scene)[1][0] - cd.t)
    assert kinds(scene) == {"lift": ("position", True, True), "pull": ("velocity", True, True)}


def test_a_tree_has_none() -> None:
    assert str(cd.derive(sledge()).classification()) == "no constraints"
