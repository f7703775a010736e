"""States side by side have the bits of single states: every mechanism, every width."""

from __future__ import annotations

import warnings
from itertools import cycle

import numpy as np
import pytest

import cardan as cd
from cardan.errors import SolveWarning
from cardan.runtime.calls import calling
from laws.cases import derived, states
from mechanisms import ZOO
from spread import some

pytestmark = pytest.mark.optimized

# blocks of all widths and a rest
COUNT = 45


# one width for one mechanism, the other for the next
PAIRS = [(name, lanes) for name, first in zip(ZOO, cycle((4, 4, 8, 8)), strict=False)
         for lanes in (first, 12 - first)]  # fmt: skip


@pytest.mark.parametrize(("name", "lanes"), some(PAIRS, 9))
def test_lanes_have_the_bits_of_single_states(
    name: str, lanes: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CARDAN_LANES", str(lanes))
    # no batch is so small that its states are simply done one by one
    monkeypatch.setattr(calling, "LITTLE", 0)
    model = cd.compile(derived(name))
    q, u = (np.resize(x, (COUNT, x.shape[1])) for x in states(name))
    rng = np.random.default_rng(3)
    tau, udot = rng.uniform(-1, 1, (2, *u.shape))
    t = rng.uniform(0, 1, COUNT)
    model.prepare("forward_dynamics", "inverse_dynamics", batch=True)
    assert model.lanes("forward_dynamics") == model.lanes("inverse_dynamics") == lanes
    with warnings.catch_warnings():
        # a listed state may be singular
        warnings.simplefilter("ignore", SolveWarning)
        forward = model.forward_dynamics(q, u, tau=tau, t=t)
        inverse = model.inverse_dynamics(q, u, udot, t=t)
    for k in range(COUNT):
        if np.isfinite(forward[k]).all():
            one = model.forward_dynamics(q[k], u[k], tau=tau[k], t=t[k])
            assert one.tobytes() == forward[k].tobytes()
        one = model.inverse_dynamics(q[k], u[k], udot[k], t=t[k])
        assert one.tobytes() == inverse[k].tobytes()
