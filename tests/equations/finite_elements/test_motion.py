"""Motions in absolute coordinates end where those of the joints do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.initial import start_of
from laws.circuits import EVERY, compiled, start
from mechanisms import ZOO, State
from mechanisms.rolling import ROLLING
from spread import some

SPAN, STEP = 0.1, 1e-3
# of what the last extrapolation still changed, plus rounding of some hundred steps
TIMES = 10
NAMES = ("free_ZYX", "backwards", "gear", "drives", "universal", "point_on_curve", "prescribed")


def trees() -> dict[str, tuple[Callable[[], cd.Scene], State]]:
    """Of the zoo, and a wheel that rolls straight on."""
    found = {name: (ZOO[name].build, ZOO[name].states[0]) for name in NAMES if name in ZOO}
    rolling = State({"rolls": (0, 0, 0, 0.1, 0)}, {"rolls": (0.6, 0, 0.1, 0, 2.0)})
    return found | {"coin": (ROLLING["coin"], rolling)}


def extrapolated(model: cd.CompiledModel, names: tuple[str, ...], **state: object) -> tuple:
    """Coordinates at the end for steps that go to 0, and what the last extrapolation changed."""
    method = cd.GeneralizedAlpha(rho_inf=0.8)
    ends = []
    for h in (STEP, STEP / 2, STEP / 4):
        motion = model.simulate(SPAN, method=method, step=h, rtol=1e-11, atol=1e-12, **state)
        assert motion.t[-1] == pytest.approx(SPAN)
        ends.append(np.array([motion[name][-1] for name in names]))
    # order 2, and what is left of order 3
    first = [(4 * ends[k + 1] - ends[k]) / 3 for k in (0, 1)]
    return (8 * first[1] - first[0]) / 7, np.abs(first[1] - first[0]).max()


@pytest.mark.parametrize("name", some(trees(), 2))
def test_trees(name: str) -> None:
    build, state = trees()[name]
    relative, absolute = (cd.compile(build(), coordinates=c) for c in ("relative", "absolute"))
    given = {"q": state.q, "u": state.u}
    if relative.manifest["multipliers"]:
        # as they are named: speeds that come apart are not start of a run
        q, u = relative.split(start_of(relative, state.q, state.u)[0])
        u = relative.close_velocity(q, u)[: relative.nu]
        given["u"] = dict(zip(relative.speeds, u.tolist(), strict=True))
    exact = relative.simulate(SPAN, rtol=1e-12, atol=1e-13, **given)
    found, change = extrapolated(absolute, relative.coordinates, **given)
    expected = np.array([exact[c][-1] for c in relative.coordinates])
    assert np.abs(found - expected).max() < TIMES * change + 1e-9


@pytest.mark.parametrize("name", ["four_bar", "bricard", "cam"])
def test_circuits(name: str) -> None:
    relative = compiled(name)
    absolute = cd.compile(EVERY[name].build(), coordinates="absolute")
    q, u = start(relative, name, 0.3)
    given = {
        "q": dict(zip(relative.coordinates, q.tolist(), strict=True)),
        "u": dict(zip(relative.speeds, u.tolist(), strict=True)),
    }
    exact = relative.simulate(SPAN, rtol=1e-12, atol=1e-13, **given)
    found, change = extrapolated(absolute, relative.coordinates, **given)
    expected = np.array([exact[c][-1] for c in relative.coordinates])
    assert np.abs(found - expected).max() < TIMES * change + 1e-9
