"""Families are open: a member is one file and its line, and all lists follow.

Each test adds a member to a copy of the source and runs it in a process of its own.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from architecture.sources import PACKAGE, ROOT


class Copy:
    """A copy of the source, with the kernels that were installed."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.package = folder, folder / "cardan"
        shutil.copytree(PACKAGE, self.package, ignore=shutil.ignore_patterns("__pycache__"))

    def add(self, file: str, text: str) -> None:
        """Write a new file."""
        path = self.package / file
        assert not path.exists()
        path.write_text(text, "utf-8")

    def insert(self, file: str, before: str, line: str) -> None:
        """Write a line before another one."""
        path = self.package / file
        text = path.read_text("utf-8")
        assert text.count(before) == 1, f"{file} has {before!r} not once"
        path.write_text(text.replace(before, f"{line}\n{before}"), "utf-8")

    def run(self, code: str) -> str:
        """What a program prints that sees the copy instead of the source."""
        seen = os.pathsep.join([str(self.folder), str(ROOT / "tests")])
        program = "import cardan\nfrom pathlib import Path\n" + textwrap.dedent(code)
        done = subprocess.run(
            [sys.executable, "-c", program],
            cwd=self.folder,
            env={**os.environ, "PYTHONPATH": seen},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout


@pytest.fixture
def source(tmp_path: Path) -> Copy:
    return Copy(tmp_path / "copy")


RK3_C = """\
/* Kutta's method: 3 stages, order 3, fixed step.
 *
 * Source: W. Kutta, Z. Math. Phys. 46 (1901), 435-453.
 */
#include "explicit.h"

static int init(cardan_run *run)
{
    run->on_grid = 1;
    return cardan_fixed_init(run);
}

static int step(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    real *k = run->k, *trial = run->trial;
    const real t = run->t, t_new = cardan_grid(run), h = t_new - t;
    int status = cardan_refresh(run);
    const real *y = cardan_enter(run, run->y, run->f, k);

    run->culprit = -1;
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h / 2 * k[i];
    status = status != 0 ? status : cardan_slope(run, t + h / 2, trial, k + n);
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h * (2 * k[n + i] - k[i]);
    status = status != 0 ? status : cardan_slope(run, t_new, trial, k + 2 * n);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < n; i++)
        trial[i] = y[i] + h / 6 * (k[i] + 4 * k[n + i] + k[2 * n + i]);
    cardan_leave(run, trial);
    return cardan_commit(run, t_new, trial);
}

static int dense(cardan_run *run)
{
    cardan_hermite(run, run->k, run->k + run->n);
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_rk3_method = {init, step, dense, cardan_no_memory, NULL, 3, 3};
"""
RK3 = '''\
"""Kutta's method of order 3."""

from .integrator import Integrator

METHOD = Integrator(
    name="RK3",
    kernel="rk3",
    order=3,
    dense_order=3,
    adaptive=False,
    applies="an example of a method that is new",
    source="W. Kutta, Z. Math. Phys. 46 (1901), 435-453",
    tableau=((), (0.5,), (-1.0, 2.0), (1 / 6, 2 / 3, 1 / 6)),
)
'''


def test_an_integrator_is_a_file_of_c_and_a_record(source: Copy) -> None:
    """It runs, has the order that it claims, is exported with what it needs, and is listed."""
    source.add("kernels/rk3.c", RK3_C)
    source.add("schema/integrators/rk3.py", RK3)
    source.insert("schema/integrators/__init__.py", "    rk4,\n", "    rk3,")
    source.insert("schema/integrators/__init__.py", "    *(radau,", "    rk3,")
    said = source.run("""
        from analyses.conftest import double_scene
        from analyses.test_records import table
        from cardan.cli import main
        from kernels import test_order, test_response
        method = test_order.METHODS["RK3"]
        for test in (test_order.test_order_of_the_steps, test_response.test_a_step_is_the_matrix):
            test(method, 1.0, Path.cwd())
        test_order.test_order_between_the_steps(method, Path.cwd())
        test_response.test_order("RK3")
        equations = cardan.derive(double_scene())
        model, start = cardan.compile(equations), {"elbow": 0.4}
        exact = model.simulate(1.0, q=start, rtol=1e-12)
        errors = []
        for step in (2e-3, 1e-3):
            motion = model.simulate(1.0, q=start, method="RK3", step=step)
            errors.append(abs(motion.q[-1] - exact.q[-1]).max())
        assert motion.solver_info.method == "RK3"
        assert 6 < errors[0] / errors[1] < 10, errors
        equations.export("c", ["rhs"], language="c", integrators=["rk3"])
        assert '| `"RK3"` | 3 | 3 | fixed |' in table()
        print(*model.simulate(1.0, method="RK3", step=1e-3).x[-1])
        try:
            main(["report", "--help"])
        except SystemExit:
            pass
    """)
    numbers, _, listed = said.partition("\n")
    assert "RK3" in listed
    # the export compiles alone and simulates the same motion from its start
    folder = source.folder / "c"
    command = ["cc", "-std=c99", "-DCARDAN_EXAMPLE", "-o", "example", *_sources(folder), "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    out = subprocess.run(["./example"], cwd=folder, capture_output=True, text=True, check=True)
    last = [float(line.split(" = ")[1]) for line in out.stdout.splitlines() if line[:2] == "x["]
    assert last == pytest.approx([float(word) for word in numbers.split()], abs=1e-12)


def _sources(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.glob("*.c"))


SEAT = '''\
"""A translation along a circle: the child keeps its axes, like the seat of a big wheel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...ir.arithmetic import cos, sin
from ...ir.matrix import Matrix
from ..quantity import Quantity
from ..validation import number
from .joint import Component, Joint


@dataclass(frozen=True)
class Seat(Joint):
    """The child goes along a circle in the x-y plane of the parent and keeps its axes.

    Args:
        radius: Of the circle [m].

    Source: made up for a test, 2024.
    """

    kind: ClassVar[str] = "seat"
    radius: Any = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "radius", number("seat", "radius", self.radius))

    @property
    def coordinates(self) -> tuple[Component, ...]:
        return (Component("", "rad"),)

    def quantities(self) -> dict[str, Quantity]:
        return {"radius": Quantity(self.radius, "m")}

    @property
    def closes_by_coordinates(self) -> bool:
        return True

    def pose(self, q: Matrix, **data: Matrix) -> tuple[Matrix, Matrix]:
        r = data["radius"][0]
        place = Matrix.vector(q.graph, [r * sin(q[0]), r * (1.0 - cos(q[0])), 0.0])
        return Matrix.identity(q.graph, 3), place

    def motion(self, q: Matrix, **data: Matrix) -> Matrix:
        r = data["radius"][0]
        way = [r * cos(q[0]), SIGN * r * sin(q[0]), 0.0]
        return Matrix.vstack(Matrix.zeros(q.graph, 3), Matrix.vector(q.graph, way))

    def constrained(self, q: Matrix, **data: Matrix) -> Matrix:
        graph = q.graph
        across = Matrix.vector(graph, [-SIGN * sin(q[0]), cos(q[0]), 0.0])
        sideways = Matrix.hstack(across, Matrix.vector(graph, [0.0, 0.0, 1.0]))
        return Matrix.vstack(
            Matrix.hstack(Matrix.identity(graph, 3), Matrix.zeros(graph, 3, 2)),
            Matrix.hstack(Matrix.zeros(graph, 3, 3), sideways),
        )


SIGN = 1.0
'''


def test_a_joint_is_a_file(source: Copy) -> None:
    """It is public, written in scene files, and judged: a wrong mode of motion is found."""
    source.add("elements/joints/seat.py", SEAT)
    source.insert("elements/joints/__init__.py", "from .spherical", "from .seat import Seat")
    source.insert("elements/joints/__init__.py", "        Universal,\n", "        Seat,")
    code = """
        Path("wheel.yaml").write_text('''cardan: 2
        gravity: [0, -9.81, 0]
        bodies: {seat: {mass: 2, inertia: [0.1, 0.2, 0.3], com: [0.1, -0.2, 0.3]}}
        joints: {wheel: {type: seat, radius: 3, parent: ground, child: seat}}
        ''')
        scene = cardan.load("wheel.yaml")
        assert isinstance(scene.joints["wheel"].kind, cardan.Seat)
        model = cardan.compile(scene, functions=["rhs", "forward_dynamics", "energy"])
        # what is built is judged at once; a pendulum that does not turn
        udot = model.forward_dynamics([0.7], [2.0])
        print(model.verify())
        print(float(udot[0]))
    """
    said = source.run(code)
    assert "NOTHING CHECKED" not in said
    assert float(said.split()[-1]) == pytest.approx(-9.81 / 3 * 0.644217687237691, rel=1e-12)
    wrong = source.package / "elements/joints/seat.py"
    wrong.write_text(wrong.read_text("utf-8").replace("SIGN = 1.0", "SIGN = -1.0"), "utf-8")
    with pytest.raises(AssertionError, match="differs from an independent Newton-Euler"):
        source.run(code)


LISTS = '''\
"""Runs as JSON: every variable a list of numbers, texts letter by letter."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from .contents import Attributes, FileFormat, Variable, Variables


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    rows = {
        name: [one.dimensions, one.values.dtype.str, one.values.shape, one.values.tobytes().hex(),
               dict(one.attributes)]
        for name, one in variables.items()
    }
    path.write_text(json.dumps({"attributes": dict(attributes), "variables": rows}), "utf-8")


def _parsed(data: bytes) -> tuple[Attributes, Variables]:
    whole = json.loads(data)
    return whole["attributes"], {
        name: Variable(
            tuple(axes), np.frombuffer(bytes.fromhex(text), kind).reshape(shape), texts
        )
        for name, (axes, kind, shape, text, texts) in whole["variables"].items()
    }


LISTS = FileFormat("JSON", (".lists",), _written, (b'{"attributes"',), _parsed)
'''


def test_a_format_of_saved_runs_is_a_file(source: Copy) -> None:
    """It saves and loads, and the command line offers it."""
    source.add("runtime/formats/lists.py", LISTS)
    source.insert("runtime/formats/__init__.py", "from .matlab", "from .lists import LISTS")
    path = source.package / "runtime/formats/__init__.py"
    text = path.read_text("utf-8")
    assert text.count("JSON, NETCDF4)") == 1
    path.write_text(text.replace("NETCDF4)", "NETCDF4, LISTS)"), "utf-8")
    source.run("""
        from analyses.conftest import double_scene
        from cardan.cli.options.run import motion as saved
        motion = cardan.compile(double_scene()).simulate(0.5, q={"elbow": 0.4})
        assert motion.save("run.lists").read_bytes().startswith(b'{"attributes"')
        again = cardan.load_motion("run.lists")
        assert again.x.tobytes() == motion.x.tobytes()
        assert again.solver_info == motion.solver_info
        assert again.at(0.3).tobytes() == motion.at(0.3).tobytes()
        assert saved("run.lists") == Path("run.lists")
    """)


GRAVITY_POWER = """\
gravity_power | t q u r | | W | causes of forces
    power of the weight of all bodies\
"""
RECIPE = """\
@recipe
def gravity_power(c: Context) -> tuple[Output, ...]:
    force = c.d.bias(moving=False)
    power = -(force.T @ c.d.block("u", force.rows))[0]
    return (Output("power", (), (power.node,), ("power",), ("W",)),)


"""


def test_a_model_function_is_a_row_and_its_recipe(source: Copy) -> None:
    """Callable, differentiable, said to be unchecked, exported and documented."""
    source.insert("schema/functions.py", "constraint_bias | ", GRAVITY_POWER)
    source.insert("equations/functions/functions.py", "@recipe\ndef integrate(", RECIPE)
    output = source.run("""
        import numpy as np
        import cardan as cd
        from golden.functions import page, stub
        from mechanisms import ZOO

        scene = ZOO["double_pendulum"].build()
        equations = cd.derive(scene)
        model = cd.compile(equations)
        q, u = np.random.default_rng(1).uniform(-1, 1, (2, 7, model.nu))
        expected = -(model.gravity(q) * u).sum(axis=-1)
        close = lambda a, b: np.allclose(a, b, rtol=1e-12, atol=1e-14)
        assert close(model.gravity_power(q, u), expected)
        assert close(model.gravity_power(u=u[0], q=q[0], t=1.0), expected[0])
        out = np.empty(7)
        assert model.gravity_power(q, u, out=out) is out and close(out, expected)
        name, values = next(iter(model.parameters)), np.linspace(1.0, 2.0, 7)
        power = model.gravity_power(q, u, parameters={name: values})
        one = model.with_parameters({name: values[3]})
        assert close(power[3], one.gravity_power(q[3], u[3]))
        slope = model.derivative("gravity_power", "u")(q, u)
        assert close(slope, -model.gravity(q))
        help(model.gravity_power)
        told = model.verify()
        assert "gravity_power" in told.unchecked and "NOT CHECKED: gravity_power" in str(told)
        folder = equations.export("exported", functions=["gravity_power"])
        assert "power of the weight" in (folder / "gravity_power.c").read_text()
        (pyx,) = folder.glob("*.pyx")
        assert "def gravity_power(q, u, *" in pyx.read_text()
        row = "| `gravity_power(q, u, r=, t=)` | power of the weight of all bodies | (...) | W |"
        assert row in page()
        assert "    def gravity_power(\\n        self,\\n        q: State," in stub()
        print("all of it")
    """)
    assert "Power of the weight of all bodies." in output
    assert output.endswith("all of it\n")
