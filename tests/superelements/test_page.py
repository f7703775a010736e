"""docs/superelements.md is true: its tables are those of the code."""

from __future__ import annotations

import re
from itertools import zip_longest
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from superelements import blades, slider_crank
from superelements.components import beam, reference

PAGE = (Path(__file__).parents[2] / "docs" / "superelements.md").read_text("utf-8")


def test_the_errors_of_the_page() -> None:
    exact = np.array(reference("se_beam_16")["reference"]["full_clamped_free_omega"][:5])
    rows = re.findall(r'^\| (\d) \| `"(\w+)"` \| (.*) \|$', PAGE, re.M)
    assert len(rows) == 8
    for count, method, errors in rows:
        omega = beam(method=method, modes=int(count)).modes(["root"]).frequencies[:5]
        found = omega / exact[: len(omega)] - 1
        for stated, error in zip_longest(errors.split(" | "), found):
            if stated == "–":
                assert error is None or error > 0.3
            else:
                np.testing.assert_allclose(error, float(stated), rtol=0.35)


def test_the_errors_of_two_beams() -> None:
    """Those of the reference, whose frequencies scenes with superelements have."""
    known = reference("coupled_L_frame_A")["reference"]
    for name, method in (("cb", "craig_bampton"), ("rubin", "rubin")):
        errors = np.abs(np.array(known[f"{name}_6_6_omega"]) / known["full_omega"][:6] - 1)
        stated = re.search(rf'by (\S+) to (\S+)\swith\s`"{method}"`', PAGE)
        assert stated is not None
        found = errors.min(), errors.max()
        np.testing.assert_allclose(found, [float(x) for x in stated.groups()], rtol=0.2)


@pytest.mark.slow
def test_the_blades_of_the_page() -> None:
    assert_same_table(blades.table(), atol=0.011)


@pytest.mark.slow
def test_the_forms_of_the_inertia_of_the_page() -> None:
    assert_same_table(slider_crank.forms(), rtol=0.06)


@pytest.mark.slow
def test_the_slider_crank_of_the_page() -> None:
    """Superelements tend to beams: the largest bow, and the bow throughout."""
    truth = slider_crank.beams().bow
    parts = [slider_crank.superelements(count).bow for count in (1, 2, 4)]
    largest = [np.abs(bow).max() / np.abs(truth).max() - 1 for bow in parts]
    apart = [np.abs(bow - truth).max() / np.abs(truth).max() for bow in parts]
    print("1, 2, 4 superelements: largest bow", largest, "largest difference", apart)
    stated = re.search(r"comes out (\d+) % too large with one superelement, (\d+) % with\s", PAGE)
    assert stated is not None
    found = 100 * np.array([largest[0], largest[2]])
    np.testing.assert_allclose(found, [float(one) for one in stated.groups()], atol=1.0)
    assert apart[0] > 3 * apart[1] > 6 * apart[2]


def assert_same_table(table: str, **tolerances: float) -> None:
    """The page has these lines; numbers may differ a little between machines."""
    for line in (one for one in table.splitlines() if not one.startswith("|---")):
        label = line.split(" | ")[0]
        alike = (x for x in PAGE.splitlines() if x.startswith(f"{label} |"))
        (stated,) = (x for x in alike if x.count("|") == line.count("|"))
        numbers = (re.findall(r"[-+]?\d[\d.e+-]*", x.removeprefix(label)) for x in (line, stated))
        found, expected = (np.array([float(x) for x in row]) for row in numbers)
        np.testing.assert_allclose(found, expected, err_msg=line, **tolerances)


def test_every_method_and_file_is_on_the_page() -> None:
    assert all(f'`"{method}"`' in PAGE for method in cd.superelement.METHODS)
    assert all(reader.endings[0] in PAGE or reader.untested for reader in cd.superelement.READERS)
