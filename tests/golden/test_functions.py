"""One table of model functions: what is written of it, what must agree with it, and a new row.

``pytest tests/golden/test_functions.py --accept`` writes the stub and the page anew.
"""

from __future__ import annotations

import inspect
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.equations.recipes import RECIPES
from cardan.runtime.absolute.evaluated import Results
from cardan.runtime.functions import Functions
from cardan.runtime.verification.judges import JUDGES
from cardan.runtime.verify import CHECKED
from cardan.schema.blocks import ARGUMENTS
from cardan.schema.functions import FUNCTIONS, OF_ELEMENTS, STANDARD
from golden.functions import written
from mechanisms import ZOO
from mechanisms.closed import CLOSED

ROOT = Path(__file__).parents[2]
ACCEPT = "pytest tests/golden/test_functions.py --accept"
NEEDS = {
    *("constraints", "events", "closed form", "linear"),
    *("bodies", "inertias", "kinetic energy", "causes of forces"),
}
# what a system has as many of as its elements say
OPEN = ("ndependent", "nclosing", "ncosines", "nphi", "nsources", "ny")


@pytest.mark.parametrize(("place", "text"), list(written()), ids=lambda value: str(value)[:40])
def test_what_is_written_of_the_table(place: str, text: str, pytestconfig: pytest.Config) -> None:
    if pytestconfig.getoption("--accept"):
        (ROOT / place).write_text(text, "utf-8")
    assert (ROOT / place).read_text("utf-8") == text, f"{place} is not of this table: {ACCEPT}"


def test_every_row_has_its_recipe_and_only_such() -> None:
    assert set(RECIPES) == set(FUNCTIONS)
    # over elements, what evaluates a function has its name
    there = {name for name in FUNCTIONS if name in vars(Results)}
    assert there == set(OF_ELEMENTS)


def test_words_of_the_table() -> None:
    for row in FUNCTIONS.values():
        assert {*row.arguments} <= {*ARGUMENTS}, row.name
        assert {*row.needs} <= NEEDS, row.name
        assert row.of in ("", "frame", "joint", "function"), row.name
        assert row.about, row.name
        assert row.shape or row.unit or row.of == "function", row.name


def test_what_judges_a_function_is_a_row() -> None:
    assert {*CHECKED, *JUDGES} <= {*STANDARD}


@pytest.mark.parametrize("name", [n for n in FUNCTIONS if n in vars(Functions)])
def test_a_method_is_a_function_with_a_signature_and_a_docstring(name: str) -> None:
    method, row = getattr(cd.CompiledModel, name), FUNCTIONS[name]
    assert inspect.isfunction(method)
    words = list(inspect.signature(method).parameters)
    assert words[0] == "self"
    assert words[1 : 2 + bool(row.of)] == [row.of] * bool(row.of) + words[1 + bool(row.of) :][:1]
    text = inspect.getdoc(method) or ""
    assert row.about[1:] in text
    assert all(f"\n    {word}: " in text for word in words[1:])


def counts(model: cd.CompiledModel) -> dict[str, int]:
    rows = [row["level"] for row in model.manifest["multipliers"]]
    found = {"nlam": len(rows), "npositions": rows.count("position"), "ne": len(model.event_names)}
    sizes = {name: getattr(model, name) for name in ("nq", "nu", "nz", "nx", "ns", "nr")}
    return found | sizes | {"ntangent": model.nu**2}


def asked(shape: str) -> bool:
    return not any(word in shape for word in OPEN)


SCENES = {
    **{name: ZOO[name] for name in ("double_pendulum", "free_quaternion", "damped")},
    **{name: CLOSED[name] for name in ("four_bar", "slider_crank")},
}


