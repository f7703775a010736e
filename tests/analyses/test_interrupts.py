"""Ctrl-C where Python evaluates the model: what was computed is kept, also below C frames."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from analyses.conftest import double_scene
from analyses.interpreted import (
    assembled,
    beam,
    four_bar,
    interrupted,
    loaded,
    many,
    simulated,
)
from cardan.ir import straight_line

WAITED = 300  # seconds for a process of its own, on a busy machine
# scene, work, calls of model functions before Ctrl-C, words of the warning
WORK: dict[str, tuple[Callable[[], cd.Model], Callable[..., Any], int, str]] = {
    "simulate": (double_scene, simulated, 3000, "interrupted at t = "),
    "simulate a beam": (beam, simulated, 2000, "interrupted at t = "),
    "ensemble": (double_scene, many, 20_000, "interrupted"),
    "assembly": (four_bar, assembled, 2000, "interrupted after"),
    "statics": (beam, loaded, 20_000, "interrupted behind"),
}


@pytest.mark.parametrize("start", ["fork", "spawn"])
@pytest.mark.parametrize("name", WORK)
def test_what_was_computed_is_kept(name: str, start: str, tmp_path: Path) -> None:
    if start not in multiprocessing.get_all_start_methods():
        pytest.skip("processes are not forked here")
    build, work, calls, words = WORK[name]
    model = cd.compile(build(), directory=tmp_path / "model")
    # what is written now is all that the other process has
    model.prepare()
    work_once(model, name)
    context = multiprocessing.get_context(start)
    mine, theirs = context.Pipe(duplex=False)
    place = str(model.directory)
    process = context.Process(target=interrupted, args=(work, calls, place, theirs))
    process.start()
    theirs.close()
    try:
        assert mine.poll(WAITED), "nothing came back"
        found = mine.recv()
    finally:
        process.join(WAITED)
        process.kill()
    assert process.exitcode == 0
    assert found["status"] == "interrupted"
    assert found["rows"] > 0
    assert found["calls"] > calls
    assert any(words in said for said in found["said"]), found["said"]
    assert found.get("gap", 0.0) < 1e-9


def work_once(model: cd.CompiledModel, name: str) -> None:
    """Write the functions that the work needs, while there is a compiler."""
    if name == "assembly":
        model.assemble({"A": 0.5}, starts=2)
    elif name == "statics":
        model.statics(hold={"pin": (0.0, 0.1)}, steps=1)
    else:
        model.simulate(1e-2, method="RK4", step=1e-3)


@pytest.mark.parametrize("error", [ZeroDivisionError("mine"), SystemExit(3), MemoryError()])
@pytest.mark.parametrize("build", [double_scene, beam])
def test_what_a_function_raises_comes_through(
    build: Callable[[], cd.Model], error: BaseException, bare: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Errors of any kind cross the C frames, and the model goes on after them."""
    model = cd.compile(build())
    motion = model.simulate(5e-3, method="RK4", step=1e-3)
    # none before all is loaded and judged
    usual, calls = straight_line.straight_line, [-(10**9)]

    def failing(function: Any) -> Callable[..., list[float]]:
        evaluate = usual(function)

        def evaluated(*blocks: Any) -> list[float]:
            calls[0] += 1
            if calls[0] == 40:
                raise error
            return evaluate(*blocks)

        return evaluated

    monkeypatch.setattr(straight_line, "straight_line", failing)
    other = bare(model)
    other.simulate(5e-3, method="RK4", step=1e-3)
    calls[0] = 0
    with pytest.raises(type(error) if not isinstance(error, MemoryError) else cd.SolveError):
        other.simulate(5e-2, method="RK4", step=1e-3, check=True)
    again = other.simulate(5e-3, method="RK4", step=1e-3)
    assert again.x[-1] == pytest.approx(motion.x[-1], abs=1e-9)
