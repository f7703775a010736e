"""Exported runs over elements with events, modes and internal states are those of Python."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_events import LOWER, cantilever
from cardan.codegen.export.finite_elements import METHODS
from cardan.schema.integrators import KERNELS
from codegen.running import STRICT, compilers
from codegen.test_export_mesh import Builder, builder
from laws.event_scenes import SCENES
from spread import some

__all__ = ["builder"]

pytestmark = pytest.mark.skipif("gcc" not in compilers(), reason="needs a C compiler")

SPAN, CLOSE = 0.12, 1e-9
TIMES = 5
MAIN = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

enum { TIMES = %(times)d, WIDTH = 1 + cardan_nq + cardan_nu + cardan_nz + cardan_nr + cardan_ns };

static void report(void *context, double t, const char *event)
{
    (void)context;
    printf("event %%.17g %%s\\n", t, event);
}

int main(void)
{
    static const double x[] = {%(x)s};
    static double times[TIMES], rows[TIMES * WIDTH];
    cardan_simulation run = {.x = %(start)s, .end = %(end)s, %(how)s, .times = times,
                             .time_count = TIMES, .rows = rows, .on_event = report};
    void *memory = malloc(cardan_simulation_size(&cardan_scene, &run));
    int status;

    (void)x;
    for (int i = 0; i < TIMES; i++)
        times[i] = run.end * i / (TIMES - 1);
    status = memory ? cardan_simulate(&cardan_scene, &run, memory) : 1;
    printf("status %%d\\n", status);
    for (int i = 0; i < run.row_count * WIDTH; i++)
        printf("row %%.17g\\n", rows[i]);
    free(memory);
    return 0;
}
"""


def exported_run(
    builder: Builder, folder: Path, end: float, how: Mapping[str, float], x: Any = None
) -> tuple[int, np.ndarray, list[tuple[float, str]]]:
    """The answer of an exported run, its rows t, x, r, s, and its events."""
    given = {"times": TIMES, "end": end, "how": ", ".join(f".{k} = {v}" for k, v in how.items())}
    given |= {"start": "NULL", "x": "0"} if x is None else {"start": "x"}
    if x is not None:
        given["x"] = ", ".join(f"{value:.17g}" for value in x)
    lines = [line.split() for line in builder.run(folder, main=MAIN % given)]
    status = next(int(line[1]) for line in lines if line[0] == "status")
    rows = np.array([float(line[1]) for line in lines if line[0] == "row"]).reshape(TIMES, -1)
    return status, rows, [(float(line[1]), line[2]) for line in lines if line[0] == "event"]


def same_run(found: tuple[int, np.ndarray, list[tuple[float, str]]], motion: cd.Trajectory) -> None:
    """A run in C, and the same in Python."""
    status, rows, events = found
    assert status == 0
    expected = np.concatenate([motion.t[:, None], motion.x, motion.r, motion.s], axis=1)
    assert rows == pytest.approx(expected, rel=CLOSE, abs=CLOSE)
    assert [name for _, name in events] == [event.name for event in motion.events]
    assert [t for t, _ in events] == pytest.approx([e.t for e in motion.events], abs=CLOSE)


def arm(sample: float | None) -> cd.Scene:
    """A beam at a stop, a wheel at its tip under a controller, a motor that lags."""
    scene = cantilever(2, lower=LOWER, restitution=0.1)
    wheel = scene.body("wheel", mass=0.05, inertia=(1e-4,) * 3)
    scene.joint("spin", cd.Revolute("y"), scene.bodies["head"], wheel, q0=0.1)
    q, u = scene.q("spin"), scene.u("spin")
    pid = cd.Controller.pid("spin", q, u, target=0.4, kp=0.3, ki=0.5, kd=0.01, sample=sample)
    scene.force("pid", pid)
    scene.force("motor", cd.Actuator("tilt", command=0.02, lag=0.01, limit=0.1))
    return scene


# explicit ones of given steps resolve the longitudinal vibration of light elements
STEPS = {"alpha": 1e-4, "rk4": 2e-5}


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[float | None, Path]:
    """Exports of a beam with a controller, continuous and sampled."""
    where = tmp_path_factory.mktemp("arms")
    return {
        sample: cd.derive(arm(sample)).export(where / f"{k}", language="c", integrators=METHODS)
        for k, sample in enumerate((None, 0.01))
    }


