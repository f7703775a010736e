"""The table of figures: what is missed or missing is said, whatever could be measured."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks import all_figures, gradient_figures, paths, profiles, superelement_page
from benchmarks.batches import Way
from benchmarks.figures import MULTIPLE, Figure, figures, multiple, ratio
from benchmarks.measure import Found
from benchmarks.page import left_out, markdown, sections, slower
from cardan.peers.comparison import LANES, OURS, Comparison, Row
from cardan.peers.contest import Time
from cardan.peers.processor import Peak

COUNTS = {"panda": {"forward_dynamics": {"mul": 600, "add": 500, "trig": 12}}}


def row(program: str, seconds: float, error: float = 1e-16) -> Row:
    return Row(program, program, "forward_dynamics", Time(seconds, seconds), error, None)


def found() -> Found:
    rows = (row(OURS, 1e-7), row(LANES, 2e-8, 3e-16), row("casadi", 2e-7))
    comparison = Comparison(rows, {"pydy": "more than 5 bodies"}, 10.0)
    lacking = {"UR5": "its file is not here"}
    return Found({"panda": comparison}, {}, COUNTS, lacking, Peak(16.0, 120.0, 8), 8)


def test_every_line_is_there_and_says_what_was_not_measured() -> None:
    lines = {figure.name: figure.texts()[1:] for figure in figures(found())}
    assert lines["operations, Panda, forward dynamics"] == ("≤ 1165", "1100", "reached")
    assert lines["forward dynamics, Panda, of CasADi's time"] == ("≤ 0.55", "0.5", "reached")
    not_here = ("≤ 0.16", "not measured", "missed")
    assert lines["forward dynamics, Panda, of Pinocchio's time"] == not_here
    assert lines["Panda, forward dynamics, batch, per state"] == ("≤ 24 ns", "20 ns", "reached")
    # 1,100 operations and six sines with cosines, in 20 ns of a processor that does 120 per ns
    assert lines["Panda, forward dynamics, batch, of the peak"][1:] == ("57.8 %", "reached")


def test_an_ensemble_is_measured_against_our_own_loop() -> None:
    lines = {figure.name: figure for figure in figures(found())}
    name = "ensemble of Panda, runs per time, of our loop in C"
    assert lines[name].value is None
    measured = replace(found(), ensembles={"panda": (1e-4, 2.5e-5)})
    line = next(figure for figure in figures(measured) if figure.name == name)
    assert (line.value, line.reached) == (4.0, False)


def test_preparing_many_bodies() -> None:
    measured = replace(found(), prepared={"chain": 4.0, "tree": 44.0})
    lines = {figure.name: figure for figure in figures(measured)}
    assert lines["prepare 10,000 bodies, chain"].texts()[1:] == ("≤ 5 s", "4 s", "reached")
    assert not lines["prepare 10,000 bodies, random tree"].reached
    absolute = lines["prepare 10,000 bodies, chain in absolute coordinates"]
    assert absolute.texts()[2] == "not measured"


def test_ways_of_a_batch_and_a_second_thread() -> None:
    ways = [Way("rows", 3e-8, 0.0), Way("structure of arrays, float32", 1e-8, 4e-7)]
    measured = replace(found(), batches={"panda": ways}, threads={"panda": None})
    lines = {figure.name: figure for figure in figures(measured)}
    name = "Panda, forward dynamics, batch from Python"
    assert lines[f"{name}, rows"].reached
    assert lines[f"{name}, structure of arrays"].value is None
    assert lines[f"{name}, structure of arrays, float32"].texts()[2] == "10 ns"
    assert not lines["Panda, forward dynamics, two threads, of one"].reached
    assert any("a second thread was not measured" in note for note in left_out(measured))
    table = next(rows for title, _, rows in sections(measured) if "many states" in title)
    assert [row[-1] for row in table] == ["1.00", "3.00", "not measurable"]


def test_ratio_and_error_are_those_of_the_rows() -> None:
    assert ratio(found(), "panda", "forward_dynamics", "casadi", LANES) == 0.1
    assert ratio(found(), "panda", "forward_dynamics", "mujoco") is None
    assert 0.13 < multiple(found().comparisons["panda"]) < 0.14 < MULTIPLE


def test_more_is_better_where_it_is_said() -> None:
    assert Figure("share", 45, 50.0, "%", least=True).reached
    assert not Figure("share", 45, 40.0, "%", least=True).reached
    assert not Figure("time", 45, None).reached


def test_who_was_left_out_is_named_once_with_the_reason() -> None:
    text = "\n".join(left_out(found()))
    assert "UR5 was not measured: its file is not here" in text
    assert "on Panda, fingers fixed: more than 5 bodies" in text


def test_tables_have_as_many_cells_as_headings() -> None:
    for _, headings, lines in sections(found()):
        assert all(len(line) == len(headings) for line in lines)
        assert len(markdown(headings, lines)) == 2 + len(lines)


def test_the_table_of_all_has_the_missed_first(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(all_figures, "SAVED", tmp_path / "out" / "figures")
    all_figures.save("a.md", [("one", "≤ 1", "0.5", "reached"), ("two", "≤ 1", "2", "missed")])
    all_figures.save("b.md", [("three", "≤ 1 us", "2 us", "no")])
    assert all_figures.saved() == [
        ("two", "≤ 1", "2", "no", "a.md"),
        ("three", "≤ 1 us", "2 us", "no", "b.md"),
        ("one", "≤ 1", "0.5", "yes", "a.md"),
    ]


def test_every_program_with_figures_leaves_them() -> None:
    """A page that says what is to be reached has its rows in the table of all."""
    folder = Path(__file__).parent
    makefile = (folder.parents[1] / "Makefile").read_text("utf-8").replace("\\\n", " ")
    (listing,) = re.findall(r"^BENCHMARKS = (.*)$", makefile, re.MULTILINE)
    programs = {*listing.split()} - {"all_figures"}
    assert len(programs) >= 10
    texts = {name: (folder / f"{name}.py").read_text("utf-8") for name in programs}
    assert not [name for name, text in texts.items() if not re.search(r"^    save\(", text, re.M)]


def test_rows_of_paths_gradients_profiles_and_superelements() -> None:
    path = paths.Row("cantilever, 1000 elements", 6001, 10, 35, 0.0, 0.24, 1e-13)
    long = replace(path, name="cantilever, 16000 elements", whole=7.2)
    assert [row[2:] for row in paths.figures([path, long])] == [("24.0 ms", "yes"), ("30.0", "no")]
    rows = [
        ("double pendulum (5 parameters)", "cardan", "", "", "2.0", "1", ""),
        ("", "CVODES", "", "", "10", "83", ""),
        ("", "CVODES", "", "", "10", "79", ""),
    ]
    by_lanes = [("double pendulum", "13 / 13", "8 / 8", "10 / 11")]
    assert [row[2:] for row in gradient_figures.figures(rows, by_lanes)] == [
        ("2", "yes"), ("79", "no"), ("10 ns", "yes"),
    ]  # fmt: skip
    split = [("a call", "2 s", "2 s", "1 s: C", "2.0", "C"), ("a run", "2 s", "", "0 s", "", "C")]
    assert list(profiles.figures(split)) == [("a call, by its floor", "≤ 3", "2.0", "yes")]
    brick = superelement_page.Call("root", "balance", 9, True, 361.0, 1e-16)
    crank = superelement_page.Step("chord frame", 24, 7.6, 2.26, 7e-7)
    every = superelement_page.Found([brick], [], [crank], [], 0.0)
    saved = [row[2:] for row in superelement_page.figures(every)]
    assert saved == [("361 ns", "yes"), ("2.26", "no")]


def test_programs_that_are_faster_are_named() -> None:
    measured = found()
    assert list(slower(measured)) == []
    quick = replace(measured.comparisons["panda"], rows=(row(OURS, 1e-7), row("casadi", 8e-8)))
    assert list(slower(replace(measured, comparisons={"panda": quick}))) == [
        "Panda, fingers fixed, forward dynamics: CasADi takes 0.80 of our time"
    ]
