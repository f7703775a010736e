"""Files of older versions stay readable."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import cardan as cd

SAVED = Path(__file__).parents[1] / "references" / "saved"


def test_a_motion_of_format_1(tmp_path: Path) -> None:
    motion, table = cd.load_motion(SAVED / "run_1.nc"), np.load(SAVED / "run_1.npy")
    parts = (motion.t[:, None], motion.x, motion.r, motion.s, motion.pose("rod")[:, :3, 3])
    np.testing.assert_array_equal(np.concatenate(parts, axis=1), table)
    (event,) = motion.events
    assert (event.name, event.kind) == ("stop.lower", "impact")
    assert motion.energy.total[-1] == pytest.approx(-4.347714837426282, rel=1e-15)
    assert "lost in impacts 0.9999" in repr(motion)
    # between its rows, and in a page, by its coordinates alone
    turned = motion.resample([0.1, 0.2]).pose("rod")
    np.testing.assert_allclose(turned[:, 0, 0], np.cos(motion.at([0.1, 0.2])[:, 0]), atol=1e-15)
    assert motion.animate(tmp_path / "page.html").stat().st_size > 10_000
    # saved again it has a hash
    again = cd.load_motion(motion.save(tmp_path / "run.nc"))
    np.testing.assert_array_equal(again.x, motion.x)


def test_an_ensemble_without_a_format(tmp_path: Path) -> None:
    runs = cd.load_ensemble(SAVED / "ensemble_0.nc")
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
