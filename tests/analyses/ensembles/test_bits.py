"""A run has the same bits wherever it is computed: in lanes, alone, in threads, as a motion."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.ensembles import EnsembleRecord
from cardan.analyses.ensembles.lane_runner import width_of
from cardan.runtime.calls.lanes import width
from runtime import pendulum

pytestmark = pytest.mark.optimized

TORQUE = (np.array([0.0, 0.4, 0.9, 2.0]), np.array([0.0, 1.0, -1.0, 0.5]))


def same(one: EnsembleRecord, other: EnsembleRecord) -> None:
    """Everything but the time it took."""
    np.testing.assert_array_equal(one.final, other.final)
    np.testing.assert_array_equal(one.numbers, other.numbers)
    assert one.status.tolist() == other.status.tolist()
    assert one.messages == other.messages
    assert one.results.keys() == other.results.keys()
    for name, value in one.results.items():
        np.testing.assert_array_equal(value, other.results[name])


def lanes(model: cd.CompiledModel, t: Any, **options: Any) -> EnsembleRecord:
    """In lanes, however few runs there are."""
    model.prepare("rhs", batch=True)
    job = model.ensemble(t, **options, lanes=1).job
    if width() == 1:
        pytest.skip("no vectors here")
    # those of runs with parameters of their own would be built where they pay
    width_of(model, job.how, job.event_table, job.varied.varies_parameters, np.inf)
    return model.ensemble(t, **options)


CASES = {
    "start": {"t": 2.0, "vary": cd.sample.random(37, {"elbow": (-2, 2), "shoulder.u": (-3, 3)})},
    "times": {
        "t": np.linspace(0, 2, 23),
        "q": {"elbow": np.linspace(-1, 1, 19)},
        "inputs": {"torque": TORQUE},
    },
    "backward": {"t": (2.0, 0.0), "q": {"shoulder": np.linspace(-1, 1, 11)}},
    "parameters": {
        "t": 1.5,
        "vary": cd.sample.latin_hypercube(21, {"upper.mass": (0.5, 2), "elbow": (-1, 1)}),
        "reduce": ["max of elbow", "mean of shoulder.u", "rms of height"],
    },
    "inputs": {"t": np.linspace(0, 1, 5), "inputs": {"torque": np.linspace(-2, 2, 9)}},
    "order 5": {
        "t": np.linspace(0, 1, 9),
        "q": {"elbow": np.linspace(-1, 1, 21)},
        "method": "RK45",
    },
    "fixed": {"t": 1.0, "q": {"elbow": np.linspace(-1, 1, 9)}, "method": "RK4", "step": 0.01},
    "few": {"t": 1.0, "q": {"elbow": np.array([0.1, 0.2])}, "max_step": 0.05},
}


@pytest.mark.parametrize("case", CASES)
def test_lanes_threads_and_single_runs(case: str, double: cd.CompiledModel) -> None:
    options = CASES[case]
    alone = double.ensemble(**options, lanes=1, threads=1)
    assert alone.success
    assert alone.job.width == 1
    wide = lanes(double, **options, threads=1)
    assert (wide.job.width > 1) == wide.job.how.method.lanes
    same(wide, alone)
    same(double.ensemble(**options, threads=3), alone)
    for i in (0, len(alone) - 1):
        motion = wide.run(i)
        np.testing.assert_array_equal(motion.x[-1], alone.final[i])
        assert motion.statistics["steps"] == alone.statistics["steps"][i]


def test_a_run_is_what_simulate_makes(double: cd.CompiledModel) -> None:
    times = np.linspace(0, 2, 17)
    elbow = np.linspace(-1, 1, 12)
    made = lanes(double, times, q={"elbow": elbow}, inputs={"torque": TORQUE})
    for i in (0, 5, 11):
        motion = double.simulate(times, q={"elbow": elbow[i]}, inputs={"torque": TORQUE})
        np.testing.assert_array_equal(made["states"][i], motion.x)
        np.testing.assert_array_equal(made.run(i, times).x, motion.x)


@pytest.mark.parametrize("method", ["DOP853", "RK45"])
def test_quaternions(method: str, ball: cd.CompiledModel) -> None:
    x0 = ball.random_state(3, (20,))
    options: dict[str, Any] = {"t": np.linspace(0, 3, 7), "x0": x0, "method": method}
    alone = ball.ensemble(**options, lanes=1)
    same(lanes(ball, **options), alone)
    lengths = np.linalg.norm(alone["states"][:, :, :4], axis=2)
    np.testing.assert_allclose(lengths, 1, rtol=0, atol=1e-15)


def test_what_has_no_value_stays_in_its_lane(edge: cd.CompiledModel) -> None:
    # some runs come to x = 1, others turn back before; one starts beyond
    x = np.linspace(-1, 0.9, 27)
    x[7] = 1.5
    options: dict[str, Any] = {"t": 2.0, "q": {"slide": x}, "parameters": {"push": -x}}
    with pytest.warns(cd.SolveWarning, match="did not reach their end"):
        alone = edge.ensemble(**options, lanes=1)
    with pytest.warns(cd.SolveWarning):
        wide = lanes(edge, **options)
    same(wide, alone)
    assert 0 < alone.finished.sum() < 26
    assert alone.status[7] == "not_finite"
    assert "'slide.u'" in alone.messages[7]
    with pytest.warns(cd.SolveWarning):
        motion = edge.simulate(2.0, q={"slide": x[7]})
    said = motion.message.replace("motion.", "runs.run(7).")
    assert (motion.status, said) == (alone.status[7], alone.messages[7])


def test_equations_without_a_solution_stay_in_their_lane(folded: cd.CompiledModel) -> None:
    speeds = np.linspace(-1, 1, 24)
    m = np.ones(24)
    m[5] = 0
    options: dict[str, Any] = {
        "t": 1.0,
        "q": {"elbow": 0.3},
        "u": {"elbow": speeds},
        "parameters": {"m": m},
    }
    with pytest.warns(cd.SolveWarning):
        alone = folded.ensemble(**options, lanes=1)
    with pytest.warns(cd.SolveWarning):
        wide = lanes(folded, **options)
    same(wide, alone)
    assert alone.status[5] == "not_finite"
    assert 0 < alone.finished.sum() < 23


# a pendulum whose equations give a status beyond 3.1
RHS = """#include "cardan.h"

