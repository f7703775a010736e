"""Motions without mass or inertia: refused by name, with a compiler and without."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import cardan as cd
from cardan.runtime.build import toolchain

pytestmark = pytest.mark.usefixtures("cache_directory")

GENERAL = {"EA": 1e4, "GA": 1e4, "GJ": 10.0, "EI": 10.0}


def point() -> cd.Scene:
    """A point mass on a ball joint: nothing resists its turn about the line between them."""
    scene = cd.Scene("point")
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1))
    scene.joint("ball", cd.Spherical(), scene.ground, bob)
    return scene


def free_point() -> cd.Scene:
    scene = cd.Scene("free_point")
    scene.joint("float", cd.Free(), scene.ground, scene.body("bob", mass=1.0))
    return scene


def arm() -> cd.Scene:
    """An arm without mass, beside one that has some."""
    scene = cd.Scene("arm")
    heavy = scene.body("heavy", mass=2.0, inertia=(1, 1, 1))
    scene.joint("one", cd.Revolute("y"), scene.ground, heavy)
    scene.joint("two", cd.Revolute("y"), heavy, scene.body("light", mass=0.0))
    return scene


def beam(**inertia: float) -> Callable[[], cd.Scene]:
    def build() -> cd.Scene:
        scene = cd.Scene("beam")
        section = cd.section.general(**GENERAL, **inertia)
        scene.beam("rod", scene.ground, (1, 0, 0), section, elements=3)
        return scene

    return build


SINGULAR = {
    "'bob'": point,
    "'bob' can": free_point,
    "'two'": arm,
    "'rod.1'": beam(rhoA=0),
    "'rod.1', 'rod.2'": beam(rhoA=1, rhoI=0),
}


def doubled() -> cd.Scene:
    """Two ball joints between the same points of two bodies, one of them light: rows too many."""
    scene = cd.Scene("doubled", gravity=(-9.81, 0, 0))
    near = scene.body("near", mass=1.0, com=(0, 0, -1), inertia=(1, 1, 1))
    far = scene.body("far", mass=1e-6, com=(0, 0, -1), inertia=(1e-9, 1e-9, 1e-9))
    scene.joint("hang", cd.Revolute("y"), scene.ground, near)
    scene.joint("knee", cd.Revolute("y"), near.at(0, 0, -1), far)
    scene.joint("twice", cd.Revolute("y"), near.at(0, 1, -1), far.at(0, 1, 0))
    return scene


@pytest.fixture(params=["compiled", "plain"])
def compiler(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    if request.param == "plain":
        monkeypatch.setenv("PATH", "/nonexistent")
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setattr(toolchain, "ziglang", lambda: [])
        monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    return str(request.param)


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
@pytest.mark.parametrize("named", SINGULAR)
def test_what_moves_without_mass_is_named(named: str, compiler: str) -> None:
    model = cd.compile(SINGULAR[named](), coordinates="absolute")
    q, u = model.split(model.initial())
    with pytest.raises(cd.SolveError, match=f"M is singular: .*{named}.* Give that body a mass"):
        model.forward_dynamics(q, u)


@pytest.mark.parametrize("method", ["alpha", "DOP853"])
def test_runs_do_not_begin(method: str) -> None:
    model = cd.compile(point(), coordinates="absolute")
    chosen = cd.GeneralizedAlpha() if method == "alpha" else method
    with pytest.warns(cd.SolveWarning, match=r"M is singular: .*'bob'"):
        motion = model.simulate(0.1, method=chosen)
    assert motion.status == "model_failed"


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
def test_redundant_rows_and_light_bodies_are_no_such_motions(compiler: str) -> None:
    scene = doubled()
    model = cd.compile(scene, coordinates="absolute")
    found = model.forward_dynamics(*model.split(model.initial()))
    # a pendulum of 2 kg m^2 and 1 kg m, up to the mass of the light body
    assert found[model.speeds.index("hang.u")] == pytest.approx(9.81 / 2, rel=1e-4)
