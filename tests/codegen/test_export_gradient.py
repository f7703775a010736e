"""Exported C that runs a motion and sweeps back: the gradients of the compiled model."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from analyses.gradients.test_gradients import ball
from analyses.gradients.test_passes import UP, windows_scene
from cardan.errors import CodegenError, DerivationError
from codegen.running import STRICT, compilers
from codegen.test_export import example_of, numbers
from table import each

MAIN = r"""
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

static void show(const double *x, ptrdiff_t n)
{
    for (ptrdiff_t i = 0; i < n; i++)
        printf("%.17g\n", x[i]);
}

int main(void)
{
    static const double x[] = {START};
    cardan_gradient of = {.run = {.end = END, .x = x, .rtol = RTOL, .atol = ATOL, .step = STEP}};
    void *memory = malloc(cardan_gradient_size(&cardan_scene, &of));
    const int status = cardan_gradient_of(&cardan_scene, &of, memory);

    printf("%d %d %s|%s\n", status, (int)of.run.steps, of.refused ? of.refused : "",
           of.event ? of.event : "");
    if (status != 0)
        return 0;
    show(&of.cost, 1);
    show(of.by_x, cardan_nq + cardan_nu + cardan_nz);
    show(of.by_p, cardan_np);
    show(of.by_r, cardan_nr);
    free(memory);
    return 0;
}
"""
# what was computed agrees to rounding of the order of operations, which compilers choose
CLOSE = 1e-13
TIGHT = {"rtol": 1e-10, "atol": 1e-12}
NAMES = {"rk4": "RK4", "rk45": "RK45", "dop853": "DOP853", "radau": "Radau"}


def program(folder: Path, x0: Any, end: float, how: dict[str, float], prefix: str = "") -> str:
    """What an export says of a motion from x0."""
    options = {"RTOL": 0.0, "ATOL": 0.0, "STEP": 0.0, "END": end}
    options |= {name.upper(): value for name, value in how.items()}
    options["START"] = ", ".join(map(repr, map(float, x0)))
    main = MAIN
    for name, value in options.items():
        main = main.replace(f"{name}}}" if name == "START" else f"= {name}", (
            f"{value}}}" if name == "START" else f"= {value}"
        ))  # fmt: skip
    if prefix:
        for name in ("cardan_gradient_size", "cardan_gradient_of", "cardan_scene", "cardan_n"):
            main = main.replace(name, prefix + name)
    (folder.parent / "main.c").write_text(main)
    answer = subprocess.run(
        [*compilers()["gcc"], *STRICT, "-O1", "-ffp-contract=on", f"-I{folder}", "-o", "main",
         "main.c", *map(str, folder.glob("*.c")), "-lm"],
        cwd=folder.parent, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert answer.returncode == 0, answer.stderr
    return subprocess.run(
        ["./main"], cwd=folder.parent, capture_output=True, text=True, check=True
    ).stdout


def compared(
    equations: Any, where: Path, cost: Any, x0: Any, end: float = 1.0, method: str = "dop853",
    prefix: str = "", close: float = CLOSE, **how: float,
) -> None:  # fmt: skip
    """The gradient of an export beside that of the model, along what the speeds move."""
    how = how or TIGHT
    functions = ["mass_matrix"]
    folder = equations.export(
        where, functions, language="c", integrators=[method], gradient=cost, prefix=prefix
    )
    lines = program(folder, x0, end, how, prefix).splitlines()
    assert lines[0].startswith("0 "), lines[0]
    model = cd.compile(equations)
    wrt = ("x0", "p", *model.inputs)
    expected = model.gradient(end, cost, wrt=wrt, x0=x0, method=NAMES[method], **how)
    steps = expected.motion.solver_info.statistics["steps"]
    assert steps == int(lines[0].split()[1]) or close > CLOSE
    values = np.array(lines[1:], dtype=float)
    ends = np.cumsum([1, model.nq, model.nx - model.nq, len(model.parameters)])
    value, by_q, by_rest, by_p, by_r = np.split(values, ends)
    # what moves a coordinate off the unit sphere moves nothing
    q, *_ = model.parts_of(np.asarray(x0, dtype=float))
    by_q = model.derivative("qdot", wrt="u")(q, np.zeros(model.nu)).T @ by_q
    slopes = [expected.slope[name] for name in wrt]
    reference = np.concatenate([[expected.value], *map(np.atleast_1d, slopes)])
    ours = np.concatenate([value, by_q, by_rest, by_p, by_r])
    assert np.abs(ours - reference).max() <= close * np.abs(reference).max()


def arm() -> cd.Scene:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    m, length = scene.parameter("m", 1.0), scene.parameter("length", 0.6)
    upper = scene.body(
        "upper", mass=m, com=(0, 0, -length / 2), inertia=cd.inertia.rod(m, length, axis="z")
    )
    hand = scene.body("hand", mass=0.5, com=(0.02, 0, -0.2), inertia=(0.01, 0.02, 0.03))
    scene.joint("shoulder", cd.Spherical(), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -length), hand)
    tau = scene.input("tau", 0.3)
    # a push that begins at a time
    scene.force("motor", cd.JointForce("elbow", tau + sp.Piecewise((0, cd.t < 0.41), (0.5, True))))
    scene.output("reach", hand.at(0, 0, -0.4).position()[0])
    return scene


COST = cd.cost(final="(reach - 0.5)^2 + m*elbow", running="1e-2*tau^2 + elbow.u^2")
X0 = [0.9, 0.1, 0.3, 0.2, 0.5, 0.4, -1.0, 0.7, 0.2]


@pytest.mark.parametrize("method", NAMES)
def test_trees(method: str, tmp_path: Path) -> None:
    x0 = np.array(X0)
    x0[:4] /= np.linalg.norm(x0[:4])
    how = {"step": 2e-3} if method == "rk4" else {}
    # sizes of steps of Radau follow from how far iterations go, which rounding decides: there
    # gradients differ as motions do
    close = 1e-8 if method == "radau" else CLOSE
    compared(cd.derive(arm()), tmp_path / "c", COST, x0, method=method, close=close, **how)


def test_prefixes(tmp_path: Path) -> None:
    x0 = np.array(X0)
    x0[:4] /= np.linalg.norm(x0[:4])
    compared(cd.derive(arm()), tmp_path / "c", COST, x0, prefix="arm_")


def test_a_start_of_another_length(tmp_path: Path) -> None:
    """A quaternion counts by its direction: differences of the cost itself, entry by entry."""
    cost = cd.cost(final="reach")
    folder = cd.derive(arm()).export(
        tmp_path / "c", ["energy"], language="c", integrators=["rk4"], gradient=cost
    )

    def run(x0: Any) -> Any:
        return np.array(program(folder, x0, 0.3, {"step": 1e-3}).splitlines()[1:], dtype=float)

    slope = run(X0)[1:10]
    for k in (0, 2, 4, 7):
        unit = 1e-3 * np.eye(9)[k]
        wide, near = (run(X0 + s * unit)[0] - run(X0 - s * unit)[0] for s in (2, 1))
        assert (8 * near - wide) / 12e-3 == pytest.approx(slope[k], abs=1e-8)
    assert slope[:4] @ X0[:4] == pytest.approx(0, abs=1e-15)


def four_bar() -> cd.Scene:
    scene = cd.Scene("four-bar", gravity=(0, -9.81, 0))
    length = scene.parameter("length", 0.8)
    crank, coupler, rocker = (
        scene.body(name, mass=1.0, com=(size / 2, 0, 0), inertia=cd.inertia.rod(1.0, 0.5))
        for name, size in (("crank", 0.3), ("coupler", length), ("rocker", 0.6))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.9, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(length, 0, 0), rocker.at(0.6, 0, 0), cut=True)
    scene.output("x", coupler.at(length, 0, 0).position()[0])
    return scene


def closed(
    scene: cd.Scene, where: Path, cost: Any, given: dict[str, Any], names: tuple[str, ...],
    end: float, method: str, close: float, parameters: tuple[str, ...] = (),
) -> None:  # fmt: skip
    """Derivatives by what is named at the start, to which those by the state are put together."""
    equations = cd.derive(scene)
    model = cd.compile(equations)
    x0 = model.initial(**given)
    folder = equations.export(where, ["energy"], language="c", integrators=[method], gradient=cost)
    lines = program(folder, x0, end, TIGHT).splitlines()
    assert lines[0].startswith("0 "), lines[0]
    values = np.array(lines[1:], dtype=float)
    by_x, by_p = values[1 : 1 + model.nx], values[1 + model.nx :]
    expected = model.gradient(end, cost, wrt=("p", *names), method=NAMES[method], **given, **TIGHT)
    assert values[0] == pytest.approx(expected.value, rel=1e-12)
    for name in names:
        block, _, entry = name.partition("0.")

        def moved(by: float, block: str = block, entry: str = entry) -> Any:
            start = {**given[block], entry: given[block][entry] + by}
            return model.initial(**{**given, block: start})

        slope = by_x @ along(moved)
        assert slope == pytest.approx(expected.slope[name], rel=1e-8, abs=1e-8), name
    size = np.abs(expected.slope["p"]).max()
    for k, (name, value) in enumerate(model.parameters.items()):
        if parameters and name not in parameters:
            continue

        def changed(by: float, name: str = name, value: float = value) -> Any:
            return model.with_parameters({name: value + by}).initial(**given)

        moves = along(changed)
        slope = by_p[k] + by_x @ moves
        # where a parameter moves the start, differences say how
        tolerance = close if np.abs(moves).max() < 1e-12 else 1e-8
        assert slope == pytest.approx(expected.slope["p"][k], abs=tolerance * size), name


def along(start: Callable[[float], Any]) -> Any:
    """Derivative of a start, to fourth order."""
    wide, near = (start(h) - start(-h) for h in (2e-3, 1e-3))
    return (8 * near - wide) / 12e-3


@pytest.mark.parametrize("method", ["dop853", "radau"])
def test_loops_and_their_starts(method: str, tmp_path: Path) -> None:
    given = {"q": {"A": 0.8}, "u": {"A": 2.0}}
    cost = cd.cost(final="x", running="B^2")
    names, end = ("q0.A", "u0.A"), 0.7 if method == "dop853" else 0.05
    closed(four_bar(), tmp_path / "c", cost, given, names, end, method, CLOSE)


def test_starts_that_loops_move(tmp_path: Path) -> None:
    """A state that opens loops is brought onto them first: differences of the cost, by entries."""
    equations = cd.derive(four_bar())
    x0 = cd.compile(equations).initial(q={"A": 0.8}, u={"A": 2.0})
    folder = equations.export(
        tmp_path / "c", ["energy"], language="c", integrators=["rk4"], gradient=cd.cost(final="x")
    )

    def run(x0: Any) -> Any:
        return np.array(program(folder, x0, 0.3, {"step": 1e-3}).splitlines()[1:], dtype=float)

    slope = run(x0)[1 : 1 + len(x0)]
    for k in (0, 2, 3):
        unit = 1e-4 * np.eye(len(x0))[k]
        difference = (run(x0 + unit)[0] - run(x0 - unit)[0]) / 2e-4
        assert difference == pytest.approx(slope[k], rel=1e-5)


def test_places_where_branches_meet(tmp_path: Path) -> None:
    cost = cd.cost(final="x", running="A0^2")
    names = (("u0.A0",), 1.0, "dop853", 1e-9, ("gravity.y", "crank0.mass"))
    closed(windows_scene(), tmp_path / "c", cost, UP, *names)


def test_events_end_with_their_name(tmp_path: Path) -> None:
    """Never a number: how the time of an event moves is no part of the C."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    scene.force("floor", cd.Stop("z", lower=0.0, restitution=0.8))
    cost = cd.cost(final="z")
    folder = cd.derive(scene).export(
        tmp_path / "c", ["energy"], language="c", integrators=["dop853"], gradient=cost
    )
    said = program(folder, [1.0, 0.0], 2.0, TIGHT)
    assert said.startswith("-20 ")
    assert "model.gradient" in said
    assert "floor" in said.split("|")[1]
    # before the impact there is one
    lines = program(folder, [1.0, 0.0], 0.4, TIGHT).splitlines()
    found = ball().gradient(0.4, cost, x0=[1.0, 0.0], wrt="x0", **TIGHT)
    np.testing.assert_allclose(np.array(lines[1:4], float), [found.value, *found.slope["x0"]])


