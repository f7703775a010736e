"""Functions in C that compute inputs, with states of their own, beside the same expressions."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.runtime.build import cache

STRIBECK, BRISTLES, DAMPING, VISCOUS = 0.01, 1e4, 100.0, 0.4
# Canudas de Wit et al., A new model for control of systems with friction, IEEE TAC 40, 1995
LUGRE = f"""
#include <math.h>
#include "constants.h"

int lugre(double t, const double *x, const double *reads, double *gives)
{{
    const double v = reads[0], z = x[2], s = v / {STRIBECK};
    const double level = 1.0 + 0.5 * exp(-s * s), rate = v - SIGMA * fabs(v) / level * z;

    (void)t;
    gives[0] = -(SIGMA * z + {DAMPING} * rate + {VISCOUS} * v);
    gives[1] = rate;
    return 0;
}}
"""
START = {"q": {"x": 2.0}}


def sled(in_c: bool) -> cd.Scene:
    """A sled on a spring with friction by bristles."""
    scene = cd.Scene("sled")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("sled", mass=1.0))
    scene.force("spring", cd.JointSpring("x", stiffness=2.0))
    v, push = scene.u("x"), scene.input("push", default=0.0, unit="N")
    scene.force("push", cd.JointForce("x", push))
    if in_c:
        friction, rate = scene.input("friction", unit="N"), scene.input("rate", unit="m/s")
        scene.force("bristles", cd.Controller(states=("z",), changes=(rate,)))
        scene.force("friction", cd.JointForce("x", friction))
        scene.output("speed", v)
        scene.output("twice", 2 * v + friction)
        return scene
    z = sp.Symbol("z")
    level = 1 + 0.5 * sp.exp(-((v / STRIBECK) ** 2))
    rate = v - BRISTLES * sp.Abs(v) / level * z
    force = -(BRISTLES * z + DAMPING * rate + VISCOUS * v)
    scene.force("bristles", cd.Controller("x", states=(z,), changes=(rate,), force=force))
    return scene


@pytest.fixture(scope="module")
def models() -> tuple[cd.CompiledModel, cd.CompiledModel]:
    return cd.compile(sled(True)), cd.compile(sled(False))


def written(folder: Path, text: str = LUGRE, name: str = "lugre") -> Path:
    (folder / "constants.h").write_text(f"#define SIGMA {BRISTLES}\n")
    file = folder / f"{name}.c"
    file.write_text(text)
    return file


@pytest.fixture
def law(tmp_path: Path) -> cd.CFunction:
    return cd.CFunction(written(tmp_path), reads="speed")


@pytest.mark.parametrize("method", ["DOP853", "RK45", "Radau"])
def test_the_motion_is_that_of_the_expressions(models: Any, law: Any, method: str) -> None:
    times, how = np.linspace(0, 1, 11), {"method": method, "rtol": 1e-9, "max_step": 0.1}
    found = models[0].simulate(times, inputs={("friction", "rate"): law}, **START, **how)
    expected = models[1].simulate(times, **START, **how)
    assert found.success
    assert found.x == pytest.approx(expected.x, abs=1e-8)
    # the sled has turned back by then, and the bristles are bent to their level
    assert abs(found["bristles.z"][-1]) > 5e-5
    # what was given stands in the motion
    force = -(BRISTLES * found["bristles.z"] + DAMPING * found["rate"] + VISCOUS * found["x.u"])
    assert found["friction"] == pytest.approx(force, abs=1e-9)


def test_functions_of_python_tables_and_c_go_together(models: Any, law: Any) -> None:
    table = ([0, 0.5, 0.5, 1], [0, 0, 3, 3])
    laws = {("friction", "rate"): law}
    for push in (lambda t, x: 3.0 * np.sin(5 * t), table, 2.0):
        how = {"method": "DOP853", "rtol": 1e-9, "max_step": 0.01}
        found = models[0].simulate(1.0, inputs=laws | {"push": push}, **START, **how)
        expected = models[1].simulate(1.0, inputs={"push": push}, **START, **how)
        assert found.x[-1] == pytest.approx(expected.x[-1], abs=1e-8)


def test_samples_are_held(models: Any, tmp_path: Path) -> None:
    text = "int hold(double t, const double *x, const double *r, double *g) { g[0] = t; return 0; }"
    hold = cd.CFunction(written(tmp_path, text, "hold"))
    times = [0, 0.1, 0.3, 0.6, 0.9]
    found = models[1].simulate(times, inputs={"push": hold}, sample=0.25, **START)
    assert found["push"] == pytest.approx([0, 0, 0.25, 0.5, 0.75])


def test_ensembles_ask_it(models: Any, law: Any) -> None:
    starts = [1.0, 1.5, 2.0]
    how = {"method": "DOP853", "rtol": 1e-9, "max_step": 0.1}
    laws = {("friction", "rate"): law}
    runs = models[0].ensemble(0.5, vary={"x": starts}, inputs=laws, **how)
    for k, x in enumerate(starts):
        alone = models[1].simulate(0.5, q={"x": x}, **how)
        assert runs.final[k] == pytest.approx(alone.x[-1], abs=1e-8)


def test_a_changed_file_is_compiled_again(models: Any, tmp_path: Path) -> None:
    text = (
        "int push(double t, const double *x, const double *r, double *g) { g[0] = %s; return 0; }"
    )
    for value in (1.0, 5.0):
        push = cd.CFunction(written(tmp_path, text % value, "push"))
        found = models[1].simulate(0.01, inputs={"push": push}, **START)
        assert found["push"][-1] == value


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({(): "law"}, r"\(\): give the name of an input, or names of several"),
        ({3: "law"}, r"3: give the name of an input, or names of several"),
        ({("friction", "rate"): 1.0}, r"friction, rate: several names go with a cd\.CFunction"),
        ({("friction", "friction"): "law"}, "'friction' is given twice"),
        ({("friction", "rate"): "law", "rate": 1.0}, "'rate' is given twice"),
        ({"friction": "law", "rate": "law"}, "twice: name all that it gives in one tuple"),
        ({("friction", "ratee"): "law"}, "no input 'ratee'.*Did you mean 'rate'"),
        ({("friction", "rate"): "loop"}, "reads output 'twice', which depends on input 'friction'"),
        ({("friction", "rate"): "none"}, "no output 'sped'.*Did you mean 'speed'"),
    ],
)
def test_what_does_not_fit_is_refused(
    models: Any, tmp_path: Path, inputs: dict[Any, Any], words: str
) -> None:
    file = written(tmp_path)
    reads = {"law": "speed", "loop": ["twice"], "none": ["sped"]}
    laws = {name: cd.CFunction(file, "lugre", outputs) for name, outputs in reads.items()}
    given = {key: laws.get(value, value) for key, value in inputs.items()}
    with pytest.raises(cd.ModelError, match=words):
        models[0].simulate(0.1, inputs=given, **START)


def test_what_an_output_reads_may_be_given_by_others(models: Any, tmp_path: Path) -> None:
    """An output may depend on inputs that no C function gives."""
    text = """int lugre(double t, const double *x, const double *r, double *g)
    { g[0] = r[0]; return 0; }"""
    law = cd.CFunction(written(tmp_path, text), reads=["twice"])
    found = models[0].simulate(0.1, inputs={"push": law, "friction": 3.0}, **START)
    assert found["push"] == pytest.approx(2 * found["x.u"] + 3.0, abs=1e-12)


@pytest.mark.parametrize(
    ("file", "name", "words"),
    [
        ("none.c", "", r"there is no C file .*none\.c"),
        ("constants.h", "", r"there is no C file .*constants\.h"),
        ("lugre.c", "system(1)", r"'system\(1\)' is not a name in C"),
        ("lugre.c", "a\nb", "is not a name in C"),
    ],
)
def test_what_is_no_function_is_refused(tmp_path: Path, file: str, name: str, words: str) -> None:
    written(tmp_path)
    with pytest.raises(cd.ModelError, match=words):
        cd.CFunction(tmp_path / file, name)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("int lugre(double t) { return broken; }", "broken"),
        ("static int lugre(void) { return 0; }", "has no function 'lugre'"),
    ],
)
def test_c_that_does_not_compile(models: Any, tmp_path: Path, text: str, words: str) -> None:
    law = cd.CFunction(written(tmp_path, text))
    with pytest.raises(cd.BuildError, match=words):
        models[1].simulate(0.1, inputs={"push": law}, **START)


def test_without_a_compiler_it_says_so(
    models: Any, law: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing() -> None:
        raise cd.CompilerMissing("no C compiler")

    monkeypatch.setattr(cache, "compiler", missing)
    with pytest.raises(cd.CompilerMissing):
        models[0].simulate(0.1, inputs={("friction", "rate"): law}, **START)


def test_a_function_ends_the_run(models: Any, tmp_path: Path) -> None:
    text = """int lugre(double t, const double *x, const double *r, double *g)
    { g[0] = 0; return t > 0.5 ? 7 : 0; }"""
    law = cd.CFunction(written(tmp_path, text))
    with pytest.warns(cd.SolveWarning, match=r"C function 'lugre' of lugre\.c returned 7"):
        found = models[0].simulate(1.0, inputs={"push": law}, method="RK4", step=0.01, **START)
    assert found.status == "function_failed"
    assert found.t[-1] == pytest.approx(0.5)


def test_what_is_not_finite_names_the_input(models: Any, tmp_path: Path) -> None:
    text = """int lugre(double t, const double *x, const double *r, double *g)
    { g[0] = t > 0.5 ? 0.0 / 0.0 : 0.0; return 0; }"""
    law = cd.CFunction(written(tmp_path, text))
    with pytest.warns(cd.SolveWarning, match="input 'push' is nan"):
        found = models[0].simulate(1.0, inputs={"push": law}, method="RK4", step=0.01, **START)
    assert np.isfinite(found.x).all()


MAIN = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

int lugre(double t, const double *x, const double *reads, double *gives);

static int inputs(void *context, double t, const double *x, double *r)
{
    double gives[2];
    const int status = lugre(t, x, x + 1, gives);

    ++*(long *)context;
    r[r_friction] = gives[0];
    r[r_rate] = gives[1];
    return status;
}

int main(void)
{
    long calls = 0;
    cardan_simulation run = {.end = 1, .rtol = 1e-9, .atol = 1e-12, .inputs = inputs};
    double x[3] = {2, 0, 0};
    void *memory = malloc(cardan_simulation_size(&cardan_scene, &run));

    run.x = x, run.context = &calls;
    if (!memory || cardan_simulate(&cardan_scene, &run, memory) != 0)
        return 1;
    printf("%.17g %.17g %.17g %ld\\n", run.x_end[0], run.x_end[1], run.x_end[2], calls);
    free(memory);
    return 0;
}
"""


@pytest.mark.parametrize("integrator", ["dop853", "rosenbrock"])
def test_exported_runs_ask_functions_too(models: Any, tmp_path: Path, integrator: str) -> None:
    folder = tmp_path / "sled"
    cd.derive(sled(True)).export(folder, language="c", integrators=[integrator])
    (tmp_path / "main.c").write_text(MAIN)
    written(tmp_path)
    compiler = cache.compiler().command
    sources = [*map(str, folder.glob("*.c")), str(tmp_path / "main.c"), str(tmp_path / "lugre.c")]
    program = tmp_path / "program"
    command = [*compiler, "-std=c99", "-O1", f"-I{folder}", "-o", str(program), *sources, "-lm"]
    subprocess.run(command, check=True, capture_output=True)
    answer = subprocess.run(
        [str(program)], check=True, capture_output=True, text=True
    ).stdout.split()
    expected = models[1].simulate(1.0, method="Radau", rtol=1e-10, **START)
    assert [*map(float, answer[:3])] == pytest.approx(expected.x[-1], abs=1e-6)
    assert int(answer[3]) > 100
