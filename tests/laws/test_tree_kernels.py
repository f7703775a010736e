"""Functions that kernels assemble over a tree give what straight-line expressions give.

The kernels sum in axes of the ground about the origin of the tree's first body, the straight-line
expressions in axes of the bodies about their own origins: results agree to rounding, which for M
and the forces is that of sums, and for accelerations that times the condition of M.
"""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.ir.interpreter import evaluate
from cardan.ir.trees.assembly import Assembly
from laws.cases import EPS, SEED, derived, states, values
from mechanisms import ZOO
from mechanisms.chain import chain
from spread import some
from table import each

BLOCKS = {"forward_dynamics": "q u tau", "inverse_dynamics": "q u udot"}
REQUESTS = [("mass_matrix", None), *(("derivative", f"{f}: {wrt}") for f, wrt in BLOCKS.items())]
TAKEN = tuple(name for name in ZOO if not derived(name).refusal("mass_matrix", short=True))
COMPILED = TAKEN[::6]


def given(name: str) -> dict:
    e, (q, u), rng = derived(name), states(name), np.random.default_rng(SEED + 3)
    udot, tau = rng.uniform(-3, 3, u.shape), rng.uniform(-1, 1, u.shape)
    nz = len(e.blocks["z"].entries)
    modes = len(e.blocks["s"].entries)
    more = {"z": rng.uniform(-0.2, 0.2, (len(q), nz)), "s": np.ones((len(q), modes))}
    return values(e, q=q, u=u, udot=udot, tau=tau, **more)


def condition(e: object, blocks: dict) -> float:
    M = evaluate(e.function("mass_matrix"), blocks, arithmetic="numpy")["M"]
    return float(np.linalg.cond(M).max())


@pytest.mark.parametrize("name", some(TAKEN, 3))
def test_expressions(name: str) -> None:
    e, blocks = derived(name), given(name)
    # rounding of sums about the base: levers from there against levers from the body
    rounding = 2000 * EPS * condition(e, blocks)
    for function, of in REQUESTS:
        form = e.form(function, of, loops=True)
        if not isinstance(form, Assembly):
            # forces of elements depend on more than the kernel takes
            assert function == "derivative"
            assert e.system.forces
            continue
        straight = e.function(function, of)
        found = evaluate(form.straight(), blocks, arithmetic="numpy")
        exact = evaluate(straight, blocks, arithmetic="numpy")
        for output in straight.outputs:
            # what no state changes comes without states
            want, got = np.broadcast_arrays(exact[output.name], found[output.name])
            size = max(1.0, np.abs(want).max(initial=0))
            np.testing.assert_allclose(got, want, rtol=0, atol=rounding * size)


@each("name", COMPILED)
def test_compiled(name: str) -> None:
    """C gives what its expressions give, and lanes the bits of single states."""
    e, blocks = derived(name), given(name)
    model = cd.compile(e, functions=("mass_matrix", "forward_dynamics", "derivative"), loops=True)
    q, u, tau = (blocks[letter] for letter in ("q", "u", "tau"))
    more = {k: blocks[k] for k in ("z", "s") if blocks[k].size}
    M = model.mass_matrix(q)
    assert np.array_equal(M, [model.mass_matrix(x) for x in q])
    slopes = model.derivative("forward_dynamics", wrt=("q", "u", "tau"))
    batch = slopes(q, u, tau=tau, **more)
    for k in range(len(q)):
        one = slopes(q[k], u[k], tau=tau[k], **{n: x[k] for n, x in more.items()})
        assert all(np.array_equal(a, b[k]) for a, b in zip(one, batch, strict=True))
    exact = evaluate(
        e.function("derivative", "forward_dynamics: q u tau"), blocks, arithmetic="numpy"
    )
    rounding = 2000 * EPS * np.linalg.cond(M).max()
    for value, name_of in zip(batch, ("d_q", "d_u", "d_tau"), strict=True):
        size = max(1.0, np.abs(exact[name_of]).max())
        np.testing.assert_allclose(value, exact[name_of], rtol=0, atol=rounding * size)


