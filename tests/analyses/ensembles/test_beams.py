"""Runs of a closed mechanism with a beam start and go as ``simulate`` makes them one by one."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import cardan as cd

END = 2e-3


@pytest.fixture(scope="module")
def crank() -> cd.CompiledModel:
    """A crank that is driven, a rod that bends, a slider."""
    scene = cd.Scene("crank", gravity=(0, 0, -9.81))
    speed = scene.parameter("speed", 20.0)
    arm = scene.body("arm", mass=0.5, com=(0.075, 0, 0), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("drive", cd.Revolute("y"), scene.ground, arm, prescribed=speed * cd.t)
    slider = scene.body("slider", mass=0.3)
    scene.joint("guide", cd.Prismatic("x"), scene.ground.at(0.45, 0, 0), slider)
    steel = cd.material(E=2.1e11, nu=0.3, rho=7850, damping=1e-5)
    square, free = cd.section.rectangle(width=0.006, height=0.006), ("ry",)
    beam = scene.beam(
        "rod", arm.at(0.15, 0, 0), slider, square, steel, elements=2,
        release_start=free, release_end=free,
    )  # fmt: skip
    scene.output("middle", beam.at(0.5).position()[2])
    return cd.compile(scene)


def test_every_run_has_the_bits_of_simulate(crank: cd.CompiledModel) -> None:
    speeds = [20.0, 10.0]
    found = crank.ensemble(END, vary={"speed": speeds})
    for k, speed in enumerate(speeds):
        alone = crank.with_parameters(speed=speed).simulate(END)
        np.testing.assert_array_equal(found.run(k).x, alone.x)
    assert len({found.run(k).x[0].tobytes() for k in range(2)}) == 2  # speeds differ at the start


def test_one_state_starts_all_runs(crank: cd.CompiledModel) -> None:
    alone = crank.simulate(END)
    found = crank.ensemble(END, x0=alone.x[0], runs=2)
    for k in range(2):
        np.testing.assert_allclose(found.run(k).x[-1], alone.x[-1], atol=1e-7, rtol=1e-6)


def test_a_pickled_motion_is_the_same(crank: cd.CompiledModel) -> None:
    motion = crank.simulate(END)
    back = pickle.loads(pickle.dumps(motion))
    np.testing.assert_array_equal(back.x, motion.x)
    np.testing.assert_array_equal(back["middle"], motion["middle"])


def test_parameters_of_one_call(crank: cd.CompiledModel) -> None:
    q, u = crank.split(crank.initial())
    slides = list(crank.speeds).index("guide.u")
    u[slides] = 2.0
    heavy, light = crank.energy(q, u, parameters={"slider.mass": 3.0}), crank.energy(q, u)
    assert heavy.kinetic - light.kinetic == pytest.approx(0.5 * 2.7 * 2.0**2, rel=1e-12)
    with pytest.raises(cd.ArgumentError, match="one set after the other"):
        crank.energy(q, u, parameters={"slider.mass": [1.0, 2.0]})
