"""The verbs of a compiled model: the stub that type checkers read, and what Python shows of them.

``pytest tests/golden/test_verbs.py --accept`` writes the stub anew.
"""

from __future__ import annotations

import importlib
import inspect
import os
import pydoc
import subprocess
import sys
from pathlib import Path

import pytest

import cardan as cd
from golden.verbs import STUB, stub, verbs

ACCEPT = "pytest tests/golden/test_verbs.py --accept"


def test_the_stub_is_that_of_the_functions(pytestconfig: pytest.Config) -> None:
    if pytestconfig.getoption("--accept"):
        STUB.write_text(stub(), "utf-8")
    assert STUB.read_text("utf-8") == stub(), f"it is written by {ACCEPT}"


@pytest.mark.parametrize("name", verbs())
def test_a_verb_has_the_signature_of_its_function(name: str) -> None:
    module, _, function = verbs()[name].partition(":")
    expected = inspect.signature(getattr(importlib.import_module(module), function))
    shown = inspect.signature(getattr(cd.CompiledModel, name))
    first, *others = shown.parameters.values()
    assert first.name == "self"
    assert others == list(expected.parameters.values())[1:]
    assert shown.return_annotation == expected.return_annotation
    assert all(one.kind is not one.VAR_KEYWORD or one.name == "named" for one in others)


def test_help_tells_what_a_verb_takes() -> None:
    text = pydoc.render_doc(cd.CompiledModel.equilibrium, renderer=pydoc.plaintext)
    assert "equilibrium(self, *, q: " in text
    assert "Where a model rests under its forces" in text
    assert "model: " not in text
    bound = object.__new__(cd.CompiledModel).equilibrium
    assert next(iter(inspect.signature(bound).parameters)) == "q"
    assert bound.__qualname__ == "CompiledModel.equilibrium"


PROGRAM = """
from cardan.api.compiled_model import CompiledModel

def use(model: CompiledModel) -> None:
    rest = model.with_parameters(m=1.0).equilibrium(inputs={"load": 2.0})
    model.modes(3, rest).frequencies
    model.statics(P=(0, 10))
    model.equilibrium(laod={"P": 1.0})
"""


def test_a_type_checker_sees_a_misspelt_word(tmp_path: Path) -> None:
    path = tmp_path / "program.py"
    path.write_text(PROGRAM, "utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", str(path)]
    root = Path(__file__).parents[2]
    where = os.environ | {"MYPYPATH": str(root / "src")}
    done = subprocess.run(command, cwd=root, env=where, capture_output=True, text=True, check=False)
    assert 'Unexpected keyword argument "laod" for "equilibrium"' in done.stdout, done.stdout
    assert "Found 1 error in 1 file" in done.stdout, done.stdout
