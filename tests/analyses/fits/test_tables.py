"""Tables of measurements: what is wrong in them is said by line and column."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from analyses.fits.test_search import swing
from cardan.analyses.identification.data import read
from cardan.errors import ArgumentError
from table import each

BROKEN = {
    "a word": ("t,tip\n0,1\n0.1,two\n", r"line 3, column 'tip': 'two' is not a number; leave"),
    "a comma": ('t,tip\n0,"1,5"\n', r"line 2, column 'tip': '1,5' .* with a point instead"),
    "a cell too many": ("t,tip\n# said\n0,1\n0.1,2,3\n", "line 4: 3 cells, .* 2 columns: t, tip"),
    "a name twice": ("t,tip,tip\n0,1,2\n", "line 1: 'tip' is the name of several columns"),
    "no lines": ("t,tip\n", "give a line of names, such as t,elbow, and lines of numbers"),
    "no numbers": ("", "give a line of names"),
}


@each("case", list(BROKEN))
def test_what_is_wrong_is_told_by_its_place(case: str, tmp_path: Path) -> None:
    text, message = BROKEN[case]
    file = tmp_path / "run.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ArgumentError, match=message):
        read(file)


def test_blank_cells_were_not_measured(tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    file.write_text("t [s],x\n0,1\n0.1,\n0.2, \n0.3,nan\n0.4,5\n", encoding="utf-8")
    np.testing.assert_array_equal(read(file)["x"], [1.0, np.nan, np.nan, np.nan, 5.0])
    times = np.linspace(0, 2, 41)
    tip = swing().simulate(times, q={"hinge": 0.5}, rtol=1e-9)["tip"]
    lines = [f"{t},{'' if k % 3 else x}" for k, (t, x) in enumerate(zip(times, tip, strict=True))]
    file.write_text("\n".join(["t,tip", *lines]), encoding="utf-8")
    fit = swing().fit(file, unknown=("length",), q={"hinge": 0.5}, parameters={"length": 0.9})
    assert fit.parameters["length"] == pytest.approx(0.8, rel=1e-7)
    assert np.isfinite(fit.residuals["tip"]).sum() == 14


def test_missing_times_are_asked_for() -> None:
    with pytest.raises(ArgumentError, match=r"no column 't' of times: call it 't' or 't \[s\]'"):
        swing().fit({"time": [0, 1], "tip": [0, 1]}, unknown="length")
    with pytest.raises(ArgumentError, match=r"Its columns: time, tip"):
        swing().fit({"time": [0, 1], "tip": [0, 1]}, unknown="length")
    with pytest.raises(cd.ArgumentError, match=r"call their column 't'.* There are: time, hinge"):
        swing().identify({"time": [0, 1], "hinge": [0, 1]})
