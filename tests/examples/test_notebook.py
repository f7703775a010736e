"""The notebook runs in an empty folder, and what is stored in it is what it gives.

``pytest tests/examples --accept`` stores its outputs anew.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from examples.notebook import code, load, run, save

NOTEBOOK = Path(__file__).parents[2] / "examples" / "05_notebook.ipynb"


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> list[list[dict]]:
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("notebook"))
        return run(load(NOTEBOOK))


def test_stored_outputs_are_true(outputs: list[list[dict]], pytestconfig: pytest.Config) -> None:
    notebook = load(NOTEBOOK)
    if pytestconfig.getoption("--accept"):
        for number, (cell, made) in enumerate(zip(code(notebook), outputs, strict=True), 1):
            cell["outputs"], cell["execution_count"] = made, number
        save(NOTEBOOK, notebook)
    stored = [cell["outputs"] for cell in code(notebook)]
    assert stored == outputs, "run pytest tests/examples --accept and read the difference"


def test_it_shows_what_it_promises(outputs: list[list[dict]]) -> None:
    shown = [output for cell in outputs for output in cell]
    text = "".join(line for output in shown for line in output.get("text", ()))
    pictures = "".join(
        line for output in shown for lines in output.get("data", {}).values() for line in lines
    )
    assert "<svg" in pictures
    assert r"\ddot{\mathrm{elbow}}" in pictures
    assert r"\cos{\left(elbow \right)}" in text
    assert "same C: True" in text
    # equations set by the browser, a run drawn, a mechanism with names for what follows
    assert "<math" in pictures
    assert 'stroke-width="1.4"' in pictures
    assert "x.theta = -r*sin(phi + theta)/cos(phi)" in text
    assert "With what the loops determine" in pictures
    assert "largest force at the elbow" in text
    assert "int mass_matrix(" in text
    (error,) = outputs[-1]
    assert error["ename"] == "ModelError"
    assert "Did you mean 'lower'?" in error["evalue"]


def test_no_place_of_a_machine_is_stored() -> None:
    text = NOTEBOOK.read_text(encoding="utf-8")
    assert str(Path.home()) not in text
    assert "/tmp" not in text
