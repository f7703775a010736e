"""Exported C gives the bits of the loaded model; two compilers agree, to the bit on request."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.build import cache
from cardan.codegen.writing import generate
from codegen.running import CONTRACT, EXACT, STRICT, call, compilers
from golden.scenes import EXAMPLES, FUNCTIONS, scene_of
from spread import some

pytestmark = pytest.mark.optimized

STATES = 20
EPS = float(np.finfo(float).eps)
CASES = [
    pytest.param(example, function, id=f"{example.name}-{function}")
    for example in EXAMPLES
    for function in FUNCTIONS
]


def inputs(model: cd.CompiledModel) -> list[dict[str, np.ndarray]]:
    """Blocks at random states."""
    rng = np.random.default_rng(11)
    start = {"t": np.array([0.3]), "p": model.parameters.vector}
    start |= {block: model._layout.start(block) for block in "rzs"}
    found = []
    for x in model.random_state(rng, (STATES,)):
        q, u = model.split(x)
        tau, udot = rng.uniform(-1, 1, (2, model.nu))
        found.append(start | {"q": q, "u": u, "tau": tau, "udot": udot})
    return found


def results(example: Path, function: str, compiler: str, flags: tuple[str, ...]) -> np.ndarray:
    equations = cd.derive(scene_of(example))
    file = generate(equations.function(function), model=equations.system.name)
    model = cd.compile(equations, functions=FUNCTIONS)
    return np.array([call(file, values, compiler, flags).out for values in inputs(model)])


@pytest.mark.parametrize(("example", "function"), some(CASES, 8))
def test_the_bits_of_the_loaded_model(example: Path, function: str) -> None:
    model = cd.compile(cd.derive(scene_of(example)), functions=FUNCTIONS)
    compiler = cache.compiler()
    assert compiler is not None
    family = {"gcc": "gcc", "clang": "clang"}[compiler.family]
    flags = tuple(f for f in compiler.flags() if f not in ("-shared", "-fPIC"))
    alone = results(example, function, family, flags)
    takes = {"inverse_dynamics": ("q", "u", "udot"), "mass_matrix": ("q",)}
    for values, expected in zip(inputs(model), alone, strict=True):
        positional = [values[block] for block in takes.get(function, ("q", "u"))]
        more = {"tau": values["tau"]} if function == "forward_dynamics" else {}
        found = getattr(model, function)(*positional, t=0.3, **more)
        assert found.reshape(-1).tobytes() == expected.tobytes()


@pytest.mark.skipif(len(compilers()) < 2, reason="needs gcc and the package ziglang")
@pytest.mark.parametrize(("example", "function"), some(CASES, 10, 4))
def test_two_compilers(example: Path, function: str) -> None:
    fast = {name: (*STRICT, "-O2", "-march=native", *CONTRACT[name]) for name in compilers()}
    first, second = (results(example, function, name, flags) for name, flags in fast.items())
    model = cd.compile(cd.derive(scene_of(example)), functions=FUNCTIONS)
    bounds = [
        max(1e-13, 100 * EPS * np.linalg.cond(model.mass_matrix(v["q"]))) for v in inputs(model)
    ]
    error = np.abs(first - second).max(axis=1) / np.abs(first).max(axis=1)
    assert np.all(error <= bounds)

    # without contraction there is nothing to choose: the same bits
    exact = [results(example, function, name, EXACT) for name in fast]
    assert exact[0].tobytes() == exact[1].tobytes()
