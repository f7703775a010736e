"""Recursions in C: few lines however many bodies, strict flags, the numbers of the splice."""

from __future__ import annotations

import numpy as np

import cardan as cd
from cardan.codegen import generate
from cardan.ir.function import Function
from codegen.running import call, compilers, expected
from equations.test_sweeps import chain
from table import each


def written(n: int, name: str = "forward_dynamics") -> tuple[cd.Equations, str, Function]:
    equations = cd.derive(chain(n), method="articulated")
    recursion = equations.recursion(name)
    return equations, generate(recursion, model="chain").text, recursion.straight()


@each("compiler", compilers())
@each("name", ["forward_dynamics", "inverse_dynamics", "energy", "rhs"])
def test_numbers(name: str, compiler: str) -> None:
    equations = cd.derive(chain(11), method="articulated")
    recursion = equations.recursion(name)
    file, straight = generate(recursion, model="chain"), recursion.straight()
    rng = np.random.default_rng(5)
    values = {b.name: rng.uniform(-1, 1, len(b)) for b in straight.inputs}
    values["p"] = np.array([p.value for p in equations.system.parameters])
    exact = expected(straight, values)
    found = call(file, values, compiler).out
    np.testing.assert_allclose(found, exact, rtol=1e-11, atol=1e-12 * np.abs(exact).max())


def test_lines_do_not_grow_with_the_chain() -> None:
    short, long = (len(written(n)[1].splitlines()) for n in (30, 60))
    # tables and the list of inputs grow, code does not
    assert long - short < 30 * 8


def test_the_text_is_the_same_every_time() -> None:
    assert written(9)[1] == written(9)[1]


def test_a_reader_finds_the_way() -> None:
    text = written(20)[1]
    for line in (
        " * visits: 1 angles, 20 outward, 20 inward, 20 outward",
        "/* outward, 20 visits */",
        "for (int i = 0; i < ",
        "body_omega_x",
        "parent_omega_x",
        " and 7 more */",
    ):
        assert line in text, line
