"""Exports of products with derivatives: in C, NumPy and JavaScript, beside a compiled model."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.bindings import wrist
from codegen.running import STRICT, compilers
from codegen.test_wasm_export import complaint, needs_node, told

FUNCTIONS = [
    ("vjp", "rhs: q u"),
    ("jvp", "forward_dynamics: q u"),
    ("hessian", "pose(hand): q"),
    "mass_matrix",
]
Q, U = np.array([0.8, 0.0, 0.6, 0.0, 0.3]), np.array([0.1, -0.2, 0.3, 0.4])


@pytest.fixture(scope="module")
def equations() -> Any:
    return cd.derive(wrist())


@pytest.fixture(scope="module")
def expected(equations: Any) -> dict[str, Any]:
    """Vectors and results, one after the other."""
    model = cd.compile(equations)
    rng = np.random.default_rng(6)
    weights, direction, of_pose = (rng.standard_normal(size) for size in (9, 8, (4, 4)))
    by_q, by_u = model.vjp("rhs", wrt=("q", "u"))(0.0, np.concatenate([Q, U]), weights=weights)
    parts = (direction[:4], direction[4:])
    change = model.jvp("forward_dynamics", wrt=("q", "u"))(Q, U, parts)
    hessian = model.hessian(("pose", "hand"), wrt="q")(Q, of_pose)
    return {
        "vjp__rhs_q_u": (weights, np.concatenate([by_q, by_u])),
        "jvp__forward_dynamics_q_u": (direction, change),
        "hessian__pose_hand_q_785989e0": (of_pose.ravel(), hessian),
    }


MAIN = """
#include "functions.h"
#include <stdio.h>

int main(void)
{{
    static const double tau[] = {{0, 0, 0, 0}};
    static const double q[] = {{{q}}}, u[] = {{{u}}}, v[{name}_v_size] = {{{v}}};
    static double out[{name}_out_size], work[{name}_work_size + 1], w[{name}_w_size + 1];
    const cardan_in in = {{.q = q, .u = u, .tau = tau, .w = w, .v = v}};
    prepare_{name}(cardan_default_p, w);
    if ({name}(&in, out, work))
        return 1;
    for (int k = 0; k < {name}_out_size; k++)
        printf("%.17g\\n", out[k]);
    return 0;
}}
"""


@pytest.mark.parametrize("compiler", sorted(compilers()))
def test_c(compiler: str, equations: Any, expected: Any, tmp_path: Path) -> None:
    folder = equations.export(tmp_path / "c", FUNCTIONS, language="c")
    assert "v has 16 numbers" in (folder / "README.md").read_text("utf-8")
    build = [*compilers()[compiler], *STRICT, "-O1", f"-I{folder}"]
    sources = sorted(map(str, folder.glob("*.c")))
    for name, (vector, result) in expected.items():
        main, program = tmp_path / "main.c", tmp_path / name
        texts = {
            key: ", ".join(map(repr, x.tolist()))
            for key, x in zip("quv", (Q, U, vector), strict=True)
        }
        main.write_text(MAIN.format(name=name, **texts), "utf-8")
        subprocess.run([*build, str(main), *sources, "-o", str(program), "-lm"], check=True)
        answer = subprocess.run([str(program)], capture_output=True, text=True, check=True)
        found = [float(line) for line in answer.stdout.split()]
        np.testing.assert_allclose(found, result.ravel(), rtol=1e-12, atol=1e-13)
    # what the example calls first may take a vector
    alone = equations.export(tmp_path / "alone", [("hessian", "mass_matrix: q")], language="c")
    sources = sorted(map(str, alone.glob("*.c")))
    example = [*build, f"-I{alone}", "-DCARDAN_EXAMPLE", *sources, "-o", str(tmp_path / "e"), "-lm"]
    subprocess.run(example, check=True)
    answer = subprocess.run([str(tmp_path / "e")], capture_output=True, text=True, check=True)
    assert answer.stdout.count("hessian__mass_matrix_q") == 16


def test_numpy(equations: Any, expected: Any, tmp_path: Path) -> None:
    folder = equations.export(tmp_path / "c", FUNCTIONS, language="cython")
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace"]
    subprocess.run(build, cwd=folder, check=True, capture_output=True, timeout=300)
    vectors = {name: vector.tolist() for name, (vector, _) in expected.items()}
    program = f"""
import json, sys
sys.modules["cardan"] = None
import numpy as np
import wrist as m
q, u = np.array({Q.tolist()}), np.array({U.tolist()})
v = {{k: np.array(x) for k, x in {vectors}.items()}}
x = np.concatenate([q, u])
names = list(v)
several = v[names[2]] * np.array([[1.0], [-2.0]])
try:
    m.vjp__rhs_q_u(0.0, x, v[names[1]])
except ValueError as error:
    failure = str(error)
print(json.dumps([
    m.vjp__rhs_q_u(0.0, x, v[names[0]]).tolist(),
    m.jvp__forward_dynamics_q_u(q, u, v[names[1]]).tolist(),
    m.hessian__pose_hand_q_785989e0(q, v[names[2]]).tolist(),
    m.hessian__pose_hand_q_785989e0(q, several).tolist(),
    m.hessian__pose_hand_q_785989e0.__doc__,
    failure,
]))
"""
    answer = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr
    *found, several, text, failure = json.loads(answer.stdout)
    results = [result for _, result in expected.values()]
    for one, other in zip(found, results, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-13)
    both = np.stack([results[2], -2.0 * results[2]])
    np.testing.assert_allclose(several, both, rtol=1e-12, atol=1e-13)
    assert "v: weights of the results, or direction of the change, (..., 16)" in text
    assert failure == "v must have shape (..., 9), not (8,)"


@needs_node
def test_javascript(equations: Any, expected: Any, tmp_path: Path) -> None:
    folder = equations.export(tmp_path / "c", FUNCTIONS, language="wasm")
    x = {
        "vjp__rhs_q_u": f"x: {np.concatenate([Q, U]).tolist()}",
        "jvp__forward_dynamics_q_u": f"q: {Q.tolist()}, u: {U.tolist()}",
        "hessian__pose_hand_q_785989e0": f"q: {Q.tolist()}",
    }
    calls = ", ".join(
        f"model.{name}({{ {x[name]}, v: {vector.tolist()} }})"
        for name, (vector, _) in expected.items()
    )
    program = (
        f"const [gradient, change, hessian] = [{calls}];"
        "console.log(JSON.stringify([[...gradient.d_q, ...gradient.d_u], [...change],"
        "[...hessian]]));"
    )
    found = told(folder, program)
    for one, (_, result) in zip(found, expected.values(), strict=True):
        np.testing.assert_allclose(one, result.ravel(), rtol=1e-12, atol=1e-13)
    # by name, and what is wrong
    named = told(
        folder,
        "const v = { 'elbow.udot.weight': 1 }, x = new Float64Array(9).fill(0.1);"
        "const list = new Float64Array(9); list[8] = 1;"
        "const two = [v, list].map((v) => [...model.vjp__rhs_q_u({ x, v }).d_q]);"
        "console.log(JSON.stringify(two));",
    )
    np.testing.assert_array_equal(*named)
    at = "q: {}, u: {}"
    short = complaint(folder, f"model.jvp__forward_dynamics_q_u({{ {at}, v: [1, 2] }})")
    assert "jvp__forward_dynamics_q_u: v has length 2, not 8" in short
    missing = complaint(folder, f"model.jvp__forward_dynamics_q_u({{ {at} }})")
    assert "jvp__forward_dynamics_q_u needs v" in missing
