"""Exported runs side by side in plain C: the bits of single runs, rows and answers too."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.bindings import unit
from codegen.running import CONTRACT, STRICT, compilers
from mechanisms import ZOO
from mechanisms.closed_planar import four_bar

LANE_FILES = ("model_lanes.c", "simd_steps.c", "lane_control.c", "lane_dop853.c", "lane_rk45.c")
FLAGS = (*STRICT, "-O2", "-march=native", "-fno-tree-vectorize", "-fno-math-errno")
MAIN = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>
enum { COUNT = 7, TIMES = 5, NX = cardan_nq + cardan_nu + cardan_nz };
int main(void)
{
    static double x[COUNT * NX], ends[2][COUNT * NX];
    static double rows[2][COUNT * TIMES * (1 + NX + cardan_nr + cardan_ns)];
    static const double times[TIMES] = {0.0, 0.1, 0.37, 0.5, 1.0};
    static ptrdiff_t answers[2][COUNT];
    ptrdiff_t steps[2];
    for (int k = 0; k < COUNT * NX; k++) {
        const int i = k % NX;
        x[k] = (i < cardan_nq ? cardan_default_q[i] : 0.0) + 0.05 * (k / NX) * (1 + i % 3);
    }
    x[2 * NX] = NAN;
    for (int alone = 0; alone < 2; alone++) {
        const cardan_lane_build *build = alone ? NULL : &cardan_scene_lanes;
        cardan_simulations runs = {
            .common = {.method = METHOD, .end = 1, .times = times, .time_count = TIMES},
            .count = COUNT, .x = x, .x_end = ends[alone], .rows = rows[alone],
            .answers = answers[alone]};
        void *memory = malloc(cardan_simulations_size(&cardan_scene, build, &runs));
        if (cardan_simulate_lanes(&cardan_scene, build, &runs, memory)) return 1;
        steps[alone] = runs.steps;
        printf("%d\\n", (int)runs.side_by_side);
        free(memory);
    }
    printf("%d\\n", (int)(steps[0] - steps[1]));
    printf("%d\\n", memcmp(answers[0], answers[1], sizeof answers[0]));
    /* all but the run that could not start, which is not a number */
    for (int i = 0; i < COUNT; i++) {
        const size_t width = sizeof rows[0] / COUNT / sizeof(double);
        const int end = memcmp(ends[0] + i * NX, ends[1] + i * NX, NX * sizeof(double));
        const int row = memcmp(rows[0] + i * width, rows[1] + i * width, width * sizeof(double));
        printf("%d %d\\n", (int)answers[0][i], i == 2 ? 0 : end | row);
    }
    for (int i = 0; i < NX; i++) printf("%.17g\\n", ends[0][6 * NX + i]);
    return 0;
}
"""


def _program(folder: Path, compiler: str, width: int, method: str) -> list[str]:
    """What the program prints; its lanes and all else are compiled apart."""
    flags = [*compilers()[compiler], *FLAGS, *CONTRACT[compiler], f"-I{folder}"]
    (folder.parent / "main.c").write_text(MAIN.replace("METHOD", f'"{method}"'))
    objects = []
    for name in LANE_FILES:
        objects.append(str(folder.parent / f"{name}.o"))
        lanes = [*flags, f"-DCARDAN_LANES={width}", "-c", str(folder / name), "-o", objects[-1]]
        subprocess.run(lanes, check=True)
    files = [str(path) for path in (folder.parent / "main.c", *folder.glob("*.c"))]
    plain = [flag for flag in flags if flag not in ("-Wconversion", "-Wpedantic")]
    program = str(folder.parent / "main")
    subprocess.run([*plain, *files, *objects, "-o", program, "-lm"], check=True)
    return subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()


@pytest.mark.parametrize(
    ("name", "compiler", "width", "method"),
    [
        ("double_pendulum", "gcc", 4, "dop853"),
        ("double_pendulum", "gcc", 2, "rk45"),
        ("springs", "gcc", 4, "rk45"),
        ("spherical_quaternion", "gcc", 8, "dop853"),
        ("double_pendulum", "clang", 4, "dop853"),
    ],
)
def test_lanes_have_the_bits_of_single_runs(
    name: str, compiler: str, width: int, method: str, tmp_path: Path
) -> None:
    if compiler not in compilers():
        pytest.skip(f"{compiler} is not installed")
    scene = ZOO[name].build()
    how: Any = {"language": "c", "integrators": ["dop853", "rk45"]}
    folder = cd.derive(scene).export(tmp_path / "c", ["energy"], **how)
    said = _program(folder, compiler, width, method)
    assert said[:4] == [str(width), "1", "0", "0"]
    answers = said[4:18]
    assert answers[4] != "0"  # the run that begins with what is not a number
    assert answers[1::2] == ["0"] * 7
    assert answers[0:4:2] + answers[6::2] == ["0"] * 6
    model = cd.compile(scene)
    start = np.zeros(model.nx)
    start[: model.nq] = model.initial()[: model.nq]
    start += 0.05 * 6 * (1 + np.arange(model.nx) % 3)
    start[: model.nq] = unit(start[: model.nq], model.manifest.quaternions)
    end = model.simulate(1.0, x0=start, rtol=1e-9, atol=1e-12).x[-1]
    np.testing.assert_allclose(np.array(said[18:], float), end, rtol=1e-6, atol=1e-7)


def test_the_example_of_lanes_runs(tmp_path: Path) -> None:
    how: Any = {"language": "c", "integrators": ["dop853"], "prefix": "arm_"}
    folder = cd.derive(ZOO["double_pendulum"].build()).export(tmp_path / "c", ["energy"], **how)
    assert "lane_dop853.c" not in (folder / "functions.h").read_text("utf-8")
    compiler = next(iter(compilers().values()))
    flags = [*compiler, "-std=c99", "-O2", "-march=native"]
    names = ("model_lanes", "simd_steps", "lane_control", "lane_dop853")
    for name in names:
        subprocess.run([*flags, "-DCARDAN_LANES=4", "-c", f"{name}.c"], cwd=folder, check=True)
    files = [path.name for path in folder.glob("*.c")]
    linked = [*files, *(f"{name}.o" for name in names), "-o", "example", "-lm"]
    subprocess.run([*flags, "-DCARDAN_EXAMPLE_LANES", *linked], cwd=folder, check=True)
    said = subprocess.run(["./example"], cwd=folder, capture_output=True, text=True, check=True)
    assert "10 runs, 4 side by side" in said.stdout


@pytest.mark.filterwarnings("ignore:the start of 'four_bar'")
def test_systems_with_constraints_have_none(tmp_path: Path) -> None:
    how: Any = {"language": "c", "integrators": ["dop853"]}
    folder = cd.derive(four_bar()).export(tmp_path / "c", ["energy"], **how)
    assert not list(folder.glob("*lane*.c"))
    assert '"simulate.h"' in (folder / "functions.h").read_text("utf-8")
