"""Instantaneous screw axes against what one sees."""

from __future__ import annotations

import numpy as np

import cardan as cd


def test_a_screw_turns_about_its_axis() -> None:
    scene = cd.Scene("bolt")
    bolt = scene.body("bolt", mass=1, inertia=(0.1, 0.1, 0.1))
    joint = cd.Screw((0, 3, 4), pitch=0.02)
    scene.joint("thread", joint, scene.ground.at(0.5, 0, 0), bolt.at(0, 0.3, 0))
    model = cd.compile(scene)
    q, u = model.split(model.initial({"thread": 0.7}, {"thread": 2.0}))
    axis = model.screw_axis("bolt", q, u)
    line = np.array([0, 0.6, 0.8])
    assert np.allclose(axis.direction, line, atol=1e-14)
    assert np.isclose(axis.rate, 2.0)
    # the point lies on the line of the joint
    assert np.allclose(np.cross(axis.point - [0.5, 0, 0], line), 0, atol=1e-14)
    # advance along the thread, measured along a run
    motion = model.simulate((0, 1e-4), q={"thread": 0.7}, u={"thread": 2.0})
    moved = motion.pose("bolt")[-1, :3, 3] - motion.pose("bolt")[0, :3, 3]
    turned = motion["thread"][-1] - motion["thread"][0]
    assert np.isclose(axis.pitch, moved @ line / turned, rtol=1e-6)


def test_the_pole_of_a_coupler_is_where_the_cranks_cross() -> None:
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    lengths = {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}
    crank, coupler, rocker = (
        scene.body(name, mass=1, com=(size / 2, 0, 0), inertia=(0.01, 0.01, 0.01))
        for name, size in lengths.items()
    )
    pin = cd.Revolute("z")
    scene.joint("A", pin, scene.ground, crank)
    scene.joint("B", pin, crank.at(0.1, 0, 0), coupler)
    scene.joint("D", pin, scene.ground.at(0.3, 0, 0), rocker)
    scene.joint("C", pin, coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0), cut=True)
    model = cd.compile(scene)
    motion = model.simulate(0.3, q={"A": 1.0}, u={"A": 5.0})
    axes = motion.screw_axis("coupler")
    assert np.allclose(np.abs(axes.direction[:, 2]), 1)
    assert np.allclose(axes.slide, 0, atol=1e-12)
    # both cranks point to the pole
    for name, foot in (("crank", 0.0), ("rocker", 0.3)):
        pose = motion.pose(name)
        along = pose[:, :2, 0]
        arm = axes.point[:, :2] - [foot, 0.0]
        crossed = along[:, 0] * arm[:, 1] - along[:, 1] * arm[:, 0]
        assert np.allclose(crossed, 0, atol=1e-6 * (1 + np.abs(arm).max()))


def test_parallel_motion_and_rest() -> None:
    scene = cd.Scene("sled")
    sled = scene.body("sled", mass=1)
    scene.joint("slide", cd.Translation(), scene.ground, sled)
    model = cd.compile(scene)
    moving = model.screw_axis("sled", np.zeros(3), np.array([0, 3.0, 4.0]))
    assert (moving.rate, moving.slide) == (0, 5)
    assert np.isnan(moving.point).all()
    assert np.isinf(moving.pitch)
    assert np.allclose(moving.direction, (0, 0.6, 0.8))
    still = model.screw_axis("sled", np.zeros((2, 3)), np.zeros((2, 3)))
    assert not still.direction.any()
    assert np.isnan(still.pitch).all()


def test_the_axis_goes_along_with_what_is_prescribed() -> None:
    scene = cd.Scene("trolley", gravity=(0, 0, 0))
    trolley, wheel = (scene.body(name, mass=1, inertia=(1, 1, 1)) for name in ("trolley", "wheel"))
    pull = scene.input("pull")
    scene.joint("rail", cd.Prismatic("x"), scene.ground, trolley, prescribed=2 * cd.t)
    scene.joint(
        "lift", cd.Prismatic("y"), trolley, post := scene.body("post", mass=1), prescribed=pull
    )
    scene.joint("axle", cd.Revolute("z"), post, wheel)
    model = cd.compile(scene)
    times = np.array([0.0, 0.5, 1.0])
    motion = model.simulate(
        1.0, t_eval=times, u={"axle": 4.0}, inputs={"pull": (np.arange(5.0), 3 * np.arange(5.0))}
    )
    axes = motion.screw_axis("wheel")
    # a wheel at (2 t, 3 t) that moves with (2, 3) and turns by 4: it rests beside its center
    expected = np.stack([2 * times - 3 / 4, 3 * times + 2 / 4, 0 * times], axis=-1)
    assert np.allclose(axes.point, expected, atol=1e-7)