void prepare_rhs(const double *p, wreal *w);
void prepare_rhs(const double *p, wreal *w) { w[0] = CARDAN_WREAL(p[2] / p[1]); }

#include "lanes.h"

int rhs(const cardan_in *in, real *out, real *work);
int rhs(const cardan_in *in, real *out, real *work)
{
    real a[CARDAN_PADDED(1)], s[CARDAN_PADDED(1)], c[CARDAN_PADDED(1)];
    const double *each = (const double *)in->q;

    (void)work;
    a[0] = in->q[0];
    cardan_sincos(1, a, s, c);
    out[0] = in->u[0];
    out[1] = -in->w[0] * s[0];
    for (int k = 0; k < CARDAN_LANES; k++)
        if (each[k] > 3.1)
            return 7;
    return 0;
}
"""


def written(recipe: dict[str, Any]) -> str:
    """The equations, and what their object says about itself."""
    own = pendulum.sizes("rhs", recipe)
    return f"{RHS}#ifdef CARDAN_LOADED\nconst int rhs_sizes[] = {{{own}}};\n#endif\n"


def test_a_status_stays_in_its_lane(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text, entry = pendulum.text, pendulum.entry
    monkeypatch.setattr(pendulum, "text", lambda n, r: written(r) if n == "rhs" else text(n, r))
    monkeypatch.setattr(pendulum, "entry", lambda *a: entry(*a) | {"lanes": [1, 2, 4, 8]})
    model = cd.CompiledModel(pendulum.write(tmp_path / "model"))
    speeds = np.linspace(-3, 4, 24)
    options: dict[str, Any] = {"t": 0.8, "q": {"swing": 2.6}, "u": {"swing": speeds}}
    with pytest.warns(cd.SolveWarning):
        alone = model.ensemble(**options, lanes=1)
    with pytest.warns(cd.SolveWarning):
        same(lanes(model, **options), alone)
    assert set(alone.status) == {"finished", "model_failed"}
    assert "status 7" in alone.messages[23]
