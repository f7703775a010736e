"""docs/superelements.md is true: its tables are those of the code."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

import cardan as cd
from superelements.components import beam, reference

PAGE = (Path(__file__).parents[2] / "docs" / "superelements.md").read_text("utf-8")


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
