"""Motions of the benchmark: problems, tables and figures, whoever is installed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.motion import page
from benchmarks.motion.contest import LOST, Outcome, Row, fronts, measure
from benchmarks.motion.figures import Measured, figures, ratio
from benchmarks.motion.problem import Task
from benchmarks.motion.problems import PROBLEMS
from benchmarks.motion.programs import PEERS, PROGRAMS, ours
from benchmarks.motion.programs.program import Entry, Program, present, willing

DOUBLE = PROBLEMS["double_pendulum"]


def row(program: str, method: str, seconds: float, error: float, setting: float = 1e-9) -> Row:
    return Row(program, method, setting, seconds, seconds, error)


def found() -> Measured:
    rows = (
        row(ours.NAME, "DOP853", 2e-4, 1e-6),
        row(ours.NAME, "DOP853", 5e-4, 1e-10),
        row("CasADi", "CVODES Adams", 6e-3, 9e-10),
        row("MuJoCo", "RK4", 1e-3, 1e-3, 1000),
    )
    absent = {"Exudyn": "joint 'a' is revolute along [1, 1, 0]"}
    outcome = Outcome(DOUBLE, rows, 1e-13, absent, {"CasADi CVODES BDF": [1e-4]})
    return Measured(
        {"double_pendulum": outcome}, gain=6.0, lacking={"Panda": "its file is not here"}
    )


def test_every_line_is_there_and_says_what_was_not_measured() -> None:
    lines = {figure.name: figure.texts()[1:] for figure in figures(found())}
    assert lines["double pendulum, 10 s to 1e-09 m"] == ("≤ 1 ms", "0.5 ms", "reached")
    assert lines["double pendulum, 10 s to 1e-09 m, fastest other of ours"][1:] == ("12", "reached")
    assert lines["ten-link pendulum, 10 s to 1e-10 m"] == ("≤ 3 ms", "not measured", "missed")
    assert lines["Panda, ensemble in lanes, of one by one"] == ("≥ 5", "6", "reached")
    missing = sum(bool(program.missing()) for program in PEERS)
    verdict = "missed" if missing else "reached"
    assert lines["programs beside cardan that took part"] == ("≥ 5", str(5 - missing), verdict)


def test_who_does_not_get_as_far_is_compared_where_it_gets() -> None:
    rows = (row(ours.NAME, "RK45", 1e-3, 5e-8), row("Exudyn", "GeneralizedAlpha", 5e-3, 4e-6))
    absent = {"MuJoCo": "soft"}
    measured = Measured({"andrews": Outcome(PROBLEMS["andrews"], rows, 1e-13, absent)})
    lines = {figure.name: figure.texts()[2] for figure in figures(measured)}
    assert lines["Andrews' squeezer to 1e-07 rad, Exudyn (to 4e-06 only) of ours"] == "5"
    assert lines["Andrews' squeezer to 1e-07 rad, CasADi of ours"] == "not measured"
    assert not any("squeezer" in name and "MuJoCo" in name for name in lines)


def test_only_runs_that_are_right_enough_count() -> None:
    outcome = found().outcomes["double_pendulum"]
    assert outcome.best(1e-5, (ours.NAME,)) == outcome.rows[0]
    assert outcome.best(1e-5, ("MuJoCo",)) is None
    assert ratio(found(), "double_pendulum", 1e-9, ("CasADi", "MuJoCo")) == pytest.approx(12)
    assert ratio(found(), "double_pendulum", 1e-12, ("CasADi",)) is None


def test_tables_and_notes() -> None:
    outcome = found().outcomes["double_pendulum"]
    headings, rows = page.fastest(outcome)
    assert all(len(line) == len(headings) for line in rows)
    assert rows[0][0] == ours.NAME
    assert "0.5 (DOP853)" in rows[0]
    assert all(len(line) == len(page.HEADINGS) for line in page.lines(outcome))
    assert len(list(fronts(outcome))) == 3
    notes = "\n".join(page.left_out(found()))
    assert "Exudyn was not measured: joint 'a' is revolute along [1, 1, 0]" in notes
    assert "Panda was not measured: its file is not here" in notes
    assert "CasADi CVODES BDF lost the motion or gave up at 0.0001" in notes


def test_page_and_pictures(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from benchmarks.motion import pictures

    measured = found()
    page.write(measured, figures(measured), tmp_path)
    pictures.write(dict(measured.outcomes), tmp_path / "runs")
    text = (tmp_path / "runs.md").read_text("utf-8")
    assert "![time against error](runs/double_pendulum.svg)" in text
    assert "another way to it is 1.0e-13 m apart." in text.replace("\n", " ")
    assert "| CasADi | CVODES Adams | 1e-09 | 6 | 6 | 9.0e-10 |" in text
    # the same bytes for the same numbers
    first = (tmp_path / "runs" / "double_pendulum.svg").read_bytes()
    pictures.write(dict(measured.outcomes), tmp_path / "runs")
    assert (tmp_path / "runs" / "double_pendulum.svg").read_bytes() == first


def test_a_contest_without_other_programs() -> None:
    def wrong() -> np.ndarray:
        return np.full(2, 1e3)

    def gives_up() -> np.ndarray:
        raise ValueError("too small a step")

    fake = Program(
        "fake",
        present,
        willing,
        lambda task: [Entry("fake", "wrong", 1, wrong), Entry("fake", "none", 2, gives_up)],
    )

    def cannot(task: Task) -> list[Entry]:
        raise RuntimeError("no compiler\nin detail")

    gone = Program("gone", lambda: "not installed: pip install gone", willing, lambda task: [])
    broken = Program("broken", present, willing, cannot)
    small = replace(DOUBLE, methods={"DOP853": (1e-6, 1e-8)}, end=0.5)
    outcome = measure(small, (ours.PROGRAM, fake, gone, broken), 2, lambda text: None)
    assert [r.setting for r in outcome.rows] == [1e-6, 1e-8]
    assert outcome.rows[1].error < outcome.rows[0].error < 1e-5 < LOST
    assert outcome.doubt < 1e-12
    assert outcome.lost == {"fake wrong": [1], "fake none": [2]}
    assert outcome.absent == {"gone": "not installed: pip install gone", "broken": "no compiler"}


def test_members() -> None:
    assert len(PROBLEMS) == 6
    assert [name for name, problem in PROBLEMS.items() if problem.name != name] == []
    assert PROGRAMS[0].name == ours.NAME
    for problem in PROBLEMS.values():
        # fewer digits first
        settings = [*problem.methods.values(), problem.tolerances]
        assert all(sorted(each, reverse=True) == list(each) for each in settings)
        assert list(problem.steps) == sorted(problem.steps)
