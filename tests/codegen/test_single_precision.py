"""Exports in single precision, for microcontrollers: float alone, no memory, bounded runs."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import BuildError, CodegenError
from codegen.bindings import wrist
from codegen.running import STRICT, compilers
from mechanisms import ZOO
from mechanisms.closed_planar import four_bar

FLOAT = (*STRICT, "-Wdouble-promotion", "-O2")
METHODS = ("rk4", "dop853", "rk45")
MAIN = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    for (ptrdiff_t k = 0; k < cardan_scene.method_count; k++) {
        cardan_simulation run = {.method = cardan_scene.methods[k].name, .end = 1, .rtol = 1e-5f,
                                 .atol = 1e-6f, .budget = BUDGET};
        void *memory = malloc(cardan_simulation_size(&cardan_scene, &run));
        printf("%d\\n", cardan_simulate(&cardan_scene, &run, memory));
        printf("%d\\n", (int)run.steps);
        for (int i = 0; i < cardan_nq + cardan_nu; i++) printf("%.9g\\n", (double)run.x_end[i]);
        free(memory);
    }
    return 0;
}
"""
# what a program may want of others: parts of memory and strings, the library in single precision
LIBRARY = {"memcpy", "memset", "memmove", "memcmp", "strcmp", "strlen"}
SINGLE = re.compile(
    "(sqrt|cbrt|hypot|pow|exp|log|sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh"
    "|atanh|floor|ceil|fabs|fmax|fmin|fmod|copysign|nextafter|nan)f"
)
# the others in gcc alone
CLANG = ("wrist", "four_bar")
SCENES: dict[str, Any] = {
    "wrist": wrist,
    "springs": ZOO["springs"].build,
    "driven": ZOO["driven"].build,
    "damped": ZOO["damped"].build,
    "four_bar": four_bar,
}


