"""Checkpoints go on where their build is the one of today, and are refused in words elsewhere."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan import version
from cardan.analyses.simulation.files import append_log
from compatibility.write import FILES, KEEP, START, VARIED, model


def ahead_of_a_stepper(path: Path) -> np.ndarray:
    stepper = model().resume(path)
    stepper.step(0.1)
    return np.asarray(stepper.state)


def rows_of_a_run(path: Path) -> np.ndarray:
    return model().simulate(0.2, **START, checkpoint=path, every=0).x


def ends_of_an_ensemble(path: Path) -> np.ndarray:
    return model().ensemble(**VARIED, reduce=KEEP, threads=1, checkpoint=path).final


USES: dict[str, tuple[Callable[[Path], np.ndarray], str]] = {
    "stepper": (ahead_of_a_stepper, "ahead"),
    "run_file": (rows_of_a_run, "run"),
    "ensemble_file": (ends_of_an_ensemble, "ensemble"),
}
CASES = [
    pytest.param(path, kind, id=path.stem)
    for kind in USES
    for path in sorted(FILES.glob(f"{kind}_[0-9]*"))
]


@pytest.mark.parametrize(("path", "kind"), CASES)
def test_a_checkpoint_goes_on_or_is_refused(path: Path, kind: str, tmp_path: Path) -> None:
    """Equations, compiler and processor decide which: their bits are in the file."""
    use, name = USES[kind]
    found, refused = None, ""
    try:
        found = use(Path(shutil.copy(path, tmp_path)))
    except cd.ModelError as error:
        refused = str(error)
    if found is None:
        assert "cardan 0.1.0" in refused
        assert "anew" in refused
    else:
        expected = np.load(FILES / "checkpoints.npz")[name]
        np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-6)


def of_a_newer_cardan(form: version.Format, path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Write a checkpoint as a cardan of tomorrow does."""
    newer = form._replace(version=form.version + 7, oldest=form.version + 7)
    with monkeypatch.context() as patch:
        patch.setattr(append_log, "VERSION", "9.8.7")
        append_log.AppendLog(path, newer, {"model": "of tomorrow"}, {}).close()


@pytest.mark.parametrize("kind", ["run_file", "ensemble_file"])
def test_a_checkpoint_of_a_newer_cardan_is_refused(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    form = {"run_file": version.RUN_FILE, "ensemble_file": version.ENSEMBLE_FILE}[kind]
    path = tmp_path / "runs.part"
    of_a_newer_cardan(form, path, monkeypatch)
    before = path.read_bytes()
    with pytest.raises(cd.ModelError) as refused:
        USES[kind][0](path)
    told = str(refused.value)
    assert form.refusal(f"checkpoint {path}", form.version + 7, "9.8.7") == told
    # what it cannot read it leaves alone
    assert path.read_bytes() == before


def test_a_stepper_of_a_newer_cardan_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from cardan.analyses.simulation.files import checkpoint

    path, made = tmp_path / "stepper.npz", model()
    number = version.STEPPER.version + 1
    newer = version.STEPPER._replace(version=number, oldest=number)
    with monkeypatch.context() as patch:
        patch.setattr(checkpoint, "STEPPER", newer)
        patch.setattr(checkpoint, "VERSION", "9.8.7")
        made.stepper(**START).save(path)
    with pytest.raises(cd.ModelError) as refused:
        made.resume(path)
    assert str(refused.value) == version.STEPPER.refusal(path, number, "9.8.7")


def test_a_checkpoint_of_other_equations_names_its_writer(tmp_path: Path) -> None:
    """What the generator writes may change between two versions with one format."""
    path, made = tmp_path / "stepper.npz", model()
    made.stepper(**START).save(path)
    with pytest.raises(cd.ModelError, match=r"cardan 0\.1\.0 wrote it.* start the run anew"):
        made.with_parameters(m=2.0).resume(path)


def other_run(path: Path) -> Any:
    return model().simulate(0.3, **START, checkpoint=path, every=0)


def test_a_checkpoint_of_another_run_names_its_writer(tmp_path: Path) -> None:
    path = tmp_path / "run.part"
    rows_of_a_run(path)
    with pytest.raises(cd.ModelError, match=r"cardan 0\.1\.0 wrote it.* to begin anew"):
        other_run(path)
