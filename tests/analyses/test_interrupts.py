"""Ctrl-C where Python evaluates the model: what was computed is kept, also below C frames."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Sequence
from itertools import product
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from analyses.conftest import double_scene
from analyses.interpreted import assembled, beam, four_bar, interrupted, loaded, many, simulated
from cardan.ir import straight_line
from spread import some

WAITED = 300  # seconds for a process of its own, on a busy machine
# scene, work, calls of model functions before Ctrl-C, words of the warning
WORK: dict[str, tuple[Callable[[], cd.Scene], Callable[..., Any], int, str]] = {
    "simulate": (double_scene, simulated, 3000, "interrupted at t = "),
    "simulate a beam": (beam, simulated, 2000, "interrupted at t = "),
    "ensemble": (double_scene, many, 20_000, "interrupted"),
    "assembly": (four_bar, assembled, 2000, "interrupted after"),
    "statics": (beam, loaded, 20_000, "interrupted behind"),
}


@pytest.mark.parametrize(("name", "start"), some(product(WORK, ("fork", "spawn")), 3))
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
        model.statics(locked={"pin": (0.0, 0.1)}, steps=1)
    else:
        model.simulate(1e-2, method="RK4", step=1e-3)


class Calls:
    """Model functions that do something at one of their calls.

    Attributes:
        left: Calls until then.
        action: What they do.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch, action: Callable[[], object]) -> None:
        self.left, self.action = -1, action
        usual = straight_line.straight_line
        monkeypatch.setattr(straight_line, "straight_line", lambda f: self.counted(usual(f)))

    def counted(self, evaluate: Callable[..., list[float]]) -> Callable[..., list[float]]:
        """A function that counts its calls."""

        def evaluated(*blocks: Sequence[float]) -> list[float]:
            self.left -= 1
            if self.left == 0:
                self.action()
            return evaluate(*blocks)

        return evaluated


def raising(error: BaseException) -> Callable[[], object]:
    """What raises an error."""

    def action() -> None:
        raise error

    return action


def test_a_stepper_goes_on_after_ctrl_c(bare: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    model = cd.compile(double_scene())
    calls = Calls(monkeypatch, lambda: signal.raise_signal(signal.SIGINT))
    stepper = bare(model).stepper(q={"elbow": 0.4}, method="RK4", step=1e-3)
    stepper.step(0.01)
    calls.left = 40
    with pytest.raises(KeyboardInterrupt):
        stepper.step(1.0)
    assert 0.01 < stepper.t < 1.0
    stepper.step(1.0 - stepper.t)
    whole = model.simulate(1.0, q={"elbow": 0.4}, method="RK4", step=1e-3)
    # the same grid of steps but for one around the interrupt, of order 4
    assert stepper.state == pytest.approx(whole.x[-1], abs=1e-8)


@pytest.mark.parametrize("error", [ZeroDivisionError("mine"), SystemExit(3), MemoryError()])
@pytest.mark.parametrize("build", [double_scene, beam])
def test_what_a_function_raises_comes_through(
    build: Callable[[], cd.Scene], error: BaseException, bare: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Errors of any kind cross the C frames, and the model goes on after them."""
    model = cd.compile(build())
    motion = model.simulate(5e-3, method="RK4", step=1e-3)
    calls = Calls(monkeypatch, raising(error))
    other = bare(model)
    # all is loaded and judged
    other.simulate(5e-3, method="RK4", step=1e-3)
    calls.left = 40
    with pytest.raises(type(error) if not isinstance(error, MemoryError) else cd.SolveError):
        other.simulate(5e-2, method="RK4", step=1e-3, check=True)
    again = other.simulate(5e-3, method="RK4", step=1e-3)
    assert again.x[-1] == pytest.approx(motion.x[-1], abs=1e-9)