def _run(folder: Path, compiler: str = "gcc", budget: int = 100000, prefix: str = "") -> list[Any]:
    """Answer, steps and end of a second by every method."""
    main = folder.parent / "main.c"
    text = MAIN.replace("BUDGET", str(budget))
    main.write_text(re.sub(r"\bcardan_(?!simulation run)", f"{prefix}cardan_", text))
    program = folder.parent / "main"
    files = [str(path) for path in (main, *folder.glob("*.c"))]
    command = [*compilers()[compiler], "-std=c99", "-O2", f"-I{folder}", *files]
    done = subprocess.run(
        [*command, "-o", str(program), "-lm"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    said = subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout.split()
    size = len(said) // len(METHODS)
    return [
        (int(row[0]), int(row[1]), np.array(row[2:], float))
        for row in (said[k : k + size] for k in range(0, len(said), size))
    ]


@pytest.mark.parametrize(
    ("name", "compiler"),
    [(name, c) for name in SCENES for c in sorted(compilers()) if c == "gcc" or name in CLANG],
)
@pytest.mark.filterwarnings("ignore:the start of 'four_bar'")
def test_runs_in_single_precision(name: str, compiler: str, tmp_path: Path) -> None:
    """No warning, and a second of motion as cardan has it: 7 digits, less what steps amplify."""
    equations = cd.derive(SCENES[name]())
    how: Any = {"language": "c", "integrators": METHODS, "precision": "single"}
    folder = equations.export(tmp_path / "c", **how)
    command = [*compilers()[compiler], *FLOAT, "-DCARDAN_EXAMPLE", f"-I{folder}"]
    files = [str(path) for path in folder.glob("*.c")]
    made = subprocess.run(
        [*command, *files, "-o", str(tmp_path / "example"), "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert made.returncode == 0, made.stderr
    end = cd.compile(equations).simulate(1.0, rtol=1e-10, atol=1e-12).x[-1]
    for status, _, x in _run(folder, compiler):
        assert status == 0
        error = np.abs(x - end).max() / max(1.0, np.abs(end).max())
        print(f"{name}: {error:.1e}")
        # a thousand roundings of 6e-8, or tolerances of 1e-5 per step
        assert error < 5e-5


@pytest.mark.parametrize("precision", ["single", "double"])
def test_nothing_allocates_or_prints(precision: str, tmp_path: Path) -> None:
    """Symbols that objects want of others: no malloc, no stdio; in single precision no double."""
    if not shutil.which("nm"):
        pytest.skip("nm is not installed")
    how: Any = {"language": "c", "integrators": METHODS, "precision": precision}
    folder = cd.derive(ZOO["springs"].build()).export(tmp_path / "c", **how)
    files = [str(path) for path in folder.glob("*.c") if path.name != "example.c"]
    compiler = next(iter(compilers().values()))
    # tables of pointers are constants where nothing moves them
    flags = ("-std=c99", "-O2", "-fno-pic", "-c")
    subprocess.run([*compiler, *flags, *files], cwd=tmp_path, check=True)
    listed = subprocess.run(
        ["nm", "-P", *map(str, tmp_path.glob("*.o"))], capture_output=True, text=True, check=True
    )
    rows = [line.split()[:2] for line in listed.stdout.splitlines() if not line.endswith(":")]
    symbols = {kind: {name for name, k in rows if (k == "U") == (kind == "U")} for kind in "UD"}
    wanted = symbols["U"] - symbols["D"] - LIBRARY - {"_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail"}
    assert not {"malloc", "calloc", "realloc", "free", "printf", "fprintf", "puts"} & wanted
    if precision == "single":
        assert {name for name in wanted if not SINGLE.fullmatch(name)} == set()
    # nothing that is written to outlives a call
    assert {name for name, kind in rows if kind in "dDbBC"} == set()


def test_a_run_ends_when_its_budget_is_spent(tmp_path: Path) -> None:
    how: Any = {"language": "c", "integrators": METHODS, "precision": "single"}
    folder = cd.derive(wrist()).export(tmp_path / "c", **how)
    more = 1
    assert [(status, steps) for status, steps, _ in _run(folder, budget=5)] == [(more, 5)] * 3


def test_prefix_and_precision_go_together(tmp_path: Path) -> None:
    how: Any = {"language": "c", "integrators": METHODS, "precision": "single"}
    plain = cd.derive(wrist()).export(tmp_path / "a" / "c", **how)
    prefixed = cd.derive(wrist()).export(tmp_path / "b" / "c", **how, prefix="arm_")
    for one, other in zip(_run(plain), _run(prefixed, prefix="arm_"), strict=True):
        assert one[:2] == other[:2]
        np.testing.assert_array_equal(one[2], other[2])


def test_what_does_not_go_with_it_is_refused(tmp_path: Path) -> None:
    equations = cd.derive(wrist())
    with pytest.raises(CodegenError, match="precision 'half' does not exist"):
        equations.export(tmp_path / "c", language="c", precision="half")
    with pytest.raises(CodegenError, match="goes with language='c'"):
        equations.export(tmp_path / "c", language="jax", precision="single")
    with pytest.raises(CodegenError, match="'radau' solves equations in double"):
        equations.export(tmp_path / "c", language="c", integrators=["radau"], precision="single")
    folder = equations.export(tmp_path / "c", ["energy"], language="c", precision="single")
    with pytest.raises(BuildError, match="single precision"):
        cd.load_model(folder).energy([1, 0, 0, 0, 0], [0, 0, 0, 0])
    # a flag alone makes no floats of doubles
    double = equations.export(tmp_path / "d", ["energy"], language="c")
    command = ["-DCARDAN_FLOAT", "-c", str(double / "energy.c"), "-o", str(tmp_path / "x.o")]
    compiler = next(iter(compilers().values()))
    made = subprocess.run([*compiler, *command], capture_output=True, text=True, check=False)
    assert made.returncode
    assert "cardan_numbers_are_float" in made.stderr
