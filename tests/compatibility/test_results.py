"""Runs and ensembles that were saved once are read for ever, with the same numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan import version
from cardan.runtime import formats
from cardan.runtime.formats.contents import Contents
from cardan.runtime.trajectory import storage
from compatibility.write import FILES, STORED, of_ensemble, of_motion

RUNS = sorted(path for path in FILES.glob("run_*.nc") if path.with_suffix(".npz").exists())
ENSEMBLES = sorted(
    path for path in FILES.glob("ensemble_*.nc") if path.with_suffix(".npz").exists()
)


@pytest.mark.parametrize("path", RUNS, ids=lambda path: path.stem)
def test_a_run_has_the_numbers_it_had(path: Path, tmp_path: Path) -> None:
    expected = np.load(path.with_suffix(".npz"))
    motion = cd.load_motion(path)
    found = of_motion(motion)
    assert set(found) == set(expected.files)
    for name in STORED:
        np.testing.assert_array_equal(found[name], expected[name])
    for name in set(found) - {*STORED}:
        scale = np.abs(expected[name]).max(initial=1e-300)
        np.testing.assert_allclose(found[name], expected[name], rtol=1e-12, atol=1e-12 * scale)
    again = cd.load_motion(motion.save(tmp_path / "run.nc"))
    np.testing.assert_array_equal(again.x, motion.x)
    assert motion.animate(tmp_path / "page.html").path.stat().st_size > 10_000


@pytest.mark.parametrize("path", ENSEMBLES, ids=lambda path: path.stem)
def test_an_ensemble_has_the_numbers_it_had(path: Path) -> None:
    expected, found = np.load(path.with_suffix(".npz")), of_ensemble(cd.load_ensemble(path))
    assert set(found) == set(expected.files)
    for name, values in found.items():
        np.testing.assert_array_equal(values, expected[name])


def test_a_motion_of_format_1(tmp_path: Path) -> None:
    """Before files had hashes."""
    motion, table = cd.load_motion(FILES / "run_1.nc"), np.load(FILES / "run_1.npy")
    parts = (motion.t[:, None], motion.x, motion.r, motion.s, motion.pose("rod")[:, :3, 3])
    np.testing.assert_array_equal(np.concatenate(parts, axis=1), table)
    (event,) = motion.events
    assert (event.name, event.kind) == ("stop.lower", "impact")
    assert motion.energy.total[-1] == pytest.approx(-4.347714837426282, rel=1e-15)
    assert "impacts 0.9999" in repr(motion)
    # between its rows, and in a page, by its coordinates alone
    turned = motion.resample([0.1, 0.2]).pose("rod")
    np.testing.assert_allclose(turned[:, 0, 0], np.cos(motion.at([0.1, 0.2])[:, 0]), atol=1e-15)
    assert motion.animate(tmp_path / "page.html").path.stat().st_size > 10_000
    # saved again it has a hash
    again = cd.load_motion(motion.save(tmp_path / "run.nc"))
    np.testing.assert_array_equal(again.x, motion.x)


def test_an_ensemble_without_a_format(tmp_path: Path) -> None:
    runs = cd.load_ensemble(FILES / "ensemble_0.nc")
    assert runs.status.tolist() == ["finished"] * 3
    np.testing.assert_array_equal(runs["pivot"], runs.final[:, 0])
    assert runs["max of pivot"].tolist() == [0.0, 0.0, 0.028403262762516004]
    assert runs["mean of pivot"][3] == -0.12030501525478367
    bins = runs["histogram of pivot from -0.25 to 0 in 3"]
    assert bins.counts.tolist() == [1, 1, 0]
    np.testing.assert_allclose(bins.edges, np.linspace(-0.25, 0, 4), atol=1e-16)
    assert runs["states"].shape == (3, 4, 2)
    assert runs.varied["pivot"].tolist() == [-1.0, -2.0, -3.0]
    with pytest.raises(cd.ModelError, match="does not say which entries are coordinates"):
        _ = runs.q
    again = cd.load_ensemble(runs.save(tmp_path / "runs.nc"))
    np.testing.assert_array_equal(again["states"], runs["states"])


def test_a_run_under_former_names_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cardan of tomorrow, to which speeds were ``u`` and their rows ``speeds``."""
    path = sorted(FILES.glob("run_2_*.nc"))[0]
    here = cd.load_motion(path)
    contents = formats.load(path, version.RUN, ("title", *storage.NOTES))
    variables = {{"u": "rates"}.get(name, name): x for name, x in contents.variables.items()}
    notes = {**contents.notes}
    notes["manifest"] = notes["manifest"].replace('"speeds"', '"rates"')
    file = formats.save(tmp_path / "run.nc", version.RUN, Contents(variables, notes), "")
    number = version.RUN.version
    renamed = {number: {"rates": "u", "manifest.rates": "speeds"}}
    tomorrow = version.RUN._replace(version=number + 1, renamed=renamed)
    monkeypatch.setattr(storage, "RUN", tomorrow)
    motion = cd.load_motion(file)
    np.testing.assert_array_equal(motion.x, here.x)
    assert motion.manifest["speeds"] == here.manifest["speeds"]