def slopes_of(model: cd.CompiledModel, q: np.ndarray, u: np.ndarray, tau: np.ndarray) -> list:
    return list(model.derivative("forward_dynamics", wrt=("q", "u", "tau"))(q, u, tau=tau))


@pytest.mark.parametrize("n", [16, 30, 100])
def test_chains(n: int) -> None:
    """M against unit accelerations in Newton and Euler's recursion, slopes against differences."""
    functions = ("mass_matrix", "inverse_dynamics", "forward_dynamics", "derivative")
    model = cd.compile(chain(n), functions=functions, loops=True)
    rng = np.random.default_rng(SEED)
    q, u, tau = rng.uniform(-1, 1, (3, n))
    M, zero, one = model.mass_matrix(q), np.zeros(n), np.eye(n)
    assert "tree_mass.h" in model.manifest.functions["mass_matrix"].headers
    still = model.inverse_dynamics(q, zero, zero)
    by_unit = np.stack([model.inverse_dynamics(q, zero, e) for e in one]) - still
    np.testing.assert_allclose(
        M, by_unit, rtol=0, atol=50 * EPS * np.abs(still).max() + 1e-13 * n**2
    )
    cond = np.linalg.cond(M)
    by_q, by_u, inverse = slopes_of(model, q, u, tau)
    size = np.abs(inverse).max()
    np.testing.assert_allclose(inverse @ M, one, rtol=0, atol=n * EPS * cond)
    # central differences of eighth order along a direction: error h^8 and rounding / h
    direction, weights = rng.uniform(-1, 1, n) / np.sqrt(n), (4 / 5, -1 / 5, 4 / 105, -1 / 280)

    def along(function: object, h: float) -> np.ndarray:
        pairs = [function(k * h) - function(-k * h) for k in (1, 2, 3, 4)]
        return sum(w * pair for w, pair in zip(weights, pairs, strict=True)) / h

    def of_q(h: float) -> np.ndarray:
        return model.forward_dynamics(q + h * direction, u, tau=tau)

    def of_u(h: float) -> np.ndarray:
        return model.forward_dynamics(q, u + h * direction, tau=tau)

    for found, function in ((by_q @ direction, of_q), (by_u @ direction, of_u)):
        expected = along(function, 0.01)
        # forward dynamics body by body is exact to rounding, what is solved with M to its condition
        bound = 100 * EPS * max(cond, 1e4) * max(np.abs(found).max(), np.abs(expected).max())
        np.testing.assert_allclose(found, expected, rtol=0, atol=bound)
    assert size > 0


def test_far_away() -> None:
    """A scene a thousand kilometers away has the same M and slopes: no number knows where it is."""
    results = []
    for x in (0.0, 1e6):
        scene = cd.Scene("far", gravity=(0, 0, -9.81))
        parent = scene.ground.at(x, 2 * x, -x)
        for i in range(18):
            rod = scene.body(
                f"rod{i}", mass=1 + 0.1 * i, com=(0.4, 0.1, 0), inertia=(0.1, 0.2, 0.25)
            )
            scene.joint(f"hinge{i}", cd.Revolute("yzx"[i % 3]), parent, rod)
            parent = rod.at(0.7, 0.1, 0)
        model = cd.compile(scene, functions=("mass_matrix", "derivative"), loops=True)
        q, u, tau = np.random.default_rng(SEED).uniform(-1, 1, (3, 18))
        results.append([model.mass_matrix(q), *slopes_of(model, q, u, tau)])
    for here, there in zip(*results, strict=True):
        np.testing.assert_array_equal(here, there)


def test_reasons() -> None:
    """Equations say why a function is not assembled."""
    e = cd.derive(chain(4))
    assert e.refusal("mass_matrix") == "6 pairs of speeds inboard of each other are few"
    assert e.refusal("mass_matrix", short=True) == ""
    long = cd.derive(chain(16))
    assert long.refusal("derivative", "forward_dynamics: q u p").endswith("derivatives by 'p'")
    assert long.refusal("derivative", "energy: q").endswith("derivatives of 'energy'")
