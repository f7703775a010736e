"""One table of model functions: what is written of it, and what must agree with it.

``pytest tests/golden/test_functions.py --accept`` writes the stub and the page anew.
"""

from __future__ import annotations

import inspect
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.equations.functions.recipes import RECIPES
from cardan.runtime.calls.functions import Functions
from cardan.runtime.models.finite_elements.evaluation import Results
from cardan.schema.blocks import ARGUMENTS
from cardan.schema.functions import FUNCTIONS, OF_ELEMENTS, STANDARD
from golden.functions import JUDGED, written
from mechanisms import ZOO
from mechanisms.closed import CLOSED

ROOT = Path(__file__).parents[2]
ACCEPT = "pytest tests/golden/test_functions.py --accept"
NEEDS = {
    *("constraints", "events", "closed form", "linear"),
    *("bodies", "inertias", "kinetic energy", "causes of forces"),
    *("element forces", "internal states", "known friction"),
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
        assert row.of in ("", "frame", "joint", "function", "formula"), row.name
        assert row.about, row.name
        assert row.shape or row.unit or row.of == "function", row.name


def test_what_judges_a_function_is_a_row() -> None:
    assert {*STANDARD} >= JUDGED


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
    forces = len(model.manifest.element_forces)
    found = {"nlam": len(rows), "npositions": rows.count("position"), "ne": len(model.event_names)}
    found["nforces"] = forces
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
        if row.of in ("function", "formula") or row.for_display or not asked(row.shape):
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