@pytest.mark.parametrize("name", SCENES)
def test_shapes_of_what_is_derived_are_those_of_the_table(name: str) -> None:
    equations = cd.derive(SCENES[name].build())
    model = cd.compile(equations)
    frame, joint = model.frames[0], model.joints[0]
    for function in equations.names():
        row = FUNCTIONS[function]
        if row.of == "function" or row.for_reading or not asked(row.shape):
            continue
        of = {"frame": frame, "joint": joint}.get(row.of)
        outputs = equations.function(function, of).outputs
        expected = row.sizes(counts(model))
        if len(outputs) == 1:
            assert outputs[0].shape == expected, function
        else:
            assert (sum(output.size for output in outputs),) == (int(np.prod(expected)),), function


def test_results_over_elements_have_the_shapes_of_the_table() -> None:
    model = cd.compile(ZOO["double_pendulum"].build(), coordinates="absolute")
    q, u = model.split(model.initial())
    of = {"frame": model.frames[0], "joint": model.joints[0]}
    given = {"udot": u, "du": 0.1 * u, "events": np.zeros(0), "t": 0.0, "x": model.initial()}
    given |= {"q": q, "u": u}
    for name in (n for n in OF_ELEMENTS if n in vars(Functions)):
        row, method = FUNCTIONS[name], getattr(model, name)
        parameters = inspect.signature(method).parameters.values()
        needed = [one.name for one in parameters if one.default is one.empty]
        result = method(*((given | of)[word] for word in needed))
        expected = row.sizes(counts(model) | {"ny": 0, "nsources": 0})
        assert np.shape(np.array(result)) == expected, name


ROW = """
gravity_power | t q u r | | W | causes of forces |
    power of the weight of all bodies
"""
RECIPE = """

@recipe
def gravity_power(c: Context) -> tuple[Output, ...]:
    force = c.d.bias(moving=False)
    power = -(force.T @ c.d.block("u", force.rows))[0]
    return (Output("power", (), (power.node,), ("power",), ("W",)),)
"""
PROGRAM = """
import sys, inspect
import numpy as np
import cardan as cd
from cardan.codegen import export
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
heavy = model.gravity_power(q, u, parameters={name: 2 * value for name, value in
                                              model.parameters.items() if name == "m1"} or None)
assert heavy.shape == (7,)
slope = model.derivative("gravity_power", "u")(q, u)
assert close(slope, -model.gravity(q))
help(model.gravity_power)
told = model.verify()
assert "gravity_power" in told.unchecked and "NOT CHECKED: gravity_power" in str(told)
folder = equations.export(sys.argv[1], functions=["gravity_power"])
assert "power of the weight" in (folder / "gravity_power.c").read_text()
(pyx,) = folder.glob("*.pyx")
assert "def gravity_power(q, u, *" in pyx.read_text()
assert "| `gravity_power(q, u, r=, t=)` | power of the weight of all bodies | (...) | W |" in page()
assert "    def gravity_power(\\n        self,\\n        q: State," in stub()
print("all of it")
"""


def test_one_row_and_its_recipe_make_a_function(tmp_path: Path) -> None:
    """Callable, differentiable, said to be unchecked, exported and documented."""
    copy = tmp_path / "src" / "cardan"
    shutil.copytree(ROOT / "src" / "cardan", copy, ignore=shutil.ignore_patterns("__pycache__"))
    table, recipes = copy / "schema" / "functions.py", copy / "equations" / "functions.py"
    text = table.read_text("utf-8")
    end = text.index('\n"""\n', text.index('TABLE = """'))
    table.write_text(f"{text[:end]}{ROW.rstrip()}{text[end:]}", "utf-8")
    recipes.write_text(recipes.read_text("utf-8") + RECIPE, "utf-8")
    path = os.pathsep.join([str(copy.parent), str(ROOT / "tests")])
    command = [sys.executable, "-c", PROGRAM, str(tmp_path / "exported")]
    done = subprocess.run(
        command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "Power of the weight of all bodies." in done.stdout
    assert done.stdout.endswith("all of it\n")
