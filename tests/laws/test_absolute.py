"""Compiled models in absolute coordinates move as those of their joints do."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.interpreted import without_compiler
from cardan.errors import DerivationError
from cardan.runtime.models.finite_elements.elements import State
from cardan.runtime.models.finite_elements.mesh import Mesh
from laws.cases import derived, states
from mechanisms import ZOO

# these in every run, the others where there is time: every one compiles some kinds of elements
SHOWN = ("double_pendulum", "cart_pole", "universal", "cylindrical", "planar", "spatial_chain")
ROUNDING = 1e-11
STEP = 1e-6


def slowly() -> list[Any]:
    """The zoo, most of it marked slow."""
    return [n if n in SHOWN else pytest.param(n, marks=pytest.mark.slow) for n in ZOO]


@functools.cache
def both(name: str) -> tuple[cd.CompiledModel, cd.CompiledModel]:
    """A mechanism in absolute and in relative coordinates."""
    try:
        absolute = cd.compile(ZOO[name].build(), coordinates="absolute")
    except DerivationError as refused:
        pytest.skip(str(refused))
    return absolute, cd.compile(derived(name, "newton_euler"))


def carried(model: cd.CompiledModel, other: cd.CompiledModel, q: Any, u: Any) -> tuple[Any, Any]:
    """The state of the nodes where joints are at q and move with u."""
    given = {"t": np.zeros(1), "q": q, "u": u, "r": other._layout.start("r")}
    found = model._evaluate_saved("states", p=model.parameters.vector, **given)
    return found["q"], found["u"]


def mesh_of(model: cd.CompiledModel) -> Mesh:
    """Its elements."""
    return model._source.results(model).mesh  # type: ignore[attr-defined, no-any-return]


@pytest.mark.parametrize("name", slowly())
def test_accelerations(name: str) -> None:
    model, other = both(name)
    for q, u in list(zip(*states(name), strict=True))[:4]:
        nodes, speeds = carried(model, other, q, u)
        mine, theirs = model.forward_dynamics(nodes, speeds), other.forward_dynamics(q, u)
        size = 1 + np.abs(theirs).max(initial=0)
        for k, speed in enumerate(other.speeds):
            assert abs(mine[model.speeds.index(speed)] - theirs[k]) < 100 * ROUNDING * size


@pytest.mark.parametrize("name", SHOWN)
def test_energy_momentum_and_frames(name: str) -> None:
    model, other = both(name)
    q, u = (block[-1] for block in states(name))
    nodes, speeds = carried(model, other, q, u)
    mine, theirs = model.energy(nodes, speeds), other.energy(q, u)
    size = 1 + abs(theirs.kinetic) + abs(theirs.potential)
    assert abs(mine.kinetic - theirs.kinetic) < ROUNDING * size
    np.testing.assert_allclose(model.momentum(nodes, speeds), other.momentum(q, u), atol=1e-11)
    for frame in other.frames:
        np.testing.assert_allclose(model.pose(frame, nodes), other.pose(frame, q), atol=1e-13)
        at = model.velocity(frame, nodes, speeds), other.velocity(frame, q, u)
        np.testing.assert_allclose(*at, atol=1e-12)


@pytest.mark.parametrize("name", SHOWN)
def test_tangents_are_derivatives(name: str) -> None:
    model, other = both(name)
    mesh, rng = mesh_of(model), np.random.default_rng(3)
    nodes, speeds = carried(model, other, *(block[-1] for block in states(name)))
    udot, lam = rng.normal(size=model.nu), rng.normal(size=model.nlam)
    rest = {"udot": udot, "lam": lam}
    moved = {
        "K": lambda d: State(q=mesh.move(nodes, d), u=speeds, **rest),
        "C": lambda d: State(q=nodes, u=speeds + d, **rest),
        "M": lambda d: State(q=nodes, u=speeds, udot=udot + d, lam=lam),
    }
    tangent = mesh.tangent(State(q=nodes, u=speeds, **rest))
    for part, at in moved.items():
        sides = [[mesh.balance(at(s * STEP * e))[0] for s in (1, -1)] for e in np.eye(model.nu)]
        slope = np.array([(a - b) / (2 * STEP) for a, b in sides]).T
        exact = tangent[part].toarray()
        np.testing.assert_allclose(exact, slope, atol=1e-7 * (1 + np.abs(exact).max()))
    G = tangent["G"].toarray()
    sides = [[mesh.balance(moved["K"](s * STEP * e))[1] for s in (1, -1)] for e in np.eye(model.nu)]
    slope = np.array([(a - b) / (2 * STEP) for a, b in sides]).T
    np.testing.assert_allclose(G[: len(slope)], slope, atol=1e-7 * (1 + np.abs(G).max()))


def test_one_motion_by_extrapolation() -> None:
    """Two steps of order 2 and their difference say where the motion ends."""
    model, other = both("double_pendulum")
    start = dict(zip(other.coordinates, (1.0, 0.4), strict=True))
    exact = other.simulate(1.0, q=start, rtol=1e-12, atol=1e-12)
    method = cd.GeneralizedAlpha(0.8)
    ends = []
    for step in (2e-3, 1e-3, 5e-4):
        motion = model.simulate(1.0, q=start, method=method, step=step)
        ends.append(np.array([motion[name][-1] for name in other.coordinates]))
    coarse, fine, finest = ends
    order = np.log2(np.abs(coarse - fine) / np.abs(fine - finest))
    np.testing.assert_allclose(order, 2.0, atol=0.15)
    np.testing.assert_allclose(finest + (finest - fine) / 3, exact.q[-1], atol=2e-8)


def test_explicit_methods_go_too() -> None:
    model, other = both("double_pendulum")
    start = dict(zip(other.coordinates, (1.0, 0.4), strict=True))
    exact = other.simulate(1.0, q=start, rtol=1e-12, atol=1e-12)
    motion = model.simulate(1.0, q=start, method="DOP853", rtol=1e-9, atol=1e-11)
    for name in other.coordinates:
        assert abs(motion[name][-1] - exact[name][-1]) < 1e-7


def arm(elements: int) -> cd.Scene:
    """A rubber arm with a ball at its tip."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.45, rho=1100)
    section = cd.section.circle(radius=0.01)
    beam = scene.beam(
        "arm", scene.ground, (1, 0, 0), section=section, material=rubber, elements=elements
    )
    ball = scene.body("ball", mass=0.01, inertia=cd.inertia.sphere(0.01, 0.02))
    scene.joint("hinge", cd.Revolute("y"), beam.end, ball.at(-0.05, 0, 0))
    return scene


