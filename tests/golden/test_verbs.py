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
from golden.verbs import Verb, modules, path, stub, verbs

MODULES = [importlib.import_module(f"cardan.api.{name}") for name in modules()]
ACCEPT = "pytest tests/golden/test_verbs.py --accept"


@pytest.mark.parametrize("module", modules())
def test_a_stub_is_that_of_the_functions(module: str, pytestconfig: pytest.Config) -> None:
    if pytestconfig.getoption("--accept"):
        path(module).write_text(stub(module), "utf-8")
    assert path(module).read_text("utf-8") == stub(module), f"it is written by {ACCEPT}"


EVERY = [verb for module in modules() for verb in verbs(module)]


@pytest.mark.parametrize("verb", EVERY, ids=lambda verb: f"{verb.owner}.{verb.name}")
def test_a_verb_has_the_signature_of_its_function(verb: Verb) -> None:
    kind = next(vars(module)[verb.owner] for module in MODULES if verb.owner in vars(module))
    method = getattr(kind, verb.name)
    if verb.kind == "attribute":
        method = method.fget if isinstance(method, property) else method.func
    shown = inspect.signature(method)
    others = list(shown.parameters.values())
    if verb.kind != "maker":
        assert others.pop(0).name == "self"
    assert others == verb.arguments
    assert shown.return_annotation == verb.signature.return_annotation
    assert all(one.kind is not one.VAR_KEYWORD or one.name == "named" for one in others)


def test_help_tells_what_a_verb_takes() -> None:
    text = pydoc.render_doc(cd.CompiledModel.equilibrium, renderer=pydoc.plaintext)
    assert "equilibrium(self, *, q: " in text
    assert "Equilibrium of a model under its forces" in text
    assert "model: " not in text
    bound = object.__new__(cd.CompiledModel).equilibrium
    assert next(iter(inspect.signature(bound).parameters)) == "q"
    assert bound.__qualname__ == "CompiledModel.equilibrium"


PROGRAM = """
from cardan.api.compiled_model import CompiledModel

def use(model: CompiledModel) -> None:
    rest = model.with_parameters(m=1.0).equilibrium(inputs={"load": 2.0})
    model.modes(3, rest).plot("modes.png", count=2)
    model.simulate(1.0).plot(names=["elbow"])
    model.statics(P=(0, 10))
    model.equilibrium(laod={"P": 1.0})
    model.simulate(1.0).animate("page.html", fsp=30)
"""


def test_a_type_checker_sees_a_misspelt_word(tmp_path: Path) -> None:
    path = tmp_path / "program.py"
    path.write_text(PROGRAM, "utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", str(path)]
    root = Path(__file__).parents[2]
    where = os.environ | {"MYPYPATH": str(root / "src")}
    done = subprocess.run(command, cwd=root, env=where, capture_output=True, text=True, check=False)
    assert 'Unexpected keyword argument "laod" for "equilibrium"' in done.stdout, done.stdout
    assert 'Unexpected keyword argument "fsp" for "animate"' in done.stdout, done.stdout
    assert "Found 2 errors in 1 file" in done.stdout, done.stdout
