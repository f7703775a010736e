"""Dense output that waits until somebody asks: the bits of one that is made at once."""

from __future__ import annotations

import pickle
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.conftest import double_scene
from cardan.analyses.simulation import driving
from cardan.runtime.trajectory.dense_output import Dense, LaterDense
from mechanisms import ZOO

HOW: dict[str, Any] = {"t": 2.0, "q": {"elbow": 0.7}, "method": "DOP853", "rtol": 1e-8}


def at_once(model: Any, **how: Any) -> Any:
    """The motion of a run that does not wait."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(driving, "can_wait", lambda runner: False)
        motion = model.simulate(**how)
    assert type(motion.dense) is Dense
    return motion


@pytest.mark.parametrize(
    ("name", "method"),
    [
        ("double_pendulum", "DOP853"),
        ("spherical_quaternion", "RKMK853"),
        ("free_quaternion", "RKMK853"),
        ("driven", "DOP853"),
        ("damped", "DOP853"),
    ],
)
def test_bits_and_values(name: str, method: str) -> None:
    model = cd.compile(ZOO[name].build())
    start = model.initial(q=ZOO[name].states[0].q, u=ZOO[name].states[0].u)
    how: dict[str, Any] = {"x0": start, "method": method, "rtol": 1e-8}
    later, now = model.simulate(2.0, **how), at_once(model, t=2.0, **how)
    assert isinstance(later.dense, LaterDense)
    assert later.dense.spreads.tobytes() == now.dense.spreads.tobytes()
    assert later.x.tobytes() == now.x.tobytes()
    saved = now.statistics["evaluations"] - later.statistics["evaluations"]
    assert saved == 3 * later.statistics["steps"]
    # the kernels' output times take no part in it; they close quaternions as well
    times = np.linspace(0.0, 2.0, 23)
    listed = model.simulate(times, **how)
    np.testing.assert_allclose(later.at(times), listed.x, rtol=0, atol=1e-13)


def test_what_the_run_had_counts() -> None:
    """Its parameters, constant inputs and direction, whatever ran since."""
    model = cd.compile(double_scene())
    changes: list[dict[str, Any]] = [
        {"parameters": {"gravity.z": -1.0}},
        {"inputs": {"torque": 2.0}},
        {"t": (1.0, -1.0)},
    ]
    motions = [model.simulate(**{**HOW, **change}) for change in changes]
    model.simulate(**{**HOW, "rtol": 1e-4, "inputs": {"torque": -1.0}})
    for motion, change in zip(motions, changes, strict=True):
        now = at_once(model, **{**HOW, **change})
        assert motion.dense.spreads.tobytes() == now.dense.spreads.tobytes(), change


def test_many_may_ask_and_files_have_it(tmp_path: Path) -> None:
    model = cd.compile(double_scene())
    expected = at_once(model, **HOW).dense.spreads.tobytes()
    motion, read, sent = (model.simulate(**HOW) for _ in range(3))
    with ThreadPoolExecutor(4) as pool:
        asked = pool.map(lambda _: motion.dense.spreads.tobytes(), range(8))
    assert set(asked) == {expected}
    assert pickle.loads(pickle.dumps(sent)).dense.spreads.tobytes() == expected
    read.save(tmp_path / "motion.nc")
    assert cd.load_motion(tmp_path / "motion.nc").dense.spreads.tobytes() == expected


def test_runs_that_cannot_wait() -> None:
    """Events, signals and functions as inputs, closed loops: what is over cannot be asked again."""
    model = cd.compile(double_scene())
    four_bar = cd.compile(cd.load(cd.examples.path("four_bar")))
    times = np.array([0.0, 1.0, 2.0])
    motions = [
        model.simulate(**HOW, events={"low": ("elbow", 0.1)}),
        model.simulate(**HOW, inputs={"torque": (times, times)}),
        model.simulate(**HOW, inputs={"torque": lambda t, x: t}),
        four_bar.simulate(0.2, q={"A": 0.6}, method="DOP853"),
    ]
    assert [type(motion.dense) for motion in motions] == [Dense] * len(motions)
