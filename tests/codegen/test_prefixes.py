"""Exports whose names begin with a prefix, side by side in one program."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import cardan as cd

MOTIONS = """
#include "one/functions.h"
#include "two/functions.h"
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    cardan_simulation one = {.end = 0.1, .step = 1e-3}, two = one;
    void *first = malloc(one_cardan_simulation_size(&one_cardan_scene, &one));
    void *second = malloc(two_cardan_simulation_size(&two_cardan_scene, &two));
    int status = one_cardan_simulate(&one_cardan_scene, &one, first);
    status |= two_cardan_simulate(&two_cardan_scene, &two, second);
    printf("%.17g\\n%.17g\\n", one.x_end[0], two.x_end[0]);
    free(first);
    free(second);
    return status;
}
"""


def _four_bar(name: str, length: float) -> cd.Scene:
    """A loop, whose positions are found with pivoting."""
    scene = cd.Scene(name)
    before = scene.ground
    # a parallelogram, which is closed
    for k, angle in enumerate((-1.2, 1.2, np.pi - 1.2)):
        bar = scene.body(f"bar{k}", mass=1, com=(length / 2, 0, 0), inertia=(0.1, 0.1, 0.1))
        scene.joint(f"joint{k}", cd.Revolute("y"), before, bar, q0=angle)
        before = bar.at(length, 0, 0)
    scene.joint("last", cd.Revolute("y"), scene.ground.at(length, 0, 0), before, q0=np.pi - 1.2)
    return scene


def _linked(folder: Path, text: str, names: list[str]) -> list[float]:
    """What a program of these exports prints."""
    (folder / "both.c").write_text(text)
    files = [str(path) for name in names for path in (folder / name).glob("*.c")]
    program = [str(folder / "both"), str(folder / "both.c"), *files, "-lm"]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", f"-I{folder}"]
    made = subprocess.run(
        ["cc", *flags, "-o", *program], capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr
    said = subprocess.run(program[:1], capture_output=True, text=True, check=True)
    return [float(line) for line in said.stdout.split()]


@pytest.mark.skipif(shutil.which("cc") is None, reason="no cc")
def test_closed_systems_of_two_prefixes_move_in_one_program(tmp_path: Path) -> None:
    """``cardan_solve_semidefinite`` of a macro was renamed without it; a guard hid the run."""
    wanted = []
    for name, length in (("one", 1.0), ("two", 2.0)):
        equations = cd.derive(_four_bar(name, length))
        equations.export(tmp_path / name, language="c", integrators=["rk4"], prefix=f"{name}_")
        model = cd.load_model(tmp_path / name)
        wanted.append(model.simulate(0.1, method="RK4", step=1e-3).x[-1, 0])
    np.testing.assert_allclose(_linked(tmp_path, MOTIONS, ["one", "two"]), wanted, atol=1e-12)


BEAMS = """
#include "one/functions.h"
#include "two/functions.h"
#include <stdio.h>
static one_cardan_model one;
static two_cardan_model two;
int main(void)
{
    int status = one_prepare_model(one_cardan_default_p, &one);
    status |= two_prepare_model(two_cardan_default_p, &two);
    printf("%d\\n%d\\n", (int)one.mesh.nu, (int)two.mesh.nu);
    return status;
}
"""


@pytest.mark.skipif(shutil.which("cc") is None, reason="no cc")
def test_beams_of_two_prefixes_have_models_of_their_own(tmp_path: Path) -> None:
    """A macro was defined twice, and memory for the first model served for the second."""
    for name, elements in (("one", 1), ("two", 2)):
        scene = cd.Scene(name)
        steel, square = cd.material(E=2e11, nu=0.3, rho=7850), cd.section.rectangle(0.02, 0.02)
        scene.beam("bar", scene.ground, (1, 0, 0), square, steel, elements=elements)
        cd.derive(scene).export(
            tmp_path / name, functions=["energy"], language="c", prefix=f"{name}_"
        )
    assert _linked(tmp_path, BEAMS, ["one", "two"]) == [6, 12]
