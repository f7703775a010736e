"""Processors with fewer vectors and both compilers: 40 digits judge, lanes have equal bits."""

from __future__ import annotations

import platform

import numpy as np
import pytest

from cardan.codegen import generate
from cardan.ir.interpreter import evaluate
from codegen.lanes import WIDTHS, call_lanes
from codegen.running import CONTRACT, SPEED, STRICT, call, compilers
from laws.cases import EPS, derived, states, values

MEMBERS = ("spatial_chain", "free_quaternion", "crane")
X86 = platform.machine() in ("x86_64", "AMD64")
# what there is, without AVX-512, without AVX2 and FMA; the clang of ziglang spells them its own way
PROCESSORS: dict[str, dict[str, tuple[str, ...]]] = {
    "native": {"gcc": ("-march=native",), "clang": ("-march=native",)}
}
if X86:
    PROCESSORS |= {
        "no AVX-512": {"gcc": ("-march=native", "-mno-avx512f"), "clang": ("-mcpu=haswell",)},
        "AVX2": {"gcc": ("-march=x86-64-v3",), "clang": ("-march=x86_64_v3",)},
        "SSE2": {"gcc": ("-march=x86-64",), "clang": ("-march=x86_64",)},
    }
LANES = 8


@pytest.mark.slow
@pytest.mark.parametrize("compiler", sorted(compilers()))
@pytest.mark.parametrize("processor", PROCESSORS)
@pytest.mark.parametrize("name", MEMBERS)
def test_every_build_is_right_and_every_width_the_same(
    name: str, processor: str, compiler: str
) -> None:
    equations = derived(name)
    file = generate(equations.form("forward_dynamics"), model=name)
    q, u = states(name)
    given = values(equations)
    tau = np.random.default_rng(2).uniform(-1, 1, u.shape)
    rows = [
        given | {"q": q[k % len(q)], "u": u[k % len(q)], "tau": tau[k % len(q)]}
        for k in range(LANES)
    ]
    flags = (*STRICT, *SPEED, *PROCESSORS[processor][compiler], *CONTRACT[compiler])
    found = np.array([call(file, row, compiler, flags).out for row in rows])
    for lanes in WIDTHS:
        for start in range(0, LANES, lanes):
            _, many = call_lanes(file, rows[start : start + lanes], flags, compiler)
            assert many.tobytes() == found[start : start + lanes].tobytes(), lanes
    # one listed and one random state: forty digits are slow
    for k in (1, min(len(q), LANES) - 1):
        exact = evaluate(equations.function("forward_dynamics"), rows[k], "mp")["udot"]
        mass = evaluate(equations.function("mass_matrix"), rows[k], "float")["M"]
        n = len(u[0])
        allowed = max(1e-13, 100 * EPS * np.linalg.cond(np.reshape(mass, (n, n)).astype(float)))
        error = np.abs(found[k] - np.array(exact, dtype=float)).max()
        assert error <= allowed * np.abs(np.array(exact, dtype=float)).max()
