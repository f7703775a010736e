"""The generalized-alpha method on elements in tables: orders, conditions, step control, loads."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_alpha import Exact, slope, spinning, top

Array = np.ndarray
INDICES = pytest.mark.parametrize("index", [2, 3])
RUBBER = cd.material(E=5e5, nu=0.5, rho=1100)


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    return top("heavy_top_meshed", coordinates="absolute")


@pytest.fixture(scope="module")
def exact(model: cd.CompiledModel) -> Exact:
    return Exact(model, np.linspace(0, 0.2, 41))


@INDICES
def test_order_of_every_variable(model: cd.CompiledModel, exact: Exact, index: int) -> None:
    method, counts = cd.GeneralizedAlpha(0.8, index=index), np.array([400, 800, 1600])
    since = 8 if index == 3 else 0
    errors = [exact.errors(model, since, method=method, step=0.2 / n) for n in counts]
    for name, column in zip(("q", "u", "multipliers"), np.transpose(errors), strict=True):
        print(f"index {index}: {name} of order {slope(counts, column):.3f}")
        assert slope(counts, column) == pytest.approx(2, abs=0.15)


@pytest.mark.parametrize(("index", "order"), [(2, 2), (3, 1)])
def test_multipliers_of_the_first_steps(model: cd.CompiledModel, index: int, order: int) -> None:
    counts, errors = np.array([400, 800, 1600, 3200]), []
    for n in counts:
        exact = Exact(model, np.arange(6) * 0.2 / n)
        method = cd.GeneralizedAlpha(0.8, index=index)
        errors.append(exact.errors(model, method=method, step=0.2 / n)[2])
    print(f"index {index}: multipliers of the first steps are of order {slope(counts, errors):.3f}")
    assert slope(counts, errors) == pytest.approx(order, abs=0.15)


def test_condition_does_not_depend_on_the_step(model: cd.CompiledModel) -> None:
    """Unknowns and rows in units: those of mesh_solve.c."""
    from cardan.runtime.models.finite_elements.mesh import State

    start = spinning(model)
    mesh = model._source.results(model).mesh
    parts = mesh.tangent(State(start[: model.nq], u=start[model.nq :]))
    K, C, M, G = (parts[name].toarray() for name in "KCMG")
    alpha = cd.stability.Alpha.chung_hulbert(0.8)
    part, conditions = (1 - alpha.af) / (1 - alpha.am), {}
    for h in 10.0 ** -np.arange(2, 7):
        S = M + h * alpha.gamma * part * C + h * h * alpha.beta * part * K
        least = np.abs(np.diag(S)).min()
        units = np.concatenate([1 / np.sqrt(np.diag(S)), np.full(len(G), np.sqrt(least))])
        matrix = np.block([[S, G.T], [G, np.zeros((len(G), len(G)))]])
        conditions[h] = np.linalg.cond(units[:, None] * matrix * units)
    print(", ".join(f"{h:.0e}: {c:.3g}" for h, c in conditions.items()))
    assert max(conditions.values()) < 1000
    small = [c for h, c in conditions.items() if h <= 1e-4]
    assert max(small) < 1.05 * min(small)


def test_damping_is_capped(model: cd.CompiledModel) -> None:
    method = cd.GeneralizedAlpha(rho_inf=1.0)
    motion = model.simulate(0.1, x0=spinning(model), method=method, step=1e-3)
    assert motion.success
    assert "rho_inf 0.95" in str(motion)


# step control


def pendulum() -> cd.Scene:
    """Two rods of 1 m in a plane."""
    scene = cd.Scene("rods_meshed", gravity=(0, 0, -9.81))
    push = scene.input("push")
    rod = cd.inertia.rod(1, 1, axis="z")
    a = scene.body("a", mass=1, com=(0, 0, -0.5), inertia=rod)
    b = scene.body("b", mass=1, com=(0, 0, -0.5), inertia=rod)
    scene.joint("upper", cd.Revolute("y"), scene.ground, a)
    scene.joint("lower", cd.Revolute("y"), a.at(0, 0, -1), b)
    scene.force("kick", cd.Force(b.at(0, 0, -1), (push, 0, 0)))
    return scene


def rubber() -> cd.Scene:
    """A rod of rubber let go from the side, of which every oscillation is resolved."""
    scene = cd.Scene("rubber_meshed", gravity=(0, 0, -9.81))
    tube = cd.section.tube(0.1, 0.02)
    rod = scene.beam("rod", (0, 0, 0), (1, 0, 0), tube, RUBBER, elements=2)
    scene.joint("pin", cd.Revolute("y"), scene.ground, rod.start)
    return scene


BENT = {"q": {"upper": 1.0, "lower": 0.5}}


@cache
def problem(name: str) -> tuple[cd.CompiledModel, dict[str, Any], float]:
    """A model, its start and a time."""
    if name == "double pendulum":
        return cd.compile(pendulum(), coordinates="absolute"), dict(BENT), 2.0
    if name == "rubber":
        return cd.compile(rubber()), {}, 0.5
    found = top("heavy_top_meshed", coordinates="absolute")
    return found, {"x0": spinning(found)}, 0.1


@INDICES
@pytest.mark.parametrize("name", ["double pendulum", "heavy top", "rubber"])
def test_error_follows_the_tolerance(name: str, index: int) -> None:
    """Global error ~ tolerance^(2/3) over four decades, few rejected steps, matrices kept."""
    model, start, end = problem(name)
    exact = model.simulate([0, end], **start, rtol=1e-12, atol=1e-13, method="DOP853").q[-1]
    tolerances, errors, rejected, steps = 10.0 ** -np.arange(5, 10), [], 0, 0
    for tolerance in tolerances:
        method = cd.GeneralizedAlpha(0.8, index=index)
        options = {"rtol": tolerance, "atol": 1e-3 * tolerance}
        motion = model.simulate([0, end], **start, method=method, **options)
        errors.append(np.abs(motion.q[-1] - exact).max())
        told = motion.statistics
        rejected, steps = rejected + told["rejections"], steps + told["steps"]
        if tolerance <= 1e-7:
            assert told["factorizations"] <= 0.5 * told["steps"]
    found = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    print(f"{name}, index {index}: tolerance^{found:.3f}, {rejected} of {steps} rejected, {errors}")
    assert found == pytest.approx(2 / 3, abs=0.12)
    assert rejected <= 0.02 * steps


# loads


@INDICES
@pytest.mark.parametrize("kick", [0.0, 50.0], ids=["free", "impulsive"])
def test_double_pendulum(kick: float, index: int) -> None:
    """With a blow of 10 ms in the middle of the motion, against relative coordinates."""
    model = problem("double pendulum")[0]
    given = {"push": ([0, 0.5, 0.5, 0.51, 0.51, 1], [0, 0, kick, kick, 0, 0])}
    exact = cd.compile(pendulum()).simulate([0, 1.0], **BENT, inputs=given, rtol=1e-12, atol=1e-13)
    known = np.array([exact["upper"][-1], exact["lower"][-1]])
    counts, errors = np.array([200, 400, 800]), []
    for n in counts:
        method = cd.GeneralizedAlpha(0.8, index=index)
        motion = model.simulate([0, 1.0], **BENT, inputs=given, method=method, step=1.0 / n)
        found = np.array([motion["upper"][-1], motion["lower"][-1]])
        errors.append(np.abs(found - known).max())
    print(f"kick {kick} N, index {index}: {errors}, order {slope(counts, errors):.3f}")
    assert slope(counts, errors) == pytest.approx(2, abs=0.15)


@INDICES
def test_energy_of_a_damped_pendulum(index: int) -> None:
    """One node at its own pivot, a spring and losses: the ledger closes."""
    scene = cd.Scene("damped_meshed", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1), inertia=(0.1, 0.1, 0.1))
    scene.joint("pin", cd.Revolute("y"), scene.ground, bob)
    rope = cd.SpringDamper(
        scene.ground.at(1, 0, 0), bob.at(0, 0, -1), stiffness=10.0, damping=4.0, rest_length=1.0
    )
    scene.force("oil", rope)
    model = cd.compile(scene, coordinates="absolute")
    exact = cd.compile(scene).simulate([0, 1.0], q={"pin": 1.0}, rtol=1e-11).work["oil"][-1]
    by_explicit = model.simulate([0, 1.0], q={"pin": 1.0}, method="DOP853", rtol=1e-10)
    assert by_explicit.work["oil"][-1] == pytest.approx(exact, rel=1e-8)
    counts, errors, drifts = np.array([100, 200, 400]), [], []
    for n in counts:
        method = cd.GeneralizedAlpha(0.8, index=index)
        motion = model.simulate([0, 1.0], q={"pin": 1.0}, method=method, step=1.0 / n)
        assert motion.success
        errors.append(abs(motion.work["oil"][-1] - exact))
        drifts.append(np.abs(motion.energy_residual).max())
    print(f"index {index}: work {errors}, drift {drifts}")
    assert slope(counts, errors) == pytest.approx(2, abs=0.15)
    assert slope(counts, drifts) == pytest.approx(2, abs=0.15)