def test_costs_without_a_derivative_are_refused(tmp_path: Path) -> None:
    """NaN is no gradient."""
    folder = cd.derive(arm()).export(
        tmp_path / "c", ["energy"], language="c", integrators=["rk4"],
        gradient=cd.cost(final="sqrt(elbow - 100)"),
    )  # fmt: skip
    said = program(folder, X0, 0.1, {"step": 1e-2})
    assert said.startswith("-20 ")
    assert "no finite value" in said


def test_the_example_shows_it(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    options: dict[str, Any] = {"integrators": ["rk4"], "gradient": COST}
    folder = equations.export(tmp_path / "c", ["energy"], language="c", **options)
    lines = example_of(folder)
    model = cd.compile(equations)
    found = model.gradient(1.0, COST, wrt=("p", "tau"), method="RK4", step=1e-3)
    assert numbers(lines, "cost") == pytest.approx([found.value], rel=1e-12)
    assert numbers(lines, "by_r") == pytest.approx([found.slope["tau"]], rel=1e-11)
    assert numbers(lines, "by_p") == pytest.approx(found.slope["p"].tolist(), rel=1e-11, abs=1e-12)
    assert "motion_gradient.h" in (folder / "README.md").read_text("utf-8")


def test_the_package_for_numpy_has_it(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    options: dict[str, Any] = {"integrators": ["rk4"], "gradient": COST}
    folder = equations.export(tmp_path / "c", ["energy"], language="cython", **options)
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace"]
    flags = {**os.environ, "CFLAGS": "-O0"}
    answer = subprocess.run(build, cwd=folder, env=flags, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stderr
    package, model = loaded(next(folder.glob("arm*.so")), "arm"), cd.compile(equations)
    x0 = np.array(X0)
    x0[:4] /= np.linalg.norm(x0[:4])
    value, slope = package.gradient(0.6, x0, r={"tau": 0.2}, parameters={"m": 1.3}, step=1e-3)
    expected = model.gradient(
        0.6, COST, x0=x0, inputs={"tau": 0.2}, parameters={"m": 1.3}, wrt=("u0", "p", "tau"),
        method="RK4", step=1e-3,
    )  # fmt: skip
    assert value == pytest.approx(expected.value, rel=1e-13)
    size = CLOSE * np.abs(expected.slope["p"]).max()
    np.testing.assert_allclose(slope["x"][5:], expected.slope["u0"], atol=size, rtol=0)
    np.testing.assert_allclose(slope["p"], expected.slope["p"], atol=size, rtol=0)
    np.testing.assert_allclose(slope["r"], [expected.slope["tau"]], atol=size, rtol=0)
    assert package.gradient(0.1)[1]["x"].shape == (9,)
    with pytest.raises(ValueError, match="no method 'euler'"):
        package.gradient(0.1, method="euler")
    with pytest.raises(package.GradientError, match="status 2"):
        package.gradient(0.6, step=1e-3, most_steps=10)


def loaded(path: Path, name: str) -> Any:
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


REFUSED = [
    ({"integrators": []}, "name its method"),
    ({"integrators": ["alpha"]}, "no table of coefficients"),
    ({"language": "casadi", "integrators": ["rk4"]}, "'casadi'"),
    ({"precision": "single", "integrators": ["rk4"]}, "'single'"),
]


@each("options, match", REFUSED)
def test_refused_with_the_cure(options: dict[str, Any], match: str) -> None:
    with pytest.raises(CodegenError, match=match):
        cd.derive(arm()).export("nowhere", gradient=COST, **{"language": "c", **options})


def test_times_that_parameters_decide_are_refused(tmp_path: Path) -> None:
    scene = cd.Scene("pushed")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=2.0))
    begin = scene.parameter("begin", 0.3)
    scene.force("push", cd.JointForce("x", sp.Piecewise((0, cd.t < begin), (1, True))))
    with pytest.raises(DerivationError, match="a parameter decides when"):
        cd.derive(scene).export(
            tmp_path / "c", language="c", integrators=["rk4"], gradient=cd.cost(final="x")
        )
    with pytest.raises(DerivationError, match="speed_of_light"):
        cd.derive(arm()).export(
            tmp_path / "c",
            language="c",
            integrators=["rk4"],
            gradient=cd.cost(final="speed_of_light"),
        )
