"""Friction that follows from reactions, over elements as over joints."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from contextlib import nullcontext

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.finite_elements.elements import State
from faults.test_verify import braked
from laws.test_absolute import STEP, carried, mesh_of
from laws.test_happening import inclined
from spread import some

G = 9.81
FINE = {"rtol": 1e-10, "atol": 1e-12}


def slider_crank(smooth: float | None = None) -> cd.Scene:
    """A crank, a rod and a slider; friction in the slider and in a bearing."""
    scene = cd.Scene("slider crank", gravity=(0, 0, -G))
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=(1e-3, 4e-3, 4e-3))
    rod = scene.body("rod", mass=0.8, com=(0.25, 0, 0), inertia=(1e-3, 2e-2, 2e-2))
    slider = scene.body("slider", mass=0.5, com=(0.02, 0, 0.01), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("drive", cd.Revolute("y"), scene.ground, crank)
    scene.joint("big", cd.Revolute("y"), crank.at(0.2, 0, 0), rod)
    scene.joint("small", cd.Revolute("y"), rod.at(0.5, 0, 0), slider)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, slider)
    scene.force("rub", cd.Friction("slide", mu=0.2, smooth=smooth))
    scene.force("bearing", cd.Friction("big", mu=0.3, radius=0.02, smooth=smooth))
    scene.force("motor", cd.JointForce("drive", 1.5))
    return scene


def flexible_slider_crank(smooth: float | None = None) -> cd.Scene:
    """The same with a rod that bends, and friction in the slider."""
    scene = cd.Scene("flexible slider crank", gravity=(0, 0, -G))
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=(1e-3, 4e-3, 4e-3))
    slider = scene.body("slider", mass=0.5, com=(0.02, 0, 0.01), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("drive", cd.Revolute("y"), scene.ground, crank)
    scene.joint("slide", cd.Prismatic("x"), scene.ground.at(0.7, 0, 0), slider)
    material = cd.material(E=2e9, nu=0.3, rho=2700, damping=1e-4)
    ends = {"release_start": "ry", "release_end": "ry"}
    start, section = crank.at(0.2, 0, 0), cd.section.circle(0.02)
    scene.beam("rod", start, slider, section, material, elements=2, **ends)
    scene.force("rub", cd.Friction("slide", mu=0.2, smooth=smooth))
    scene.force("motor", cd.JointForce("drive", 1.5))
    return scene


SCENES: dict[str, Callable[[], cd.Scene]] = {
    "inclined": lambda: inclined("rough", True),
    "braked": braked,
}


@functools.cache
def both(name: str) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """A scene in absolute coordinates and in those of its joints."""
    build = SCENES[name]
    return cd.compile(build(), coordinates="absolute"), cd.compile(build())


@pytest.mark.parametrize("seed", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in (1, 2))])
@pytest.mark.parametrize("name", some(SCENES, 2))
def test_one_law_in_both_coordinates(name: str, seed: int) -> None:
    """Accelerations, reactions, forces, powers, events and what is behind them."""
    model, other = both(name)
    rng = np.random.default_rng(seed)
    q, u = rng.uniform(-1, 1, (2, other.nq))
    nodes, speeds = carried(model, other, q, u)
    places = [model.speeds.index(speed) for speed in other.speeds]
    for s in (np.sign(u), np.zeros(2), np.array([2.0, 1.0])):
        # what sticks does not move
        moving = np.where(s == 2, 0.0, u)
        nodes, speeds = carried(model, other, q, moving)
        mine, theirs = (
            m.rhs(0.0, np.r_[x, v], s=s)[m.nq :]
            for m, x, v in ((model, nodes, speeds), (other, q, moving))
        )
        assert mine[places] == pytest.approx(theirs, rel=1e-10, abs=1e-10)
        values = [m.events(x, v, s=s) for m, x, v in ((model, nodes, speeds), (other, q, moving))]
        assert values[0] == pytest.approx(values[1], rel=1e-9, abs=1e-9)
        # coming to rest is not an event of what sticks
        for e in np.eye(len(values[0]))[1 if s[0] == 2 else 0 :]:
            behind = [
                m.transition(x, v, e, s=s)[m.nu :]
                for m, x, v in ((model, nodes, speeds), (other, q, moving))
            ]
            assert behind[0] == pytest.approx(behind[1])
    for joint in other.joints:
        mine, theirs = model.reaction(joint, nodes, speeds), other.reaction(joint, q, moving)
        assert mine == pytest.approx(theirs, rel=1e-9, abs=1e-9)
    assert model.element_forces(nodes, speeds) == pytest.approx(
        other.element_forces(q, moving), rel=1e-9, abs=1e-9
    )
    assert model.power(nodes, speeds).sum() == pytest.approx(other.power(q, moving).sum())


def test_tangents_are_derivatives() -> None:
    """K, C and what multipliers do, friction included, against differences."""
    model, other = both("braked")
    mesh, rng = mesh_of(model), np.random.default_rng(3)
    nodes, speeds = carried(model, other, *rng.uniform(-1, 1, (2, other.nq)))
    lam, s = rng.normal(size=model.nlam), np.array([1.0, -1.0])
    tangent = mesh.tangent(State(q=nodes, u=speeds, lam=lam, s=s))

    def slope(n: int, at: Callable[[np.ndarray], State]) -> np.ndarray:
        sides = [[mesh.balance(at(k * STEP * e))[0] for k in (1, -1)] for e in np.eye(n)]
        return np.array([(a - b) / (2 * STEP) for a, b in sides]).T

    K = slope(model.nu, lambda d: State(q=mesh.move(nodes, d), u=speeds, lam=lam, s=s))
    C = slope(model.nu, lambda d: State(q=nodes, u=speeds + d, lam=lam, s=s))
    L = -slope(model.nlam, lambda d: State(q=nodes, u=speeds, lam=lam + d, s=s)).T
    for name, expected in (("K", K), ("C", C)):
        assert tangent[name].toarray() == pytest.approx(expected, abs=1e-6)
    assert tangent["L"].toarray() == pytest.approx(L, abs=1e-7)
    # friction is more than what the rows hold with
    assert np.abs(L - tangent["G"].toarray()).max() > 0.01


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_block_on_an_incline(coordinates: str) -> None:
    """Up, to rest and down again by hand: a = g (sin + mu cos), then g (sin - mu cos)."""
    angle, mu, v = 0.5, 0.3, 2.0
    scene = cd.Scene("incline", gravity=(-G * math.sin(angle), 0, -G * math.cos(angle)))
    block = scene.body("block", mass=2.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, block)
    scene.force("rub", cd.Friction("slide", mu=mu))
    model = cd.compile(scene, coordinates=coordinates)
    up, down = (G * (math.sin(angle) + k * mu * math.cos(angle)) for k in (1, -1))
    for options in (FINE, {"method": "GeneralizedAlpha", "step": 1e-2}):
        if coordinates == "relative" and "step" in options:
            continue
        motion = model.simulate(1.0, u={"slide": v}, **options)
        (turn,) = motion.events
        assert turn.t == pytest.approx(v / up, abs=1e-9)
        end = v**2 / (2 * up) - down * (1 - v / up) ** 2 / 2
        # steps of the second order are exact at constant accelerations, but for where they end
        assert motion["slide"][-1] == pytest.approx(end, abs=1e-8)


@pytest.mark.parametrize("smooth", [None, pytest.param(1e-2, marks=pytest.mark.slow)])
def test_slider_crank(smooth: float | None) -> None:
    """A closed loop with two frictions, with stick and slip and without."""
    ends, times = [], []
    for coordinates in ("relative", "absolute"):
        with pytest.warns(cd.SolveWarning) if coordinates == "relative" else nullcontext():
            model = cd.compile(slider_crank(smooth), coordinates=coordinates)
        start = {"q": {"drive": 0.3}, "u": {"drive": 3.0}}
        motion = model.simulate(0.6, method="DOP853", **start, **FINE)
        ends.append([motion[name][-1] for name in ("drive", "slide", "drive.u")])
        times.append([event.t for event in motion.events])
    assert ends[0] == pytest.approx(ends[1], rel=1e-7)
    assert times[0] == pytest.approx(times[1], abs=1e-7)
    assert len(times[0]) == (2 if smooth is None else 0)
    # the same motion by an implicit method, in which friction follows from its own multipliers
    steps = [
        model.simulate(0.6, method="GeneralizedAlpha", step=h, **start)["drive"][-1]
        for h in (2e-3, 1e-3)
    ]
    assert steps[1] == pytest.approx(ends[1][0], abs=1e-3)
    assert (steps[0] - ends[1][0]) / (steps[1] - ends[1][0]) == pytest.approx(4, abs=0.4)


def test_flexible_slider_crank() -> None:
    """Steps of two methods against an explicit one without any matrix of friction."""
    model, start = cd.compile(flexible_slider_crank(0.05)), {"q": {"drive": 0.2}}
    ends = [
        m.simulate(0.15, method="DOP853", rtol=1e-9, atol=1e-11, **start)["drive"][-1]
        for m in (model, cd.compile(_frictionless()))
    ]
    assert abs(ends[1] - ends[0]) > 1e-2
    for method in ("GeneralizedAlpha", "HHT"):
        motion = model.simulate(0.15, method=method, step=1e-4, **start)
        assert motion["drive"][-1] == pytest.approx(ends[0], abs=1e-6)
    motion = model.simulate(0.15, method="Radau", rtol=1e-7, **start)
    assert motion["drive"][-1] == pytest.approx(ends[0], abs=1e-6)


@pytest.mark.slow
def test_flexible_slider_crank_sticks_and_slips() -> None:
    """Its slider starts at rest, and comes to rest at the end of its stroke."""
    model, start = cd.compile(flexible_slider_crank()), {"q": {"drive": 0.2}}
    exact = model.simulate(0.5, method="DOP853", rtol=1e-8, atol=1e-10, **start)
    motion = model.simulate(0.5, method="GeneralizedAlpha", step=1e-4, **start)
    assert [event.name for event in motion.events] == ["rub.slip", "rub.stop"]
    for mine, other in zip(motion.events, exact.events, strict=True):
        assert mine.name == other.name
        assert mine.t == pytest.approx(other.t, abs=1e-6)
    assert motion["drive"][-1] == pytest.approx(exact["drive"][-1], rel=1e-6)
    # what friction takes is what its force takes
    power = np.trapezoid(motion["rub.force"] * motion["slide.u"], motion.t)
    assert power == pytest.approx(
        motion.work_done[-1, list(motion.manifest.elements.power_sources).index("rub")], rel=1e-3
    )


def test_in_a_plane() -> None:
    """The same motion with nodes of three coordinates."""
    start, ends = {"q": {"drive": 0.2}}, []
    for plane in (None, "y"):
        model = cd.compile(flexible_slider_crank(), plane=plane)
        motion = model.simulate(0.5, method="GeneralizedAlpha", step=1e-3, **start)
        ends.append([motion["drive"][-1], motion["rub.force"][-1], *(e.t for e in motion.events)])
    assert ends[0] == pytest.approx(ends[1], rel=1e-6)


def _frictionless() -> cd.Scene:
    scene = flexible_slider_crank(0.05)
    del scene.forces["rub"]
    return scene


def test_a_run_over_elements_ends_where_it_jams() -> None:
    """The heavy rod on a light cart of the test in joint coordinates, at the same instant."""
    ends = []
    for coordinates in ("relative", "absolute"):
        scene = cd.Scene("wedge", gravity=(0, 0, -G))
        cart = scene.body("cart", mass=0.1)
        rod = scene.body("rod", mass=10.0, com=(0, 0, 1.0), inertia=(0.1, 0.1, 0.01))
        scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
        scene.joint("h", cd.Revolute("y"), cart, rod)
        scene.force("rail", cd.Friction("x", mu=0.9))
        model = cd.compile(scene, coordinates=coordinates)
        motion = model.simulate(
            5.0, q={"h": 1.2}, u={"x": 50.0, "h": -4.0}, method="DOP853", **FINE
        )
        assert motion.events[-1].name == "rail.jam"
        ends.append(motion.t[-1])
    assert ends[0] == pytest.approx(ends[1], abs=1e-8)


def test_every_function_is_verified() -> None:
    for name in SCENES:
        verification = both(name)[0].verify()
        assert verification.unchecked == ()
