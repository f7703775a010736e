"""What carries a picture: pins, rails and clamps where the ground holds something."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from view.unpacked import data_of


def supports(motion: cd.Trajectory, tmp_path: Path) -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = data_of(motion.animate(tmp_path / "page.html").html)["supports"]
    return rows


def slider_crank() -> cd.Scene:
    """In the x-z plane; the crank turns about y, the slider runs on a line that is x of a frame."""
    scene = cd.Scene("slider_crank", gravity=(0, 0, -9.81))
    crank = scene.body("crank", mass=1, com=(0.1, 0, 0), inertia=(0.01, 0.01, 0.01))
    rod = scene.body("rod", mass=1, com=(0.25, 0, 0), inertia=(0.01, 0.01, 0.01))
    slider = scene.body("slider", mass=1, inertia=(0.01, 0.01, 0.01))
    scene.joint("drive", cd.Revolute("-y"), scene.ground.at(0, 0, 0.5), crank)
    scene.joint("knee", cd.Revolute("y"), crank.at(0.2, 0, 0), rod)
    scene.joint("guide", cd.Prismatic("x"), scene.ground.at(0, 0, 0.5), slider)
    scene.joint("wrist", cd.Revolute("y"), rod.at(0.5, 0, 0), slider)
    return scene


def test_pins_and_rails_stand_where_joints_of_the_tree_and_of_loops_are(tmp_path: Path) -> None:
    model = cd.compile(slider_crank())
    motion = model.simulate(1.0, q=model.assemble({"drive": 0.5}).q, u={"drive": 9.0})
    by_kind = {row["kind"]: row for row in supports(motion, tmp_path)}
    assert set(by_kind) == {"pin", "rail"}
    pin, rail = by_kind["pin"], by_kind["rail"]
    np.testing.assert_allclose(pin["at"], [0, 0, 0.5], atol=1e-6)
    np.testing.assert_allclose(np.abs(pin["axis"]), [0, 1, 0], atol=1e-12)
    # the rail holds every place of the slider, and no more
    places = motion.pose("slider")[:, :3, 3]
    along = (places - rail["at"]) @ rail["axis"]
    np.testing.assert_allclose(rail["travel"], [along.min(), along.max()], atol=2e-3)


def pendulum(joint: cd.Joint) -> tuple[cd.Scene, cd.Body]:
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("hold", joint, scene.ground, rod)
    return scene, rod


def test_shapes_of_the_user_on_the_ground_replace_supports(tmp_path: Path) -> None:
    scene, _ = pendulum(cd.Revolute("y"))
    assert len(supports(cd.compile(scene).simulate(0.1), tmp_path)) == 1
    wall = scene.body("wall", mass=1, inertia=(1, 1, 1), shape=cd.shape.box(0.1, 1, 1))
    scene.joint("built", cd.Fixed(), scene.ground, wall)
    assert supports(cd.compile(scene).simulate(0.1), tmp_path) == []


def test_joints_without_an_axis_get_none(tmp_path: Path) -> None:
    scene, _ = pendulum(cd.Spherical())
    assert supports(cd.compile(scene).simulate(0.1), tmp_path) == []


def test_ends_of_beams_on_the_ground_are_clamped(tmp_path: Path) -> None:
    scene = cd.Scene("beam", gravity=(0, 0, -9.81))
    tip = scene.body("tip", mass=0.1, inertia=(1e-4,) * 3, pose=(1, 0, 0))
    steel = cd.material(E=2e11, nu=0.3, rho=7800)
    scene.beam("beam", tip, scene.ground, cd.section.circle(0.02), steel, elements=2)
    (clamp,) = supports(cd.compile(scene).simulate(0.01), tmp_path)
    assert clamp["kind"] == "clamp"
    np.testing.assert_allclose(clamp["at"], [0, 0, 0], atol=1e-12)
    # out of the ground, along the beam
    np.testing.assert_allclose(clamp["axis"], [1, 0, 0], atol=1e-12)


def test_a_sweep_has_a_rail_that_holds_all_of_it(tmp_path: Path) -> None:
    scene = cd.Scene("cart", gravity=(0, 0, -9.81))
    cart = scene.body("cart", mass=1)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    motion = cd.compile(scene).simulate(2.0, q={"slide": -0.5}, u={"slide": 1.0})
    (rail,) = supports(motion, tmp_path)
    np.testing.assert_allclose(rail["travel"], [0, 2], atol=1e-6)


def test_a_body_that_touches_is_as_large_as_its_contact(tmp_path: Path) -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    ball = scene.body("ball", mass=2, inertia=(0.1, 0.1, 0.1))
    scene.joint("free", cd.Free(), scene.ground, ball)
    touch = cd.Contact(ball.at(0, 0, 0.1), scene.ground, radius=0.3, stiffness=1e4, damping=0.5)
    scene.force("floor", touch)
    data = data_of(cd.compile(scene).simulate(0.1).animate(tmp_path / "page.html").html)
    spheres = [s for s in data["bodies"][0]["solids"] if s["kind"] == "sphere"]
    assert [0.0, 0.0, 0.1] in [s["a"] for s in spheres if s["r"] == 0.3]


def test_what_flies_has_its_arms(tmp_path: Path) -> None:
    scene = cd.Scene("drone", gravity=(0, 0, -9.81))
    drone = scene.body("drone", mass=1, inertia=(0.1, 0.1, 0.1))
    scene.joint("fly", cd.Free(), scene.ground, drone)
    ends = [(0.2, 0.2, 0), (-0.2, 0.2, 0), (-0.2, -0.2, 0), (0.2, -0.2, 0)]
    for k, end in enumerate(ends):
        scene.force(f"lift{k}", cd.Force(drone.at(*end), (0, 0, 2), in_=drone))
    data = data_of(cd.compile(scene).simulate(0.1).animate(tmp_path / "page.html").html)
    links = [s["b"] for s in data["bodies"][0]["solids"] if s["kind"] == "link"]
    assert sorted(map(tuple, links)) == sorted(ends)


def test_a_rail_stays_under_a_carriage_with_a_shape(tmp_path: Path) -> None:
    scene = cd.Scene("cart", gravity=(0, 0, -9.81))
    cart = scene.body("cart", mass=1, shape=cd.shape.box(0.3, 0.2, 0.1))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("pin", cd.Revolute("y"), cart, rod)
    motion = cd.compile(scene).simulate(1.0, q={"pin": 1.0})
    assert [row["kind"] for row in supports(motion, tmp_path)] == ["rail"]


def test_no_post_goes_through_a_shape_that_turns(tmp_path: Path) -> None:
    scene = cd.Scene("wheel", gravity=(0, 0, -9.81))
    wheel = scene.body("wheel", mass=1, inertia=(1, 1, 1), shape=cd.shape.cylinder(0.3, 0.05))
    scene.joint("axle", cd.Revolute("y"), scene.ground, wheel)
    assert supports(cd.compile(scene).simulate(0.1, u={"axle": 1.0}), tmp_path) == []