@pytest.mark.parametrize("sample", [None, pytest.param(0.01, marks=pytest.mark.slow)])
@pytest.mark.parametrize("method", some(METHODS, 3, METHODS.index("radau") % 3))
def test_a_beam_with_a_controller_and_a_stop(
    method: str, sample: float | None, folders: dict[float | None, Path], builder: Builder
) -> None:
    how = {"step": STEPS[method]} if method in STEPS else {"rtol": 1e-11, "atol": 1e-13}
    name: Any = cd.GeneralizedAlpha(0.8) if method == "alpha" else KERNELS[method].name
    model = cd.load_model(folders[sample])
    motion = model.simulate(np.linspace(0, SPAN, TIMES), method=name, **how)
    # the stop is met, the controller works, the motor has a state of its own
    assert {event.name for event in motion.events} >= {"stop.lower"}
    assert abs(motion["spin"][-1] - motion["spin"][0]) > 1e-3
    assert len(motion.ticks) == (0 if sample is None else 13)
    assert abs(motion.x[-1][-1]) > 1e-3
    found = exported_run(builder, folders[sample], SPAN, {"method": f'"{method}"', **how})
    same_run(found, motion)


@pytest.mark.parametrize("method", [pytest.param("dop853", marks=pytest.mark.slow), "alpha"])
def test_friction_from_a_reaction(method: str, builder: Builder, tmp_path: Path) -> None:
    """A sledge on the tip of a beam, which slides and sticks by its normal force."""
    scene = cantilever(2, lower=LOWER, restitution=0.0)
    sledge = scene.body("sledge", mass=0.05, inertia=(1e-4,) * 3)
    scene.joint("track", cd.Prismatic("x"), scene.bodies["head"], sledge, u0=0.016)
    scene.force("rub", cd.Friction("track", mu=0.3))
    folder = cd.derive(scene).export(tmp_path / "c", language="c", integrators=[method])
    how = {"step": STEPS[method]} if method in STEPS else {"rtol": 1e-11, "atol": 1e-13}
    name: Any = cd.GeneralizedAlpha(0.8) if method == "alpha" else KERNELS[method].name
    model = cd.load_model(folder)
    motion = model.simulate(np.linspace(0, SPAN, TIMES), method=name, **how)
    assert {"stop.lower", "rub.stop"} <= {event.name for event in motion.events}
    same_run(exported_run(builder, folder, SPAN, {"method": f'"{method}"', **how}), motion)


@pytest.mark.parametrize("compiler", some(sorted(compilers()), 2))
def test_all_files_compile_without_a_warning(
    compiler: str, folders: dict[float | None, Path], tmp_path: Path
) -> None:
    sources = sorted(map(str, folders[0.01].glob("*.c")))
    command = [*compilers()[compiler], *STRICT, "-O0", "-DCARDAN_EXAMPLE", *sources]
    command += ["-o", str(tmp_path / "example"), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_the_example_tells_its_events(folders: dict[float | None, Path], builder: Builder) -> None:
    lines = builder.run(folders[0.01], "-DCARDAN_EXAMPLE", "-DSTEP=1e-4")
    motion = cd.load_model(folders[0.01]).simulate(1.0, method=cd.GeneralizedAlpha(0.8), step=1e-4)
    told = [line.split(": ")[1] for line in lines if line.startswith("event at")]
    assert told == [event.name for event in motion.events]
    modes = [float(line.split(" = ")[1]) for line in lines if line.startswith("s[")]
    assert modes == pytest.approx(motion.s[-1], abs=1e-6)


@pytest.mark.filterwarnings("ignore:the start of 'stopped' is equally near")
@pytest.mark.parametrize("name", some(SCENES, 3))
def test_scenes_of_every_kind(name: str, builder: Builder, tmp_path: Path) -> None:
    """Stops, locks, dry friction, contacts, controllers and lags, with and without loops."""
    scene, start = SCENES[name]()
    folder = cd.derive(scene, coordinates="absolute").export(
        tmp_path / "c", language="c", integrators=("alpha",)
    )
    # sums are contracted in the same way
    model = cd.CompiledModel(folder, reproducible=True)
    motion = model.simulate(
        np.linspace(0, 1.0, TIMES), q=start, method=cd.GeneralizedAlpha(0.8), step=1e-3
    )
    x = model.initial(q=start)
    same_run(exported_run(builder, folder, 1.0, {"step": 1e-3}, x), motion)


def test_functions_of_events_are_those_of_python(builder: Builder, tmp_path: Path) -> None:
    equations = cd.derive(arm(0.01))
    names = {"energy", "events", "transition", "rhs"}
    folder = equations.export(tmp_path / "c", sorted(names), language="c")
    texts = {name: (folder / name).read_text("utf-8") for name in ("functions.h", "README.md")}
    assert all(f"int {name}(" in texts["functions.h"] for name in names)
    assert "reads t, q, u, z, s, r, e */" in texts["functions.h"]
    assert "This model has events" in texts["README.md"]
    # a model without events has no such functions
    plain = cd.derive(cantilever(1))
    with pytest.raises(cd.DerivationError, match="'events' does not exist"):
        plain.export(tmp_path / "plain", ["events"], language="c")
