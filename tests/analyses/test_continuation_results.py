"""Paths as files, tables and pages, and as load paths of statics."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import netcdf_file

from analyses.test_continuation import EXACT, truss, two_links
from cardan.errors import ModelError, SolveWarning


def test_paths_as_files_tables_and_pages(tmp_path: Path) -> None:
    path = two_links().continuation(P=(0, 4), branches=1, bounds={"theta": (-1.4, 1.4)})
    table = path.table()
    rows = sum(len(branch) for branch in path.branches.values())
    assert all(column.shape == (rows,) for column in table.values())
    on_branch = table["branch"] == 1
    theta = table["theta"][on_branch]
    np.testing.assert_allclose(table["P"][on_branch], 2 * theta / np.sin(theta), rtol=1e-10)
    lines = path.save(tmp_path / "path.csv").read_text("utf-8").splitlines()
    assert len(lines) == rows + 1
    assert lines[0].startswith("branch_name,P,theta,middle,slide,stable")
    with netcdf_file(path.save(tmp_path / "path.nc"), mmap=False) as file:
        np.testing.assert_array_equal(file.variables["theta"][:], table["theta"])
        kinds = file.variables["point_kind"][:]
        assert b"branch point" in b"".join(kinds[0])
    page = path.animate(tmp_path / "page.html", branch="1a").path.read_text("utf-8")
    assert "two_links" in page
    with pytest.raises(ModelError, match="Did you mean '1a'"):
        path.animate(tmp_path / "page.html", branch="1aa")


def test_statics_by_length() -> None:
    """The same rows through limit loads, which end a path of loads."""
    model = truss(3.0)
    with pytest.warns(SolveWarning, match="more stably|unstable from a load"):
        path = model.statics(P=(0, 2), arc=True)
    assert path.success
    assert path["P"][-1] == pytest.approx(2.0)
    loads = [values["P"] for values in path.critical()]
    wanted = [point["P"] for point in model.continuation(P=(0, 2)).points[:-1]]
    np.testing.assert_allclose(loads, wanted, atol=EXACT)
    assert [crossing.of for crossing in path.crossings].count("limit") == 2
    for row in path:
        assert row.converged
    with pytest.raises(ModelError, match="arc=True give"):
        model.statics(P=[0, 1, 2], arc=True)
