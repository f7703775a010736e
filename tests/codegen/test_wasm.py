"""WebAssembly has the bits of C without contraction, for every operator and mechanism."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.codegen.wasm.module import signed, unsigned
from cardan.codegen.writing import generate, lowered
from cardan.schema.blocks import ORDER
from codegen import functions
from codegen.running import EXACT, Answer, call
from codegen.wasm_running import call_wasm
from laws.cases import derived, states
from mechanisms import ZOO
from spread import some

FUNCTIONS = ("forward_dynamics", "inverse_dynamics", "energy", "mass_matrix", "constraints")
# the mathematical libraries of C differ in the last bit
LIBRARY = frozenset(functions.LIBRARY.split()) - {"sin", "cos"}


@pytest.mark.parametrize("value", [0, 1, 63, 64, 127, 128, 65535, 2**31 - 1])
def test_numbers_in_leb128(value: int) -> None:
    def decoded(encoded: bytes, is_signed: bool) -> int:
        total = sum((byte & 0x7F) << (7 * k) for k, byte in enumerate(encoded))
        return total - (1 << 7 * len(encoded)) if is_signed and encoded[-1] & 0x40 else total

    assert decoded(unsigned(value), False) == value
    assert decoded(signed(value), True) == value
    assert decoded(signed(-value), True) == -value


@pytest.mark.parametrize("seed", range(12))
def test_random_expressions(seed: int) -> None:
    function = functions.random_function(seed, operators=f"{functions.EXACT} sin cos stumpff table")
    values = functions.values(seed)
    c = call(generate(function), values, flags=EXACT)
    wasm = call_wasm(lowered(function), values, sum(o.size for o in function.outputs))
    assert_equal_bits(c, wasm)


def assert_equal_bits(c: Answer, wasm: Answer) -> None:
    assert wasm.status == c.status
    for ours, theirs in ((wasm.out, c.out), (wasm.w, c.w)):
        same = (ours == theirs) | (np.isnan(ours) & np.isnan(theirs))
        assert same.all(), f"{ours[~same]} in WebAssembly, {theirs[~same]} in C"


PAIRS = [(name, function) for name in ZOO for function in FUNCTIONS]


@pytest.mark.parametrize(("name", "function"), some(PAIRS, 17))
def test_functions_of_every_mechanism(name: str, function: str) -> None:
    equations = derived(name)
    if function not in equations.names():
        pytest.skip("this system has no such function")
    form = equations.form(function)
    q, u = (x[0] for x in states(name))
    rng = np.random.default_rng(5)
    values = {block.name: rng.uniform(-1, 1, len(block)).tolist() for block in form.inputs}
    values |= {"q": q.tolist(), "u": u.tolist(), "t": [0.3]}
    values |= {"p": [row.value for row in equations.system.parameters]}
    values |= {block: values.get(block, [0.0]) for block in ORDER}
    c, program = call(generate(form), values, flags=EXACT), lowered(form)
    wasm = call_wasm(program, values, sum(o.size for o in form.outputs))
    if LIBRARY & {*program.operations, *program.prepare_operations}:
        scale = np.abs(c.out).max(initial=0.0)
        np.testing.assert_allclose(wasm.out, c.out, rtol=0, atol=1e-14 * scale)
    else:
        assert_equal_bits(c, wasm)