def disturbed(model: cd.CompiledModel) -> State:
    """A state beside the reference configuration."""
    mesh, rng = mesh_of(model), np.random.default_rng(5)
    q = mesh.move(model.initial()[: model.nq], 0.01 * rng.normal(size=model.nu))
    u, udot, lam = (rng.normal(size=n) for n in (model.nu, model.nu, model.nlam))
    return State(q=q, u=u, udot=udot, lam=lam)


def test_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    model = cd.compile(arm(3))
    at = disturbed(model)
    known, motion = results(model, at), model.simulate(0.01)
    bare = without_compiler(model, monkeypatch)
    assert mesh_of(bare).interpreted
    found = results(bare, at)
    rest = bare.equilibrium(locked={"hinge": 0.0})
    for name, value in known.items():
        size = 1 + np.abs(value).max(initial=0)
        np.testing.assert_allclose(found[name], value, rtol=0, atol=1e-9 * size, err_msg=name)
    assert rest.converged
    np.testing.assert_allclose(bare.simulate(0.01).x[-1], motion.x[-1], rtol=0, atol=1e-9)


def results(model: cd.CompiledModel, at: State) -> dict[str, Any]:
    """What elements give in every way."""
    mesh, du = mesh_of(model), 0.1 * np.arange(1, model.nu + 1) / model.nu
    tangent = mesh.tangent(at)
    return {
        "balance": np.concatenate(mesh.balance(at)),
        "gamma": mesh.gamma(at),
        "energy": mesh.total("energy", 2, at),
        "moved": mesh.move(at.q, du),
        "rates": mesh.rates(at.q, du),
        "udot": np.concatenate(mesh.accelerations(at)),
        "position": mesh.call("close_position", at, model.nq + model.nlam),
        "velocity": mesh.call("close_velocity", at, model.nu + model.nlam),
        "stress": mesh.settled(at),
        **{name: matrix.toarray() for name, matrix in tangent.items()},
    }


@pytest.mark.parametrize("lanes", ["2", "4", "8"])
def test_elements_side_by_side_give_the_bits_of_single_ones(
    lanes: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = []
    for width in ("1", lanes):
        monkeypatch.setenv("CARDAN_LANES", width)
        model = cd.load_model(cd.compile(arm(19)).directory)
        mesh, at = mesh_of(model), disturbed(model)
        found.append([mesh.results(form, at) for form in ("balance", "balance_tangent", "energy")])
        assert max(form.lanes for group in mesh._groups for form in group.forms) == int(width)
    for one, several in zip(*found, strict=True):
        for a, b in zip(one, several, strict=True):
            np.testing.assert_array_equal(a, b)
