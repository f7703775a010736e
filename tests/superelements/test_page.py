"""docs/superelements.md is true: its program runs, its tables are those of the code."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from superelements.components import BAR, beam, reference

PAGE = (Path(__file__).parents[2] / "docs" / "superelements.md").read_text("utf-8")


def test_the_program_of_the_page_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for ending in (".sti", ".mas", ".dof", ".inp"):
        (tmp_path / f"bar{ending}").write_bytes(BAR.with_suffix(ending).read_bytes())
    monkeypatch.chdir(tmp_path)
    program, of_beams = re.findall(r"```python\n(.*?)```", PAGE, re.S)
    (tmp_path / "program.py").write_text(program, "utf-8")
    names: dict[str, object] = {}
    exec(compile(program, "docs/superelements.md", "exec"), names)
    assert isinstance(names["again"], cd.superelement.Superelement)
    assert np.shape(names["response"]) == (2, 12, 12)
    exec(compile(of_beams, "docs/superelements.md", "exec"), names)
    assert isinstance(names["all_in_one"], cd.superelement.Superelement)


def test_the_errors_of_the_page() -> None:
    exact = np.array(reference("se_beam_16")["reference"]["full_clamped_free_omega"][:3])
    rows = re.findall(r'^\| (\d) \| `"(\w+)"` \| (.*) \|$', PAGE, re.M)
    assert len(rows) == 4
    for count, method, errors in rows:
        omega = beam(method=method, modes=int(count)).modes(["root"]).frequencies[:3]
        stated = [float(one) for one in errors.split(" | ")]
        np.testing.assert_allclose(omega / exact - 1, stated, rtol=0.35)


def test_every_method_and_file_is_on_the_page() -> None:
    assert all(f'`"{method}"`' in PAGE for method in cd.superelement.METHODS)
    assert all(reader.endings[0] in PAGE or reader.untested for reader in cd.superelement.READERS)
