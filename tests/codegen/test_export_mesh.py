"""Exported models whose elements stand in tables: C that runs without Python."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse

import cardan as cd
from cardan.codegen.export.finite_elements import METHODS
from cardan.errors import CodegenError, DerivationError
from cardan.runtime.models.initial import start_of
from cardan.schema import kernel_files
from codegen.running import STRICT, compilers
from mechanisms.closed_planar import FOUR_BAR, four_bar_angles

STEP = 4e-3
QUICK = ("-O0", "-fno-math-errno", "-ffp-contract=off")

pytestmark = pytest.mark.skipif("gcc" not in compilers(), reason="needs a C compiler")


def swing(elements: int = 2) -> cd.Scene:
    """A rubber bar on a pin with a bob on a hinge, and a spring on the hinge."""
    scene = cd.Scene("swing")
    rubber = cd.material(E=5e6, nu=0.3, rho=1100)
    section = cd.section.rectangle(0.02, 0.02)
    bar = scene.beam("bar", (0, 0, 0), (0.8, 0, 0), section, rubber, elements=elements)
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
    stiffness = scene.parameter("stiffness", 0.4, unit="N*m/rad")
    bob = scene.body("bob", mass=0.3, com=(0.05, 0, 0), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("hinge", cd.Revolute("y"), bar.end, bob)
    scene.force("spring", cd.JointSpring("hinge", stiffness=stiffness))
    push = scene.input("push", default=0.2, unit="N")
    scene.force("wind", cd.Force(bar.end, (push, 0, 0)))
    scene.output("tip", bar.end.position()[2], unit="m")
    scene.output("reach", bar.end.position()[0], unit="m")
    return scene


def linkage() -> cd.Scene:
    """The four-bar, a little open where it starts."""
    scene = cd.Scene("linkage", gravity=(0, -9.81, 0))
    bars = {"crank": FOUR_BAR["crank"], "coupler": FOUR_BAR["coupler"]}
    bars["rocker"] = FOUR_BAR["rocker"]
    a, b, c = (
        scene.body(name, mass=x, com=(x / 2, 0, 0), inertia=cd.inertia.box(x, x, 0.02, 0.01))
        for name, x in bars.items()
    )
    q0 = {name: round(angle, 2) for name, angle in four_bar_angles(0.6).items()}
    pivot = scene.ground.at(FOUR_BAR["ground"], 0, 0)
    scene.joint("A", cd.Revolute("z"), scene.ground, a, q0=q0["A"])
    scene.joint("B", cd.Revolute("z"), a.at(bars["crank"], 0, 0), b, q0=q0["B"])
    scene.joint("D", cd.Revolute("z"), pivot, c, q0=q0["D"])
    end = c.at(bars["rocker"], 0, 0)
    scene.joint("C", cd.Revolute("z"), b.at(bars["coupler"], 0, 0), end)
    return scene


class Builder:
    """Compiles exports; the kernels, which are the same for all, once."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def run(self, export: Path, *more: str, main: str | None = None) -> list[str]:
        """What the example prints, or a main program."""
        objects = []
        for source in sorted(export.glob("*.c")):
            if main is not None and source.name == "example.c":
                continue
            home = (
                self.folder
                if source.name in {path.name for path in kernel_files.files()}
                else export
            )
            target = home / f"{source.stem}.o"
            if source.name == "example.c" or not target.exists():
                self.call("-c", f"-I{export}", *more, str(source), "-o", str(target))
            objects.append(target)
        program = export / "example"
        if main is not None:
            text = self.folder / "main.c"
            text.write_text(main)
            objects.append(text)
        self.call(f"-I{export}", *map(str, objects), "-o", str(program), "-lm")
        done = subprocess.run([str(program)], capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr
        return done.stdout.splitlines()

    def call(self, *words: str) -> None:
        command = [*compilers()["gcc"], *STRICT, *QUICK, *words]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr


@pytest.fixture(scope="module")
def builder(tmp_path_factory: pytest.TempPathFactory) -> Builder:
    return Builder(tmp_path_factory.mktemp("kernels"))


@pytest.fixture(scope="module")
def swinging(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The export of a beam with a body."""
    folder = tmp_path_factory.mktemp("swing") / "c"
    return cd.derive(swing()).export(folder, integrators=("alpha",))


def numbers(lines: list[str], name: str) -> np.ndarray:
    return np.array([float(x.split(" = ")[1]) for x in lines if x.startswith(f"{name}[")])


def same_run(lines: list[str], model: cd.CompiledModel, rel: float) -> cd.Trajectory:
    """The run in Python; what a program printed of its own start and end is the same."""
    motion = model.simulate(1.0, method=cd.GeneralizedAlpha(0.8), step=STEP)
    energy = model.energy(*model.split(motion.x[0]))
    assert numbers(lines, "energy") == pytest.approx(energy, rel=rel, abs=1e-12)
    # other flags round differently
    assert numbers(lines, "x") == pytest.approx(motion.x[-1], rel=1e-9, abs=1e-9)
    return motion


def test_a_flexible_scene_simulates_without_python(swinging: Path, builder: Builder) -> None:
    lines = builder.run(swinging, "-DCARDAN_EXAMPLE", f"-DSTEP={STEP}")
    motion = same_run(lines, cd.load_model(swinging), rel=1e-12)
    assert np.abs(motion.x[-1] - motion.x[0]).max() > 1


def test_steps_that_tolerances_ask_for_are_those_of_python(
    swinging: Path, builder: Builder
) -> None:
    lines = builder.run(swinging, "-DCARDAN_EXAMPLE")
    model = cd.load_model(swinging)
    motion = model.simulate(1.0, method=cd.GeneralizedAlpha(0.8))
    # other steps would be off by some of the tolerance, 1e-6 of the size
    assert numbers(lines, "x") == pytest.approx(motion.x[-1], rel=1e-8, abs=1e-8)


def test_what_may_be_chosen_is_defined_for_all_files_at_once(swinging: Path) -> None:
    (said,) = re.findall(r"when this is compiled: (.*?) \*/", (swinging / "example.c").read_text())
    chosen = said.split(", ")
    assert chosen == ["-DSTEP=1e-3", "-DRHO_INF=0.9"]
    command = [*compilers()["gcc"], *STRICT, "-fsyntax-only", "-DCARDAN_EXAMPLE", *chosen]
    sources = sorted(map(str, swinging.glob("*.c")))
    done = subprocess.run([*command, *sources], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("plane", [pytest.param(None, marks=pytest.mark.slow), "z"])
def test_a_rigid_closed_scene_simulates_without_python(
    plane: str | None, builder: Builder, tmp_path: Path
) -> None:
    equations = cd.derive(linkage(), coordinates="absolute", plane=plane)
    folder = equations.export(tmp_path / "c", integrators=("alpha",))
    lines = builder.run(folder, "-DCARDAN_EXAMPLE", f"-DSTEP={STEP}")
    model = cd.compile(equations)
    # loops were open at first, and both have closed them
    motion = same_run(lines, model, rel=1e-10)
    open_by = np.abs(model.constraints(start_of(model, {}, {})[0][: model.nq])).max()
    assert open_by > 1e-4
    assert np.abs(motion.x[-1] - motion.x[0]).max() > 0.1


START = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

int main(void)
{
    static cardan_model model;
    static real x[cardan_nq + cardan_nu], p[cardan_np];
    real *work;
    int status;

    for (int i = 0; i < cardan_np; i++)
        p[i] = cardan_default_p[i];
    p[p_length] = LENGTH;
    status = prepare_model(p, &model);
    work = malloc(model_work_size(&model) * sizeof(real));
    status |= start_model(&model, 0, cardan_default_r, x, work);
    printf("status[0] = %d\\n", status == CARDAN_CONSTRAINT_OPEN);
    for (int i = 0; i < cardan_nq + cardan_nu; i++)
        printf("x[%d] = %.17g\\n", i, x[i]);
    free(work);
    return 0;
}
"""


@pytest.mark.parametrize("closed", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_a3_starts_in_c_at_other_lengths(closed: bool, builder: Builder, tmp_path: Path) -> None:
    """Exported C moved nodes and joints alike until the joints were closed."""
    scene = cd.Scene("chain")
    length = scene.parameter("length", 0.5, unit="m")
    inner = scene.ground
    for name, angle in (("A", 0.4), ("B", -1.0), ("C", -1.2))[: 3 if closed else 2]:
        body = scene.body(name.lower(), mass=1.0, com=(0.2, 0, 0), inertia=(0.01, 0.02, 0.03))
        scene.joint(name, cd.Revolute("z"), inner, body, q0=angle, u0=0.3)
        inner = body.at(length, 0, 0)
    if closed:
        scene.joint("D", cd.Revolute("z"), inner, scene.ground.at(1.0, 0, 0))
    folder = cd.derive(scene, coordinates="absolute").export(tmp_path / "c", integrators=("alpha",))
    model = cd.load_model(folder)
    for size in (0.5, 0.6):
        lines = builder.run(folder, main=START.replace("LENGTH", repr(size)))
        refused = closed and size != 0.5
        assert numbers(lines, "status")[0] == refused
        if not refused:
            expected = model.with_parameters(length=size).simulate(1e-6).x[0]
            # the nearest of all closed positions: a minimum, known to the root of rounding
            assert numbers(lines, "x") == pytest.approx(expected, abs=1e-7 if closed else 1e-9)


MAIN = """
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

static void show(const char *name, const real *x, int n)
{
    for (int i = 0; i < n; i++)
        printf("%s[%d] = %.17g\\n", name, i, x[i]);
}

int main(void)
{
    static cardan_model model;
    static real x[cardan_nq + cardan_nu], p[cardan_np], r[cardan_nr + 1], out[10000];
    static int32_t columns[cardan_nvalues], starts[cardan_nunknowns + 1];
    static ptrdiff_t unknowns[cardan_nlam + 1];
    const real t = 0.5;
    const cardan_in in = {.t = &t, .q = x, .u = x + cardan_nq, .r = r, .w = model_w(&model)};
    real *work;
    int status;

    for (int i = 0; i < cardan_np; i++)
        p[i] = cardan_default_p[i];
    CHANGED
    status = prepare_model(p, &model);
    work = malloc(model_work_size(&model) * sizeof(real));
    status |= start_model(&model, t, r, x, work);
    show("x", x, cardan_nq + cardan_nu);
    for (int i = 0; i < cardan_nu; i++)
        x[cardan_nq + i] = 0.1 * (i % 7);
    status |= forward_dynamics(&in, out, work), show("udot", out, forward_dynamics_out_size);
    status |= rhs(&in, out, work), show("rhs", out, rhs_out_size);
    status |= energy(&in, out, work), show("energy", out, energy_out_size);
    status |= momentum(&in, out, work), show("momentum", out, momentum_out_size);
    status |= balance(&in, out, work), show("balance", out, balance_out_size);
    status |= outputs(&in, out, work), show("outputs", out, outputs_out_size);
    status |= mass_matrix(&in, out, work), show("matrix", out, mass_matrix_out_size);
    model_pattern(columns, starts, unknowns);
    for (int i = 0; i < cardan_nvalues; i++)
        printf("columns[%d] = %d\\n", i, (int)columns[i]);
    for (int i = 0; i <= cardan_nunknowns; i++)
        printf("starts[%d] = %d\\n", i, (int)starts[i]);
    for (int i = 0; i < cardan_nlam; i++)
        printf("unknowns[%d] = %d\\n", i, (int)unknowns[i]);
    free(work);
    return status;
}
"""


def test_functions_follow_the_parameters(swinging: Path, builder: Builder) -> None:
    changed = {"stiffness": 1.5, "bar.material.E": 2e7, "bob.mass": 0.5}
    names = {name: f"p_{name.replace('.', '_')}" for name in changed}
    lines = builder.run(
        swinging,
        main=MAIN.replace("CHANGED", " ".join(f"p[{names[k]}] = {v};" for k, v in changed.items())),
    )
    model = cd.load_model(swinging).with_parameters(changed)
    q, _ = model.split(numbers(lines, "x"))
    u = 0.1 * (np.arange(model.nu) % 7)
    given = {"t": 0.5, "r": np.zeros(model.nr)}
    lam = model.multipliers(q, u, **given)
    expected = {
        "udot": [*model.forward_dynamics(q, u, **given), *lam],
        "rhs": model.rhs(0.5, np.concatenate([q, u]), r=given["r"]),
        "energy": model.energy(q, u, **given),
        "momentum": model.momentum(q, u),
        "outputs": model.outputs(q, u, **given),
    }
    for name, values in expected.items():
        scale = np.abs(values).max()
        assert numbers(lines, name) == pytest.approx(values, rel=1e-9, abs=1e-10 * scale)
    # the sparse matrix is [M G^T; G 0]
    columns, starts = (numbers(lines, name).astype(int) for name in ("columns", "starts"))
    n = len(starts) - 1
    matrix = scipy.sparse.csr_array((numbers(lines, "matrix"), columns, starts), (n, n)).toarray()
    rows = numbers(lines, "unknowns").astype(int)
    M, G = model.mass_matrix(q, **given), model.constraint_jacobian(q, **given)
    np.testing.assert_allclose(matrix[: model.nu, : model.nu], M, atol=1e-11 * np.abs(M).max())
    np.testing.assert_allclose(matrix[rows, : model.nu], G, atol=1e-12)
    np.testing.assert_allclose(matrix[: model.nu, rows], G.T, atol=1e-12)
    assert not matrix[model.nu :, model.nu :].any()
    assert len(numbers(lines, "balance")) == model.nu + 2 * len(rows)


def test_files_are_those_of_the_manifest_and_the_same_again(swinging: Path, tmp_path: Path) -> None:
    data = json.loads((swinging / "manifest.json").read_text("utf-8"))
    again = cd.derive(swing()).export(tmp_path / "again", integrators=("alpha",))
    names = {path.name for path in again.iterdir()}
    assert names == {"manifest.json", *data["sha256"]}
    for name in names:
        content = (again / name).read_bytes()
        assert content == (swinging / name).read_bytes(), name
        assert str(tmp_path).encode() not in content
        assert str(Path.cwd()).encode() not in content
    assert {"elements.c", "tables.h", "model.h", "functions.h", "README.md"} <= names


def test_without_integrators_it_tells_the_energy(builder: Builder, tmp_path: Path) -> None:
    scene = cd.Scene("slide")
    block = scene.body("block", mass=2.0)
    scene.joint("rail", cd.Prismatic("z"), scene.ground, block, q0=0.5, u0=2.0)
    folder = cd.derive(scene, coordinates="absolute").export(tmp_path / "c", ["energy"])
    assert "int rhs(" not in (folder / "elements.c").read_text("utf-8")
    assert not (folder / "alpha.c").exists()
    lines = builder.run(folder, "-DCARDAN_EXAMPLE")
    kinetic, potential = 2.0 * 2.0**2 / 2, 2.0 * 9.81 * 0.5
    expected = [kinetic, potential, kinetic + potential]
    assert numbers(lines, "energy") == pytest.approx(expected, rel=1e-12)


def test_what_does_not_go_with_elements_is_refused(tmp_path: Path) -> None:
    equations = cd.derive(swing())
    with pytest.raises(CodegenError, match="language='c'"):
        equations.export(tmp_path / "c", language="cython")
    with pytest.raises(CodegenError, match=f"goes with {', '.join(METHODS)}"):
        equations.export(tmp_path / "c", integrators=("midpoint",))
    with pytest.raises(CodegenError, match="Did you mean 'alpha'"):
        equations.export(tmp_path / "c", integrators=("alpah",))
    with pytest.raises(DerivationError, match="Did you mean 'energy'"):
        equations.export(tmp_path / "c", ["enrgy"])
    with pytest.raises(DerivationError, match="poses of nodes are in q"):
        equations.export(tmp_path / "c", [("pose", "bob")])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
def test_the_example_runs_as_its_first_line_says(method: str, tmp_path: Path) -> None:
    equations = cd.derive(linkage(), coordinates="absolute")
    folder = equations.export(tmp_path / "c", integrators=(method,), reproducible=True)
    first = (folder / "example.c").read_text("utf-8").splitlines()[0]
    command = first.removeprefix("/* Try it:  ").removesuffix(" */")
    done = subprocess.run(["sh", "-c", command], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    model = cd.CompiledModel(folder, reproducible=True)
    found = numbers(done.stdout.splitlines(), "x")
    if method == "alpha":
        # the same C at the same flags, in steps as the same tolerances ask for
        end = model.simulate(1.0, method="GeneralizedAlpha").x[-1]
        assert found == pytest.approx(end, rel=1e-10, abs=1e-10)
    else:
        end = model.simulate(1.0, method="DOP853", rtol=1e-11, atol=1e-13).x[-1]
        assert found == pytest.approx(end, rel=1e-5, abs=1e-5)
