"""What is saved comes back: motions and ensembles of every scene, in both kinds of coordinates."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import CardanError
from golden.scenes import EXAMPLES, scene_of
from mechanisms import ZOO
from mechanisms.carried import CARRIED
from mechanisms.closed import CLOSED
from mechanisms.flexible import FLEXIBLE
from mechanisms.mechanism import State
from mechanisms.rolling import ROLLING
from mechanisms.superelements import FLYERS

SPAN = 0.02  # s
REST = State()
SCENES: dict[str, Callable[[], tuple[cd.Scene, State]]] = {
    **{n: (lambda m=m: (m.build(), m.states[0])) for n, m in ZOO.items()},
    **{n: (lambda m=m: (m.build(), m.state(0.3))) for n, m in (CLOSED | CARRIED).items()},
    **{n: (lambda build=build: (build(), REST)) for n, build in ROLLING.items()},
    **{f"flexible {n}": (lambda build=build: (build(), REST)) for n, build in FLEXIBLE.items()},
    **{f"superelement {n}": (lambda f=f: (f.build(), REST)) for n, f in FLYERS.items()},
    **{path.name: (lambda path=path: (scene_of(path), REST)) for path in EXAMPLES},
}
KINDS = ("relative", "absolute")
# these in every run: joints, both coordinates, a loop, events, a beam, inputs
SHOWN = {
    ("spatial_chain", "relative"),
    ("double_pendulum", "absolute"),
    ("four_bar", "relative"),
    ("flexible pendulum", "absolute"),
    ("trolley.yaml", "relative"),
}
CASES = [(name, kind) for name in SCENES for kind in KINDS]
# scenes that cannot be had in these coordinates, or cannot move from where they stand
REFUSED = (CardanError,)


def _marked() -> list[Any]:
    return [
        pytest.param(*case, marks=[] if case in SHOWN else [pytest.mark.slow]) for case in CASES
    ]


@cache
def _model(name: str, kind: str) -> tuple[cd.CompiledModel, State]:
    """The compiled model and where it starts.

    Raises:
        ModelError: it cannot be had in these coordinates.
    """
    scene, state = SCENES[name]()
    return cd.compile(scene, coordinates=kind), state


def _moved(name: str, kind: str, t: Any) -> cd.Trajectory:
    """A short run, or a skipped test that says why there is none."""
    try:
        model, state = _model(name, kind)
    except REFUSED as refused:
        pytest.skip(f"not in {kind} coordinates: {refused}")
    known = {joint["name"] for joint in model.manifest["joints"] if joint["q"]}
    start = {
        "q": {n: v for n, v in state.q.items() if n in known},
        "u": {n: v for n, v in state.u.items() if n in known},
    }
    for given in (start, {}):
        try:
            return model.simulate(t, **given)
        except CardanError as problem:
            refused_start = problem
    pytest.skip(f"no start: {refused_start}")


def _of(what: Callable[[], Any]) -> Any:
    """A result, or the kind of error that there is instead."""
    try:
        return what()
    except CardanError as error:
        return type(error).__name__


def _same(here: Any, there: Any) -> bool:
    """Equal to the bit, through tables, tuples and records."""
    if isinstance(there, np.ndarray):
        return np.array_equal(here, there, equal_nan=there.dtype.kind == "f")
    if isinstance(there, Mapping):
        return list(here) == list(there) and all(_same(here[k], there[k]) for k in there)
    if isinstance(there, tuple | list):
        return len(here) == len(there) and all(map(_same, here, there))
    if type(there).__name__ == "Event":
        return _same(vars(here), vars(there))
    return bool(here == there)


def _page(motion: cd.Trajectory, path: Path) -> dict[str, Any]:
    text = motion.animate(path, fps=2000.0, page="plain").path.read_text("utf-8")
    found: dict[str, Any] = json.JSONDecoder().raw_decode(text[text.index('{"t":') :])[0]
    return found


PLAIN = ("t", "x", "q", "u", "z", "r", "s", "work_done", "sources", "events", "ticks")
STORED = {
    **{
        name: (lambda m, name=name: getattr(m, name))
        for name in (*PLAIN, "solver_info", "ledger", "work")
    },
    "energy": lambda m: tuple(m.energy),
    "energy residual": lambda m: m.energy_residual,
    "drift": lambda m: m.drift,
    "balance": lambda m: str(m.balance),
    "constraints": lambda m: m.constraints,
    "told": repr,
    "names": lambda m: {row["name"]: m[row["name"]] for row in m.manifest["coordinates"]},
}


@pytest.mark.parametrize("sampled", [False, True], ids=["dense", "sampled"])
@pytest.mark.parametrize(("name", "kind"), _marked())
def test_motions(name: str, kind: str, sampled: bool, tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        motion = _moved(name, kind, np.linspace(0, SPAN, 7) if sampled else SPAN)
        compared = _compare(motion, tmp_path)
    assert compared > 30


def _compare(motion: cd.Trajectory, folder: Path) -> int:
    """How many things were compared: those of the file alone and those with the model."""
    path = motion.save(folder / "run.nc")
    alone, whole = cd.load_motion(path), cd.load_motion(path, model=motion.model)
    compared = 0
    for word, of in STORED.items():
        there = _of(lambda of=of: of(motion))
        for back in (alone, whole):
            assert _same(_of(lambda of=of, back=back: of(back)), there), word
            compared += 1
    assert alone.save(folder / "again.nc").read_bytes() == path.read_bytes()
    compared += _joints(motion, whole) + _frames(motion, alone, whole)
    compared += _between(motion, alone, whole) + _pages(motion, alone, whole, folder)
    return compared


def _joints(motion: cd.Trajectory, whole: cd.Trajectory) -> int:
    """Reactions, outputs and multipliers, which need the model."""
    names = [row["name"] for row in motion.manifest["joints"]]
    for joint in names:
        assert _same(
            _of(lambda j=joint: whole.reaction(j)), _of(lambda j=joint: motion.reaction(j))
        )
    rows = [row["name"] for row in motion.manifest["outputs"]]
    for output in rows:
        assert _same(_of(lambda o=output: whole[o]), _of(lambda o=output: motion[o]))
    assert _same(_of(lambda: whole.multipliers), _of(lambda: motion.multipliers))
    return len(names) + len(rows) + 1


def _frames(motion: cd.Trajectory, alone: cd.Trajectory, whole: cd.Trajectory) -> int:
    """Poses: with the model to the bit; from those in the file to rounding, 100 eps times size."""
    frames = [row["name"] for row in motion.manifest["frames"]]
    for frame in frames:
        there = _of(lambda f=frame: motion.pose(f))
        assert _same(_of(lambda f=frame: whole.pose(f)), there)
        if not isinstance(there, str):
            size = 1 + np.abs(there).max()
            np.testing.assert_allclose(alone.pose(frame), there, rtol=0, atol=2e-14 * size)
    return len(frames)


def _between(motion: cd.Trajectory, alone: cd.Trajectory, whole: cd.Trajectory) -> int:
    """States between the rows: with the model to the bit."""
    if motion.dense is None:
        # rows alone: at their times the states, at others none
        assert isinstance(_of(lambda: alone.at(0.37 * SPAN)), str)
        np.testing.assert_array_equal(alone.at(motion.t), motion.x)
        return 2
    times = np.linspace(0, motion.t[-1], 11)
    there = motion.at(times)
    assert _same(whole.at(times), there)
    assert alone.dense is not None
    # a file alone does not project what lies between its rows onto the constraints: it has the
    # polynomials, to the bit
    np.testing.assert_array_equal(alone.at(times), motion.dense.at(times)[:, : motion.x.shape[1]])
    frame = motion.manifest["frames"][-1]["name"] if motion.manifest["frames"] else None
    pose = _of(lambda: alone.resample(times).pose(frame)) if frame else "none"
    if not isinstance(pose, str) and motion.model is not None:
        wanted = motion.model.pose(
            frame, alone.at(times)[:, : motion.nq], t=times, r=_inputs(motion, times)
        )
        size = 1 + np.abs(wanted).max()
        np.testing.assert_allclose(pose, wanted, rtol=0, atol=2e-14 * size)
    return 3


def _inputs(motion: cd.Trajectory, times: np.ndarray) -> np.ndarray | None:
    """Inputs at times, for functions of the model."""
    return motion.resample(times).r if motion.r.shape[1] else None


def _pages(motion: cd.Trajectory, alone: cd.Trajectory, whole: cd.Trajectory, folder: Path) -> int:
    """Pages: with the model to the letter; alone the same bodies at the same times."""
    there = _of(lambda: _page(motion, folder / "there.html"))
    assert _same(_of(lambda: _page(whole, folder / "whole.html")), there)
    if isinstance(there, str):
        return 1
    here = _page(alone, folder / "here.html")
    assert [b["name"] for b in here["bodies"]] == [b["name"] for b in there["bodies"]]
    assert here["t"][0] == there["t"][0]
    assert here["t"][-1] == there["t"][-1]
    if here["t"] == there["t"]:
        for own, other in zip(here["bodies"], there["bodies"], strict=True):
            # five decimals, rounded to either side; of what is closed by constraints
            # and told by polynomials it is the rows that agree
            closed = motion.ledger is not None and motion.dense is not None
            rows = slice(None, None, len(own["pose"]) - 1) if closed else slice(None)
            shown, wanted = np.array(own["pose"])[rows], np.array(other["pose"])[rows]
            np.testing.assert_allclose(shown, wanted, rtol=1e-14, atol=1.1e-5)
    return 2 + len(here["bodies"])


# ensembles


@pytest.mark.parametrize(("name", "kind"), _marked())
def test_ensembles(name: str, kind: str, tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        motion = _moved(name, kind, SPAN)
        model = motion.model
        assert model is not None
        varied = {model.speeds[-1]: [0.0, 1e-3, 2e-3]} if model.speeds else {}
        kept = ["states", f"max of {model.coordinates[0]}", f"mean of {model.coordinates[0]}"]
        try:
            runs = model.ensemble(np.linspace(0, SPAN, 3), u=varied, reduce=kept, threads=1)
        except CardanError as refused:
            pytest.skip(f"no ensemble: {refused}")
    back = cd.load_ensemble(runs.save(tmp_path / "runs.nc"))
    assert repr(back) == repr(runs)
    for word in ("final", "q", "u", "t", "status", "finished", "statistics", "varied", "messages"):
        assert _same(getattr(back, word), getattr(runs, word)), word
    assert _same(back.results, runs.results)
    assert _same(back[model.coordinates[0]], runs[model.coordinates[0]])
    again = back.save(tmp_path / "again.nc").read_bytes()
    assert again == (tmp_path / "runs.nc").read_bytes()
    with pytest.raises(cd.ModelError, match="has no model"):
        back.run(0)


def test_every_scene_is_here() -> None:
    print(f"{len(CASES)} scenes and kinds of coordinates, of motions twice, dense and sampled")
    assert len(SCENES) >= len(ZOO) + len(CLOSED) + len(FLEXIBLE) + len(FLYERS) + len(EXAMPLES) + 5
    assert set(CASES) >= SHOWN
